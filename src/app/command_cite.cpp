// Prints what a paper says of a result.
#include "app/command_cite.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "app/study_registry.hpp"
#include "base/law_text.hpp"
#include "base/version.hpp"
#include "keys/case_file.hpp"
#include "keys/wrapped_text.hpp"
#include "results/result_folder.hpp"

namespace fiberfate {
namespace {

constexpr std::size_t text_width = 96;
constexpr std::size_t longest_value = 60;  // letters; longer lists are in case.resolved.toml

/// References, each once, numbered in the order in which the text names them.
class References {
 public:
  /// Gives the mark of sources that are separated by "; ": " [1, equation 5.7; 2]".
  std::string mark(const std::string& sources) {
    std::vector<std::string> marks;
    for (std::size_t begin = 0; begin < sources.size();) {
      const std::size_t end = std::min(sources.find("; ", begin), sources.size());
      marks.push_back(mark_of_one(sources.substr(begin, end - begin)));
      begin = end + 2;
    }
    return marks.empty() ? "" : fmt::format(" [{}]", fmt::join(marks, "; "));
  }

  void print() const {
    fmt::print("\nReferences\n");
    for (std::size_t i = 0; i < sources_.size(); ++i)
      fmt::print("{}", wrapped(fmt::format("[{}] {}", i + 1, sources_[i]), "  ", text_width));
  }

 private:
  /// Places in the thesis, "thesis equation 5.7", share one reference.
  std::string mark_of_one(const std::string& source) {
    const std::string short_name = "thesis ";
    if (source.starts_with(short_name))
      return fmt::format("{}, {}", number_of(thesis_title), source.substr(short_name.size()));
    return std::to_string(number_of(source));
  }

  std::size_t number_of(const std::string& source) {
    const auto found = std::ranges::find(sources_, source);
    if (found != sources_.end()) return static_cast<std::size_t>(found - sources_.begin()) + 1;
    sources_.push_back(source);
    return sources_.size();
  }

  std::vector<std::string> sources_;
};

std::string program() {
  return fmt::format("The fiberfate developers, fiberfate {} (2026), software, Apache-2.0", version);
}

/// The keys of a case beside those of a case with all defaults.
struct KeysBesideDefaults {
  explicit KeysBesideDefaults(const LoadedCase& loaded)
      : values(loaded.values), standard(loaded.kind->make()) {
    loaded.kind->describe(table, values);
    loaded.kind->describe(defaults, standard);
  }
  KeysBesideDefaults(const KeysBesideDefaults&) = delete;
  KeysBesideDefaults& operator=(const KeysBesideDefaults&) = delete;

  CaseValues values, standard;
  KeyTable table, defaults;
};

/// Finds the law that a key names; null where the key names none.
const NamedText* chosen_law(const Key& key) {
  const auto has_source = [](const NamedText& choice) { return !choice.source.empty(); };
  if (std::ranges::none_of(key.choices, has_source)) return nullptr;
  const std::string value = key.write(NumberStyle::friendly);
  for (const NamedText& choice : key.choices)
    if (value == '"' + choice.name + '"') return &choice;
  return nullptr;
}

/// Whether a key says how a run goes on the machine, not what it computes.
bool is_of_the_machine(const Key& key) {
  return key.section() == "run" || key.section() == "output";
}

std::string without_stop(std::string text) {
  if (text.ends_with('.')) text.pop_back();
  return text;
}

void print_laws(const KeyTable& table, References& references) {
  fmt::print("\nLaws\n");
  for (const Key& key : table.keys())
    if (const NamedText* law = chosen_law(key))
      fmt::print("{}", wrapped(fmt::format("{} = \"{}\": {}{}", without_numbers(key.name), law->name,
                                           without_stop(law->meaning), references.mark(law->source)),
                               "  ", text_width));
}

void print_values(const KeysBesideDefaults& keys) {
  fmt::print("\nValues other than the defaults\n");
  for (const Key& key : keys.table.keys()) {
    const std::string value = key.write(NumberStyle::friendly);
    const Key* same = keys.defaults.find(key.name);
    if (value.empty() || chosen_law(key) != nullptr || is_of_the_machine(key)) continue;
    if (same != nullptr && same->write(NumberStyle::friendly) == value) continue;
    fmt::print("  {} = {}\n", key.name, value.size() > longest_value ? "(in case.resolved.toml)" : value);
  }
}

void print_bibtex() {
  fmt::print(
      "\nBibTeX\n"
      "  @software{{fiberfate,\n"
      "    author  = {{{{The fiberfate developers}}}},\n"
      "    title   = {{fiberfate: what becomes of the fibers when a discontinuous-fiber composite is "
      "processed}},\n"
      "    version = {{{}}},\n"
      "    year    = {{2026}}\n"
      "  }}\n",
      version);
}

void cite_result(const std::string& folder, References& references) {
  const LoadedCase loaded = load_resolved_case(ResultFolder::open(folder).resolved_case(), case_kinds());
  const MethodText& method = study_of(loaded).method;
  const KeysBesideDefaults keys(loaded);
  const std::string computed = fmt::format("Computed with fiberfate {}{}, study {}.", version,
                                           references.mark(program()), loaded.kind->name);
  fmt::print("Method\n{}",
             wrapped(fmt::format("{}{} {}", method.sentence, references.mark(method.source), computed), "  ",
                     text_width));
  print_laws(keys.table, references);
  print_values(keys);
}

}  // namespace

int run_cite(const CiteOptions& options) {
  References references;
  if (options.folder.empty())
    fmt::print("{}", wrapped("A paper cites the program" + references.mark(program()) +
                                 "; 'fiberfate cite DIR' adds the method, laws and values of a result.",
                             "", text_width));
  else
    cite_result(options.folder, references);
  references.print();
  print_bibtex();
  return 0;
}

}  // namespace fiberfate
