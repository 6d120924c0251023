// Integrates the relaxation of lengths with the exponential, at one point or at many.
#include "continuum/length_relaxation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t block_size = 256;

LengthFlows part_of(const LengthFlows& flows, std::size_t begin, std::size_t count) {
  return {flows.rate.subspan(begin, count), flows.viscosity.subspan(begin, count),
          flows.compression.empty() ? flows.compression : flows.compression.subspan(begin, count)};
}

void relax_block(const RelaxationLaw& law, const LengthFlows& flows, double duration, std::size_t begin,
                 std::span<double> lengths) {
  const std::size_t points = flows.size();
  const std::size_t count = std::min(block_size, points - begin);
  std::array<double, block_size> rate_constants;
  std::array<double, block_size> equilibrium_lengths;
  law.evaluate(part_of(flows, begin, count), std::span(rate_constants).first(count),
               std::span(equilibrium_lengths).first(count));
  for (std::size_t i = 0; i < count; ++i) rate_constants[i] = std::expm1(-rate_constants[i] * duration);
  for (std::size_t row = begin; row < lengths.size(); row += points) {
    for (std::size_t i = 0; i < count; ++i) {
      const double length = lengths[row + i];
      const double excess = length - equilibrium_lengths[i];
      const double relaxed = std::max(equilibrium_lengths[i], length + excess * rate_constants[i]);
      lengths[row + i] = excess > 0 ? relaxed : length;
    }
  }
}

}  // namespace

double relax_length(double length, const LengthRelaxation& relaxation, double duration) {
  require_number("length", length, not_negative);
  require_number("duration", duration, not_negative);
  const double excess = length - relaxation.equilibrium_length;
  if (!(excess > 0) || duration == 0) return length;
  const double relaxed = length + excess * std::expm1(-relaxation.rate_constant * duration);
  return std::max(relaxation.equilibrium_length, relaxed);
}

void relax_lengths(const RelaxationLaw& law, const LengthFlows& flows, double duration,
                   std::span<double> lengths) {
  const std::size_t points = flows.size();
  require_number("duration", duration, not_negative);
  flows.check();
  require_numbers("lengths", lengths, not_negative);
  if (points == 0 || duration == 0) return;
  require_same_size("lengths", lengths.size(), lengths.size() / points * points);
  const auto blocks = static_cast<std::ptrdiff_t>((points + block_size - 1) / block_size);
  parallel_for(blocks,
               [&](std::size_t block) { relax_block(law, flows, duration, block * block_size, lengths); });
}

}  // namespace fiberfate
