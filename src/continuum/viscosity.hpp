// States the viscosity laws of polymer melts: Newtonian, power law, Carreau, Cross, Cross-WLF.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "continuum/law_parameter.hpp"

namespace fiberfate {

/// Holds what the viscosity of a melt depends on.
struct MeltState {
  double rate = 0;         ///< shear rate sqrt(2 D:D), 1/s, not negative
  double temperature = 0;  ///< K; only Cross-WLF uses it
  double pressure = 0;     ///< Pa; only Cross-WLF uses it
};

/// eta = eta_0.
struct Newtonian {
  double viscosity;  ///< eta_0, Pa s

  double operator()(const MeltState&) const { return viscosity; }
};

/// eta = K rate^(n-1) (Ostwald-de Waele); below `lowest_rate` the viscosity stays what it is there, since for
/// n < 1 the law is infinite at rest.
struct PowerLaw {
  double consistency;         ///< K, Pa s^n
  double index;               ///< n, 1
  double lowest_rate = 1e-3;  ///< 1/s

  double operator()(const MeltState& melt) const;
};

/// eta = eta_inf + (eta_0 - eta_inf) [1 + (time rate)^a]^((n-1)/a); a = 2 is Carreau (1972), other a Yasuda
/// (1979).
struct Carreau {
  double zero_rate_viscosity;          ///< eta_0, Pa s
  double time;                         ///< s
  double index;                        ///< n, 1
  double infinite_rate_viscosity = 0;  ///< eta_inf, Pa s
  double transition = 2;               ///< a, 1

  double operator()(const MeltState& melt) const;
};

/// eta = eta_0/(1 + (eta_0 rate/tau)^(1-n)) (Cross 1965).
struct Cross {
  double zero_rate_viscosity;  ///< eta_0, Pa s
  double critical_stress;      ///< tau, Pa: where shear thinning is half way
  double index;                ///< n, 1

  double operator()(const MeltState& melt) const;
};

/// Cross with the Williams-Landel-Ferry shift of temperature and pressure:
///   eta_0 = D_1 exp(-A_1 (T - T_s)/(A_2 + T - T_s)),   T_s = D_2 + D_3 p,   A_2 = A_2* + D_3 p.
/// Below T_s the melt is solid and the law does not hold; the viscosity stays D_1 there, at most.
struct CrossWlf {
  double critical_stress;  ///< tau, Pa
  double index;            ///< n, 1
  double d_1;              ///< Pa s
  double d_2;              ///< K
  double d_3 = 0;          ///< K/Pa
  double a_1 = 0;          ///< 1
  double a_2 = 51.6;       ///< A_2*, K

  double operator()(const MeltState& melt) const;
};

/// Gives the viscosity of a melt, at one state or at many.
class ViscosityLaw {
 public:
  ViscosityLaw() = default;
  ViscosityLaw(const ViscosityLaw&) = delete;
  ViscosityLaw& operator=(const ViscosityLaw&) = delete;
  virtual ~ViscosityLaw() = default;

  /// Tells the viscosity, Pa s. Raises InputError for a state that no melt has (a negative rate, NaN,
  /// Cross-WLF without temperature), as `evaluate` does.
  [[nodiscard]] virtual double at(const MeltState& melt) const = 0;
  /// Evaluates n states; `temperatures` (K) and `pressures` (Pa) are used by Cross-WLF only and may be empty
  /// otherwise.
  virtual void evaluate(std::span<const double> rates, std::span<const double> temperatures,
                        std::span<const double> pressures, std::span<double> viscosities) const = 0;
};

/// Describes a law of the registry, as AttritionLawEntry does.
struct ViscosityLawEntry {
  std::string name;
  std::string summary;
  std::vector<LawParameter> parameters;
  std::unique_ptr<ViscosityLaw> (*make)(std::span<const double> values);
};

/// Gives all viscosity laws: newtonian, power_law, carreau, cross, cross_wlf.
[[nodiscard]] const std::vector<ViscosityLawEntry>& viscosity_laws();
/// Finds a law by name; raises InputError with the nearest name when there is none.
[[nodiscard]] const ViscosityLawEntry& find_viscosity_law(std::string_view name);
/// Makes a law from the values of its parameters; raises InputError for a missing value or one outside its
/// bounds.
[[nodiscard]] std::unique_ptr<ViscosityLaw> make_viscosity_law(std::string_view name,
                                                               std::span<const double> values);

}  // namespace fiberfate
