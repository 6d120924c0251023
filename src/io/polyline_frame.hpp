// Holds polylines at one time with numbers at their points, on each of them and about them all.
#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace fiberfate {

/// Holds one named array of numbers that go with points, polylines or the whole frame.
struct FrameArray {
  std::string name;
  std::string unit;    ///< SI; "1" for a pure number
  int components = 1;  ///< numbers an entry
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::int32_t>, std::vector<std::uint32_t>>
      values;
};

/// Holds polylines at one time. Every frame of a file has the same arrays in the same order.
struct PolylineFrame {
  double time = 0;                    ///< s
  std::vector<double> points;         ///< x, y, z of every point, polyline after polyline, m
  std::vector<std::int64_t> offsets;  ///< first point of every polyline, and the number of points
  std::vector<FrameArray> point_data;
  std::vector<FrameArray> line_data;
  std::vector<FrameArray> frame_data;  ///< one entry each
};

}  // namespace fiberfate
