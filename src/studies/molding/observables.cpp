// What the study molding measures.
#include "studies/molding/observables.hpp"

#include <cmath>

#include "microstructure/tensor.hpp"
#include "molding/filling_account.hpp"

namespace fiberfate {
namespace {

using Moment = FillingMoment;
constexpr InSummary number = InSummary::as_number, whole = InSummary::as_count;

double count(std::size_t things) {
  return static_cast<double>(things);
}
double marks(const Moment& m, NodeMark mark) {
  return static_cast<double>(count_marks(m.filling.state(), mark));
}

// Both series.csv and the summary have these.
const Observable<Moment>& filled() {
  static const Observable<Moment> one = {
      "filled_fraction", "", "filled", "filled", [](const Moment& m) { return m.filled_fraction; }, number};
  return one;
}
const Observable<Moment>& sprue_pressure() {
  static const Observable<Moment> one = {"sprue_pressure_Pa",
                                         "Pa",
                                         "sprue",
                                         "pressure",
                                         [](const Moment& m) { return m.filling.state().sprue_pressure; },
                                         number};
  return one;
}
const Observable<Moment>& injected() {
  static const Observable<Moment> one = {
      "injected_volume_m3", "m3", "", "", [](const Moment& m) { return m.injected_volume; }, number};
  return one;
}

/// Mean lengths of a kind: "L_N" + suffix, "L_W" + suffix.
Observables<PlaceSample> place_lengths(const std::string& suffix, MeanLengths PlaceSample::*means) {
  return {
      {"L_N" + suffix, "m", "", "", [=](const PlaceSample& p) { return (p.*means).number_average; }, number},
      {"L_W" + suffix, "m", "", "", [=](const PlaceSample& p) { return (p.*means).weight_average; }, number}};
}

/// Those that a report lists.
Observables<PlaceSample> labelled(Observables<PlaceSample> lengths) {
  for (Observable<PlaceSample>& one : lengths) one.label = one.column.substr(0, 3);
  return lengths;
}

std::vector<GapField> melt_fields() {
  const auto at = [](const GapPoint& p, const std::vector<double>& by_point) {
    return by_point[p.node * p.fields.filling().layers().count() + p.layer];
  };
  const auto height = [](const GapPoint& p) { return p.fields.filling().layers().middles()[p.layer]; };
  return {
      {{"place", "", "", "", [](const GapPoint& p) { return count(p.place); }}},
      {{"height", "", "", "", height}},
      {{"z_m", "m", "", "",
        [=](const GapPoint& p) { return 0.5 * height(p) * p.fields.filling().mesh().thickness(p.node); }}},
      {{"temperature_K", "K", "temperature", "temperature_profile",
        [=](const GapPoint& p) { return at(p, p.fields.filling().state().temperature); }},
       "temperature"},
      {{"rate_per_s", "1/s", "shear rate", "rate_profile",
        [=](const GapPoint& p) { return at(p, p.fields.filling().state().rate); }},
       "rate"},
      {{"viscosity_Pa_s", "Pa s", "", "", [](const GapPoint& p) { return p.viscosity; }}},
  };
}

std::vector<GapField> fiber_fields() {
  using Of = GapField::Of;
  std::vector<GapField> fields;
  for (int k = 0; k < 6; ++k) {
    const std::string pair = std::to_string(row_of[k] + 1) + std::to_string(column_of[k] + 1);
    fields.push_back({{"a" + pair, "", "A" + pair, k == 0 ? "orientation_profile" : "",
                       [k](const GapPoint& p) {
                         return to_components(p.fields.filling().orientation(p.node, p.layer))[k];
                       }},
                      "A" + pair,
                      Of::orientation});
  }
  const auto means = [](const GapPoint& p) { return p.fields.means(0, p.node, p.layer); };
  fields.push_back(
      {{"L_N_m", "m", "L_N", "length_profile", [=](const GapPoint& p) { return means(p).number_average; }},
       "L_N",
       Of::lengths});
  fields.push_back({{"L_W_m", "m", "", "", [=](const GapPoint& p) { return means(p).weight_average; }},
                    "L_W",
                    Of::lengths});
  return fields;
}

}  // namespace

FillingMoment moment_of(const Filling& filling, double greatest) {
  const FillingState& state = filling.state();
  return {filling, greatest, state.time, filling.filled_fraction(), state.injected_volume};
}

Observables<FillingMoment> filling_observables(const std::vector<Gate>& gates) {
  Observables<Moment> all = {{"time_s", "s", "", "", [](const Moment& m) { return m.time; }},
                             filled(),
                             {"flow_rate_m3_per_s", "m3/s", "machine", "rate",
                              [](const Moment& m) { return m.filling.state().flow_rate; }},
                             sprue_pressure(),
                             injected()};
  for (std::size_t g = 0; g < gates.size(); ++g) {
    all.push_back({gates[g].name + "_pressure_Pa", "Pa", gates[g].name, "pressure",
                   [g](const Moment& m) { return m.filling.state().gates[g].pressure; }, InSummary::no,
                   CurveStyle::dashed});
    all.push_back({gates[g].name + "_rate_m3_per_s", "m3/s", gates[g].name, "rate",
                   [g](const Moment& m) { return m.filling.state().gates[g].rate; }, InSummary::no,
                   CurveStyle::dashed});
  }
  return all;
}

const std::vector<Chart>& filling_charts() {
  static const std::vector<Chart> charts = {{"pressure", "Pressure at sprue and gates", "pressure"},
                                            {"rate", "Flow rates", "flow rate"},
                                            {"filled", "Filled share of the cavity", "filled"}};
  return charts;
}

const Observables<FillingMoment>& part_observables() {
  static const Observables<Moment> all = {
      filled(),
      {"nodes", "", "", "", [](const Moment& m) { return count(m.filling.mesh().node_count()); }, whole},
      {"triangles", "", "", "", [](const Moment& m) { return count(m.filling.mesh().triangle_count()); },
       whole},
      {"volume_m3", "m3", "", "", [](const Moment& m) { return m.filling.mesh().total_volume(); }, number},
      {"area_m2", "m2", "", "", [](const Moment& m) { return m.filling.mesh().total_area(); }, number},
      injected(),
      {"volume_error", "", "", "", [](const Moment& m) { return volume_error(m.filling); }, number},
      sprue_pressure(),
      {"greatest_sprue_pressure_Pa", "Pa", "", "", [](const Moment& m) { return m.greatest_pressure; },
       number},
      {"heat_error", "", "", "", [](const Moment& m) { return heat_error(m.filling); }, number},
      {"weld_line_nodes", "", "", "", [](const Moment& m) { return marks(m, NodeMark::weld_line); }, whole},
      {"air_traps", "", "", "", [](const Moment& m) { return marks(m, NodeMark::air_trap); }, whole}};
  return all;
}

const Observables<PlaceSample>& place_observables() {
  using Sample = PlaceSample;
  static const Observables<Sample> all = joined<Sample>(
      {{{"place", "", "", "", [](const Sample& p) { return count(p.place); }},
        {"set", "", "", "", [](const Sample& p) { return count(p.set); }},
        {"value", "", "", "", [](const Sample& p) { return p.value; }},
        {"fill_time_s", "s", "filled at", "", [](const Sample& p) { return p.fill_time; }, number},
        {"temperature_K", "K", "temperature", "", [](const Sample& p) { return p.temperature; }, number}},
       labelled(place_lengths("_m", &Sample::means)),
       place_lengths("_sample_m", &Sample::of_sample),
       place_lengths("_gap_mean_m", &Sample::of_gap)});
  return all;
}

bool follows(const MoldingFields& fields, GapField::Of of) {
  if (of == GapField::Of::orientation) return fields.setup().params.fibers.orientation.has_value();
  return of == GapField::Of::melt || fields.set_count() > 0;
}

const std::vector<GapField>& gap_fields() {
  static const std::vector<GapField> all = [] {
    std::vector<GapField> fields = melt_fields();
    for (GapField& field : fiber_fields()) {
      field.profile.measure = [measure = field.profile.measure, of = field.of](const GapPoint& point) {
        return follows(point.fields, of) ? measure(point) : std::nan("");
      };
      fields.push_back(std::move(field));
    }
    return fields;
  }();
  return all;
}

const Observables<GapPoint>& profile_observables() {
  static const Observables<GapPoint> all = [] {
    Observables<GapPoint> profiles;
    for (const GapField& field : gap_fields()) profiles.push_back(field.profile);
    return profiles;
  }();
  return all;
}

const std::vector<Chart>& profile_charts() {
  static const std::vector<Chart> charts = {
      {"temperature_profile", "Temperature across the gap", "temperature"},
      {"rate_profile", "Shear rate across the gap", "shear rate"},
      {"orientation_profile", "Orientation across the gap", "a_11"},
      {"length_profile", "Length L_N across the gap", "L_N"}};
  return charts;
}

}  // namespace fiberfate
