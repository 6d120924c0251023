// Defines the list of viscosity laws.
#include <cmath>
#include <limits>
#include <type_traits>

#include "base/number_checks.hpp"
#include "continuum/law_values.hpp"
#include "continuum/viscosity.hpp"

namespace fiberfate {
namespace {

using Values = std::span<const double>;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// At 0 K, which stands for a temperature that nobody gave, Cross-WLF would take the melt for solid.
template <class Formula>
constexpr bool needs_temperature = std::is_same_v<Formula, CrossWlf>;

template <class Formula>
class ViscosityLawOf final : public ViscosityLaw {
 public:
  explicit ViscosityLawOf(const Formula& formula) : formula_(formula) {}
  [[nodiscard]] double at(const MeltState& melt) const override {
    check(melt);
    return formula_(melt);
  }
  void evaluate(Values rates, Values temperatures, Values pressures,
                std::span<double> viscosities) const override {
    require_same_size("viscosities", viscosities.size(), rates.size());
    if (!temperatures.empty()) require_same_size("temperatures", temperatures.size(), rates.size());
    if (!pressures.empty()) require_same_size("pressures", pressures.size(), rates.size());
    for (std::size_t i = 0; i < rates.size(); ++i) {
      const MeltState melt = {rates[i], temperatures.empty() ? 0.0 : temperatures[i],
                              pressures.empty() ? 0.0 : pressures[i]};
      check(melt);
      viscosities[i] = formula_(melt);
    }
  }

 private:
  static void check(const MeltState& melt) {
    require_number("rate", melt.rate, not_negative);
    require_number("temperature", melt.temperature, needs_temperature<Formula> ? positive : not_negative);
    require_number("pressure", melt.pressure, any_finite);
  }

  Formula formula_;
};

template <class Formula>
std::unique_ptr<ViscosityLaw> law_of(const Formula& formula) {
  return std::make_unique<ViscosityLawOf<Formula>>(formula);
}

std::vector<ViscosityLawEntry> make_entries() {
  constexpr double least = 1e-9;  // zero would make the melt weigh nothing
  const LawParameter eta_0 = {"eta_0", "Pa s", "Viscosity at rest", unknown, least};
  const LawParameter index = {"n", "1", "Power-law index", unknown, 0, 2};
  // Above 1 the viscosity of Cross' law would vanish at rest.
  const LawParameter thinning_index = {"n", "1", "Power-law index", unknown, 0, 1};
  const LawParameter critical_stress = {"tau", "Pa", "Stress at which shear thinning is half way", unknown,
                                        least};
  return {
      {"newtonian", "eta = eta_0", {eta_0}, [](Values v) { return law_of(Newtonian{v[0]}); }},
      {"power_law",
       "eta = K rate^(n-1), constant below the lowest rate",
       {{"K", "1", "Consistency, in Pa s^n", unknown, least},
        index,
        {"lowest_rate", "1/s", "Rate below which the viscosity no longer rises", 1e-3}},
       [](Values v) {
         return law_of(PowerLaw{v[0], v[1], v[2]});
       }},
      {"carreau",
       "eta = eta_inf + (eta_0 - eta_inf) [1 + (time rate)^a]^((n-1)/a)",
       {eta_0,
        {"time", "s", "Time constant", unknown},
        index,
        {"eta_inf", "Pa s", "Viscosity at infinite rate", 0.0},
        {"a", "1", "Width of the transition; 2 is Carreau's", 2.0, 1e-3}},
       [](Values v) {
         return law_of(Carreau{v[0], v[1], v[2], v[3], v[4]});
       }},
      {"cross",
       "eta = eta_0/(1 + (eta_0 rate/tau)^(1-n))",
       {eta_0, critical_stress, thinning_index},
       [](Values v) {
         return law_of(Cross{v[0], v[1], v[2]});
       }},
      {"cross_wlf",
       "Cross, with eta_0 = D1 exp(-A1 (T - Ts)/(A2 + T - Ts)), Ts = D2 + D3 p, A2 = A2s + D3 p",
       {critical_stress,
        thinning_index,
        {"D1", "Pa s", "Viscosity at the reference temperature", unknown, least},
        {"D2", "K", "Reference temperature without pressure", unknown},
        {"D3", "K/Pa", "Rise of the reference temperature with pressure", 0.0},
        {"A1", "1", "First constant of the WLF shift", unknown},
        {"A2s", "K", "Second constant of the WLF shift", 51.6, least}},
       [](Values v) {
         return law_of(CrossWlf{v[0], v[1], v[2], v[3], v[4], v[5], v[6]});
       }},
  };
}

}  // namespace

const std::vector<ViscosityLawEntry>& viscosity_laws() {
  static const std::vector<ViscosityLawEntry> entries = make_entries();
  return entries;
}

const ViscosityLawEntry& find_viscosity_law(std::string_view name) {
  std::vector<std::string> names;
  for (const ViscosityLawEntry& entry : viscosity_laws()) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  refuse_law_name("viscosity law", name, names);
}

std::unique_ptr<ViscosityLaw> make_viscosity_law(std::string_view name, Values values) {
  const ViscosityLawEntry& entry = find_viscosity_law(name);
  check_law_values(entry.name, entry.parameters, values);
  return entry.make(values);
}

}  // namespace fiberfate
