// Defines the list of attrition laws.
#include "continuum/length_registry.hpp"

#include <limits>

#include "continuum/law_values.hpp"
#include "continuum/stress_induced.hpp"
#include "continuum/unbreakable_length.hpp"

namespace fiberfate {
namespace {

using Values = std::span<const double>;
constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

template <class Formula>
std::unique_ptr<AttritionLaw> relaxation(const Formula& formula) {
  return make_relaxation_law(std::make_unique<RelaxationLawOf<Formula>>(formula));
}

std::unique_ptr<AttritionLaw> fragmentation(Values v, BreakageRate breakage_rate) {
  return make_fragmentation_law({v[0], v[1], v[2], v[3], v[4], v[5], breakage_rate});
}

/// Zero would divide by nothing: a pascal and a nanometre are less than any fiber has.
const LawParameter strength = {"sigma_u", "Pa", "Tensile strength of the fiber", 2e9, 1};
const LawParameter diameter = {"d_f", "m", "Diameter of the fiber", 19e-6, 1e-9};
const LawParameter lambda = {"lambda", "1", "Interaction coefficient of the unbreakable length", unknown};

std::vector<LawParameter> phelps_parameters() {
  return {
      {"C_B", "1", "Breakage coefficient: breakages of a long fiber per unit of strain", unknown},
      {"zeta", "1", "Drag coefficient of the buckling load; 0 where L_ub is given instead", 0.0},
      {"S", "1", "Standard deviation of a child's length over the parent's", unknown, 0.005, 100},
      {"E_f", "Pa", "Young's modulus of the fiber", 73e9},
      diameter,
      {"L_ub", "m", "Unbreakable length when given; 0 computes it from zeta, E_f, d_f and the flow", 0.0}};
}

std::vector<AttritionLawEntry> make_entries() {
  return {
      {"constant",
       "A given final length and rate constant: DL/Dt = -k_f (L - L_inf) (thesis 5.7)",
       {{"k_f", "1/s", "Rate constant of the decay", unknown}, {"L_inf", "m", "Final length", unknown}},
       [](Values v) {
         return relaxation(ConstantRelaxation{v[0], v[1]});
       }},
      {"unbreakable_length",
       "L_inf = lambda d_f sqrt(sigma_u/(eta rate)), k_f = xi rate (Bechara; thesis 4.3, 4.4)",
       {lambda, {"xi", "1", "Breakage per unit of strain", unknown}, strength, diameter},
       [](Values v) {
         return relaxation(UnbreakableLength{v[0], v[1], v[2], v[3]});
       }},
      {"rate_power",
       "L_inf = lambda d_f (eta rate/sigma_u)^-alpha, k_f = xi rate^beta (thesis 5.8, 5.14)",
       {lambda,
        {"alpha", "1", "Exponent of the final length", 0.5},
        {"xi", "1", "Breakage factor, in s^(beta-1)", unknown},
        {"beta", "1", "Exponent of the rate constant", unknown},
        strength,
        diameter},
       [](Values v) {
         return relaxation(RatePower{v[0], v[1], v[2], v[3], v[4], v[5]});
       }},
      {"stress_induced",
       "L_inf = lambda d_f (eta rate/sigma_u)^-alpha, k_f = k_0 (eta rate/sigma_u)^beta (thesis 5.8, 5.9)",
       {lambda,
        {"alpha", "1", "Exponent of the final length", unknown},
        {"k_0", "1/s", "Rate constant at a stress equal to the strength", unknown},
        {"beta", "1", "Exponent of the rate constant", unknown},
        strength,
        diameter},
       [](Values v) {
         return relaxation(StressInduced{v[0], v[1], v[2], v[3], v[4], v[5]});
       }},
      {"phelps",
       "dN_i/dt = -P_i N_i + sum R_ik N_k, P = C_B rate max(0, 1 - exp(1 - (L/L_ub)^4)) (Phelps-Tucker)",
       phelps_parameters(), [](Values v) { return fragmentation(v, BreakageRate::phelps); }},
      {"durin", "As phelps, with P = C_B rate min(1, (1 - exp(-(L/L_ub)^4))/(1 - 1/e)) (Durin)",
       phelps_parameters(), [](Values v) { return fragmentation(v, BreakageRate::durin); }},
  };
}

}  // namespace

const std::vector<AttritionLawEntry>& attrition_laws() {
  static const std::vector<AttritionLawEntry> entries = make_entries();
  return entries;
}

const AttritionLawEntry& find_attrition_law(std::string_view name) {
  std::vector<std::string> names;
  for (const AttritionLawEntry& entry : attrition_laws()) {
    if (entry.name == name) return entry;
    names.push_back(entry.name);
  }
  refuse_law_name("attrition law", name, names);
}

std::unique_ptr<AttritionLaw> make_attrition_law(std::string_view name, std::span<const double> values) {
  const AttritionLawEntry& entry = find_attrition_law(name);
  check_law_values(entry.name, entry.parameters, values);
  return entry.make(values);
}

}  // namespace fiberfate
