// What the runs of a rheometer say together: means over replicas, and the laws that fit them.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "results/outcome.hpp"
#include "studies/rheometer/case.hpp"
#include "studies/rheometer/stress_fit.hpp"

namespace fiberfate {

/// The laws fitted to all points with the same fibers.
struct RheometerFit {
  std::size_t fibers = 0;      ///< number of the kind
  double volume_fraction = 0;  ///< mean of the runs, as the next two
  double planned_length = 0;   ///< mean by number at the start, m; NaN for fibers of a file
  double mean_length = 0;      ///< L_N at the end, m
  ParticleNumberFit stress;
  TroutonFit viscosity;
  double dinh_armstrong = 0;  ///< N_p of semi-dilute aligned fibers of L_N and the volume fraction
};

/// Fits the finished runs, one fit a kind of fibers that has any.
[[nodiscard]] std::vector<RheometerFit> fit_readings(const RheometerCase& values, const CsvTable& readings);

/// Averages the finished runs of each point: table curves (docs/formats/rheometer.md).
[[nodiscard]] CsvTable curves_of(const RheometerCase& values, const CsvTable& readings,
                                 const std::vector<RheometerFit>& fits);

/// States where the viscosity drifts most while it is averaged; empty where it is steady, that is where what
/// the fibers add changes by less than 5 %, or by chance, from the first half of the averaged rows to the
/// last.
[[nodiscard]] std::string words_of_drift(const CsvTable& curves);

/// Makes the outcome of the finished runs: tables curves and fits, summary, headlines.
[[nodiscard]] Outcome evaluate(const RheometerCase& values, const CsvTable& readings);

/// States in words what a fit tells of R_T: its interval, or that x varies too little.
[[nodiscard]] std::string words_of(const TroutonFit& fit);

}  // namespace fiberfate
