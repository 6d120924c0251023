// Laws of mean lengths and of length distributions for C.
#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "base/error.hpp"
#include "base/number_checks.hpp"
#include "continuum/c_api.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/phelps_solver.hpp"

using namespace fiberfate;

struct fiberfate_length_law {
  std::unique_ptr<AttritionLaw> law;
};

struct fiberfate_breakage_law {
  PhelpsSolver solver;
};

namespace {

std::unique_ptr<AttritionLaw> law_of(const char* name, const fiberfate_constant* constants,
                                     std::size_t count) {
  require_pointer(name, "name");
  const AttritionLawEntry& entry = find_attrition_law(name);
  return make_attrition_law(name, lined_up(entry.name, entry.parameters, constants_at(constants, count)));
}

std::size_t bins_of(const fiberfate_breakage_law* law) {
  require_pointer(law, "law");
  return law->solver.bins().bins;
}

}  // namespace

fiberfate_status fiberfate_length_create(const char* name, const fiberfate_constant* constants,
                                         size_t constant_count, fiberfate_length_law** law) {
  return guarded([&] {
    require_pointer(law, "law");
    *law = nullptr;
    auto made = law_of(name, constants, constant_count);
    if (made->relaxation() == nullptr)
      throw InputError(fmt::format("the law {} needs a distribution of lengths", name),
                       "choose a law of the form DL/Dt = -k_f (L - L_inf)");
    *law = new fiberfate_length_law{std::move(made)};
  });
}

fiberfate_status fiberfate_length_rates(const fiberfate_length_law* law, size_t n, const double* shear_rates,
                                        const double* viscosities, const double* lengths, double* rates) {
  return guarded([&] {
    require_pointer(law, "law");
    const LengthFlows flows = flows_of(n, shear_rates, viscosities, nullptr);
    require_numbers("lengths", rows_at(lengths, n, 1, "lengths"), not_negative);
    static_cast<void>(rows_at(rates, n, 1, "rates"));
    for (std::size_t i = 0; i < n; ++i) {
      const LengthRelaxation relaxation = law->law->relaxation()->at(flows[i]);
      const double excess = std::max(0.0, lengths[i] - relaxation.equilibrium_length);
      rates[i] = excess > 0 ? -relaxation.rate_constant * excess : 0;
    }
  });
}

fiberfate_status fiberfate_length_coefficients(const fiberfate_length_law* law, size_t n,
                                               const double* shear_rates, const double* viscosities,
                                               double* rate_constants, double* final_lengths) {
  return guarded([&] {
    require_pointer(law, "law");
    law->law->relaxation()->evaluate(flows_of(n, shear_rates, viscosities, nullptr),
                                     rows_at(rate_constants, n, 1, "rate_constants"),
                                     rows_at(final_lengths, n, 1, "final_lengths"));
  });
}

fiberfate_status fiberfate_length_advance(const fiberfate_length_law* law, size_t n,
                                          const double* shear_rates, const double* viscosities,
                                          double duration, double* lengths) {
  return guarded([&] {
    require_pointer(law, "law");
    relax_lengths(*law->law->relaxation(), flows_of(n, shear_rates, viscosities, nullptr), duration,
                  rows_at(lengths, n, 1, "lengths"));
  });
}

void fiberfate_length_destroy(fiberfate_length_law* law) {
  delete law;
}

fiberfate_status fiberfate_breakage_create(const char* name, const fiberfate_constant* constants,
                                           size_t constant_count, size_t bins, double largest_length,
                                           fiberfate_breakage_law** law) {
  return guarded([&] {
    require_pointer(law, "law");
    *law = nullptr;
    const auto made = law_of(name, constants, constant_count);
    if (made->fragmentation() == nullptr)
      throw InputError(fmt::format("the law {} follows lengths, not their distribution", name),
                       "take fiberfate_length_create, or phelps or durin");
    *law = new fiberfate_breakage_law{PhelpsSolver(*made->fragmentation(), {bins, largest_length})};
  });
}

