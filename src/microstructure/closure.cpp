// Calls the closure kernels for single states and keeps the list of closures.
#include "microstructure/closure.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#include "base/entry_by_name.hpp"
#include "base/kernels.hpp"
#include "base/number_checks.hpp"
#include "microstructure/admissibility.hpp"
#include "microstructure/closure_block.hpp"
#include "microstructure/closure_laws/closure_laws.hpp"

namespace fiberfate {
namespace {

constexpr int block_lanes = 8;
using Lanes = std::array<double, 6 * block_lanes>;

/// What the list needs to know where nothing is computed.
struct NoMath {
  struct Number;
  struct Symmetric;
  struct Frame;
  struct Orthotropic;
};

template <template <class> class... Laws>
std::vector<ClosureDescription> descriptions_of(LawList<Laws...>) {
  int number = 0;
  return {
      {Closure{number++}, Laws<NoMath>::text.name, Laws<NoMath>::text.meaning, Laws<NoMath>::text.source}...};
}

void contract(Closure closure, const ClosureBlock& block) {
  return FIBERFATE_KERNEL(contract_closures)(closure, block);
}

}  // namespace

const std::vector<ClosureDescription>& closures() {
  static const std::vector<ClosureDescription> all = descriptions_of(ClosureLaws{});
  return all;
}

const char* name(Closure closure) {
  return closures()[static_cast<std::size_t>(closure)].name;
}

Closure closure_named(std::string_view name) {
  std::string wanted(name);
  std::ranges::transform(wanted, wanted.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return entry_named(closures(), "closure", wanted).closure;
}

Mat6 close(const Mat3& second, Closure closure) {
  require_forgivable(second);
  // Lane n contracts with the unit tensor (e_k e_l + e_l e_k)/2, which gives the column kl of A4.
  alignas(64) Lanes state{}, units{}, columns{};
  const Vec6 a = to_components(second);
  for (int lane = 0; lane < block_lanes; ++lane)
    for (int m = 0; m < 6; ++m) state[m * block_lanes + lane] = a[m];
  for (int n = 0; n < 6; ++n) units[n * block_lanes + n] = 1 / multiplicity_of[n];
  contract(closure, {state.data(), units.data(), columns.data()});
  Mat6 fourth;
  for (int m = 0; m < 6; ++m)
    for (int n = 0; n < 6; ++n) fourth(m, n) = columns[m * block_lanes + n];
  return fourth;
}

Mat3 closed_double_dot(const Mat3& second, const Mat3& symmetric, Closure closure) {
  require_forgivable(second);
  require_numbers("symmetric", symmetric.reshaped(), any_finite);
  alignas(64) Lanes state{}, factor{}, product{};
  const Vec6 a = to_components(second), g = to_components(symmetric);
  for (int m = 0; m < 6; ++m) {
    for (int lane = 0; lane < block_lanes; ++lane) {
      state[m * block_lanes + lane] = a[m];
      factor[m * block_lanes + lane] = g[m];
    }
  }
  contract(closure, {state.data(), factor.data(), product.data()});
  Vec6 result;
  for (int m = 0; m < 6; ++m) result[m] = product[m * block_lanes];
  return to_matrix(result);
}

}  // namespace fiberfate
