// What the option --sweep asks for.
#include "app/sweep.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "base/error.hpp"
#include "base/trimmed.hpp"

namespace fiberfate {
namespace {

constexpr double most_runs = 10000;  ///< more are a slip
constexpr std::size_t longest_name = 80;

InputError refused(const std::string& text, const std::string& complaint, const std::string& remedy) {
  return InputError({{"command line", 0, 0, "--sweep", text, complaint, remedy}});
}

/// Cuts a text at the commas that stand in no quotes and no brackets.
std::vector<std::string> parts(const std::string& text) {
  std::vector<std::string> all(1);
  int depth = 0;
  char quote = '\0';
  for (const char c : text) {
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    }
    if (c == ',' && depth == 0 && quote == '\0')
      all.emplace_back();
    else
      all.back() += c;
  }
  for (std::string& one : all) one = std::string(trimmed(one));
  return all;
}

/// Writes an assignment so that it can name a folder: "flow.rate=10 1/s" is "rate=10_1_s".
std::string in_folder_name(const SweptKey& key, const std::string& value) {
  std::string name = key.key.substr(key.key.rfind('.') + 1) + '=';
  for (const char c : value) {
    if (c == '"' || c == '\'') continue;
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '.' || c == '+' || c == '-';
    name += plain ? c : '_';
  }
  return name;
}

void require_sound(const std::vector<SweptKey>& keys) {
  std::set<std::string> known;
  double runs = 1;
  for (const SweptKey& one : keys) {
    if (!known.insert(one.key).second)
      throw refused(one.key, "the key is given twice", "give all of its values at once");
    runs *= static_cast<double>(one.values.size());
  }
  if (runs > most_runs)
    throw refused(keys.back().key, fmt::format("the values combine to {:.6g} runs", runs),
                  fmt::format("give at most {:.0f}", most_runs));
}

}  // namespace

SweptKey read_swept_key(const std::string& text) {
  const std::size_t equals = text.find('=');
  SweptKey swept{std::string(trimmed(std::string_view(text).substr(0, equals))), {}};
  if (equals == std::string::npos || swept.key.empty())
    throw refused(text, "this is not a key with values",
                  "write --sweep key=value,value, for example --sweep diffusion.C_I=0.001,0.01");
  swept.values = parts(text.substr(equals + 1));
  if (std::ranges::any_of(swept.values, &std::string::empty))
    throw refused(text, "a value is missing", "write the values with one comma between them");
  return swept;
}

std::vector<SweepRun> sweep_runs(const std::vector<SweptKey>& keys) {
  require_sound(keys);
  std::vector<SweepRun> runs(1);
  for (const SweptKey& key : keys) {
    std::vector<SweepRun> longer;
    for (const SweepRun& before : runs) {
      for (const std::string& value : key.values) {
        longer.push_back(before);
        longer.back().folder += '_' + in_folder_name(key, value);
        longer.back().values.push_back(value);
        longer.back().changes.push_back(key.key + '=' + value);
      }
    }
    runs = std::move(longer);
  }
  const std::size_t digits = std::to_string(runs.size()).size();
  for (std::size_t i = 0; i < runs.size(); ++i)
    runs[i].folder = fmt::format("{:0{}}{}", i + 1, digits, runs[i].folder).substr(0, longest_name);
  return runs;
}

}  // namespace fiberfate
