// Writes a report document as JSON and puts it into the page's template.
#include "results/report_document.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <string_view>

#include "base/error.hpp"
#include "results/base64.hpp"
#include "results/report_template.hpp"

namespace fiberfate {
namespace {

using Json = nlohmann::ordered_json;

static_assert(std::endian::native == std::endian::little, "the document holds little-endian numbers");

/// What the template holds where the document goes.
constexpr std::string_view marker = "\"@FIBERFATE_DOCUMENT@\"";

void add_text(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) json[key] = text;
}

void add_values(Json& json, const char* key, const std::vector<double>& values) {
  if (!values.empty()) json[key] = values;
}

Json write_tensor(const Mat3& tensor) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back({tensor(i, 0), tensor(i, 1), tensor(i, 2)});
  return rows;
}

Json write_axis(const ReportAxis& axis) {
  Json json{{"label", axis.label}, {"scale", axis.scale == AxisScale::logarithmic ? "log" : "linear"}};
  add_text(json, "unit", axis.unit);
  if (!axis.names.empty()) json["names"] = axis.names;
  return json;
}

const char* name_of(SectionRole role) {
  constexpr std::array names = {"", "picture", "outcome", "chart", "wide", "detail"};
  return names[static_cast<std::size_t>(role)];
}

const char* name_of(CurveStyle style) {
  switch (style) {
    case CurveStyle::dashed:
      return "dashed";
    case CurveStyle::points:
      return "points";
    case CurveStyle::filled:
      return "filled";
    case CurveStyle::line:
      break;
  }
  return "line";
}

template <class Section>
Json start_section(const char* kind, const Section& section) {
  Json json{{"kind", kind}, {"id", section.id}, {"title", section.title}};
  add_text(json, "caption", section.caption);
  if constexpr (requires { section.role; }) add_text(json, "role", name_of(section.role));
  return json;
}

template <class Number>
std::string encode(const std::vector<Number>& values) {
  return encode_base64(std::as_bytes(std::span(values)));
}

/// Writes a fact's value or a table's cell.
struct ValueWriter {
  Json operator()(const std::string& text) const { return text; }
  Json operator()(double number) const { return number; }
  Json operator()(std::int64_t number) const { return number; }
  Json operator()(const Mat3& tensor) const { return write_tensor(tensor); }
};

Json write_section(const FactsSection& section) {
  Json json = start_section("facts", section);
  json["rows"] = Json::array();
  for (const Fact& fact : section.rows) {
    Json row{{"label", fact.label}, {"value", std::visit(ValueWriter{}, fact.value)}};
    add_text(row, "unit", fact.unit);
    add_text(row, "note", fact.note);
    if (fact.prominence == Prominence::headline) row["headline"] = true;
    json["rows"].push_back(std::move(row));
  }
  return json;
}

Json write_compared(const ComparedFact& fact) {
  Json row{{"label", fact.label}, {"values", Json::array()}};
  add_text(row, "unit", fact.unit);
  if (fact.prominence == Prominence::headline) row["headline"] = true;
  for (const ComparedValue& one : fact.values) {
    row["values"].push_back(std::visit(ValueWriter{}, one.value));
    row["low"].push_back(one.ends ? Json((*one.ends)[0]) : Json());
    row["high"].push_back(one.ends ? Json((*one.ends)[1]) : Json());
  }
  if (std::ranges::none_of(fact.values, [](const ComparedValue& one) { return one.ends.has_value(); })) {
    row.erase("low");
    row.erase("high");
  }
  return row;
}

Json write_section(const ComparisonSection& section) {
  Json json = start_section("comparison", section);
  json["runs"] = section.runs;
  json["rows"] = Json::array();
  for (const ComparedFact& fact : section.rows) json["rows"].push_back(write_compared(fact));
  return json;
}

Json write_series(const std::vector<ReportSeries>& all) {
  Json json = Json::array();
  for (const ReportSeries& series : all) {
    Json entry{{"label", series.label}, {"values", series.values}, {"style", name_of(series.style)}};
    add_values(entry, "x", series.x);
    add_values(entry, "low", series.low);
    add_values(entry, "high", series.high);
    if (series.colour) entry["colour"] = *series.colour;
    json.push_back(std::move(entry));
  }
  return json;
}

