// The datasets of a VTKHDF 2 file; only sources of io include it.
//
// Source: VTK File Formats, "VTKHDF format specification", PolyData and temporal data, versions 2.0 to 2.2.
#pragma once

#include <array>
#include <string>

#include "io/poly_frame.hpp"

namespace fiberfate::vtkhdf {

/// The kinds of cells of PolyData, in the order of the columns of CellOffsets; fibers are Lines, parts
/// Polygons.
inline constexpr std::array<const char*, 4> topologies = {"Vertices", "Lines", "Polygons", "Strips"};
inline constexpr std::size_t lines = 1;
inline constexpr std::size_t polygons = 2;
inline constexpr std::size_t topology_of(CellShape shape) {
  return shape == CellShape::polyline ? lines : polygons;
}

inline const std::string root = "VTKHDF";
inline const std::string steps = "VTKHDF/Steps";
inline const std::string values = "VTKHDF/Steps/Values";
inline const std::string part_offsets = "VTKHDF/Steps/PartOffsets";
inline const std::string part_counts = "VTKHDF/Steps/NumberOfParts";
inline const std::string point_offsets = "VTKHDF/Steps/PointOffsets";
inline const std::string cell_offsets = "VTKHDF/Steps/CellOffsets";
inline const std::string connectivity_offsets = "VTKHDF/Steps/ConnectivityIdOffsets";
inline const std::string points = "VTKHDF/Points";
inline const std::string point_counts = "VTKHDF/NumberOfPoints";

/// The name of a dataset of one topology: "VTKHDF/Lines/Offsets".
inline std::string of(std::size_t topology, const char* dataset) {
  return root + '/' + topologies[topology] + '/' + dataset;
}

/// The kinds of arrays: at points, on polylines, on the whole frame.
enum class Kind { point, cell, field };
inline std::string name(Kind kind) {
  return kind == Kind::point ? "PointData" : kind == Kind::cell ? "CellData" : "FieldData";
}
inline std::string data(Kind kind, const std::string& array) {
  return root + '/' + name(kind) + '/' + array;
}
inline std::string data_offsets(Kind kind, const std::string& array) {
  return steps + '/' + name(kind) + "Offsets/" + array;
}

}  // namespace fiberfate::vtkhdf
