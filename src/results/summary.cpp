// Writes and reads summary.json.
#include "results/summary.hpp"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "base/version.hpp"
#include "fibers/observables.hpp"
#include "io/atomic_file.hpp"

namespace fiberfate {
namespace {

using Json = nlohmann::ordered_json;
constexpr int indent = 2;

Json json_of(const Mat3& tensor) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({tensor(i, 0), tensor(i, 1), tensor(i, 2)});
  return rows;
}

Json json_of(const SummaryValue& value) {
  return std::visit(
      [](const auto& one) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(one)>, Mat3>)
          return json_of(one);
        else
          return one;
      },
      value);
}

Json timings_of(const PhaseTimes& times) {
  Json timings;
  for (std::size_t phase = 0; phase < phase_count; ++phase)
    timings[phase_names[phase]] = times.seconds(static_cast<Phase>(phase));
  return timings;
}

/// Gives the numbers of a list; none where it is no list or holds something else.
std::vector<double> numbers_in(const Json& json) {
  const bool all = json.is_array() &&
                   std::all_of(json.begin(), json.end(), [](const Json& one) { return one.is_number(); });
  return all ? json.get<std::vector<double>>() : std::vector<double>{};
}

}  // namespace

std::string key_part(const std::string& name) {
  std::string part;
  for (const char letter : name) part += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  return part;
}

void describe_fibers(RunSummary& summary, const FiberState& state) {
  const MeanLengths lengths = mean_lengths(state);
  summary.simulated_s = state.time;
  summary.steps = state.step;
  summary.rods = state.rod_count();
  summary.fibers = state.fiber_count();
  summary.number_average = lengths.number_average;
  summary.weight_average = lengths.weight_average;
  summary.orientation = orientation_tensor(state, Weighting::length);
  summary.breaks = state.breaks;
  summary.volume_fraction = volume_fraction(state);
}

void write_summary(const std::string& path, const RunSummary& summary) {
  Json json;
  const auto put = [&json](const char* key, const auto& value) {
    if (value) json[key] = json_of(SummaryValue(*value));
  };
  json["study"] = summary.study;
  json["version"] = version;
  json["stop_reason"] = name(summary.stop_reason);
  if (summary.seed) json["seed"] = *summary.seed;
  json["threads"] = thread_count();
  json["ranks"] = 1;
  put("simulated_s", summary.simulated_s);
  put("steps", summary.steps);
  json["wall_s"] = summary.wall_s;
  json["cpu_s"] = summary.cpu_s;
  put("rods", summary.rods);
  put("fibers", summary.fibers);
  put("segment_steps_per_s", summary.segment_steps_per_s);
  json["peak_memory_bytes"] = peak_memory_bytes();
  put("L_N_m", summary.number_average);
  put("L_W_m", summary.weight_average);
  put("A2", summary.orientation);
  put("breaks", summary.breaks);
  put("volume_fraction", summary.volume_fraction);
  put("max_overlap_radii", summary.max_overlap);
  if (summary.timings) json["timings"] = timings_of(*summary.timings);
  for (const auto& [key, value] : summary.own) json[key] = json_of(value);
  replace_file(path, json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n');
}

/// The parsed file, so that the header need not know the JSON library.
struct SummaryFile::Document {
  Json json;
};

SummaryFile::SummaryFile(const std::string& path) : document_(std::make_unique<Document>()) {
  try {
    document_->json = Json::parse(read_file(path));
  } catch (const Json::exception& error) {  // faults of its text, and numbers beyond what a double holds
    throw StorageError("cannot read " + path + ": " + error.what());
  }
  if (!document_->json.is_object())
    throw StorageError("cannot read " + path + ": it holds no values by name");
}
SummaryFile::SummaryFile(SummaryFile&&) noexcept = default;
SummaryFile& SummaryFile::operator=(SummaryFile&&) noexcept = default;
SummaryFile::~SummaryFile() = default;

std::optional<SummaryFile> read_summary(const std::string& path) {
  if (!std::filesystem::exists(path)) return std::nullopt;
  return SummaryFile(path);
}

double SummaryFile::number(const std::string& key) const {
  const auto found = document_->json.find(key);
  return found != document_->json.end() && found->is_number() ? found->get<double>()
                                                              : std::numeric_limits<double>::quiet_NaN();
}

std::int64_t SummaryFile::count(const std::string& key) const {
  const auto found = document_->json.find(key);
  return found != document_->json.end() && found->is_number() ? found->get<std::int64_t>() : 0;
}

std::string SummaryFile::text(const std::string& key) const {
  const auto found = document_->json.find(key);
  return found != document_->json.end() && found->is_string() ? found->get<std::string>() : std::string();
}

Mat3 SummaryFile::tensor(const std::string& key) const {
  Mat3 tensor = Mat3::Constant(std::numeric_limits<double>::quiet_NaN());
  const auto found = document_->json.find(key);
  if (found == document_->json.end() || !found->is_array() || found->size() != 3) return tensor;
  for (int i = 0; i < 3; ++i) {
    const std::vector<double> row = numbers_in((*found)[i]);
    if (row.size() == 3) tensor.row(i) = Vec3(row[0], row[1], row[2]).transpose();
  }
  return tensor;
}

std::vector<double> SummaryFile::numbers(const std::string& key) const {
  const auto found = document_->json.find(key);
  return found == document_->json.end() ? std::vector<double>{} : numbers_in(*found);
}

std::vector<std::pair<std::string, SummaryValue>> SummaryFile::values() const {
  std::vector<std::pair<std::string, SummaryValue>> all;
  for (const auto& [key, value] : document_->json.items()) {
    if (value.is_string()) all.emplace_back(key, value.get<std::string>());
    if (value.is_number_integer()) all.emplace_back(key, value.get<std::int64_t>());
    if (value.is_number_float()) all.emplace_back(key, value.get<double>());
    if (!value.is_array()) continue;
    if (const Mat3 entries = tensor(key); entries.allFinite())
      all.emplace_back(key, entries);
    else if (std::vector<double> list = numbers(key); !list.empty())
      all.emplace_back(key, std::move(list));
  }
  return all;
}

std::vector<double> SummaryFile::timings() const {
  std::vector<double> seconds;
  const auto timings = document_->json.find("timings");
  if (timings == document_->json.end() || !timings->is_object()) return seconds;
  for (const char* phase : phase_names) {
    const auto found = timings->find(phase);
    seconds.push_back(found != timings->end() && found->is_number() ? found->get<double>() : 0.0);
  }
  return seconds;
}

}  // namespace fiberfate
