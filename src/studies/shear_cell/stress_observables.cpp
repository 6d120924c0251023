// Measures stresses, viscosities and powers of a moment.
#include "studies/shear_cell/stress_observables.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace fiberfate {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::array<std::pair<int, int>, 6> components = {{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}}};

template <class Measure>
auto of_stress(const Measure& measure) {
  return [measure](const CellMoment& m) { return m.stress ? measure(*m.stress) : unknown; };
}

double value_of(Rheology what, const CellMoment& m) {
  if (!m.stress) return unknown;
  const Mat3& stress = m.stress->stress;
  const double strain_rate = m.flow.rate_of_strain().squaredNorm();
  switch (what) {
    case Rheology::relative_viscosity:
      return strain_rate > 0 ? 1 + m.stress->supplied_power / (2 * m.flow.viscosity * strain_rate) : unknown;
    case Rheology::first_normal_difference:
      return stress(0, 0) - stress(1, 1);
    case Rheology::second_normal_difference:
      return stress(1, 1) - stress(2, 2);
    default:
      return elongational_viscosity(m.values.flow.type, m.flow, stress);
  }
}

/// The chart that shows a component by cause: that of stretching along x, or that of shear.
std::string chart_of_causes(int row, int column) {
  if (row == 0 && column == 0) return "stretch_causes";
  return row == 0 && column == 1 ? "shear_causes" : "";
}

Observables<CellMoment> parts_by_cause() {
  Observables<CellMoment> all;
  for (std::size_t i = 0; i < stress_causes; ++i) {
    const auto cause = static_cast<StressCause>(i);
    for (const auto& [row, column] : components) {
      const std::string pair = std::to_string(row + 1) + std::to_string(column + 1);
      const std::string chart = chart_of_causes(row, column);
      all.push_back(
          {std::string("stress_") + name(cause) + "_" + pair + "_Pa", "Pa", chart.empty() ? "" : name(cause),
           chart,
           of_stress([cause, r = row, c = column](const ParticleStress& s) { return s.of(cause)(r, c); })});
    }
  }
  return all;
}

Observables<CellMoment> powers() {
  Observables<CellMoment> all = {{"stress_power_W_per_m3", "W/m3", "supplied by the flow", "power_balance",
                                  of_stress([](const ParticleStress& s) { return s.supplied_power; })}};
  for (std::size_t i = 0; i < power_sinks; ++i) {
    const auto sink = static_cast<PowerSink>(i);
    all.push_back({std::string(name(sink)) + "_power_mean_W_per_m3", "W/m3", name(sink), "power_balance",
                   of_stress([sink](const ParticleStress& s) { return s.into(sink); }), InSummary::no,
                   CurveStyle::dashed});
  }
  return all;
}

Observables<CellMoment> viscosities() {
  const auto measure = [](Rheology what) {
    return [what](const CellMoment& m) { return value_of(what, m); };
  };
  return {
      {"relative_viscosity", "", "relative viscosity", "viscosity", measure(Rheology::relative_viscosity)},
      {"N1_Pa", "Pa", "N_1", "normal_stress", measure(Rheology::first_normal_difference)},
      {"N2_Pa", "Pa", "N_2", "normal_stress", measure(Rheology::second_normal_difference)},
      {"elongational_viscosity_Pa_s", "Pa s", "", "", measure(Rheology::elongational_viscosity)},
      {"stress_power_error", "", "", "",
       of_stress([](const ParticleStress& s) { return s.spent_power() / s.supplied_power - 1; })},
      {"stress_antisymmetric_Pa", "Pa", "", "",
       of_stress([](const ParticleStress& s) { return s.antisymmetric.norm(); })},
      {"unanswered_force", "", "", "", of_stress([](const ParticleStress& s) {
         return s.answered > 0 ? std::sqrt(s.unanswered / s.answered) : 0;
       })},
  };
}

}  // namespace

Observables<CellMoment> stress_observables() {
  return joined<CellMoment>({viscosities(),
                             tensor_observables<CellMoment>({"stress_", "_Pa", "Pa", "sigma", "stress"},
                                                            [](const CellMoment& m) {
                                                              return m.stress ? m.stress->stress
                                                                              : Mat3(Mat3::Constant(unknown));
                                                            }),
                             parts_by_cause(), powers()});
}

void StressHistory::add(const CellMoment& moment) {
  if (!moment.stress) return;
  numbers_.push_back(moment.state.time);
  for (std::size_t i = 0; i < rheologies; ++i) numbers_.push_back(value_of(static_cast<Rheology>(i), moment));
}

BlockMean StressHistory::mean(Rheology what, double from) const {
  std::vector<double> values;
  for (std::size_t row = 0; row + rheologies < numbers_.size(); row += rheologies + 1) {
    const double value = numbers_[row + 1 + static_cast<std::size_t>(what)];
    if (numbers_[row] > from && std::isfinite(value)) values.push_back(value);
  }
  return block_mean(values);
}

void summarise_stress(const StressHistory& history, double from, RunSummary& summary) {
  constexpr std::array<const char*, rheologies> names = {"relative_viscosity_mean", "N1_mean_Pa",
                                                         "N2_mean_Pa", "elongational_viscosity_mean_Pa_s"};
  constexpr std::array<const char*, rheologies> errors = {"relative_viscosity_error", "N1_error_Pa",
                                                          "N2_error_Pa", "elongational_viscosity_error_Pa_s"};
  for (std::size_t i = 0; i < rheologies; ++i) {
    const BlockMean mean = history.mean(static_cast<Rheology>(i), from);
    if (mean.values == 0) continue;
    summary.own.emplace_back(names[i], mean.mean);
    summary.own.emplace_back(errors[i], mean.error);
    if (i == 0) summary.own.emplace_back("relative_viscosity_autocorrelation_rows", mean.autocorrelation);
  }
}

}  // namespace fiberfate
