// Builds the sections of a molding report.
#include "studies/molding/sections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "io/vtkhdf_file.hpp"
#include "results/fiber_frame.hpp"
#include "studies/molding/checkpoint.hpp"
#include "studies/molding/part_details.hpp"
#include "studies/molding/setup.hpp"

namespace fiberfate {
namespace {

constexpr double zero_celsius = 273.15;         // K
constexpr std::size_t most_values = 1'500'000;  // of one field over all times that a page can carry

/// An array of result.vtkhdf as the page shows it.
struct ShownField {
  const char* array;
  const char* label;
  const char* unit;
  int component = 0;
  double offset = 0;
  enum class Times { all, last } times = Times::all;
};

const std::vector<ShownField>& shown_fields() {
  using Times = ShownField::Times;
  static const std::vector<ShownField> fields = {
      {"fill_time", "fill time", "s", 0, 0, Times::last},
      {"pressure", "pressure", "Pa"},
      {"temperature", "temperature, mean over the gap", "degC", 0, -zero_celsius},
      {"L_N", "length L_N", "m"},
      {"L_W", "length L_W", "m"},
      {"L_N_compared", "length L_N, compared law", "m", 0, 0, Times::last},
      {"A2", "orientation A11", "1", 0},
      {"A2", "orientation A22", "1", 1},
      {"A2", "orientation A33", "1", 2}};
  return fields;
}

std::vector<float> component_of(const FrameArray& array, int component, double offset) {
  const std::vector<double> all = numbers_of({array}, array.name);
  std::vector<float> values;
  const auto stride = static_cast<std::size_t>(array.components);
  for (std::size_t i = static_cast<std::size_t>(component); i < all.size(); i += stride)
    values.push_back(static_cast<float>(all[i] + offset));
  return values;
}

const FrameArray* find_array(const PolyFrame& frame, const std::string& name) {
  const auto found = std::find_if(frame.point_data.begin(), frame.point_data.end(),
                                  [&name](const FrameArray& array) { return array.name == name; });
  return found == frame.point_data.end() ? nullptr : &*found;
}

/// Chooses frames so that a page can carry them: all, or every second, third, … and the last.
std::vector<std::size_t> chosen_frames(std::size_t frames, std::size_t nodes) {
  const std::size_t every = 1 + frames * nodes / most_values;
  std::vector<std::size_t> chosen;
  for (std::size_t i = (frames - 1) % every; i < frames; i += every) chosen.push_back(i);
  return chosen;
}

/// Adds places and weld lines out of the last state, and the layers, whose thickness only its shell tells.
void add_last_state(const MoldingCase& values, const ResultFolder& folder, ShellSection& section) {
  const MoldingCheckpoint last = load_molding(folder);
  add_layers(folder, ShellMesh(last.shell), section);
  const MoldingSetup setup = molding_setup(values, last.shell);
  for (const Gate& gate : setup.params.gates)
    section.places.push_back(
        {gate.name, PlaceMark::gate, gate.end ? Vec3(0.5 * (gate.position + *gate.end)) : gate.position});
  for (const NamedPlace& place : values.output.places)
    section.places.push_back({place.name, PlaceMark::place, position_of(place, setup.part)});
  ShellLines weld = {"weld lines", {}};
  const auto is_weld = [&](Index node) {
    return last.state.mark[static_cast<std::size_t>(node)] == NodeMark::weld_line;
  };
  for (const auto& triangle : last.shell.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const Index a = triangle[k], b = triangle[(k + 1) % 3];
      if (!is_weld(a) || !is_weld(b)) continue;
      for (const Index node : {a, b})
        for (int axis = 0; axis < 3; ++axis)
          weld.segments.push_back(static_cast<float>(last.shell.nodes[static_cast<std::size_t>(node)][axis]));
    }
  if (!weld.segments.empty()) section.lines.push_back(std::move(weld));
  for (std::size_t i = 0; i < last.state.mark.size(); ++i) {
    if (last.state.mark[i] == NodeMark::air_trap)
      section.places.push_back({"", PlaceMark::trap, last.shell.nodes[i]});
    if (last.state.mark[i] == NodeMark::last_filled)
      section.places.push_back({"last filled", PlaceMark::place, last.shell.nodes[i]});
  }
}

/// Picks the values of a column in the rows of a place.
std::vector<double> of_place(const CsvTable& table, double place, const std::string& column) {
  std::vector<double> picked;
  for (std::size_t i = 0; i < table.rows(); ++i)
    if (table.values[0][i] == place) picked.push_back(table.column(column)[i]);
  return picked;
}

}  // namespace

ShellSection part_section(const MoldingCase& values, const ResultFolder& folder) {
  const VtkhdfReader reader(folder.frames());
  const PolyFrame last = reader.read(reader.times().size() - 1);
  ShellSection section;
  section.id = "part";
  section.title = "The part while it fills";
  section.points.assign(last.points.begin(), last.points.end());
  section.triangles.assign(last.connectivity.begin(), last.connectivity.end());
  section.fill_time = component_of(*find_array(last, "fill_time"), 0, 0);
  const std::vector<std::size_t> frames = chosen_frames(reader.times().size(), last.points.size() / 3);
  for (const std::size_t frame : frames) section.times.push_back(reader.times()[frame]);
  for (const ShownField& shown : shown_fields())
    if (find_array(last, shown.array) != nullptr) section.fields.push_back({shown.label, shown.unit, {}});
  for (const std::size_t index : frames) {
    const PolyFrame frame = reader.read(index);
    std::size_t field = 0;
    for (const ShownField& shown : shown_fields()) {
      const FrameArray* array = find_array(frame, shown.array);
      if (array == nullptr) continue;
      if (shown.times == ShownField::Times::all || index == frames.back())
        section.fields[field].frames.push_back(component_of(*array, shown.component, shown.offset));
      ++field;
    }
  }
  add_orientation(last, section);
  // A run that was killed may have none yet.
  if (std::filesystem::exists(folder.checkpoint())) add_last_state(values, folder, section);
  add_stiffness_axes(folder, section);
  section.caption =
      "Values between the frames are interpolated; temperature, length and orientation are means over the "
      "gap. Red "
      "squares are gates, red rings likely air traps.";
  return section;
}

TableSection places_section(const MoldingCase& values, const CsvTable& places) {
  TableSection section{"places", "Named places", {}, {}};
  section.columns = {{"place"},    {"set"},     {"filled at", "s"}, {"temperature", "K"},
                     {"L_N", "m"}, {"L_W", "m"}};
  for (std::size_t i = 0; i < places.rows(); ++i) {
    const double value = places.column("value")[i];
    if (std::isfinite(value)) continue;  // the sweep has a figure of its own
    const bool compared = places.column("set")[i] > 0;
    section.rows.push_back({values.output.places[static_cast<std::size_t>(places.column("place")[i])].name,
                            compared ? values.compared.name : values.law.name,
                            places.column("fill_time_s")[i], places.column("temperature_K")[i],
                            places.column("L_N_m")[i], places.column("L_W_m")[i]});
  }
  section.caption =
      values.fibers.number_average
          ? "Means over the gap and over the radius of a sample. places.csv has L_N and L_W of all "
            "fibers of the sample beside them."
          : "L_N and L_W of all fibers in the gap and radius of a sample, in which layers of short "
            "fibers count the more; places.csv has the means over the gap beside them.";
  return section;
}

std::vector<LinesSection> profile_sections(const MoldingCase& values, const CsvTable& profiles) {
  struct Profile {
    const char *id, *title, *column;
    ReportAxis axis;
  };
  const Profile all[] = {
      {"temperature_profile", "Temperature across the gap", "temperature_K", {"temperature", "K"}},
      {"rate_profile", "Shear rate across the gap", "rate_per_s", {"shear rate", "1/s"}},
      {"orientation_profile", "Orientation A11 across the gap", "a11", {"A11"}},
      {"length_profile", "Length L_N across the gap", "L_N_m", {"L_N", "m"}}};
  std::vector<LinesSection> sections;
  for (const Profile& profile : all) {
    const std::vector<double>& column = profiles.column(profile.column);
    if (std::none_of(column.begin(), column.end(), [](double value) { return std::isfinite(value); }))
      continue;
    LinesSection section{profile.id, profile.title, {"height over the mid-plane", "m"}, profile.axis, {}, {}};
    for (std::size_t p = 0; p < values.output.places.size(); ++p) {
      const auto place = static_cast<double>(p);
      section.series.push_back({values.output.places[p].name, of_place(profiles, place, profile.column),
                                CurveStyle::line, of_place(profiles, place, "z_m")});
    }
    section.caption = "From the mid-plane to the wall, at the node nearest to each place when filling ends.";
    sections.push_back(std::move(section));
  }
  return sections;
}

HistogramSection molding_histogram(const MoldingCase& values, const CsvTable& table) {
  HistogramSection section{"histogram", "Fibers by length", {"length", "m"}, {"share of the fibers", "%"}, {},
                           {}};
  const auto shares = [&table](double place) {
    std::vector<double> picked;
    for (std::size_t i = 0; i < table.rows(); ++i)
      if (table.values[0][i] == place && table.values[1][i] == 0)
        picked.push_back(100 * table.column("number_share")[i]);
    return picked;
  };
  for (std::size_t i = 0; i < table.rows() && table.values[0][i] == -1 && table.values[1][i] == 0; ++i) {
    if (i == 0) section.edges.push_back(table.column("length_low_m")[i]);
    section.edges.push_back(table.column("length_high_m")[i]);
  }
  for (std::size_t p = 0; p < values.output.places.size(); ++p) {
    HistogramFrame frame = {values.output.places[p].name, shares(static_cast<double>(p))};
    if (!frame.values.empty()) section.frames.push_back(std::move(frame));
  }
  section.reference = HistogramFrame{"at the gates", shares(-1)};
  return section;
}

LinesSection sweep_section(const MoldingCase& values, const CsvTable& sweep) {
  const bool logarithmic = values.sweep.spacing == ParameterScale::logarithmic;
  LinesSection section{"sweep",
                       "Average error over " + values.sweep.parameter,
                       {values.sweep.parameter, "", logarithmic ? AxisScale::logarithmic : AxisScale::linear},
                       {"average error", "%"},
                       sweep.column("value"),
                       {{"average error (4.8)", sweep.column("average_error_percent")}}};
  return section;
}

LinesSection measured_section(const MoldingCase& values, const CsvTable& places, const SummaryFile& summary) {
  const double best = summary.number("sweep_best_value");
  std::size_t nearest = 0;
  for (std::size_t i = 0; i < places.rows(); ++i)
    if (std::isfinite(places.column("value")[i]) &&
        !(std::abs(std::log(places.column("value")[i] / best)) >=
          std::abs(std::log(places.column("value")[nearest] / best))))
      nearest = i;
  const double set = places.column("set")[nearest];
  LinesSection section{"measured", "Measured and predicted lengths", {"place"}, {"length", "m"}, {}, {}};
  for (const MeasuredMean mean : {MeasuredMean::number_average, MeasuredMean::weight_average}) {
    const char* label = mean == MeasuredMean::number_average ? "L_N" : "L_W";
    ReportSeries measured{std::string(label) + ", measured", {}, CurveStyle::points};
    ReportSeries predicted{std::string(label) + ", predicted", {}};
    for (std::size_t i = 0; i < places.rows(); ++i) {
      if (places.column("set")[i] != set) continue;
      const double place = places.column("place")[i];
      predicted.x.push_back(place + 1);
      predicted.values.push_back(places.column(std::string(label) + "_m")[i]);
      for (const MeasuredLength& one : values.sweep.measured)
        if (one.mean == mean && one.place == values.output.places[static_cast<std::size_t>(place)].name) {
          measured.x.push_back(place + 1);
          measured.values.push_back(one.length);
        }
    }
    if (measured.values.empty()) continue;
    section.series.push_back(std::move(measured));
    section.series.push_back(std::move(predicted));
  }
  section.caption =
      "Places in the order of output.places; predicted with the value of the sweep nearest to the best one.";
  return section;
}

}  // namespace fiberfate
