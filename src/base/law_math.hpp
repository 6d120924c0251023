// Arithmetic of one double, in which a law of forces is evaluated where no kernel does it.
//
// A law is a template over its arithmetic, so that one formula serves everywhere: PlainMath here, PackMath
// (base/pack_math.hpp) in kernels. What such a law needs, both offer.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <type_traits>

namespace fiberfate {

struct PlainMath {
  using Number = double;

  [[nodiscard]] static double number(double x) { return x; }
  [[nodiscard]] static double choose(bool mask, double yes, double no) { return mask ? yes : no; }
  [[nodiscard]] static double smaller(double a, double b) { return a < b ? a : b; }
  [[nodiscard]] static double larger(double a, double b) { return a > b ? a : b; }
  [[nodiscard]] static double square_root(double x) { return std::sqrt(x); }
  [[nodiscard]] static double exponential(double x) { return std::exp(x); }
  /// arcsin(h)/h for y = h² in [0, 1].
  [[nodiscard]] static double arcsine_ratio(double y) {
    const double h = std::sqrt(y);
    return h < 1e-8 ? 1.0 : std::asin(h) / h;
  }
};

/// The constants of a law as plain numbers, in the order of its members: what kernels of all instruction sets
/// can read.
using LawNumbers = std::array<double, 8>;

/// Writes the constants of a law of PlainMath as numbers.
template <class Law>
[[nodiscard]] LawNumbers numbers_of(const Law& law) {
  static_assert(std::is_trivially_copyable_v<Law>);
  static_assert(std::is_empty_v<Law> || sizeof(Law) % sizeof(double) == 0);
  static_assert(sizeof(Law) <= sizeof(LawNumbers), "a law has eight constants at most");
  LawNumbers numbers{};
  if constexpr (!std::is_empty_v<Law>) std::memcpy(numbers.data(), &law, sizeof(Law));
  return numbers;
}

/// Makes a law of PlainMath from its constants.
template <class Law>
[[nodiscard]] Law law_from(const LawNumbers& numbers) {
  Law law;
  if constexpr (!std::is_empty_v<Law>) std::memcpy(&law, numbers.data(), sizeof(Law));
  return law;
}

}  // namespace fiberfate
