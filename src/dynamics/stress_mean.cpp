// Sums and averages particle stresses.
#include "dynamics/stress_mean.hpp"

#include <cstddef>

#include "base/error.hpp"

namespace fiberfate {
namespace {

/// Visits every number of a stress, for saving and for restoring.
template <class Stress, class Visit>
void visit_numbers(Stress& one, const Visit& visit) {
  const auto visit_all = [&visit](auto& matrix) {
    for (auto* at = matrix.data(); at != matrix.data() + matrix.size(); ++at) visit(*at);
  };
  visit_all(one.stress);
  for (auto& part : one.by_cause) visit_all(part);
  visit_all(one.power);
  visit(one.supplied_power);
  visit_all(one.antisymmetric);
  visit(one.unanswered);
  visit(one.answered);
}

}  // namespace

void StressMean::add(const ParticleStress& reading, double duration) {
  sum_.add(reading, duration);
  duration_ += duration;
}

ParticleStress StressMean::mean() const {
  ParticleStress mean;
  if (!is_empty()) mean.add(sum_, 1 / duration_);
  return mean;
}

std::vector<double> StressMean::numbers() const {
  if (is_empty()) return {};
  std::vector<double> numbers = {duration_};
  visit_numbers(sum_, [&numbers](double number) { numbers.push_back(number); });
  return numbers;
}

StressMean StressMean::from(const std::vector<double>& numbers) {
  StressMean mean;
  if (numbers.empty()) return mean;
  std::size_t at = 0;
  const auto next = [&](double& number) {
    if (at == numbers.size())
      throw InputError("a mean stress has too few numbers", "take them from StressMean::numbers()");
    number = numbers[at++];
  };
  next(mean.duration_);
  visit_numbers(mean.sum_, next);
  return mean;
}

}  // namespace fiberfate
