// Polylines or triangles at one time with numbers at their points, on each of them and about them all.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace fiberfate {

/// One named array of numbers that go with points, cells or the whole frame.
struct FrameArray {
  std::string name;
  std::string unit;    ///< SI; "1" for a pure number
  int components = 1;  ///< numbers an entry
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>, std::vector<std::uint32_t>>
      values;
};

/// What the cells of a frame are.
enum class CellShape { polyline, polygon };

/// Whether a frame has points and cells of its own or those of the frame before, of which a file keeps
/// one copy.
enum class FrameGeometry { own, as_before };

/// Polylines or polygons at one time. Every frame of a file has the same shape and the same arrays in
/// the same order.
struct PolyFrame {
  double time = 0;  ///< s
  CellShape shape = CellShape::polyline;
  FrameGeometry geometry = FrameGeometry::own;
  std::vector<double> points;              ///< x, y, z of every point, m
  std::vector<std::int64_t> offsets;       ///< first entry of every cell in `connectivity`, and their number
  std::vector<std::int64_t> connectivity;  ///< points of the cells; empty: every point once, in order
  std::vector<FrameArray> point_data;
  std::vector<FrameArray> cell_data;
  std::vector<FrameArray> frame_data;  ///< one entry each
};

}  // namespace fiberfate
