// Writes prisms. Source: VTK File Formats, "VTKHDF format specification", UnstructuredGrid, version 2.0.
#include "io/prism_file.hpp"

#include <cassert>
#include <cstdint>
#include <span>

#include "io/atomic_file.hpp"
#include "io/hdf5_file.hpp"

namespace fiberfate {
namespace {

constexpr std::uint8_t wedge = 13;  // of VTK's cell types: two triangles, one over the other

template <class T>
void write_list(Hdf5File& file, const std::string& name, const std::vector<T>& values, int columns = 0) {
  file.write("VTKHDF/" + name, std::span<const T>(values), columns);
}

void write_cells(Hdf5File& file, const PrismMesh& prisms) {
  const auto level_points = static_cast<std::int64_t>(prisms.points.size() / 3 / prisms.levels);
  std::vector<std::int64_t> connectivity, offsets = {0};
  for (std::size_t level = 0; level + 1 < prisms.levels; ++level) {
    const std::int64_t below = static_cast<std::int64_t>(level) * level_points;
    for (const auto& [a, b, c] : prisms.triangles) {
      // VTK's wedge has its first triangle's normal pointing out of it, away from the second.
      for (const std::int64_t base : {below, below + level_points})
        for (const Index corner : {a, c, b}) connectivity.push_back(base + corner);
      offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
    }
  }
  const auto cells = static_cast<std::int64_t>(offsets.size()) - 1;
  write_list(file, "NumberOfCells", std::vector<std::int64_t>{cells});
  write_list(file, "NumberOfConnectivityIds",
             std::vector<std::int64_t>{static_cast<std::int64_t>(connectivity.size())});
  write_list(file, "Connectivity", connectivity);
  write_list(file, "Offsets", offsets);
  write_list(file, "Types", std::vector<std::uint8_t>(cells, wedge));
}

}  // namespace

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
