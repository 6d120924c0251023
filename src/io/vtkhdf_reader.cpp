// Reads frames of polylines or polygons from a VTKHDF file.
#include <algorithm>

#include "base/error.hpp"
#include "io/vtkhdf_file.hpp"
#include "io/vtkhdf_layout.hpp"

namespace fiberfate {
namespace {

using vtkhdf::Kind;

template <class T>
T value_at(const Hdf5File& file, const std::string& name, std::size_t row) {
  return file.read_rows<T>(name, {row, 1}).front();
}

/// Raises StorageError unless every cell is made of points that there are.
void require_whole(const PolyFrame& frame, const std::string& path) {
  const auto points = static_cast<std::int64_t>(frame.points.size() / 3);
  const auto corners =
      frame.shape == CellShape::polygon ? static_cast<std::int64_t>(frame.connectivity.size()) : points;
  const bool whole = std::is_sorted(frame.offsets.begin(), frame.offsets.end()) &&
                     frame.offsets.front() >= 0 && frame.offsets.back() <= corners &&
                     std::all_of(frame.connectivity.begin(), frame.connectivity.end(),
                                 [points](std::int64_t corner) { return corner >= 0 && corner < points; });
  if (!whole) throw StorageError("cannot read " + path + ": its cells have points that it does not hold");
}

FrameArray read_array(const Hdf5File& file, const std::string& name, RowRange range) {
  FrameArray array;
  array.unit = file.read_text_attribute(name, "unit");
  array.components = static_cast<int>(file.columns(name));
  switch (file.layout(name).element) {
    case Element::float64:
      array.values = file.read_rows<double>(name, range);
      break;
    case Element::float32:
      array.values = file.read_rows<float>(name, range);
      break;
    case Element::int32:
      array.values = file.read_rows<std::int32_t>(name, range);
      break;
    case Element::uint32:
      array.values = file.read_rows<std::uint32_t>(name, range);
      break;
    default:
      throw StorageError("cannot read " + file.path() + " (" + name + "): unexpected element type");
  }
  return array;
}

std::vector<FrameArray> read_arrays(const Hdf5File& file, Kind kind, std::size_t frame, std::uint64_t count) {
  std::vector<FrameArray> arrays;
  const std::string group = vtkhdf::root + '/' + vtkhdf::name(kind);
  if (!file.contains(group)) return arrays;
  for (const std::string& name : file.members(group)) {
    const auto first = value_at<std::int64_t>(file, vtkhdf::data_offsets(kind, name), frame);
    arrays.push_back(read_array(file, vtkhdf::data(kind, name), {static_cast<std::uint64_t>(first), count}));
    arrays.back().name = name;
  }
  return arrays;
}

}  // namespace

VtkhdfReader::VtkhdfReader(const std::string& path) : file_(Hdf5File::open(path, Hdf5File::Access::read)) {
  if (!file_.contains(vtkhdf::values) || file_.read_text_attribute(vtkhdf::root, "Type") != "PolyData")
    throw StorageError("cannot read " + path + ": it does not hold polylines or polygons over time");
  times_ = file_.read<double>(vtkhdf::values);
}

PolyFrame VtkhdfReader::read(std::size_t frame) const {
  PolyFrame result;
  result.time = times_.at(frame);
  const auto number_at = [&](const std::string& name, std::uint64_t row) {
    return static_cast<std::uint64_t>(value_at<std::int64_t>(file_, name, row));
  };
  const std::uint64_t part = number_at(vtkhdf::part_offsets, frame);
  if (frame > 0 && number_at(vtkhdf::part_offsets, frame - 1) == part)
    result.geometry = FrameGeometry::as_before;
  if (number_at(vtkhdf::of(vtkhdf::polygons, "NumberOfCells"), part) > 0) result.shape = CellShape::polygon;
  const std::size_t topology = vtkhdf::topology_of(result.shape);
  const auto first_of = [&](const std::string& name) {
    return static_cast<std::uint64_t>(file_.read_rows<std::int64_t>(name, {frame, 1})[topology]);
  };
  const std::uint64_t cells = number_at(vtkhdf::of(topology, "NumberOfCells"), part);
  const std::uint64_t points = number_at(vtkhdf::point_counts, part);
  result.points = file_.read_rows<double>(vtkhdf::points, {number_at(vtkhdf::point_offsets, frame), points});
  result.offsets = file_.read_rows<std::int64_t>(vtkhdf::of(topology, "Offsets"),
                                                 {first_of(vtkhdf::cell_offsets) + part, cells + 1});
  if (result.offsets.empty())
    throw StorageError("cannot read " + file_.path() + ": a frame has an impossible number of cells");
  if (result.shape == CellShape::polygon)
    result.connectivity = file_.read_rows<std::int64_t>(
        vtkhdf::of(topology, "Connectivity"),
        {first_of(vtkhdf::connectivity_offsets), static_cast<std::uint64_t>(result.offsets.back())});
  require_whole(result, file_.path());
  result.point_data = read_arrays(file_, Kind::point, frame, points);
  result.cell_data = read_arrays(file_, Kind::cell, frame, cells);
  result.frame_data = read_arrays(file_, Kind::field, frame, 1);
  return result;
}

}  // namespace fiberfate
