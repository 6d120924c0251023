// Reads and writes orientation tensors in case files.
#include "keys/orientation_value.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "base/error.hpp"
#include "microstructure/orientation_sampling.hpp"

namespace fiberfate {
namespace {

constexpr double trace_rounding = 2e-3;     ///< what people round off, 0.333 three times for instance
constexpr double symmetry_rounding = 1e-6;  ///< the same as OrientationDistribution admits
constexpr double exact_trace = 1e-12;  ///< nearer to 1 than this, scaling would only shuffle the last digits
constexpr const char* how_to_write =
    R"(give "isotropic", "planar", "aligned", three principal values such as [0.6, 0.3, 0.1], or three rows of three)";

const std::array<std::pair<const char*, Vec3>, 3> named_tensors = {
    {{"isotropic", Vec3::Constant(1.0 / 3)}, {"planar", Vec3(0.5, 0.5, 0)}, {"aligned", Vec3(1, 0, 0)}}};

std::optional<Vec3> read_three(const TomlValue& value) {
  const auto* items = std::get_if<std::vector<TomlValue>>(&value.data);
  if (items == nullptr || items->size() != 3) return {};
  Vec3 numbers;
  for (int i = 0; i < 3; ++i) {
    const auto number = read_quantity((*items)[i], {}, Range::any());
    if (!std::holds_alternative<double>(number)) return {};
    numbers[i] = std::get<double>(number);
  }
  return numbers;
}

std::optional<Mat3> read_components(const TomlValue& value) {
  if (const auto principal = read_three(value)) return Mat3(principal->asDiagonal());
  const auto* rows = std::get_if<std::vector<TomlValue>>(&value.data);
  if (rows == nullptr || rows->size() != 3) return {};
  Mat3 tensor;
  for (int i = 0; i < 3; ++i) {
    const auto row = read_three((*rows)[i]);
    if (!row) return {};
    tensor.row(i) = row->transpose();
  }
  return tensor;
}

Reading<Mat3> read_name(const std::string& text) {
  std::vector<std::string> names;
  for (const auto& [name, principal] : named_tensors) {
    if (text == name) return Mat3(principal.asDiagonal());
    names.emplace_back(name);
  }
  const std::string nearest = nearest_word(text, names);
  if (nearest.empty()) return Complaint{"not an orientation", how_to_write};
  return Complaint{"not an orientation", fmt::format("did you mean \"{}\"?", nearest)};
}

}  // namespace

Reading<Mat3> read_orientation(const TomlValue& value) {
  if (const auto* text = std::get_if<std::string>(&value.data)) return read_name(*text);
  std::optional<Mat3> tensor = read_components(value);
  if (!tensor) return Complaint{"not an orientation tensor", how_to_write};
  if ((*tensor - tensor->transpose()).cwiseAbs().maxCoeff() > symmetry_rounding)
    return Complaint{"the tensor is not symmetric", "give a12 = a21, a13 = a31, a23 = a32"};
  const double trace = tensor->trace();
  const bool rounded = std::abs(trace - 1) <= trace_rounding;
  try {
    require_admissible(rounded ? Mat3(*tensor / trace) : *tensor);
  } catch (const InputError& error) {
    const InputProblem& problem = error.problems().front();
    return Complaint{problem.complaint, problem.remedy};
  }
  if (std::abs(trace - 1) > exact_trace) *tensor /= trace;
  return *tensor;
}

std::string write_orientation(const Mat3& tensor, NumberStyle style) {
  for (const auto& [name, principal] : named_tensors)
    if (style == NumberStyle::friendly && tensor == Mat3(principal.asDiagonal())) return write_text(name);
  const auto row = [&tensor](int i) {
    return write_list({write_number(tensor(i, 0)), write_number(tensor(i, 1)), write_number(tensor(i, 2))});
  };
  if (tensor == Mat3(tensor.diagonal().asDiagonal()))
    return write_list({write_number(tensor(0, 0)), write_number(tensor(1, 1)), write_number(tensor(2, 2))});
  return write_list({row(0), row(1), row(2)});
}

}  // namespace fiberfate
