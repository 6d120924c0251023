// The report document: sections of facts, curves, histograms, tables, fields, fibers and parts, and
// its rendering.
#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/vector.hpp"

namespace fiberfate {

/// Numbers are in the unit that stands beside them; the page chooses a readable prefix for SI units ("m",
/// "s", "Pa", "Pa s", "N", "J", "W", "1/m"). NaN and infinity are shown as missing. A label "L_N" is set as L
/// with subscript N. docs/formats/report.md describes the JSON that this becomes.

/// Whether an axis is linear or logarithmic.
enum class AxisScale { linear, logarithmic };

/// An axis and its unit.
struct ReportAxis {
  std::string label;
  std::string unit = {};  ///< empty when there is none
  AxisScale scale = AxisScale::linear;
  std::vector<std::string> names = {};  ///< of places at 1, 2, 3, …; empty: numbers
};

/// Where a section stands on the page: with the picture on top, among the results or the charts (a wide one
/// takes both columns), or folded away. The page goes by the kind of a section that does not say.
enum class SectionRole { by_kind, picture, outcome, chart, wide, detail };

/// Whether a fact is among the few that a reader wants first.
enum class Prominence { ordinary, headline };

/// How a curve is drawn; filled: closed outlines, each ended by NaN.
enum class CurveStyle { line, dashed, points, filled };

/// What the legend of a chart tells beside names: values under the cursor and the last ones, or nothing.
enum class LegendValues { shown, none };

/// A labelled value: text, a number or a tensor.
struct Fact {
  std::string label;
  std::variant<std::string, double, std::int64_t, Mat3> value;
  std::string unit = {};
  std::string note = {};
  Prominence prominence = Prominence::ordinary;
};

/// Lists labelled values.
struct FactsSection {
  std::string id;
  std::string title;
  std::vector<Fact> rows;
  std::string caption = {};
  SectionRole role = SectionRole::by_kind;
};

/// What one run, or the mean of its replicas, has of a fact that is compared.
struct ComparedValue {
  std::variant<double, std::string> value;
  std::optional<std::array<double, 2>> ends = {};  ///< of replicas, the least and the largest
};

/// A fact of several runs.
struct ComparedFact {
  std::string label;
  std::vector<ComparedValue> values;  ///< one a run
  std::string unit = {};
  Prominence prominence = Prominence::ordinary;
};

/// Sets facts of several runs side by side.
struct ComparisonSection {
  std::string id;
  std::string title;
  std::vector<std::string> runs;
  std::vector<ComparedFact> rows;
  std::string caption = {};
  SectionRole role = SectionRole::by_kind;
};

/// One curve.
struct ReportSeries {
  std::string label;
  std::vector<double> values;
  CurveStyle style = CurveStyle::line;
  std::vector<double> x = {};      ///< its own x; empty: the section's
  std::vector<double> low = {};    ///< lower edge of a band, of points lower ends of bars; empty: none
  std::vector<double> high = {};   ///< upper edge or ends; empty: none
  std::optional<int> colour = {};  ///< number of its colour; not given: of its place in the list
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
  SectionRole role = SectionRole::by_kind;
  LegendValues legend = LegendValues::shown;
};

/// The counts of one histogram.
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
  std::vector<ReportSeries> curves = {};  ///< drawn over the bars, each with its own x
  SectionRole role = SectionRole::by_kind;
};

/// A column of a table.
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
  SectionRole role = SectionRole::by_kind;
};

/// How values of a field become colours; diverging: away from the middle of the range on both sides.
enum class ColourScale { sequential, diverging };

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
  SectionRole role = SectionRole::by_kind;
  std::optional<std::array<double, 2>> range = {};  ///< what the colours span; not given: the values
  ColourScale colours = ColourScale::sequential;
  enum class Cells { coloured, written } cells = Cells::coloured;  ///< written: with their values
  enum class Scales { independent, equal } scales = Scales::independent;
};

/// Where a cell of a field stands on its axes.
struct CellPlace {
  double x, y;
};
/// Adds a cell to a field that is given row after row.
void add_cell(HeatmapSection& section, const CellPlace& place, double value);

