// Makes from a case of the study molding what the filling solver takes.
#pragma once

#include <string>
#include <vector>

#include "molding/filled_lengths.hpp"
#include "studies/molding/case.hpp"

namespace fiberfate {

/// Everything for one filling.
struct MoldingSetup {
  MoldingPart part;
  FillingParams params;
  LengthReading reading = LengthReading::population;
  std::vector<double> sweep_values;  ///< of the sets from 1 on; set 0 is [law] as it stands
  int compared_set = -1;             ///< set of [compare]; -1: none
};

/// Meshes the part and translates a valid case. Raises InputError as make_part.
[[nodiscard]] MoldingSetup molding_setup(const MoldingCase& values);
/// Does the same for a part that is meshed already, as in a checkpoint.
[[nodiscard]] MoldingSetup molding_setup(const MoldingCase& values, const Shell& shell);

/// Finds where a named place is, m; raises InputError for flat coordinates on a part that has none.
[[nodiscard]] Vec3 position_of(const NamedPlace& place, const MoldingPart& part);

}  // namespace fiberfate
