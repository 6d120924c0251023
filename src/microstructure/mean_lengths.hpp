// The two averages by which a length distribution is usually known.
#pragma once

#include <optional>
#include <string_view>

namespace fiberfate {

/// One of the averages.
enum class LengthMean { number_average, weight_average };
inline constexpr LengthMean length_means[] = {LengthMean::number_average, LengthMean::weight_average};

/// "L_N" or "L_W".
[[nodiscard]] constexpr const char* symbol(LengthMean mean) {
  return mean == LengthMean::number_average ? "L_N" : "L_W";
}
/// The average with a symbol; nothing where it is neither's.
[[nodiscard]] constexpr std::optional<LengthMean> length_mean_of(std::string_view text) {
  for (const LengthMean mean : length_means)
    if (text == symbol(mean)) return mean;
  return std::nullopt;
}

/// The averages of fiber lengths (thesis 2.5, 2.6).
struct MeanLengths {
  double number_average = 0;  ///< L_N = sum n L / sum n, m
  double weight_average = 0;  ///< L_W = sum n L^2 / sum n L, m

  [[nodiscard]] constexpr double at(LengthMean mean) const {
    return mean == LengthMean::number_average ? number_average : weight_average;
  }
};

}  // namespace fiberfate
