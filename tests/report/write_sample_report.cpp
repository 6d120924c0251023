// Writes a report that has every kind of section, with awkward values, for the browser test:
// write_sample_report FILE.
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <vector>

#include "results/report_document.hpp"

namespace fiberfate {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

FactsSection make_facts() {
  Mat3 tensor;
  tensor << 0.7, 0.05, 0, 0.05, 0.2, 0, 0, 0, 0.1;
  return {.id = "facts",
          .title = "Facts </script> & <!-- comments",
          .rows = {{.label = "length", .value = 2.5e-3, .unit = "m"},
                   {.label = "fibers", .value = std::int64_t{2}},
                   {.label = "A_2", .value = tensor, .note = "a tensor"},
                   {.label = "file", .value = std::string("bad \xff byte")},
                   {.label = "missing", .value = nan, .unit = "Pa"}}};
}

LinesSection make_lines() {
  return {
      .id = "lines",
      .title = "Curves",
      .x = {.label = "time", .unit = "s"},
      .y = {.label = "step size", .unit = "s", .scale = AxisScale::logarithmic},
      .x_values = {0, 1, 2, 3},
      .series = {{.label = "dt",
                  .values = {1e-4, nan, 1e-5, 2e-5},
                  .low = {5e-5, nan, 5e-6, 1e-5},
                  .high = {2e-4, nan, 2e-5, 4e-5}},
                 {.label = "breaks", .values = {3e-5, 2e-5}, .style = CurveStyle::points, .x = {2.5, 0.5}}}};
}

HistogramSection make_histogram() {
  return {.id = "histogram",
          .title = "Histogram",
          .x = {.label = "length", .unit = "m"},
          .y = {.label = "fibers"},
          .edges = {0, 1e-3, 2e-3, 4e-3},
          .frames = {{"t = 0 s", {0, 0, 2}}, {"t = 1 s", {1, 2, 1}}},
          .reference = HistogramFrame{"theory", {1, 1.5, 0.5}}};
}

TableSection make_table() {
  return {.id = "table",
          .title = "Table",
          .columns = {{"phase"}, {"time", "s"}, {"calls"}},
          .rows = {{std::string("solve"), 1.25, std::int64_t{1000}},
                   {std::string("loads"), nan, std::int64_t{0}}}};
}

HeatmapSection make_heatmap() {
  return {.id = "heatmap",
          .title = "Heatmap",
          .x = {.label = "x", .unit = "m"},
          .y = {.label = "y", .unit = "m"},
          .x_values = {0, 1e-3, 2e-3},
          .y_values = {0, 1e-3},
          .values = {{1, 2, 3}, {4, nan, 6}},
          .label = "pressure",
          .unit = "Pa"};
}

/// Makes a quarter circle of radius 1 mm and a straight fiber; `pieces` of the latter share one birth fiber.
FiberFrame make_frame(double time, int pieces) {
  FiberFrame frame{.time_s = time, .lattice = Mat3::Identity() * 2e-3, .offsets = {0}};
  const auto add_node = [&](double x, double y, double z) {
    for (const double value : {x, y, z}) frame.points.push_back(static_cast<float>(value));
  };
  const auto end_fiber = [&](std::int32_t birth) {
    frame.offsets.push_back(static_cast<std::int32_t>(frame.points.size() / 3));
    frame.birth.push_back(birth);
    frame.radius.push_back(2e-5F);
  };
  for (int k = 0; k <= 8; ++k) add_node(1e-3 * std::cos(k * M_PI / 16), 1e-3 * std::sin(k * M_PI / 16), 5e-4);
  end_fiber(0);
  const int rods = 8 / pieces;
  for (int piece = 0; piece < pieces; ++piece) {
    for (int k = 0; k <= rods; ++k) add_node(2.5e-4 * (piece * rods + k), 1.5e-3, 1e-3);
    end_fiber(1);
  }
  return frame;
}

/// Makes a square of four triangles that fills from its middle; one corner stays empty.
ShellSection make_shell() {
  const float never = std::numeric_limits<float>::quiet_NaN();
  return {.id = "shell",
          .title = "Square",
          .points = {0, 0, 0, 0.1F, 0, 0, 0.1F, 0.1F, 0, 0, 0.1F, 0, 0.05F, 0.05F, 0.01F},
          .triangles = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4},
          .fill_time = {1, 1.5F, 2, never, 0},
          .times = {1, 2},
          .fields = {{"fill time", "s", {{1, 1.5F, 2, never, 0}}},
                     {"pressure", "Pa", {{0, 0, 0, 0, 1e6F}, {2e6F, 1e6F, 0, 0, 3e6F}}}},
          .places = {{"G1", PlaceMark::gate, {0.05, 0.05, 0.01}}, {"trap", PlaceMark::trap, {0, 0.1, 0}}},
          .lines = {{"weld lines", {0, 0, 0, 0.05F, 0.05F, 0.01F}}}};
}

}  // namespace
}  // namespace fiberfate

int main(int count, char** arguments) {
  using namespace fiberfate;
  if (count != 2) return EXIT_FAILURE;
  const ReportDocument document{
      .title = "Sample",
      .study = "shear_cell",
      .version = "0.1.0",
      .sections = {
          make_facts(), make_lines(), make_histogram(), make_table(), make_heatmap(),
          FibersSection{.id = "cell", .title = "The cell", .frames = {make_frame(0, 1), make_frame(0.5, 2)}},
          make_shell()}};
  std::ofstream file(arguments[1], std::ios::binary);
  file << render_report(document);
  return file.good() ? EXIT_SUCCESS : EXIT_FAILURE;
}
