// Lists the values of a summary.json.
#include "results/summary_values.hpp"

#include <nlohmann/json.hpp>

#include "io/atomic_file.hpp"

namespace fiberfate {

std::vector<std::pair<std::string, SummaryValue>> summary_values(const std::string& path) {
  const SummaryFile file(path);
  std::vector<std::pair<std::string, SummaryValue>> all;
  const auto document = nlohmann::ordered_json::parse(read_file(path));
  for (const auto& [key, value] : document.items()) {
    if (value.is_string()) all.emplace_back(key, value.get<std::string>());
    if (value.is_number_integer()) all.emplace_back(key, value.get<std::int64_t>());
    if (value.is_number_float()) all.emplace_back(key, value.get<double>());
    if (!value.is_array()) continue;
    if (const Mat3 tensor = file.tensor(key); tensor.allFinite())
      all.emplace_back(key, tensor);
    else if (std::vector<double> list = file.numbers(key); !list.empty())
      all.emplace_back(key, std::move(list));
  }
  return all;
}

}  // namespace fiberfate
