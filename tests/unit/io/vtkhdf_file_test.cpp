// Tests the layout of VTKHDF files against the specification and their survival.
#include "io/vtkhdf_file.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "unit/io/scratch_folder.hpp"

namespace fiberfate {
namespace {

using Access = Hdf5File::Access;
using Int64s = std::vector<std::int64_t>;

/// Two polylines of 2 and 3 points in even frames; three of 2, 2 and 2 points (one broke) in odd ones.
PolyFrame frame_at(int number) {
  PolyFrame frame;
  frame.time = 0.25 * number;
  frame.offsets = number % 2 == 0 ? Int64s{0, 2, 5} : Int64s{0, 2, 4, 6};
  const auto points = static_cast<std::size_t>(frame.offsets.back());
  std::vector<float> curvature;
  for (std::size_t i = 0; i < points; ++i) {
    for (int axis = 0; axis < 3; ++axis)
      frame.points.push_back(100.0 * number + 10.0 * static_cast<double>(i) + axis);
    curvature.push_back(static_cast<float>(number) + 0.5F * static_cast<float>(i));
  }
  std::vector<std::uint32_t> birth(frame.offsets.size() - 1);
  for (std::size_t i = 0; i < birth.size(); ++i)
    birth[i] = static_cast<std::uint32_t>(10 * number) + static_cast<std::uint32_t>(i);
  frame.point_data = {{"curvature", "1/m", 1, curvature}};
  frame.cell_data = {{"birth_id", "1", 1, birth}};
  frame.frame_data = {{"lattice", "m", 9, std::vector<double>(9, 1e-3 * number)}};
  return frame;
}

void expect_equal(const PolyFrame& a, const PolyFrame& b) {
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.offsets, b.offsets);
  EXPECT_EQ(a.point_data.at(0).values, b.point_data.at(0).values);
  EXPECT_EQ(a.cell_data.at(0).values, b.cell_data.at(0).values);
  EXPECT_EQ(a.frame_data.at(0).values, b.frame_data.at(0).values);
}

TEST(Vtkhdf, HasTheLayoutOfTheSpecification) {
  const ScratchFolder folder;
  VtkhdfWriter writer(folder / "r.vtkhdf", 0);
  for (int i = 0; i < 3; ++i) writer.append(frame_at(i));
  const Hdf5File file = Hdf5File::open(folder / "r.vtkhdf", Access::read);
  EXPECT_EQ(file.read_text_attribute("VTKHDF", "Type"), "PolyData");
  EXPECT_EQ(file.read_attribute<std::int64_t>("VTKHDF/Steps", "NSteps"), 3);
  EXPECT_EQ(file.read<double>("VTKHDF/Steps/Values"), (std::vector<double>{0, 0.25, 0.5}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/PartOffsets"), (Int64s{0, 1, 2}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/NumberOfParts"), (Int64s{1, 1, 1}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/PointOffsets"), (Int64s{0, 5, 11}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/CellOffsets"),
            (Int64s{0, 0, 0, 0, 0, 2, 0, 0, 0, 5, 0, 0}));
  EXPECT_EQ(file.columns("VTKHDF/Steps/CellOffsets"), 4U);
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/ConnectivityIdOffsets"),
            (Int64s{0, 0, 0, 0, 0, 5, 0, 0, 0, 11, 0, 0}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/NumberOfPoints"), (Int64s{5, 6, 5}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Lines/NumberOfCells"), (Int64s{2, 3, 2}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Lines/Offsets"), (Int64s{0, 2, 5, 0, 2, 4, 6, 0, 2, 5}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Lines/Connectivity"),
            (Int64s{0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4}));
  for (const std::string topology : {"Vertices", "Polygons", "Strips"}) {
    EXPECT_EQ(file.read<std::int64_t>("VTKHDF/" + topology + "/NumberOfCells"), (Int64s{0, 0, 0}));
    EXPECT_EQ(file.read<std::int64_t>("VTKHDF/" + topology + "/Offsets"), (Int64s{0, 0, 0}));
    EXPECT_EQ(file.rows("VTKHDF/" + topology + "/Connectivity"), 0U);
  }
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/PointDataOffsets/curvature"), (Int64s{0, 5, 11}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/CellDataOffsets/birth_id"), (Int64s{0, 2, 5}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/FieldDataOffsets/lattice"), (Int64s{0, 1, 2}));
  EXPECT_EQ(file.read_text_attribute("VTKHDF/Points", "unit"), "m");
}