Json write_section(const LinesSection& section) {
  Json json = start_section("lines", section);
  if (section.scales == LinesSection::Scales::equal) json["equal"] = true;
  if (section.legend == LegendValues::none) json["legend"] = "names";
  json["x"] = write_axis(section.x);
  add_values(json["x"], "values", section.x_values);
  json["y"] = write_axis(section.y);
  json["series"] = write_series(section.series);
  return json;
}

Json write_histogram_frame(const HistogramFrame& frame) {
  return {{"label", frame.label}, {"values", frame.values}};
}

Json write_section(const HistogramSection& section) {
  Json json = start_section("histogram", section);
  json["x"] = write_axis(section.x);
  json["y"] = write_axis(section.y);
  json["edges"] = section.edges;
  json["frames"] = Json::array();
  for (const HistogramFrame& frame : section.frames) json["frames"].push_back(write_histogram_frame(frame));
  if (section.reference) json["reference"] = write_histogram_frame(*section.reference);
  if (!section.curves.empty()) json["curves"] = write_series(section.curves);
  return json;
}

Json write_section(const TableSection& section) {
  Json json = start_section("table", section);
  json["columns"] = Json::array();
  for (const TableColumn& column : section.columns) {
    Json entry{{"label", column.label}};
    add_text(entry, "unit", column.unit);
    json["columns"].push_back(std::move(entry));
  }
  json["rows"] = Json::array();
  for (const std::vector<TableCell>& row : section.rows) {
    Json cells = Json::array();
    for (const TableCell& cell : row) cells.push_back(std::visit(ValueWriter{}, cell));
    json["rows"].push_back(std::move(cells));
  }
  return json;
}

Json write_section(const HeatmapSection& section) {
  Json json = start_section("heatmap", section);
  json["x"] = write_axis(section.x);
  add_values(json["x"], "values", section.x_values);
  json["y"] = write_axis(section.y);
  add_values(json["y"], "values", section.y_values);
  json["values"] = section.values;
  add_text(json, "label", section.label);
  add_text(json, "unit", section.unit);
  if (section.range) json["range"] = *section.range;
  if (section.colours == ColourScale::diverging) json["colours"] = "diverging";
  if (section.cells == HeatmapSection::Cells::written) json["written"] = true;
  if (section.scales == HeatmapSection::Scales::equal) json["equal"] = true;
  return json;
}

/// Writes nodes as steps between the corners of the box around them.
Json write_grid(const std::vector<float>& points) {
  constexpr double steps = std::numeric_limits<std::uint16_t>::max();
  std::array<double, 3> low, step;
  for (std::size_t k = 0; k < 3; ++k) {
    auto [least, most] = std::pair(points.empty() ? 0.0F : points[k], points.empty() ? 0.0F : points[k]);
    for (std::size_t i = k; i < points.size(); i += 3) {
      least = std::min(least, points[i]);
      most = std::max(most, points[i]);
    }
    low[k] = least;
    step[k] = (static_cast<double>(most) - least) / steps;
  }
  std::vector<std::uint16_t> whole(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
    if (step[i % 3] > 0)
      whole[i] = static_cast<std::uint16_t>(std::lround((points[i] - low[i % 3]) / step[i % 3]));
  return {{"steps", encode(whole)}, {"corner", low}, {"step", step}};
}

Json write_fiber_frame(const FiberFrame& frame, NodeEncoding encoding) {
  Json lattice = Json::array();
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) lattice.push_back(frame.lattice(i, j));
  }
  Json json{{"time_s", frame.time_s},
            {"lattice", std::move(lattice)},
            {"periodic", frame.periodic},
            {"offsets", encode(frame.offsets)}};
  if (frame.strain) json["strain"] = *frame.strain;
  if (encoding == NodeEncoding::grid) {
    json["grid"] = write_grid(frame.points);
  } else {
    json["points"] = encode(frame.points);
  }
  json["birth"] = encode(frame.birth);
  json["radius"] = encode(frame.radius);
  if (!frame.birth_node.empty()) json["birth_node"] = encode(frame.birth_node);
  return json;
}

Json write_breaks(const std::vector<FiberBreak>& breaks) {
  std::vector<float> times;
  std::vector<std::int32_t> births, nodes;
  for (const FiberBreak& one : breaks) {
    times.push_back(static_cast<float>(one.time_s));
    births.push_back(one.birth);
    nodes.push_back(one.node);
  }
  return {{"time_s", encode(times)}, {"birth", encode(births)}, {"node", encode(nodes)}};
}

