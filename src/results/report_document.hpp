// Declares the report document: sections of facts, curves, histograms, tables, fields, fibers and parts, and
// its rendering.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Numbers are in the unit that stands beside them; the page chooses a readable prefix for SI units ("m",
/// "s", "Pa", "Pa s", "N", "J", "W", "1/m"). NaN and infinity are shown as missing. A label "L_N" is set as L
/// with subscript N. docs/formats/report.md describes the JSON that this becomes.

/// Says whether an axis is linear or logarithmic.
enum class AxisScale { linear, logarithmic };

/// Names an axis and its unit.
struct ReportAxis {
  std::string label;
  std::string unit = {};  ///< empty when there is none
  AxisScale scale = AxisScale::linear;
};

/// Says how a curve is drawn.
enum class CurveStyle { line, dashed, points };

/// Holds a labelled value: text, a number or a tensor.
struct Fact {
  std::string label;
  std::variant<std::string, double, std::int64_t, Mat3> value;
  std::string unit = {};
  std::string note = {};
};

/// Lists labelled values.
struct FactsSection {
  std::string id;
  std::string title;
  std::vector<Fact> rows;
  std::string caption = {};
};

/// Holds one curve.
struct ReportSeries {
  std::string label;
  std::vector<double> values;
  CurveStyle style = CurveStyle::line;
  std::vector<double> x = {};     ///< its own x; empty: the section's
  std::vector<double> low = {};   ///< lower edge of a band; empty: none
  std::vector<double> high = {};  ///< upper edge of a band; empty: none
};

/// Shows curves over a common axis.
struct LinesSection {
  std::string id;
  std::string title;
  ReportAxis x;
  ReportAxis y;
  std::vector<double> x_values = {};  ///< x of all series that have none of their own
  std::vector<ReportSeries> series;
  std::string caption = {};
  enum class Scales { independent, equal } scales = Scales::independent;  ///< equal: for pictures of things
};

/// Holds the counts of one histogram.
struct HistogramFrame {
  std::string label;
  std::vector<double> values;  ///< one less than there are edges
};

/// Shows histograms with common bins, at several times.
struct HistogramSection {
  std::string id;
  std::string title;
  ReportAxis x;
  ReportAxis y;
  std::vector<double> edges;
  std::vector<HistogramFrame> frames;
  std::optional<HistogramFrame> reference = {};
  std::string caption = {};
};

/// Names a column of a table.
struct TableColumn {
  std::string label;
  std::string unit = {};
};

using TableCell = std::variant<std::string, double, std::int64_t>;

/// Shows numbers in columns.
struct TableSection {
  std::string id;
  std::string title;
  std::vector<TableColumn> columns;
  std::vector<std::vector<TableCell>> rows;
  std::string caption = {};
};

/// Shows a field over two axes.
struct HeatmapSection {
  std::string id;
  std::string title;
  ReportAxis x;
  ReportAxis y;
  std::vector<double> x_values;             ///< middles of the columns
  std::vector<double> y_values;             ///< middles of the rows
  std::vector<std::vector<double>> values;  ///< values[row][column]
  std::string label = {};                   ///< what the values are
  std::string unit = {};
  std::string caption = {};
};

/// Holds the fibers at one time; all lengths in m.
struct FiberFrame {
  double time_s = 0;
  Mat3 lattice = Mat3::Zero();  ///< columns are the lattice vectors; zero: there is no cell
  std::array<bool, 3> periodic = {true, true, true};
  std::vector<std::int32_t> offsets = {};  ///< node offsets, fibers + 1
  std::vector<float> points = {};          ///< nodes, xyz xyz …, unwrapped along a fiber
  std::vector<std::int32_t> birth = {};    ///< birth fiber, one a fiber
  std::vector<float> radius = {};          ///< one a fiber
};

/// Shows the cell in three dimensions over time.
struct FibersSection {
  std::string id;
  std::string title;
  std::vector<FiberFrame> frames;
  std::string caption = {};
};

/// Holds a field at the nodes of a part.
struct ShellField {
  std::string label;
  std::string unit = {};
  std::vector<std::vector<float>> frames = {};  ///< one a time of the section, or one that holds at all times
};

/// Says how a place on a part is marked.
enum class PlaceMark { gate, place, trap };

/// Names a place on a part.
struct ShellPlace {
  std::string label;
  PlaceMark mark = PlaceMark::place;
  Vec3 at = Vec3::Zero();  ///< m
};

/// Holds lines on a part, as pairs of points.
struct ShellLines {
  std::string label;
  std::vector<float> segments = {};  ///< xyz xyz a segment, m
};

/// Shows a part that fills, in three dimensions over time.
struct ShellSection {
  std::string id;
  std::string title;
  std::vector<float> points;            ///< nodes, xyz xyz …, m
  std::vector<std::int32_t> triangles;  ///< three nodes each
  std::vector<float> fill_time;         ///< one a node, s; NaN where the melt never comes
  std::vector<double> times;            ///< of the fields' frames, s
  std::vector<ShellField> fields;       ///< at least one
  std::vector<ShellPlace> places = {};
  std::vector<ShellLines> lines = {};
  std::string caption = {};
};

using ReportSection = std::variant<FactsSection, LinesSection, HistogramSection, TableSection, HeatmapSection,
                                   FibersSection, ShellSection>;

/// Holds what a report shows, from top to bottom.
struct ReportDocument {
  std::string title;
  std::string subtitle = {};
  std::string study = {};
  std::string version = {};
  std::string stop_reason = {};
  std::vector<ReportSection> sections = {};
};

/// Writes the document as JSON, schema 1.
[[nodiscard]] std::string write_report_json(const ReportDocument& document);

/// Renders the document as one HTML page that needs no other file and no network.
/// Raises InputError when fiberfate was built without the report.
[[nodiscard]] std::string render_report(const ReportDocument& document);

}  // namespace fiberfate
