// The mean of particle stresses over time.
#pragma once

#include <vector>

#include "dynamics/particle_stress.hpp"

namespace fiberfate {

/// Sums readings, each for as long as its step lasted.
class StressMean {
 public:
  void add(const ParticleStress& reading, double duration);
  [[nodiscard]] bool is_empty() const { return duration_ == 0; }
  /// The mean; zeros where nothing was added.
  [[nodiscard]] ParticleStress mean() const;

  /// The sums as plain numbers, from which another mean goes on; none where nothing was added.
  [[nodiscard]] std::vector<double> numbers() const;
  /// Goes on from numbers(); raises InputError for others.
  [[nodiscard]] static StressMean from(const std::vector<double>& numbers);

 private:
  ParticleStress sum_;
  double duration_ = 0;  // s
};

}  // namespace fiberfate
