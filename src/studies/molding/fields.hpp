// What is shown of a filling, with the names and choices of its case.
#pragma once

#include "molding/filled_lengths.hpp"
#include "studies/molding/setup.hpp"

namespace fiberfate {

/// Reads a filling with the meaning that the case gives to its length classes.
class MoldingFields : public FilledLengths {
 public:
  MoldingFields(const MoldingCase& values, const MoldingSetup& setup, const Filling& filling)
      : FilledLengths(filling, setup.reading), values_(values), setup_(setup) {}

  [[nodiscard]] const MoldingSetup& setup() const { return setup_; }
  [[nodiscard]] const MoldingCase& values() const { return values_; }
  /// Finds the nodes of the sample at a named place.
  [[nodiscard]] std::vector<Index> sample_at(const NamedPlace& place) const {
    return sample_nodes(filling().mesh(), position_of(place, setup_.part), values_.output.place_radius);
  }

 private:
  const MoldingCase& values_;
  const MoldingSetup& setup_;
};

}  // namespace fiberfate