/// The fibers at one time; all lengths in m.
struct FiberFrame {
  double time_s = 0;
  Mat3 lattice = Mat3::Zero();  ///< columns are the lattice vectors; zero: there is no cell
  std::array<bool, 3> periodic = {true, true, true};
  std::optional<double> strain = {};       ///< shear strain since the start
  std::vector<std::int32_t> offsets = {};  ///< node offsets, fibers + 1
  std::vector<float> points = {};          ///< nodes, xyz xyz …, unwrapped along a fiber
  std::vector<std::int32_t> birth = {};    ///< birth fiber, one a fiber
  std::vector<float> radius = {};          ///< one a fiber
  std::vector<std::int32_t> birth_node =
      {};  ///< first node along the birth fiber, one a fiber; empty: unknown
};

/// When a hinge broke.
struct FiberBreak {
  double time_s = 0;
  std::int32_t birth = 0;  ///< birth fiber
  std::int32_t node = 0;   ///< node along it
};

/// How nodes are written: as float32, or as uint16 steps between the corners of each frame, half as large.
enum class NodeEncoding { exact, grid };

/// Shows the cell in three dimensions over time.
struct FibersSection {
  std::string id;
  std::string title;
  std::vector<FiberFrame> frames;
  std::string caption = {};
  std::optional<std::vector<FiberBreak>> breaks = {};  ///< not given: the page sees them between frames
  NodeEncoding encoding = NodeEncoding::exact;
};

/// A field at the nodes of a part.
struct ShellField {
  std::string label;
  std::string unit = {};
  std::vector<std::vector<float>> frames = {};  ///< one a time of the section, or one that holds at all times
};

/// How a place on a part is marked.
enum class PlaceMark { gate, place, trap };

/// A place on a part.
struct ShellPlace {
  std::string label;
  PlaceMark mark = PlaceMark::place;
  Vec3 at = Vec3::Zero();  ///< m
};

/// Lines on a part, as pairs of points.
struct ShellLines {
  std::string label;
  std::vector<float> segments = {};  ///< xyz xyz a segment, m
};

/// Symmetric tensors at the nodes of a part, 11 22 33 23 31 12 each.
struct ShellTensors {
  std::string label;
  std::vector<float> values = {};  ///< of the last time
};

/// Directions at places of a part; their length is their size.
struct ShellDirections {
  std::string label;
  std::string unit = {};
  std::vector<float> at = {};       ///< xyz, m
  std::vector<float> vectors = {};  ///< xyz
};

/// Profiles from the mid-plane to the wall at the last time.
struct ShellLayers {
  std::vector<double> heights = {};   ///< of the layers, over half of the thickness
  std::vector<float> thickness = {};  ///< at each node, m
  struct Field {
    std::string label;
    std::string unit = {};
    std::vector<float> values = {};  ///< layers of a node together
  };
  std::vector<Field> fields = {};
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
  std::vector<ShellTensors> tensors = {};
  std::vector<ShellDirections> directions = {};
  std::optional<ShellLayers> layers = {};
};

using ReportSection = std::variant<FactsSection, ComparisonSection, LinesSection, HistogramSection,
                                   TableSection, HeatmapSection, FibersSection, ShellSection>;

/// Adds facts to facts, or sections of one kind to others.
template <class Item, class Added>
void append(std::vector<Item>& items, std::vector<Added> more) {
  items.insert(items.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// What a report shows, from top to bottom.
struct ReportDocument {
  std::string title;           ///< what kind of report this is
  std::string case_name = {};  ///< of the case or its folder; the page's main heading
  std::string subtitle = {};
  std::string study = {};
  std::string version = {};
  std::string stop_reason = {};  ///< as in summary.json, "unfinished" where there is none
  std::vector<ReportSection> sections = {};
};

/// Writes the document as JSON, schema 2.
[[nodiscard]] std::string write_report_json(const ReportDocument& document);

/// Renders the document as one HTML page that needs no other file and no network.
/// Raises InputError when fiberfate was built without the report.
[[nodiscard]] std::string render_report(const ReportDocument& document);

}  // namespace fiberfate
