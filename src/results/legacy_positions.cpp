// Reads Initial_Positions.txt of the published program.
#include "results/legacy_positions.hpp"

#include <fmt/format.h>

#include "io/legacy_text.hpp"

namespace fiberfate {

std::vector<LegacyFiber> read_legacy_positions(const std::string& path) {
  LegacyNumbers words(path);
  std::vector<LegacyFiber> fibers(words.count("the number of fibers"));
  for (std::size_t i = 0; i < fibers.size(); ++i) {
    const std::int64_t nodes = words.count(fmt::format("the number of nodes of fiber {}", i + 1));
    for (std::int64_t k = 0; k < nodes; ++k) {
      const std::string node = fmt::format("node {} of fiber {}", k + 1, i + 1);
      fibers[i].is_stationary |= words.truth("the mark 'is_stationary' of " + node);
      const double x = words.number("x of " + node);
      const double y = words.number("y of " + node);
      const double z = words.number("z of " + node);
      fibers[i].nodes.emplace_back(x, y, z);
    }
  }
  words.expect_end();
  return fibers;
}

}  // namespace fiberfate
