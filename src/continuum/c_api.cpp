// Errors, threads and the reading of arguments for the C interface.
#include "continuum/c_api.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <new>
#include <string>

#include "base/error.hpp"
#include "base/threads.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/closure.hpp"

namespace fiberfate {
namespace {

/// What the last failing call complained of; a fixed buffer, so that running out of memory can be told, too.
thread_local char error_text[1024] = "";

void remember(const char* text) noexcept {
  const std::string_view all(text);
  const std::size_t kept = std::min(all.size(), sizeof error_text - 1);
  std::copy_n(all.data(), kept, error_text);
  error_text[kept] = '\0';
}

constexpr std::size_t most_numbers = std::numeric_limits<std::size_t>::max() / sizeof(double);
/// More threads than any processor has.
constexpr int most_threads = 4096;

}  // namespace

fiberfate_status remember_exception() noexcept {
  try {
    throw;
  } catch (const InputError& error) {
    remember(error.what());
    return FIBERFATE_BAD_INPUT;
  } catch (const std::bad_alloc&) {
    remember("the memory ran out");
  } catch (const std::exception& error) {
    remember(error.what());
  } catch (...) {
    remember("an unknown failure");
  }
  return FIBERFATE_FAILED;
}

void require_pointer(const void* pointer, std::string_view what) {
  if (pointer == nullptr) throw InputError(fmt::format("{} is NULL", what), "pass a valid pointer");
}

void require_rows(std::size_t rows, std::size_t width) {
  if (width > 0 && rows > most_numbers / width)
    throw InputError(fmt::format("{} points are more than memory can hold", rows),
                     "pass the number of points");
}

std::span<const double> rows_at(const double* numbers, std::size_t rows, std::size_t width,
                                std::string_view what) {
  require_rows(rows, width);
  if (rows > 0) require_pointer(numbers, what);
  return {numbers, rows * width};
}

std::span<double> rows_at(double* numbers, std::size_t rows, std::size_t width, std::string_view what) {
  require_rows(rows, width);
  if (rows > 0) require_pointer(numbers, what);
  return {numbers, rows * width};
}

std::span<const fiberfate_constant> constants_at(const fiberfate_constant* constants, std::size_t count) {
  if (count == 0) return {};
  require_pointer(constants, "constants");
  const std::span<const fiberfate_constant> all(constants, count);
  for (const fiberfate_constant& one : all) require_pointer(one.name, "the name of a constant");
  return all;
}

std::vector<double> lined_up(std::string_view law, std::span<const LawParameter> parameters,
                             std::span<const fiberfate_constant> constants) {
  std::vector<double> values;
  std::vector<std::string> names;
  for (const LawParameter& parameter : parameters) {
    values.push_back(parameter.standard_value);
    names.push_back(parameter.name);
  }
  for (const fiberfate_constant& constant : constants) {
    const auto found = std::ranges::find(names, std::string_view(constant.name));
    if (found == names.end())
      throw InputError(fmt::format("the law {} has no constant '{}'", law, constant.name),
                       fmt::format("its constants are {}", fmt::join(names, ", ")));
    values[found - names.begin()] = constant.value;
  }
  return values;
}

OrientationModel model_of(const char* model, const char* closure,
                          std::span<const fiberfate_constant> constants) {
  require_pointer(model, "model");
  require_pointer(closure, "closure");
  const std::string_view name = model;
  OrientationModel chosen;
  if (const std::size_t plus = name.find('+'); plus == std::string_view::npos) {
    chosen = orientation_model_named(name, closure);
  } else {
    chosen.diffusion = rotary_diffusion_named(name.substr(0, plus));
    chosen.retardation = retardation_named(name.substr(plus + 1));
    chosen.closure = closure_named(closure);
  }
  for (const fiberfate_constant& constant : constants) set_constant(chosen, constant.name, constant.value);
  require_admissible(chosen);
  return chosen;
}

LengthFlows flows_of(std::size_t n, const double* shear_rates, const double* viscosities,
                     const double* compressions) {
  LengthFlows flows = {rows_at(shear_rates, n, 1, "shear_rates"), rows_at(viscosities, n, 1, "viscosities")};
  if (compressions != nullptr) flows.compression = rows_at(compressions, n, 1, "compressions");
  flows.check();
  return flows;
}

}  // namespace fiberfate

using namespace fiberfate;

int fiberfate_api_version(void) {
  return FIBERFATE_API_VERSION;
}

const char* fiberfate_error_text(void) {
  return error_text;
}

fiberfate_status fiberfate_set_threads(int threads) {
  return guarded([&] {
    if (threads < 1 || threads > most_threads)
      throw InputError(fmt::format("{} threads are impossible", threads),
                       fmt::format("take 1 to {}", most_threads));
    use_threads(threads);
  });
}

int fiberfate_threads(void) {
  return thread_count();
}
