// Appends frames of polylines or polygons to a VTKHDF file.
#include <algorithm>
#include <cassert>
#include <filesystem>
#include <numeric>
#include <utility>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/vtkhdf_file.hpp"
#include "io/vtkhdf_layout.hpp"

namespace fiberfate {
namespace {

using Compression = TableLayout::Compression;
using vtkhdf::Kind;
constexpr std::uint64_t step_chunk = 64;    // rows of the datasets that grow by one a frame
constexpr std::uint64_t data_chunk = 8192;  // rows of the datasets that grow by a population a frame

template <class T>
std::span<const T> view(const std::vector<T>& values) {
  return {values.data(), values.size()};
}

template <class T>
void append_one(Hdf5File& file, const std::string& name, T value) {
  file.append(name, std::span<const T>(&value, 1));
}

template <class Visit>
void visit_arrays(const PolyFrame& frame, const Visit& visit) {
  for (const FrameArray& array : frame.point_data) visit(Kind::point, array);
  for (const FrameArray& array : frame.cell_data) visit(Kind::cell, array);
  for (const FrameArray& array : frame.frame_data) visit(Kind::field, array);
}

void make_array(Hdf5File& file, Kind kind, const FrameArray& array) {
  const std::string name = vtkhdf::data(kind, array.name);
  std::visit(
      [&](const auto& values) {
        using Number = typename std::decay_t<decltype(values)>::value_type;
        const auto compression = std::is_integral_v<Number> ? Compression::deflate : Compression::none;
        file.make_table(name, {element_of<Number>(), array.components == 1 ? 0 : array.components,
                               kind == Kind::field ? step_chunk : data_chunk, compression});
      },
      array.values);
  file.write_text_attribute(name, "unit", array.unit);
  file.make_table(vtkhdf::data_offsets(kind, array.name), {Element::int64, 0, step_chunk});
}

void make_layout(Hdf5File& file, const PolyFrame& frame) {
  file.make_group(vtkhdf::root);
  const std::array<std::int64_t, 2> format_version = {2, 0};
  file.write_attribute(vtkhdf::root, "Version", std::span<const std::int64_t>(format_version));
  file.write_text_attribute(vtkhdf::root, "Type", "PolyData");
  file.make_table(vtkhdf::points, {Element::float64, 3, data_chunk});
  file.write_text_attribute(vtkhdf::points, "unit", "m");
  file.make_table(vtkhdf::point_counts, {Element::int64, 0, step_chunk});
  for (std::size_t t = 0; t < vtkhdf::topologies.size(); ++t) {
    const std::uint64_t chunk = t == vtkhdf::topology_of(frame.shape) ? data_chunk : step_chunk;
    file.make_table(vtkhdf::of(t, "Connectivity"), {Element::int64, 0, chunk, Compression::deflate});
    file.make_table(vtkhdf::of(t, "Offsets"), {Element::int64, 0, chunk, Compression::deflate});
    file.make_table(vtkhdf::of(t, "NumberOfCells"), {Element::int64, 0, step_chunk});
    file.make_table(vtkhdf::of(t, "NumberOfConnectivityIds"), {Element::int64, 0, step_chunk});
  }
  file.make_table(vtkhdf::values, {Element::float64, 0, step_chunk});
  file.write_text_attribute(vtkhdf::values, "unit", "s");
  for (const std::string& name : {vtkhdf::part_offsets, vtkhdf::part_counts, vtkhdf::point_offsets})
    file.make_table(name, {Element::int64, 0, step_chunk});
  for (const std::string& name : {vtkhdf::cell_offsets, vtkhdf::connectivity_offsets})
    file.make_table(name, {Element::int64, vtkhdf::topologies.size(), step_chunk});
  file.write_attribute<std::int64_t>(vtkhdf::steps, "NSteps", 0);
  visit_arrays(frame, [&](Kind kind, const FrameArray& array) { make_array(file, kind, array); });
}

using TopologyRow = std::array<std::int64_t, vtkhdf::topologies.size()>;

/// Where the geometry of a frame stands in the file.
struct GeometryPlace {
  std::int64_t part = 0;
  std::int64_t point = 0;
  TopologyRow cells{};
  TopologyRow connectivity{};
};

/// The place behind all geometry so far.
GeometryPlace next_place(const Hdf5File& file, std::size_t topology) {
  const auto rows = [&file](const std::string& name) { return static_cast<std::int64_t>(file.rows(name)); };
  GeometryPlace place;
  place.part = rows(vtkhdf::point_counts);
  place.point = rows(vtkhdf::points);
  // Every part has one more offset than it has cells.
  place.cells[topology] = rows(vtkhdf::of(topology, "Offsets")) - place.part;
  place.connectivity[topology] = rows(vtkhdf::of(topology, "Connectivity"));
  return place;
}

/// The place of the last frame's geometry.
GeometryPlace last_place(const Hdf5File& file) {
  const std::uint64_t last = file.rows(vtkhdf::values) - 1;
  const auto row = [&](const std::string& name) { return file.read_rows<std::int64_t>(name, {last, 1}); };
  GeometryPlace place;
  place.part = row(vtkhdf::part_offsets).front();
  place.point = row(vtkhdf::point_offsets).front();
  std::ranges::copy(row(vtkhdf::cell_offsets), place.cells.begin());
  std::ranges::copy(row(vtkhdf::connectivity_offsets), place.connectivity.begin());
  return place;
}

void append_offsets(Hdf5File& file, const PolyFrame& frame) {
  const GeometryPlace place = frame.geometry == FrameGeometry::own
                                  ? next_place(file, vtkhdf::topology_of(frame.shape))
                                  : last_place(file);
  append_one(file, vtkhdf::part_offsets, place.part);
  append_one(file, vtkhdf::part_counts, std::int64_t{1});
  append_one(file, vtkhdf::point_offsets, place.point);
  file.append(vtkhdf::cell_offsets, std::span<const std::int64_t>(place.cells));
  file.append(vtkhdf::connectivity_offsets, std::span<const std::int64_t>(place.connectivity));
  visit_arrays(frame, [&](Kind kind, const FrameArray& array) {
    append_one(file, vtkhdf::data_offsets(kind, array.name),
               static_cast<std::int64_t>(file.rows(vtkhdf::data(kind, array.name))));
  });
}

void append_topology(Hdf5File& file, const PolyFrame& frame) {
  std::vector<std::int64_t> connectivity = frame.connectivity;
  if (connectivity.empty()) {
    connectivity.resize(frame.points.size() / 3);
    std::iota(connectivity.begin(), connectivity.end(), 0);
  }
  for (std::size_t t = 0; t < vtkhdf::topologies.size(); ++t) {
    const bool empty = t != vtkhdf::topology_of(frame.shape);
    const std::vector<std::int64_t> offsets = empty ? std::vector<std::int64_t>{0} : frame.offsets;
    append_one(file, vtkhdf::of(t, "NumberOfCells"), static_cast<std::int64_t>(offsets.size()) - 1);
    append_one(file, vtkhdf::of(t, "NumberOfConnectivityIds"),
               static_cast<std::int64_t>(empty ? 0 : connectivity.size()));
    file.append(vtkhdf::of(t, "Offsets"), view(offsets));
    if (!empty) file.append(vtkhdf::of(t, "Connectivity"), view(connectivity));
  }
}

void append_frame(Hdf5File& file, const PolyFrame& frame) {
  append_offsets(file, frame);
  if (frame.geometry == FrameGeometry::own) {
    append_topology(file, frame);
    append_one(file, vtkhdf::point_counts, static_cast<std::int64_t>(frame.points.size() / 3));
    file.append(vtkhdf::points, view(frame.points));
  }
  visit_arrays(frame, [&](Kind kind, const FrameArray& array) {
    std::visit([&](const auto& values) { file.append(vtkhdf::data(kind, array.name), view(values)); },
               array.values);
  });
  append_one(file, vtkhdf::values, frame.time);
  file.write_attribute(vtkhdf::steps, "NSteps", static_cast<std::int64_t>(file.rows(vtkhdf::values)));
}

std::int64_t frames_in(const std::string& path) {
  return Hdf5File::open(path, Hdf5File::Access::read).read_attribute<std::int64_t>(vtkhdf::steps, "NSteps");
}

/// Copies the first frames of a file to a new one, frame by frame.
void copy_frames(const std::string& from, const std::string& to, std::int64_t count) {
  const VtkhdfReader reader(from);
  if (static_cast<std::int64_t>(reader.times().size()) < count)
    throw StorageError("cannot continue " + from + ": it has fewer frames than the checkpoint counts");
  Hdf5File file = Hdf5File::create(to);
  for (std::int64_t i = 0; i < count; ++i) {
    const PolyFrame frame = reader.read(i);
    if (i == 0) make_layout(file, frame);
    append_frame(file, frame);
  }
  file.close();
  sync_file(to);
}

}  // namespace

VtkhdfWriter::VtkhdfWriter(std::string path, std::int64_t kept_frames)
    : path_(std::move(path)), next_(path_ + ".next"), frames_(kept_frames) {
  std::filesystem::remove(next_);
  std::filesystem::remove(path_ + ".kept");
  if (kept_frames == 0) {
    std::filesystem::remove(path_);
  } else if (frames_in(path_) != kept_frames) {
    copy_frames(path_, next_, kept_frames);
    rename_file(next_, path_);
  }
}

void VtkhdfWriter::prepare_next(const PolyFrame& frame) {
  if (frames_ == 0) {
    Hdf5File file = Hdf5File::create(next_);
    make_layout(file, frame);
    file.close();
  } else if (!std::filesystem::exists(next_)) {
    copy_file(path_, next_);
  } else if (latest_) {
    Hdf5File file = Hdf5File::open(next_, Hdf5File::Access::read_write);
    append_frame(file, *latest_);
    file.close();
  }
  latest_.reset();
}

void VtkhdfWriter::append(const PolyFrame& frame) {
  assert(!frame.offsets.empty() &&
         (frame.connectivity.empty()
              ? frame.offsets.back() * 3 == static_cast<std::int64_t>(frame.points.size())
              : frame.offsets.back() == static_cast<std::int64_t>(frame.connectivity.size())));
  assert(frame.geometry == FrameGeometry::own || frames_ > 0);
  try {
    prepare_next(frame);
    Hdf5File file = Hdf5File::open(next_, Hdf5File::Access::read_write);
    append_frame(file, frame);
    file.close();
    sync_file(next_);
    if (frames_ == 0) {
      rename_file(next_, path_);
    } else {
      exchange_files(path_, next_);
      latest_ = frame;
    }
  } catch (const std::exception&) {
    std::error_code ignored;  // the first error is the one to report
    std::filesystem::remove(next_, ignored);
    throw;
  }
  ++frames_;
}

void VtkhdfWriter::finish() {
  std::filesystem::remove(next_);
}

}  // namespace fiberfate
