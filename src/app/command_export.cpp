// Writes a result in other formats.
#include "app/command_export.hpp"

#include "app/study_registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/csv_table.hpp"
#include "io/prism_file.hpp"
#include "io/vtkhdf_file.hpp"
#include "io/vtp_file.hpp"
#include "keys/case_file.hpp"
#include "results/fiber_frame.hpp"
#include "results/folder_record.hpp"
#include "results/result_folder.hpp"
#include "studies/molding/run.hpp"

namespace fiberfate {
namespace {

const std::vector<std::string> formats = {"vtp", "csv", "abaqus", "calculix"};

/// Lists every node of a frame, one row each; a table that cluster.file reads again.
CsvTable node_table(const PolyFrame& frame) {
  CsvTable table;
  table.columns = {"fiber", "birth_id", "birth_node", "radius_m", "x_m", "y_m", "z_m", "curvature_per_m"};
  table.values.resize(table.columns.size());
  const std::vector<double> birth = numbers_of(frame.cell_data, "birth_id");
  const std::vector<double> first = numbers_of(frame.cell_data, "birth_node");
  const std::vector<double> radius = numbers_of(frame.cell_data, "radius");
  const std::vector<double> curvature = numbers_of(frame.point_data, "curvature");
  for (std::size_t fiber = 0; fiber + 1 < frame.offsets.size(); ++fiber) {
    for (auto node = frame.offsets[fiber]; node < frame.offsets[fiber + 1]; ++node) {
      const std::size_t k = node;
      const double along = first[fiber] + static_cast<double>(node - frame.offsets[fiber]);
      const std::array<double, 8> row = {static_cast<double>(fiber),
                                         birth[fiber],
                                         along,
                                         radius[fiber],
                                         frame.points[3 * k],
                                         frame.points[3 * k + 1],
                                         frame.points[3 * k + 2],
                                         curvature[k]};
      for (std::size_t i = 0; i < row.size(); ++i) table.values[i].push_back(row[i]);
    }
  }
  return table;
}

void export_series(const VtkhdfReader& reader, const std::string& out) {
  std::vector<SeriesMember> members;
  std::string stem = "fibers";
  for (std::size_t i = 0; i < reader.times().size(); ++i) {
    const PolyFrame frame = reader.read(i);
    if (frame.shape == CellShape::polygon) stem = "part";
    members.push_back({reader.times()[i], fmt::format("{}_{:05}.vtp", stem, i)});
    write_vtp(out + '/' + members.back().file, frame);
  }
  write_pvd(fmt::format("{}/{}.pvd", out, stem), members);
}

/// Writes every .vtkhdf of a result: frames as a series of .vtp, properties as one, layers as .vtu.
void export_vtk(const VtkhdfReader& reader, const ResultFolder& folder, const std::string& out) {
  const std::string properties = folder.file("properties.vtkhdf"), layers = folder.file("layers.vtkhdf");
  export_series(reader, out);
  if (std::filesystem::exists(properties))
    write_vtp(out + "/properties.vtp", VtkhdfReader(properties).read(0));
  if (std::filesystem::exists(layers)) write_vtu(out + "/layers.vtu", read_prisms(layers));
}

/// Writes fibers_NNNNN.csv for every frame and frames.csv with their times and lattices.
void export_csv(const VtkhdfReader& reader, const std::string& out) {
  CsvTable frames;
  frames.columns = {"frame", "time_s", "h11_m", "h12_m", "h13_m", "h21_m",
                    "h22_m", "h23_m",  "h31_m", "h32_m", "h33_m"};
  frames.values.resize(frames.columns.size());
  for (std::size_t i = 0; i < reader.times().size(); ++i) {
    const PolyFrame frame = reader.read(i);
    write_csv(fmt::format("{}/fibers_{:05}.csv", out, i), node_table(frame));
    const std::vector<double> lattice = numbers_of(frame.frame_data, "lattice");
    frames.values[0].push_back(static_cast<double>(i));
    frames.values[1].push_back(frame.time);
    for (std::size_t k = 0; k < 9; ++k) frames.values[k + 2].push_back(lattice.at(k));
  }
  write_csv(out + "/frames.csv", frames);
}

/// Moves what was exported to where it is wanted; what the program did not make there stays, and refuses it.
void publish(const std::string& staged, const std::string& out) {
  namespace fs = std::filesystem;
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(staged)) names.push_back(entry.path().filename().string());
  const std::set<std::string> known = recorded_files(out);
  for (const std::string& name : names)
    if (fs::exists(out + '/' + name) && !known.contains(name)) refuse_unrecorded(out + '/' + name);
  for (const std::string& name : names) {
    record_file(out, name);
    rename_file(staged + '/' + name, out + '/' + name);
  }
}

/// A folder that is gone with all it holds when its owner is.
class TemporaryFolder {
 public:
  /// Makes a folder in a parent, which is gone again with it where it was made too and nothing else came
  /// there.
  TemporaryFolder(const std::string& parent, const std::string& name)
      : path_(parent + '/' + name), made_parent_(std::filesystem::exists(parent) ? "" : parent) {
    std::filesystem::create_directories(path_);
  }
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
    if (!made_parent_.empty()) std::filesystem::remove(made_parent_, ignored);
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_, made_parent_;
};

}  // namespace

int run_export(const ExportOptions& options) {
  if (std::find(formats.begin(), formats.end(), options.format) == formats.end()) {
    const std::string meant = nearest_word(options.format, formats);
    throw InputError(fmt::format("unknown export format '{}'", options.format),
                     meant.empty() ? fmt::format("the formats are {}", fmt::join(formats, ", "))
                                   : fmt::format("did you mean {}?", meant));
  }
  const ResultFolder folder = ResultFolder::open(options.folder);
  const LoadedCase loaded = load_resolved_case(folder.resolved_case(), case_kinds());
  const auto* molding = std::any_cast<MoldingCase>(&loaded.values);
  const bool structure = options.format == "abaqus" || options.format == "calculix";
  if (structure != (molding != nullptr) && options.format != "vtp")
    throw InputError(
        fmt::format("a result of the study {} has no export '{}'", loaded.kind->name, options.format),
        molding != nullptr ? "take vtp, abaqus or calculix; the tables of this study are CSV already"
                           : "take vtp or csv; abaqus and calculix are for filled parts");
  const std::string out = options.out.empty() ? folder.file("export_" + options.format) : options.out;
  const TemporaryFolder staged(out, ".fiberfate-export");
  std::string made;
  if (structure) {
    const auto solver = options.format == "abaqus" ? StructuralSolver::abaqus : StructuralSolver::calculix;
    export_structure(*molding, folder, staged.path(), solver);
    made = out + "/part.inp";
  } else {
    const VtkhdfReader reader(folder.frames());
    options.format == "vtp" ? export_vtk(reader, folder, staged.path()) : export_csv(reader, staged.path());
    made = fmt::format("{} frames in {}", reader.times().size(), out);
  }
  publish(staged.path(), out);
  fmt::print("{}\n", made);
  return 0;
}

}  // namespace fiberfate
