// Reads fibers from files of several formats.
#include "results/fiber_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "io/delimited_table.hpp"
#include "io/vtkhdf_file.hpp"
#include "results/fiber_checkpoint.hpp"
#include "results/fiber_frame.hpp"
#include "results/legacy_positions.hpp"

namespace fiberfate {
namespace {

/// Shapes as a file gives them, and the cell where it gives one.
struct FiberShapes {
  std::vector<std::vector<Vec3>> fibers;
  std::vector<std::uint16_t> kinds;  ///< one a fiber; empty: all are of the first kind
  std::vector<int> lines = {};       ///< of the text where each begins; empty where the file is none
  std::optional<Cell> cell;
};

FiberShapes shapes_of(const FiberState& state) {
  FiberShapes shapes;
  shapes.cell = state.cell;
  shapes.kinds = state.material_id;
  for (const FiberIndex fiber : state.fibers()) {
    const std::span<const Vec3> nodes = state.positions(fiber);
    shapes.fibers.emplace_back(nodes.begin(), nodes.end());
  }
  return shapes;
}

FiberShapes shapes_of_table(const std::string& path) {
  const DelimitedTable table(path);
  const auto column = [&table](const char* name) { return table.numbers(table.column_named(name)); };
  const std::vector<double> fiber = column("fiber"), x = column("x_m"), y = column("y_m"), z = column("z_m");
  FiberShapes shapes;
  for (std::size_t row = 0; row < fiber.size(); ++row) {
    if (row == 0 || fiber[row] != fiber[row - 1]) {
      shapes.fibers.emplace_back();
      shapes.lines.push_back(table.line_of(row));
    }
    shapes.fibers.back().emplace_back(x[row], y[row], z[row]);
  }
  return shapes;
}

FiberShapes read_shapes(const std::string& path) {
  if (path.ends_with(".h5")) return shapes_of(read_checkpoint(path).state);
  if (path.ends_with(".vtkhdf")) {
    const VtkhdfReader reader(path);
    if (reader.times().empty()) throw StorageError(path + " holds no frames");
    return shapes_of(fibers_of(reader.read(reader.times().size() - 1)));
  }
  if (path.ends_with(".csv")) return shapes_of_table(path);
  FiberShapes shapes;
  for (LegacyFiber& fiber : read_legacy_positions(path)) shapes.fibers.push_back(std::move(fiber.nodes));
  return shapes;
}

void require_kinds(const std::string& path, const FiberShapes& shapes, std::size_t known) {
  const auto most = std::max_element(shapes.kinds.begin(), shapes.kinds.end());
  if (most == shapes.kinds.end() || *most < known) return;
  throw InputError(fmt::format("{} holds {} kinds of fibers, and {} are described", path, *most + 1, known),
                   "describe the others, in their order, with fibers.more_kinds");
}

}  // namespace

FiberState read_fiber_file(const std::string& path, const std::vector<FiberMaterial>& materials,
                           const std::optional<Vec3>& cell_size) {
  FiberShapes shapes;
  try {
    shapes = read_shapes(path);
  } catch (const StorageError& error) {
    throw InputError(error.what(),
                     "give a checkpoint.h5, result.vtkhdf, fibers.csv or Initial_Positions.txt");
  }
  if (shapes.fibers.empty()) throw InputError(path + " holds no fibers", "give a file with at least one");
  if (!shapes.cell && !cell_size) throw InputError(path + " does not tell its cell", "give cell.size");
  require_kinds(path, shapes, materials.size());
  FiberState state;
  state.materials = materials;
  state.cell = cell_size ? rectangular_cell(*cell_size) : *shapes.cell;
  for (std::size_t i = 0; i < shapes.fibers.size(); ++i) {
    try {
      append_fiber(state, {shapes.fibers[i], shapes.kinds.empty() ? std::uint16_t{0} : shapes.kinds[i]});
    } catch (const InputError& error) {
      const InputProblem& problem = error.problems().front();
      const int line = shapes.lines.empty() ? 0 : shapes.lines[i];
      throw InputError({{path, line, line > 0 ? 1 : 0, "", "",
                         fmt::format("fiber {}: {}", i + 1, problem.complaint), problem.remedy}});
    }
  }
  return state;
}

}  // namespace fiberfate
