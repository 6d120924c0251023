// Draws counter-based random numbers with Random123's Philox.
#include "base/random.hpp"

#include <cmath>

#include "base/constants.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wpedantic"
#include <Random123/philox.h>
#pragma GCC diagnostic pop

namespace fiberfate {

std::array<double, 4> uniform4(std::uint64_t seed, RandomStream stream, RandomCounter counter) {
  using Generator = r123::Philox4x32;
  const Generator::ctr_type block = {
      {counter.first, counter.second, counter.third, static_cast<std::uint32_t>(stream)}};
  const Generator::key_type key = {
      {static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32U)}};
  const Generator::ctr_type bits = Generator()(block, key);
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) numbers[i] = (bits[i] + 0.5) * 0x1p-32;
  return numbers;
}

double uniform(std::uint64_t seed, RandomStream stream, RandomCounter counter) {
  return uniform4(seed, stream, counter)[0];
}

std::array<double, 2> normal2(std::uint64_t seed, RandomStream stream, RandomCounter counter) {
  const auto u = uniform4(seed, stream, counter);
  const double radius = std::sqrt(-2 * std::log(u[0]));
  return {radius * std::cos(2 * pi * u[1]), radius * std::sin(2 * pi * u[1])};
}

}  // namespace fiberfate
