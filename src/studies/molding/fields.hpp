// Takes from a filling the values that are shown: mean lengths and orientation at nodes, in layers and at
// places.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "continuum/length_classes.hpp"
#include "molding/filling.hpp"
#include "studies/molding/setup.hpp"

namespace fiberfate {

/// Reads a filling with the meaning that the case gives to its length classes.
class MoldingFields {
 public:
  MoldingFields(const MoldingCase& values, const MoldingSetup& setup, const Filling& filling)
      : values_(values), setup_(setup), filling_(filling) {}

  /// Tells whether the melt has come to a node.
  [[nodiscard]] bool is_wet(std::size_t node) const { return filling_.state().filled[node] > 0; }
  [[nodiscard]] std::size_t set_count() const { return setup_.params.fibers.length_sets.size(); }

  /// Gives the fibers of a set at a point as a population; empty where only means are followed.
  [[nodiscard]] LengthClasses population(std::size_t set, std::size_t node, std::size_t layer) const;
  /// Gives the same of the whole gap, every layer with its share of the volume.
  [[nodiscard]] LengthClasses population(std::size_t set, std::size_t node) const;
  /// Tells L_N and L_W at a point; NaN where there is no melt.
  [[nodiscard]] MeanLengths means(std::size_t set, std::size_t node, std::size_t layer) const;
  /// Tells L_N and L_W over the gap and over nodes: those of the sample where fibers are a population, the
  /// means over the gap where only means are followed, as they have been calibrated.
  [[nodiscard]] MeanLengths means(std::size_t set, std::size_t node) const;
  [[nodiscard]] MeanLengths means(std::size_t set, std::span<const Index> nodes) const;
  /// Tells L_N and L_W of all fibers in the gap at some nodes, as a burnt-off sample has them. Layers of
  /// short fibers hold more of them and count the more: the L_N of layers has the harmonic mean, L_W the
  /// arithmetic.
  [[nodiscard]] MeanLengths sample_means(std::size_t set, std::span<const Index> nodes) const;
  /// Averages the L_N and L_W of layers over the gap and nodes, by volume.
  [[nodiscard]] MeanLengths gap_means(std::size_t set, std::span<const Index> nodes) const;
  /// Gives the population at the gates.
  [[nodiscard]] LengthClasses inlet_population() const;
  [[nodiscard]] MeanLengths inlet_means() const;

  [[nodiscard]] const Filling& filling() const { return filling_; }
  [[nodiscard]] const MoldingSetup& setup() const { return setup_; }
  [[nodiscard]] const MoldingCase& values() const { return values_; }

 private:
  /// Calls body(node, volume) for nodes that hold melt; returns the sum of the volumes.
  template <class Body>
  double visit_wet(std::span<const Index> nodes, const Body& body) const;

  const MoldingCase& values_;
  const MoldingSetup& setup_;
  const Filling& filling_;
};

/// Finds the nodes of a sample at a named place: those within the case's radius, at least the nearest one.
[[nodiscard]] std::vector<Index> sample_nodes(const MoldingFields& fields, const NamedPlace& place);

}  // namespace fiberfate