Json write_section(const FibersSection& section) {
  Json json = start_section("fibers", section);
  json["frames"] = Json::array();
  for (const FiberFrame& frame : section.frames)
    json["frames"].push_back(write_fiber_frame(frame, section.encoding));
  if (section.breaks) json["breaks"] = write_breaks(*section.breaks);
  return json;
}

const char* name_of(PlaceMark mark) {
  switch (mark) {
    case PlaceMark::gate:
      return "gate";
    case PlaceMark::trap:
      return "trap";
    case PlaceMark::place:
      break;
  }
  return "place";
}

Json write_layers(const ShellLayers& layers) {
  Json json{{"heights", layers.heights}, {"thickness", encode(layers.thickness)}, {"fields", Json::array()}};
  for (const ShellLayers::Field& field : layers.fields) {
    json["fields"].push_back({{"label", field.label}, {"values", encode(field.values)}});
    add_text(json["fields"].back(), "unit", field.unit);
  }
  return json;
}

Json write_section(const ShellSection& section) {
  Json json = start_section("shell", section);
  json["points"] = encode(section.points);
  json["triangles"] = encode(section.triangles);
  json["fill_time"] = encode(section.fill_time);
  json["times"] = section.times;
  json["fields"] = Json::array();
  for (const ShellField& field : section.fields) {
    Json entry{{"label", field.label}, {"frames", Json::array()}};
    add_text(entry, "unit", field.unit);
    for (const std::vector<float>& frame : field.frames) entry["frames"].push_back(encode(frame));
    json["fields"].push_back(std::move(entry));
  }
  for (const ShellPlace& place : section.places)
    json["places"].push_back({{"label", place.label},
                              {"kind", name_of(place.mark)},
                              {"at", {place.at.x(), place.at.y(), place.at.z()}}});
  for (const ShellLines& lines : section.lines)
    json["lines"].push_back({{"label", lines.label}, {"segments", encode(lines.segments)}});
  for (const ShellTensors& tensors : section.tensors)
    json["tensors"].push_back({{"label", tensors.label}, {"frames", {encode(tensors.values)}}});
  for (const ShellDirections& directions : section.directions) {
    json["directions"].push_back({{"label", directions.label},
                                  {"at", encode(directions.at)},
                                  {"vectors", encode(directions.vectors)}});
    add_text(json["directions"].back(), "unit", directions.unit);
  }
  if (section.layers) json["layers"] = write_layers(*section.layers);
  return json;
}

/// Escapes "<" so that no text of the document can end the page's script element or open a comment.
std::string escape_for_script(const std::string& json) {
  std::string text;
  text.reserve(json.size());
  for (const char letter : json) {
    if (letter == '<') {
      text += "\\u003c";
    } else {
      text += letter;
    }
  }
  return text;
}

}  // namespace

void add_cell(HeatmapSection& section, const CellPlace& place, double value) {
  if (section.y_values.empty() || place.y != section.y_values.back()) {
    section.y_values.push_back(place.y);
    section.values.emplace_back();
  }
  if (section.values.size() == 1) section.x_values.push_back(place.x);
  section.values.back().push_back(value);
}

std::string write_report_json(const ReportDocument& document) {
  Json json{{"schema", 2}, {"title", document.title}};
  add_text(json, "case", document.case_name);
  add_text(json, "subtitle", document.subtitle);
  add_text(json, "study", document.study);
  add_text(json, "version", document.version);
  add_text(json, "stop_reason", document.stop_reason);
  json["sections"] = Json::array();
  for (const ReportSection& section : document.sections) {
    json["sections"].push_back(std::visit([](const auto& found) { return write_section(found); }, section));
  }
  // Bytes that are not UTF-8, as in a file name, are replaced rather than refused; NaN and infinity become
  // null.
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string render_report(const ReportDocument& document) {
  const std::string_view page = report_template();
  if (page.empty()) {
    throw InputError("this fiberfate was built without the HTML report",
                     "build it with -DFIBERFATE_REPORT=ON (needs Node.js 18 and npm), or read summary.json "
                     "and series.csv");
  }
  const std::size_t at = page.find(marker);
  if (at == std::string_view::npos)
    throw std::logic_error("the report's template has no place for the document");
  std::string html(page.substr(0, at));
  html += escape_for_script(write_report_json(document));
  html += page.substr(at + marker.size());
  return html;
}

}  // namespace fiberfate
