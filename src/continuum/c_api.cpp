// Wraps the point laws for C: names in, status out, nothing thrown.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "continuum/fiberfate.h"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/phelps_solver.hpp"
#include "microstructure/closure.hpp"

struct fiberfate_orientation_law {
  fiberfate::OrientationLaw law;
};

struct fiberfate_length_law {
  std::unique_ptr<fiberfate::AttritionLaw> law;
};

struct fiberfate_breakage_law {
  fiberfate::PhelpsSolver solver;
};

namespace {

using namespace fiberfate;

/// What the last failing call complained of; a fixed buffer, so that running out of memory can be told, too.
thread_local char error_text[1024] = "";

void remember(const char* text) {
  const std::string_view all(text);
  const std::size_t kept = std::min(all.size(), sizeof error_text - 1);
  std::copy_n(all.data(), kept, error_text);
  error_text[kept] = '\0';
}

/// Runs a body and turns every exception into a status.
template <class Body>
fiberfate_status guarded(const Body& body) noexcept {
  try {
    body();
    return FIBERFATE_OK;
  } catch (const InputError& error) {
    remember(error.what());
    return FIBERFATE_BAD_INPUT;
  } catch (const std::exception& error) {
    remember(error.what());
  } catch (...) {
    remember("an unknown failure");
  }
  return FIBERFATE_FAILED;
}

void require(const void* pointer, const char* what) {
  if (pointer == nullptr) throw InputError(fmt::format("{} is NULL", what), "pass a valid pointer");
}

void require_finite(double number, const char* what) {
  if (!(number >= 0) || number > 1e300)
    throw InputError(fmt::format("{} = {:g} is impossible", what, number),
                     "pass a finite number that is not negative");
}

/// Reads "iard_rpr" or "iard+rpr".
OrientationModel model_named(const std::string& model, const char* closure) {
  const std::size_t plus = model.find('+');
  if (plus == std::string::npos) return orientation_model_named(model, closure);
  OrientationModel pair;
  pair.diffusion = rotary_diffusion_named(model.substr(0, plus));
  pair.retardation = retardation_named(model.substr(plus + 1));
  pair.closure = closure_named(closure);
  return pair;
}

OrientationPoints points_of(std::size_t n, const double* orientations, const double* gradients,
                            double* results) {
  OrientationPoints points;
  points.count = n;
  points.second_stride = points.result_stride = 6;
  points.gradient_stride = 9;
  for (std::size_t m = 0; m < 6; ++m) {
    points.second[m] = orientations + m;
    points.result[m] = results + m;
  }
  for (std::size_t m = 0; m < 9; ++m) points.gradient[m] = gradients + m;
  return points;
}

/// Points to what an array of conditions holds; a missing array of compressions means 1 everywhere.
LengthFlows flows_of(std::size_t n, const double* rates, const double* viscosities,
                     const double* compressions) {
  require(rates, "shear_rates");
  require(viscosities, "viscosities");
  LengthFlows flows = {std::span(rates, n), std::span(viscosities, n)};
  if (compressions != nullptr) flows.compression = std::span(compressions, n);
  return flows;
}

/// Lines the values up with a law's parameters.
std::vector<double> values_of(const AttritionLawEntry& entry, std::span<const fiberfate_constant> constants) {
  std::vector<double> values;
  std::vector<std::string> names;
  for (const LawParameter& parameter : entry.parameters) {
    values.push_back(parameter.standard_value);
    names.push_back(parameter.name);
  }
  for (const fiberfate_constant& constant : constants) {
    require(constant.name, "the name of a constant");
    const auto found = std::ranges::find(names, std::string_view(constant.name));
    if (found == names.end())
      throw InputError(fmt::format("the law {} has no constant '{}'", entry.name, constant.name),
                       fmt::format("its constants are {}", fmt::join(names, ", ")));
    values[static_cast<std::size_t>(found - names.begin())] = constant.value;
  }
  return values;
}

}  // namespace

int fiberfate_api_version(void) {
  return FIBERFATE_API_VERSION;
}

const char* fiberfate_error_text(void) {
  return error_text;
}

fiberfate_status fiberfate_orientation_create(const char* model, const char* closure,
                                              const fiberfate_constant* constants, size_t constant_count,
                                              fiberfate_orientation_law** law) {
  return guarded([&] {
    require(law, "law");
    *law = nullptr;
    require(model, "model");
    require(closure, "closure");
    if (constant_count > 0) require(constants, "constants");
    OrientationModel chosen = model_named(model, closure);
    for (const fiberfate_constant& constant : std::span(constants, constant_count)) {
      require(constant.name, "the name of a constant");
      set_constant(chosen, constant.name, constant.value);
    }
    *law = new fiberfate_orientation_law{OrientationLaw(chosen)};
  });
}

fiberfate_status fiberfate_orientation_rates(const fiberfate_orientation_law* law, size_t n,
                                             const double* orientations, const double* gradients,
                                             double* rates) {
  return guarded([&] {
    require(law, "law");
    if (n == 0) return;
    require(orientations, "orientations");
    require(gradients, "gradients");
    require(rates, "rates");
    law->law.evaluate(points_of(n, orientations, gradients, rates));
  });
}

