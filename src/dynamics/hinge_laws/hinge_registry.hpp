// The registry of laws of bending at a hinge.
#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "base/law_math.hpp"
#include "base/law_text.hpp"

namespace fiberfate {

/// Largest sin²(theta/2) at which a law is evaluated: a fold has no finite theta / sin theta. It stands for
/// theta = 174.9 degrees.
inline constexpr double sharpest_hinge = 0.999 * 0.999;

/// Describes one law; its function takes the constants that `make` has made.
struct HingeRow {
  LawText text;
  int number;  ///< place in HingeLaws, by which kernels choose
  LawNumbers (*make)();
  double (*ratio)(const LawNumbers& law, double squared_half_sine);
};

/// Lists the laws.
[[nodiscard]] const std::vector<HingeRow>& hinge_laws();
/// Finds a law; raises InputError for a name that no law has.
[[nodiscard]] const HingeRow& hinge_law_named(std::string_view name);

/// Hinge of the chosen law. With b = p_after − p_before, |b| = 2 sin(theta/2), and gamma = (1/l_before,
/// −1/l_before − 1/l_after, 1/l_after) the node forces, apart from parts along the rods that the tensions
/// absorb, are
///   force on node j of the three = −stiffness gamma_j b,   stiffness = (E I / l̄) ratio = M / sin theta
class Hinge {
 public:
  explicit Hinge(std::string_view law) : row_(&hinge_law_named(law)), constants_(row_->make()) {}

  /// Returns M / ((E I / l̄) sin theta) for sin²(theta/2); beyond `sharpest_hinge` that of there.
  [[nodiscard]] double operator()(double squared_half_sine) const {
    return row_->ratio(constants_, std::min(squared_half_sine, sharpest_hinge));
  }

  [[nodiscard]] int law() const { return row_->number; }
  [[nodiscard]] const LawNumbers& constants() const { return constants_; }

 private:
  const HingeRow* row_;
  LawNumbers constants_;
};

}  // namespace fiberfate
