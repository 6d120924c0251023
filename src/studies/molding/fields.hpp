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
  /// Tells L_N and L_W at a point, over the gap, and over nodes with weights; NaN where there is no melt.
  [[nodiscard]] MeanLengths means(std::size_t set, std::size_t node, std::size_t layer) const;
  [[nodiscard]] MeanLengths means(std::size_t set, std::size_t node) const;
  [[nodiscard]] MeanLengths means(std::size_t set, std::span<const Index> nodes) const;
  /// Gives the population at the gates.
  [[nodiscard]] LengthClasses inlet_population() const;
  [[nodiscard]] MeanLengths inlet_means() const;

  [[nodiscard]] const Filling& filling() const { return filling_; }
  [[nodiscard]] const MoldingSetup& setup() const { return setup_; }
  [[nodiscard]] const MoldingCase& values() const { return values_; }

 private:
  const MoldingCase& values_;
  const MoldingSetup& setup_;
  const Filling& filling_;
};

/// Finds the nodes of a sample at a named place: those within the case's radius, at least the nearest one.
[[nodiscard]] std::vector<Index> sample_nodes(const MoldingFields& fields, const NamedPlace& place);

/// Lists the edges between nodes of a weld line, as pairs of nodes.
[[nodiscard]] std::vector<ShellEdge> weld_edges(const Filling& filling);

}  // namespace fiberfate
