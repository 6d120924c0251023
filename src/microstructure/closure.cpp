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

namespace fiberfate {
namespace {

constexpr int block_lanes = 8;
using Lanes = std::array<double, 6 * block_lanes>;

constexpr std::array descriptions = {
    ClosureDescription{Closure::linear, "linear",
                       "Linear in A2: exact for isotropic states, unstable in flow.",
                       "Advani, Tucker, J. Rheol. 31, 751 (1987)"},
    ClosureDescription{Closure::quadratic, "quadratic", "A2 A2: exact for aligned states.",
                       "Doi, J. Polym. Sci. B 19, 229 (1981)"},
    ClosureDescription{Closure::hybrid, "hybrid",
                       "Linear and quadratic mixed by 1 - 27 det A2; overestimates alignment.",
                       "Advani, Tucker, J. Rheol. 34, 367 (1990)"},
    ClosureDescription{Closure::ibof, "ibof",
                       "Invariant-based optimal fitting: accurate and without eigenvectors.",
                       "Chung, Kwon, J. Rheol. 46, 169 (2002)"},
    ClosureDescription{Closure::orf, "orf", "Orthotropic, fitted to flows of C_I = 0.01.",
                       "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"},
    ClosureDescription{Closure::orw, "orw", "Orthotropic, fitted to a wide range of C_I, second order.",
                       "Chung, Kwon, Polym. Compos. 22, 636 (2001)"},
    ClosureDescription{Closure::orw3, "orw3", "Orthotropic, fitted to a wide range of C_I, third order.",
                       "Chung, Kwon, Polym. Compos. 22, 636 (2001)"},
    ClosureDescription{Closure::ore, "ore",
                       "Orthotropic equivalent of the natural closure (ORN), fourth order.",
                       "VerWeyst, PhD thesis, University of Illinois (1998)"},
    ClosureDescription{Closure::ors, "ors", "Orthotropic smooth: linear in the principal values.",
                       "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"},
    ClosureDescription{Closure::orl, "orl", "Orthotropic, fitted to flows of low C_I.",
                       "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"},
    ClosureDescription{Closure::orp, "orp", "Orthotropic peaked: all fibers along the principal axes.",
                       "Cintra, Tucker, J. Rheol. 39, 1095 (1995)"},
    ClosureDescription{Closure::bingham, "bingham", "As a Bingham distribution, fitted, third order.",
                       "Chaubal, Leal, J. Rheol. 42, 177 (1998)"},
    ClosureDescription{Closure::exact, "exact", "Exact for Jeffery's equation from an isotropic state; slow.",
                       "Montgomery-Smith et al., J. Fluid Mech. 680, 321 (2011)"}};

void contract(Closure closure, const ClosureBlock& block) {
  return FIBERFATE_KERNEL(contract_closures)(closure, block);
}

}  // namespace

std::span<const ClosureDescription> closures() {
  return descriptions;
}

const char* name(Closure closure) {
  return std::ranges::find(descriptions, closure, &ClosureDescription::closure)->name;
}

Closure closure_named(std::string_view name) {
  std::string wanted(name);
  std::ranges::transform(wanted, wanted.begin(),
                         [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return entry_named(descriptions, "closure", wanted).closure;
}

Mat6 close(const Mat3& second, Closure closure) {
  require_forgivable(second);
  // Lane n contracts with the unit tensor (e_k e_l + e_l e_k)/2, which gives the column kl of A4.
  alignas(64) Lanes state{}, units{}, columns{};
  const Vec6 a = to_components(second);
  for (int lane = 0; lane < block_lanes; ++lane)
    for (int m = 0; m < 6; ++m) state[static_cast<std::size_t>(m * block_lanes + lane)] = a[m];
  for (int n = 0; n < 6; ++n) units[static_cast<std::size_t>(n * block_lanes + n)] = 1 / multiplicity_of[n];
  contract(closure, {state.data(), units.data(), columns.data()});
  Mat6 fourth;
  for (int m = 0; m < 6; ++m)
    for (int n = 0; n < 6; ++n) fourth(m, n) = columns[static_cast<std::size_t>(m * block_lanes + n)];
  return fourth;
}

Mat3 closed_double_dot(const Mat3& second, const Mat3& symmetric, Closure closure) {
  require_forgivable(second);
  require_numbers("symmetric", symmetric.reshaped(), any_finite);
  alignas(64) Lanes state{}, factor{}, product{};
  const Vec6 a = to_components(second), g = to_components(symmetric);
  for (int m = 0; m < 6; ++m) {
    for (int lane = 0; lane < block_lanes; ++lane) {
      state[static_cast<std::size_t>(m * block_lanes + lane)] = a[m];
      factor[static_cast<std::size_t>(m * block_lanes + lane)] = g[m];
    }
  }
  contract(closure, {state.data(), factor.data(), product.data()});
  Vec6 result;
  for (int m = 0; m < 6; ++m) result[m] = product[static_cast<std::size_t>(m * block_lanes)];
  return to_matrix(result);
}

}  // namespace fiberfate
