// Reads the reference tables of tests/reference.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Reads tests/reference/<name>.
inline nlohmann::json reference_table(const std::string& name) {
  std::ifstream file(std::string(FIBERFATE_SOURCE_DIR) + "/tests/reference/" + name);
  return nlohmann::json::parse(file);
}

/// Reads a row-major 3×3 tensor.
inline Mat3 matrix3(const nlohmann::json& numbers) {
  Mat3 tensor;
  for (int i = 0; i < 9; ++i) tensor(i / 3, i % 3) = numbers[static_cast<std::size_t>(i)].get<double>();
  return tensor;
}

/// Reads a row-major 6×6 tensor.
inline Mat6 matrix6(const nlohmann::json& numbers) {
  Mat6 tensor;
  for (int i = 0; i < 36; ++i) tensor(i / 6, i % 6) = numbers[static_cast<std::size_t>(i)].get<double>();
  return tensor;
}

}  // namespace fiberfate
