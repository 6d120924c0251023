// Defines the list of viscosity laws.
#include <memory>

#include "base/entry_by_name.hpp"
#include "base/number_checks.hpp"
#include "continuum/law_values.hpp"
#include "continuum/viscosity.hpp"
#include "continuum/viscosity_carreau.hpp"
#include "continuum/viscosity_cross.hpp"
#include "continuum/viscosity_cross_wlf.hpp"
#include "continuum/viscosity_newtonian.hpp"
#include "continuum/viscosity_power_law.hpp"

namespace fiberfate {
namespace {

using Values = std::span<const double>;

template <class Formula>
constexpr bool needs_temperature = requires {
  Formula::needs_temperature;
};

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
ViscosityLawEntry row() {
  return {Formula::text.name, Formula::text.meaning, Formula::text.source, Formula::parameters(),
          [](Values values) -> std::unique_ptr<ViscosityLaw> {
            return std::make_unique<ViscosityLawOf<Formula>>(Formula::of(values));
          }};
}

}  // namespace

const std::vector<ViscosityLawEntry>& viscosity_laws() {
  static const std::vector<ViscosityLawEntry> entries = {
      row<Newtonian>(), row<PowerLaw>(), row<Carreau>(), row<Cross>(), row<CrossWlf>(),
  };
  return entries;
}

const ViscosityLawEntry& find_viscosity_law(std::string_view name) {
  return entry_named(viscosity_laws(), "viscosity law", name);
}

std::unique_ptr<ViscosityLaw> make_viscosity_law(std::string_view name, Values values) {
  const ViscosityLawEntry& entry = find_viscosity_law(name);
  check_law_values(entry.name, entry.parameters, values);
  return entry.make(values);
}

}  // namespace fiberfate