TEST(Vtkhdf, GivesBackEveryFrame) {
  const ScratchFolder folder;
  VtkhdfWriter writer(folder / "r.vtkhdf", 0);
  for (int i = 0; i < 5; ++i) {
    writer.append(frame_at(i));
    // After every append the file is whole and has all frames so far.
    const VtkhdfReader reader(folder / "r.vtkhdf");
    ASSERT_EQ(reader.times().size(), static_cast<std::size_t>(i) + 1);
    for (int j = 0; j <= i; ++j) expect_equal(reader.read(static_cast<std::size_t>(j)), frame_at(j));
  }
  writer.finish();
  EXPECT_FALSE(std::filesystem::exists(folder / "r.vtkhdf.next"));
}

/// Two triangles that keep their place while a number at their points changes.
PolyFrame part_at(int number) {
  PolyFrame frame;
  frame.time = number;
  frame.shape = CellShape::polygon;
  frame.geometry = number == 0 ? FrameGeometry::own : FrameGeometry::as_before;
  frame.points = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  frame.offsets = {0, 3, 6};
  frame.connectivity = {0, 1, 2, 0, 2, 3};
  frame.point_data = {{"pressure", "Pa", 1, std::vector<float>(4, static_cast<float>(number))}};
  frame.cell_data = {{"region", "1", 1, std::vector<std::int32_t>{0, 1}}};
  frame.frame_data = {{"filled_share", "1", 1, std::vector<double>{0.5 * number}}};
  return frame;
}

TEST(Vtkhdf, KeepsOneCopyOfAGeometryThatStays) {
  const ScratchFolder folder;
  VtkhdfWriter(folder / "r.vtkhdf", 0).append(part_at(0));
  VtkhdfWriter writer(folder / "r.vtkhdf", 1);
  for (int i = 1; i < 4; ++i) writer.append(part_at(i));
  const Hdf5File file = Hdf5File::open(folder / "r.vtkhdf", Access::read);
  EXPECT_EQ(file.rows("VTKHDF/Points"), 4U);
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Polygons/Connectivity"), (Int64s{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Lines/NumberOfCells"), (Int64s{0}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/PartOffsets"), (Int64s{0, 0, 0, 0}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/PointOffsets"), (Int64s{0, 0, 0, 0}));
  EXPECT_EQ(file.read<std::int64_t>("VTKHDF/Steps/PointDataOffsets/pressure"), (Int64s{0, 4, 8, 12}));
  const VtkhdfReader reader(folder / "r.vtkhdf");
  ASSERT_EQ(reader.times().size(), 4U);
  for (int i = 0; i < 4; ++i) {
    const PolyFrame frame = reader.read(static_cast<std::size_t>(i));
    expect_equal(frame, part_at(i));
    EXPECT_EQ(frame.shape, CellShape::polygon);
    EXPECT_EQ(frame.geometry, part_at(i).geometry);
    EXPECT_EQ(frame.connectivity, part_at(i).connectivity);
  }
}

TEST(Vtkhdf, ContinuesFromAnyFrame) {
  const ScratchFolder folder;
  {
    VtkhdfWriter writer(folder / "r.vtkhdf", 0);
    for (int i = 0; i < 4; ++i) writer.append(frame_at(7));
  }
  {
    VtkhdfWriter first(folder / "r.vtkhdf", 0);
    for (int i = 0; i < 4; ++i) first.append(frame_at(i));
  }
  VtkhdfWriter writer(folder / "r.vtkhdf", 2);
  EXPECT_EQ(VtkhdfReader(folder / "r.vtkhdf").times().size(), 2U);
  for (int i = 2; i < 6; ++i) writer.append(frame_at(i));
  const VtkhdfReader reader(folder / "r.vtkhdf");
  ASSERT_EQ(reader.times().size(), 6U);
  for (int i = 0; i < 6; ++i) expect_equal(reader.read(static_cast<std::size_t>(i)), frame_at(i));
}

TEST(Vtkhdf, IgnoresACopyThatDiedWhileItWasWritten) {
  const ScratchFolder folder;
  {
    VtkhdfWriter writer(folder / "r.vtkhdf", 0);
    for (int i = 0; i < 3; ++i) writer.append(frame_at(i));
  }
  replace_file(folder / "r.vtkhdf.next", "torn");
  VtkhdfWriter writer(folder / "r.vtkhdf", 3);
  writer.append(frame_at(3));
  expect_equal(VtkhdfReader(folder / "r.vtkhdf").read(3), frame_at(3));
}

TEST(Vtkhdf, RefusesToContinueWithFramesThatAreNotThere) {
  const ScratchFolder folder;
  VtkhdfWriter(folder / "r.vtkhdf", 0).append(frame_at(0));
  EXPECT_THROW(VtkhdfWriter(folder / "r.vtkhdf", 2), StorageError);
}

}  // namespace
}  // namespace fiberfate
