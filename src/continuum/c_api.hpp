// What all functions of the C interface share: exceptions become statuses, pointers are checked, rows are
// read.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string_view>
#include <vector>

#include "base/vector.hpp"
#include "continuum/fiberfate.h"
#include "continuum/law_parameter.hpp"
#include "continuum/length_flow.hpp"
#include "continuum/orientation_model.hpp"
#include "microstructure/tensor.hpp"

namespace fiberfate {

/// Remembers what the exception in flight says as this thread's error text, and tells its status. Call in a
/// catch block.
[[nodiscard]] fiberfate_status remember_exception() noexcept;

/// Runs a body and turns every exception into a status.
template <class Body>
fiberfate_status guarded(const Body& body) noexcept {
  try {
    body();
    return FIBERFATE_OK;
  } catch (...) {
    return remember_exception();
  }
}

/// Raises InputError for a pointer that is NULL.
void require_pointer(const void* pointer, std::string_view what);

/// Raises InputError for more rows of `width` numbers than an address space holds.
void require_rows(std::size_t rows, std::size_t width);

/// Gives the numbers of `rows` rows of `width` behind a pointer; raises InputError for NULL (unless there are
/// none).
[[nodiscard]] std::span<const double> rows_at(const double* numbers, std::size_t rows, std::size_t width,
                                              std::string_view what);
[[nodiscard]] std::span<double> rows_at(double* numbers, std::size_t rows, std::size_t width,
                                        std::string_view what);

/// Gives named constants; raises InputError for NULL.
[[nodiscard]] std::span<const fiberfate_constant> constants_at(const fiberfate_constant* constants,
                                                               std::size_t count);

/// Lines constants up with a law's parameters, standard values where none is given; raises InputError for a
/// name that the law does not have.
[[nodiscard]] std::vector<double> lined_up(std::string_view law, std::span<const LawParameter> parameters,
                                           std::span<const fiberfate_constant> constants);

/// Reads an orientation model from a name, "iard_rpr" or "iard+rpr", and its constants.
[[nodiscard]] OrientationModel model_of(const char* model, const char* closure,
                                        std::span<const fiberfate_constant> constants);

/// The flow of n points; compressions of NULL mean 1 everywhere.
[[nodiscard]] LengthFlows flows_of(std::size_t n, const double* shear_rates, const double* viscosities,
                                   const double* compressions);

[[nodiscard]] inline Mat3 tensor_at(const double* components) {
  return to_matrix(Eigen::Map<const Vec6>(components));
}
[[nodiscard]] inline Mat3 matrix_at(const double* entries) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(entries);
}
inline void write_tensor(const Mat3& tensor, double* components) {
  Eigen::Map<Vec6> to(components);
  to = to_components(tensor);
}
inline void write_fourth(const Mat6& tensor, double* components) {
  Eigen::Map<Eigen::Matrix<double, 6, 6, Eigen::RowMajor>> to(components);
  to = tensor;
}

}  // namespace fiberfate
