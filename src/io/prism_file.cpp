// Writes prisms. Source: VTK File Formats, "VTKHDF format specification", UnstructuredGrid, version 2.0.
#include "io/prism_file.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstdint>
#include <span>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/hdf5_file.hpp"

namespace fiberfate {
namespace {

template <class T>
void write_list(Hdf5File& file, const std::string& name, const std::vector<T>& values, int columns = 0) {
  file.write("VTKHDF/" + name, std::span<const T>(values), columns);
}

void write_cells(Hdf5File& file, const PrismMesh& prisms) {
  const std::vector<std::int64_t> connectivity = wedges_of(prisms);
  std::vector<std::int64_t> offsets;
  for (std::size_t first = 0; first <= connectivity.size(); first += wedge_points)
    offsets.push_back(static_cast<std::int64_t>(first));
  const auto cells = static_cast<std::int64_t>(offsets.size()) - 1;
  write_list(file, "NumberOfCells", std::vector<std::int64_t>{cells});
  write_list(file, "NumberOfConnectivityIds",
             std::vector<std::int64_t>{static_cast<std::int64_t>(connectivity.size())});
  write_list(file, "Connectivity", connectivity);
  write_list(file, "Offsets", offsets);
  write_list(file, "Types", std::vector<std::uint8_t>(cells, vtk_wedge));
}

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw StorageError(fmt::format("cannot read {}: {}", path, why));
}

}  // namespace

std::vector<std::int64_t> wedges_of(const PrismMesh& prisms) {
  const auto level_points = static_cast<std::int64_t>(prisms.points.size() / 3 / prisms.levels);
  std::vector<std::int64_t> connectivity;
  for (std::size_t level = 0; level + 1 < prisms.levels; ++level) {
    const std::int64_t below = static_cast<std::int64_t>(level) * level_points;
    for (const auto& [a, b, c] : prisms.triangles)
      for (const std::int64_t base : {below, below + level_points})
        for (const Index corner : {a, c, b}) connectivity.push_back(base + corner);
  }
  return connectivity;
}

PrismMesh read_prisms(const std::string& path) {
  const Hdf5File file = Hdf5File::open(path, Hdf5File::Access::read);
  if (file.read_text_attribute("VTKHDF", "Type") != "UnstructuredGrid") refuse(path, "it holds no prisms");
  PrismMesh prisms;
  prisms.points = file.read<double>("VTKHDF/Points");
  const auto wedges = file.read<std::int64_t>("VTKHDF/Connectivity");
  if (wedges.size() < wedge_points || wedges.size() % wedge_points != 0) refuse(path, "it holds no prisms");
  const std::int64_t level_points = wedges[3] - wedges[0];
  const auto points = static_cast<std::int64_t>(prisms.points.size() / 3);
  if (level_points <= 0 || points % level_points != 0 || points / level_points < 2)
    refuse(path, "its prisms are no stack");
  prisms.levels = static_cast<std::size_t>(points / level_points);
  const std::size_t triangles = wedges.size() / wedge_points / (prisms.levels - 1);
  for (std::size_t first = 0; first < triangles * wedge_points; first += wedge_points)
    prisms.triangles.push_back({static_cast<Index>(wedges[first]), static_cast<Index>(wedges[first + 2]),
                                static_cast<Index>(wedges[first + 1])});
  if (wedges_of(prisms) != wedges) refuse(path, "its prisms are no stack");
  for (const std::string& name : file.members("VTKHDF/PointData")) {
    const std::string whole = "VTKHDF/PointData/" + name;
    prisms.point_data.push_back({name, file.read_text_attribute(whole, "unit"),
                                 static_cast<int>(file.columns(whole)), file.read<double>(whole)});
  }
  return prisms;
}

void write_prisms(const std::string& path, const PrismMesh& prisms) {
  assert(prisms.levels > 1 && prisms.points.size() % (3 * prisms.levels) == 0);
  const std::string fresh = path + ".new";
  Hdf5File file = Hdf5File::create(fresh);
  file.make_group("VTKHDF");
  const std::array<std::int64_t, 2> format_version = {2, 0};
  file.write_attribute("VTKHDF", "Version", std::span<const std::int64_t>(format_version));
  file.write_text_attribute("VTKHDF", "Type", "UnstructuredGrid");
  write_list(file, "NumberOfPoints",
             std::vector<std::int64_t>{static_cast<std::int64_t>(prisms.points.size() / 3)});
  write_list(file, "Points", prisms.points, 3);
  file.write_text_attribute("VTKHDF/Points", "unit", "m");
  write_cells(file, prisms);
  for (const FrameArray& array : prisms.point_data) {
    const std::string name = "PointData/" + array.name;
    const int columns = array.components == 1 ? 0 : array.components;
    std::visit([&](const auto& values) { write_list(file, name, values, columns); }, array.values);
    file.write_text_attribute("VTKHDF/" + name, "unit", array.unit);
  }
  file.close();
  sync_file(fresh);
  rename_file(fresh, path);
}

}  // namespace fiberfate