fiberfate_status fiberfate_orientation_advance(const fiberfate_orientation_law* law, size_t n,
                                               double* orientations, const double* gradients, double duration,
                                               double tolerance) {
  return guarded([&] {
    require(law, "law");
    require_finite(duration, "duration");
    if (!(tolerance > 0))
      throw InputError(fmt::format("tolerance = {:g} is impossible", tolerance),
                       "pass a positive number such as 1e-6");
    if (n == 0) return;
    require(orientations, "orientations");
    require(gradients, "gradients");
    law->law.advance(points_of(n, orientations, gradients, orientations), {duration, tolerance});
  });
}

fiberfate_status fiberfate_close(const char* closure, size_t n, const double* orientations,
                                 double* fourth_orders) {
  return guarded([&] {
    require(closure, "closure");
    if (n > 0) require(orientations, "orientations");
    if (n > 0) require(fourth_orders, "fourth_orders");
    const Closure chosen = closure_named(closure);
    for (std::size_t i = 0; i < n; ++i) {
      const Mat6 fourth = close(to_matrix(Eigen::Map<const Vec6>(orientations + 6 * i)), chosen);
      for (int k = 0; k < 36; ++k) fourth_orders[36 * i + static_cast<std::size_t>(k)] = fourth(k / 6, k % 6);
    }
  });
}

void fiberfate_orientation_destroy(fiberfate_orientation_law* law) {
  delete law;
}

fiberfate_status fiberfate_length_create(const char* name, const fiberfate_constant* constants,
                                         size_t constant_count, fiberfate_length_law** law) {
  return guarded([&] {
    require(law, "law");
    *law = nullptr;
    require(name, "name");
    if (constant_count > 0) require(constants, "constants");
    const AttritionLawEntry& entry = find_attrition_law(name);
    auto made = make_attrition_law(name, values_of(entry, std::span(constants, constant_count)));
    if (made->relaxation() == nullptr)
      throw InputError(fmt::format("the law {} needs a distribution of lengths", name),
                       "choose a law of the form DL/Dt = -k_f (L - L_inf)");
    *law = new fiberfate_length_law{std::move(made)};
  });
}

fiberfate_status fiberfate_length_rates(const fiberfate_length_law* law, size_t n, const double* shear_rates,
                                        const double* viscosities, const double* lengths, double* rates) {
  return guarded([&] {
    require(law, "law");
    if (n == 0) return;
    require(shear_rates, "shear_rates");
    require(viscosities, "viscosities");
    require(lengths, "lengths");
    require(rates, "rates");
    for (std::size_t i = 0; i < n; ++i) {
      const LengthRelaxation relaxation = law->law->relaxation()->at({shear_rates[i], viscosities[i], 1});
      const double excess = std::max(0.0, lengths[i] - relaxation.equilibrium_length);
      rates[i] = excess > 0 ? -relaxation.rate_constant * excess : 0;
    }
  });
}

fiberfate_status fiberfate_length_advance(const fiberfate_length_law* law, size_t n,
                                          const double* shear_rates, const double* viscosities,
                                          double duration, double* lengths) {
  return guarded([&] {
    require(law, "law");
    require_finite(duration, "duration");
    if (n == 0) return;
    require(shear_rates, "shear_rates");
    require(viscosities, "viscosities");
    require(lengths, "lengths");
    relax_lengths(*law->law->relaxation(), {std::span(shear_rates, n), std::span(viscosities, n)}, duration,
                  std::span(lengths, n));
  });
}

void fiberfate_length_destroy(fiberfate_length_law* law) {
  delete law;
}

fiberfate_status fiberfate_breakage_create(const char* name, const fiberfate_constant* constants,
                                           size_t constant_count, size_t bins, double largest_length,
                                           fiberfate_breakage_law** law) {
  return guarded([&] {
    require(law, "law");
    *law = nullptr;
    require(name, "name");
    if (constant_count > 0) require(constants, "constants");
    const AttritionLawEntry& entry = find_attrition_law(name);
    const auto made = make_attrition_law(name, values_of(entry, std::span(constants, constant_count)));
    if (made->fragmentation() == nullptr)
      throw InputError(fmt::format("the law {} follows lengths, not their distribution", name),
                       "take fiberfate_length_create, or phelps or durin");
    *law = new fiberfate_breakage_law{PhelpsSolver(*made->fragmentation(), {bins, largest_length})};
  });
}

fiberfate_status fiberfate_breakage_rates(const fiberfate_breakage_law* law, size_t n,
                                          const double* shear_rates, const double* viscosities,
                                          const double* compressions, double* rates) {
  return guarded([&] {
    require(law, "law");
    if (n == 0) return;
    require(rates, "rates");
    law->solver.breakage_rates(flows_of(n, shear_rates, viscosities, compressions),
                               std::span(rates, n * law->solver.bins().bins));
  });
}

fiberfate_status fiberfate_breakage_advance(const fiberfate_breakage_law* law, size_t n,
                                            const double* shear_rates, const double* viscosities,
                                            const double* compressions, double duration, double* numbers) {
  return guarded([&] {
    require(law, "law");
    require_finite(duration, "duration");
    if (n == 0) return;
    require(numbers, "numbers");
    law->solver.advance(flows_of(n, shear_rates, viscosities, compressions), duration,
                        std::span(numbers, n * law->solver.bins().bins));
  });
}

void fiberfate_breakage_destroy(fiberfate_breakage_law* law) {
  delete law;
}
