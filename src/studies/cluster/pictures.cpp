// Draws maps of the density and a cut.
#include "studies/cluster/pictures.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <limits>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "fibers/density_map.hpp"
#include "fibers/observables.hpp"

namespace fiberfate {
namespace {

constexpr std::array<const char*, 3> axis_names = {"x", "y", "z"};
constexpr int density_bins = 20;
constexpr int ellipse_sides = 14;
constexpr double fine = 1e-8;  // m; pictures need no more digits, and pages are shorter

/// A cut through the cell: its direction, and the two that span it.
struct Cut {
  int along, across, up;
};

double rounded(double length) {
  return fine * std::round(length / fine);
}

/// Adds the ellipse in which a plane across `along` cuts a cylinder; a cylinder that lies nearly in the plane
/// is cut no further than it is long.
void append_ellipse(ReportSeries& outlines, const Cut& cut, const Vec3& at, const Vec3& rod, double radius) {
  const double length = rod.norm(), along = std::abs(rod[cut.along]) / length;
  const double semi = std::min(radius / std::max(along, 1e-6), radius + 0.5 * length);
  double u = rod[cut.across], v = rod[cut.up];
  const double flat = std::hypot(u, v);
  if (flat > 0) {
    u /= flat;
    v /= flat;
  } else {
    u = 1;
  }
  for (int k = 0; k <= ellipse_sides; ++k) {
    const double angle = 2 * pi * k / ellipse_sides;
    const double far = semi * std::cos(angle), wide = radius * std::sin(angle);
    outlines.x.push_back(rounded(at[cut.across] + far * u - wide * v));
    outlines.values.push_back(rounded(at[cut.up] + far * v + wide * u));
  }
  outlines.x.push_back(outlines.x.back());
  outlines.values.push_back(std::numeric_limits<double>::quiet_NaN());
}

/// Where a rod passes the middle of the cell or of one of its images, it is brought into the cell.
void append_crossings(ReportSeries& outlines, const FiberState& state, const Cut& cut, const Vec3& from,
                      const Vec3& rod, double radius) {
  const Mat3 inverse = state.cell.lattice.inverse();
  const Vec3 start = inverse * from, step = inverse * rod;
  const double first = start[cut.along] - 0.5, last = first + step[cut.along];
  const bool periodic = state.cell.boundary[static_cast<std::size_t>(cut.along)] == Boundary::periodic;
  for (double plane = std::ceil(std::min(first, last)); plane < std::max(first, last); ++plane) {
    if (!periodic && plane != 0) continue;
    Vec3 place = start + (plane - first) / (last - first) * step;
    for (const int i : {0, 1, 2})
      if (state.cell.boundary[static_cast<std::size_t>(i)] == Boundary::periodic)
        place[i] -= std::floor(place[i]);
    append_ellipse(outlines, cut, state.cell.lattice * place, rod, radius);
  }
}

ReportSeries outline(const Cell& cell, const Cut& cut) {
  ReportSeries border{"cell", {}, CurveStyle::dashed};
  const Vec3 first = cell.lattice.col(cut.across), second = cell.lattice.col(cut.up);
  for (const Vec3& corner : {Vec3(Vec3::Zero()), first, Vec3(first + second), second, Vec3(Vec3::Zero())}) {
    border.x.push_back(corner[cut.across]);
    border.values.push_back(corner[cut.up]);
  }
  return border;
}

/// The direction in which most fibers lie.
Cut cut_across(const FiberState& state) {
  const Vec3 shares = orientation_tensor(state, Weighting::length).diagonal();
  int along = 0;
  shares.maxCoeff(&along);
  const auto [across, up] = other_directions(along);
  return {along, across, up};
}

}  // namespace

CsvTable density_table(const FiberState& state) {
  CsvTable table{{"along", "across_m", "up_m", "volume_fraction"}};
  for (const int along : {0, 1, 2}) {
    const DensityMap map = density_map(state, along, density_bins);
    const double width = state.cell.lattice.col(map.across).norm() / map.bins,
                 height = state.cell.lattice.col(map.up).norm() / map.bins;
    for (int row = 0; row < map.bins; ++row)
      for (int column = 0; column < map.bins; ++column)
        table.append({static_cast<double>(along), (column + 0.5) * width, (row + 0.5) * height,
                      map.volume_fraction[static_cast<std::size_t>(row * map.bins + column)]});
  }
  return table;
}

std::vector<HeatmapSection> density_sections(const ResultFolder& folder) {
  if (!std::filesystem::exists(folder.file("density.csv"))) return {};
  const CsvTable table = read_rows(folder.file("density.csv"));
  double densest = 0;
  for (const double share : table.column("volume_fraction")) densest = std::max(densest, 100 * share);
  std::vector<HeatmapSection> sections;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const auto along = static_cast<std::size_t>(table.column("along")[k]);
    if (along > 2) throw StorageError("density.csv names a direction that a cell does not have");
    const auto [across, up] = other_directions(static_cast<int>(along));
    if (sections.empty() || table.column("along")[k] != table.column("along")[k - 1]) {
      sections.push_back({fmt::format("density_{}", axis_names[along]),
                          fmt::format("Density seen along {}", axis_names[along]),
                          {axis_names[static_cast<std::size_t>(across)], "m"},
                          {axis_names[static_cast<std::size_t>(up)], "m"},
                          {},
                          {},
                          {}});
      sections.back().label = "volume fraction";
      sections.back().unit = "%";
      sections.back().range = {0, densest};
      sections.back().scales = HeatmapSection::Scales::equal;
      sections.back().caption = "Mean over columns through the whole cell; all maps have one scale.";
    }
    add_cell(sections.back(), {table.column("across_m")[k], table.column("up_m")[k]},
             100 * table.column("volume_fraction")[k]);
  }
  return sections;
}

LinesSection cut_section(const FiberState& state) {
  const Cut cut = cut_across(state);
  LinesSection section{"cut",
                       fmt::format("A cut across {}", axis_names[static_cast<std::size_t>(cut.along)]),
                       {axis_names[static_cast<std::size_t>(cut.across)], "m"},
                       {axis_names[static_cast<std::size_t>(cut.up)], "m"},
                       {},
                       {{"fibers", {}, CurveStyle::filled}}};
  for (const FiberIndex fiber : state.fibers()) {
    const std::span<const Vec3> nodes = state.positions(fiber);
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i)
      append_crossings(section.series.front(), state, cut, nodes[i], nodes[i + 1] - nodes[i],
                       state.material(fiber).radius);
  }
  section.series.push_back(outline(state.cell, cut));
  section.scales = LinesSection::Scales::equal;
  section.legend = LegendValues::none;
  section.caption = "Through the middle of the cell, as a polished section shows it.";
  return section;
}

}  // namespace fiberfate