double fiberfate_breakage_memory(size_t bins) {
  return PhelpsSolver::memory_bytes(bins);
}

fiberfate_status fiberfate_breakage_unbreakable_lengths(const fiberfate_breakage_law* law, size_t n,
                                                        const double* shear_rates, const double* viscosities,
                                                        double* lengths) {
  return guarded([&] {
    require_pointer(law, "law");
    const LengthFlows flows = flows_of(n, shear_rates, viscosities, nullptr);
    static_cast<void>(rows_at(lengths, n, 1, "lengths"));
    for (std::size_t i = 0; i < n; ++i) lengths[i] = unbreakable_length(law->solver.constants(), flows[i]);
  });
}

fiberfate_status fiberfate_breakage_children(const fiberfate_breakage_law* law, double* children) {
  return guarded([&] {
    const std::size_t bins = bins_of(law);
    static_cast<void>(rows_at(children, bins, bins, "children"));
    std::fill_n(children, bins * bins, 0.0);
    std::vector<double> column(bins);
    for (std::size_t k = 1; k < bins; ++k) {
      fill_children(k + 1, law->solver.constants().spread, std::span(column).first(k));
      for (std::size_t i = 0; i < k; ++i) children[i * bins + k] = column[i];
    }
  });
}

fiberfate_status fiberfate_breakage_means(const fiberfate_breakage_law* law, size_t n, const double* numbers,
                                          double* number_averages, double* weight_averages) {
  return guarded([&] {
    const std::size_t bins = bins_of(law);
    static_cast<void>(rows_at(numbers, n, bins, "numbers"));
    static_cast<void>(rows_at(number_averages, n, 1, "number_averages"));
    static_cast<void>(rows_at(weight_averages, n, 1, "weight_averages"));
    const std::vector<double> lengths = law->solver.bins().lengths();
    std::vector<double> here(bins);
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t bin = 0; bin < bins; ++bin) here[bin] = numbers[bin * n + i];
      const MeanLengths means = mean_lengths(lengths, here);
      number_averages[i] = means.number_average;
      weight_averages[i] = means.weight_average;
    }
  });
}

fiberfate_status fiberfate_breakage_rates(const fiberfate_breakage_law* law, size_t n,
                                          const double* shear_rates, const double* viscosities,
                                          const double* compressions, double* rates) {
  return guarded([&] {
    const std::size_t bins = bins_of(law);
    law->solver.breakage_rates(flows_of(n, shear_rates, viscosities, compressions),
                               rows_at(rates, n, bins, "rates"));
  });
}

fiberfate_status fiberfate_breakage_advance(const fiberfate_breakage_law* law, size_t n,
                                            const double* shear_rates, const double* viscosities,
                                            const double* compressions, double duration, double* numbers) {
  return guarded([&] {
    const std::size_t bins = bins_of(law);
    const std::span<double> rows = rows_at(numbers, n, bins, "numbers");
    law->solver.advance(flows_of(n, shear_rates, viscosities, compressions), duration, rows);
    require_numbers("numbers", rows, not_negative);
  });
}

void fiberfate_breakage_destroy(fiberfate_breakage_law* law) {
  delete law;
}

fiberfate_status fiberfate_mean_lengths(size_t n, const double* lengths, const double* numbers,
                                        double* number_average, double* weight_average) {
  return guarded([&] {
    require_pointer(number_average, "number_average");
    require_pointer(weight_average, "weight_average");
    const std::span<const double> all = rows_at(lengths, n, 1, "lengths");
    const std::vector<double> ones(numbers == nullptr ? n : 0, 1.0);
    const MeanLengths means = mean_lengths(all, numbers == nullptr ? ones : std::span(numbers, n));
    require_number("number_average", means.number_average, any_finite);
    require_number("weight_average", means.weight_average, any_finite);
    *number_average = means.number_average;
    *weight_average = means.weight_average;
  });
}
