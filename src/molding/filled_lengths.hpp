// Mean lengths and populations of fibers in a filling: at points, over the gap, of samples.
#pragma once

#include <span>
#include <vector>

#include "continuum/length_classes.hpp"
#include "molding/filling.hpp"

namespace fiberfate {

/// How the classes of initial length stand for the fibers.
enum class LengthReading {
  population,  ///< they are classes of a distribution
  means        ///< class 0 is L_N, class 1 is L_W
};

/// Reads the lengths of a filling with the meaning that its classes have. Keeps a reference to the filling.
class FilledLengths {
 public:
  FilledLengths(const Filling& filling, LengthReading reading) : filling_(filling), reading_(reading) {}

  /// Whether the melt has come to a node.
  [[nodiscard]] bool is_wet(std::size_t node) const { return filling_.state().filled[node] > 0; }
  [[nodiscard]] std::size_t set_count() const { return filling_.params().fibers.length_sets.size(); }

  /// Gives the fibers of a set at a point as a population; empty where only means are followed.
  [[nodiscard]] LengthClasses population(std::size_t set, std::size_t node, std::size_t layer) const;
  /// Gives the same of the whole gap, every layer with its share of the volume.
  [[nodiscard]] LengthClasses population(std::size_t set, std::size_t node) const;
  /// Gives the same of some nodes, every node with its volume of melt.
  [[nodiscard]] LengthClasses population(std::size_t set, std::span<const Index> nodes) const;
  /// L_N and L_W at a point; NaN where there is no melt.
  [[nodiscard]] MeanLengths means(std::size_t set, std::size_t node, std::size_t layer) const;
  /// L_N and L_W over the gap and over nodes: those of the sample where fibers are a population, the
  /// means over the gap where only means are followed, as they have been calibrated.
  [[nodiscard]] MeanLengths means(std::size_t set, std::size_t node) const;
  [[nodiscard]] MeanLengths means(std::size_t set, std::span<const Index> nodes) const;
  /// L_N and L_W of all fibers in the gap at some nodes, as a burnt-off sample has them. Layers of
  /// short fibers hold more of them and count the more: the L_N of layers has the harmonic mean, L_W the
  /// arithmetic.
  [[nodiscard]] MeanLengths sample_means(std::size_t set, std::span<const Index> nodes) const;
  /// Averages the L_N and L_W of layers over the gap and nodes, by volume.
  [[nodiscard]] MeanLengths gap_means(std::size_t set, std::span<const Index> nodes) const;
  /// Gives the population at the gates.
  [[nodiscard]] LengthClasses inlet_population() const;
  [[nodiscard]] MeanLengths inlet_means() const;

  [[nodiscard]] const Filling& filling() const { return filling_; }
  [[nodiscard]] LengthReading reading() const { return reading_; }

 private:
  /// Calls body(node, volume) for nodes that hold melt; returns the sum of the volumes.
  template <class Body>
  double visit_wet(std::span<const Index> nodes, const Body& body) const;

  const Filling& filling_;
  LengthReading reading_;
};

/// Finds the nodes of a sample: those within a radius of a place, at least the nearest one.
[[nodiscard]] std::vector<Index> sample_nodes(const ShellMesh& mesh, const Vec3& place, double radius);

}  // namespace fiberfate
