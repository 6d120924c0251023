// Defines the list of attrition laws.
#include "continuum/length_registry.hpp"

#include "base/entry_by_name.hpp"
#include "continuum/constant_relaxation.hpp"
#include "continuum/durin_breakage.hpp"
#include "continuum/law_values.hpp"
#include "continuum/length_parameters.hpp"
#include "continuum/phelps_breakage.hpp"
#include "continuum/rate_power.hpp"
#include "continuum/stress_induced.hpp"
#include "continuum/unbreakable_length.hpp"

namespace fiberfate {
namespace {

using Values = std::span<const double>;

/// A law that relaxes lengths.
template <class Formula>
AttritionLawEntry relaxation() {
  return {Formula::text.name,
          Formula::text.meaning,
          Formula::text.source,
          Formula::parameters(),
          AttritionForm::relaxation,
          [](Values values) {
            return make_relaxation_law(std::make_unique<RelaxationLawOf<Formula>>(Formula::of(values)));
          }};
}

std::vector<LawParameter> fragmentation_parameters() {
  return {
      {"C_B", "1", "Breakage coefficient: breakages of a long fiber per unit of strain", required_value},
      {"zeta", "1", "Drag coefficient of the buckling load; 0 where L_ub is given instead", 0.0},
      {"S", "1", "Standard deviation of a child's length over the parent's", required_value, 0.005, 100},
      {"E_f", "Pa", "Young's modulus of the fiber", 73e9},
      fiber_diameter(),
      {"L_ub", "m", "Unbreakable length when given; 0 computes it from zeta, E_f, d_f and the flow", 0.0}};
}

/// A law that breaks the fibers of bins.
template <class Breakage>
AttritionLawEntry fragmentation() {
  return {Breakage::text.name,
          Breakage::text.meaning,
          Breakage::text.source,
          fragmentation_parameters(),
          AttritionForm::fragmentation,
          [](Values v) {
            return make_fragmentation_law({v[0], v[1], v[2], v[3], v[4], v[5], Breakage::share});
          }};
}

std::vector<AttritionLawEntry> make_entries() {
  return {
      relaxation<ConstantRelaxation>(), relaxation<UnbreakableLength>(), relaxation<RatePower>(),
      relaxation<StressInduced>(),      fragmentation<PhelpsBreakage>(), fragmentation<DurinBreakage>(),
  };
}

}  // namespace

const std::vector<AttritionLawEntry>& attrition_laws() {
  static const std::vector<AttritionLawEntry> entries = make_entries();
  return entries;
}

const AttritionLawEntry& find_attrition_law(std::string_view name) {
  return entry_named(attrition_laws(), "attrition law", name);
}

std::unique_ptr<AttritionLaw> make_attrition_law(std::string_view name, std::span<const double> values) {
  const AttritionLawEntry& entry = find_attrition_law(name);
  check_law_values(entry.name, entry.parameters, values);
  return entry.make(values);
}

}  // namespace fiberfate
