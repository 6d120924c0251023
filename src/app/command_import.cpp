// Turns the input decks of the published program into a case.
#include "app/command_import.hpp"

#include "app/study_registry.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "app/legacy/deck.hpp"
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "keys/case_file.hpp"

namespace fiberfate {
namespace {

namespace fs = std::filesystem;
constexpr const char* fibers_name = "fibers.csv";

std::string default_folder(const std::string& legacy_folder) {
  return fs::absolute(legacy_folder + "/.").parent_path().filename().string() + "_case";
}

CsvTable table_of(const std::vector<LegacyFiber>& fibers) {
  CsvTable table{{"fiber", "x_m", "y_m", "z_m"}, std::vector<std::vector<double>>(4)};
  for (std::size_t i = 0; i < fibers.size(); ++i) {
    for (const Vec3& node : fibers[i].nodes) {
      table.values[0].push_back(static_cast<double>(i));
      for (std::size_t axis = 0; axis < 3; ++axis)
        table.values[axis + 1].push_back(node[static_cast<Eigen::Index>(axis)]);
    }
  }
  return table;
}

std::string notes_of(const LegacyDeck& deck) {
  std::string text = fmt::format("{:<20} {:<24} {}\n", "legacy key", "value", "became");
  for (const LegacyNote& note : deck.notes)
    text += fmt::format("{:<20} {:<24} {}\n", note.key, note.value, note.outcome);
  return text;
}

void require_free(const std::string& folder, ImportOptions::Existing existing) {
  if (existing == ImportOptions::Existing::overwrite) return;
  for (const char* name : {"case.toml", fibers_name, "import.txt"}) {
    if (fs::exists(folder + '/' + name))
      throw InputError(fmt::format("{}/{} exists already", folder, name),
                       "name another folder, or add --overwrite");
  }
}

}  // namespace

int run_import(const ImportOptions& options) {
  const std::string out = options.out.empty() ? default_folder(options.legacy_folder) : options.out;
  require_free(out, options.existing);
  LegacyDeck deck = read_legacy_deck(options.legacy_folder);
  const std::string folder = fs::absolute(out).string();
  deck.values.sample.cluster.file = fibers_name;
  const Study& study = *find_study("shear_cell");
  fs::create_directories(folder);
  write_csv(folder + '/' + fibers_name, table_of(deck.fibers));
  replace_file(folder + "/case.toml", annotated_case(study, CaseValues(deck.values)));
  replace_file(folder + "/import.txt", notes_of(deck));
  // Values that the old program took and this one does not are told as for any case, at their line of
  // case.toml.
  const LoadedCase loaded = load_case(out + "/case.toml", case_kinds());
  fmt::print("{}", notes_of(deck));
  for (const std::string& warning : loaded.warnings) fmt::print("warning: {}\n", warning);
  fmt::print("{} fibers in {}/{}; run them with: fiberfate run {}/case.toml\n", deck.fibers.size(), out,
             fibers_name, out);
  return 0;
}

}  // namespace fiberfate
