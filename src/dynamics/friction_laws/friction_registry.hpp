// The registry of laws of friction, and a law chosen from it.
#pragma once

#include <string_view>
#include <vector>

#include "base/law_math.hpp"
#include "base/law_text.hpp"
#include "fibers/contact_laws/contact_parameters.hpp"

namespace fiberfate {

/// Describes one law; its function takes the constants that `make` has made.
struct FrictionRow {
  LawText text;
  int number;  ///< place in FrictionLaws, by which kernels choose
  LawNumbers (*make)(const ContactParameters& contact, double coefficient);
  double (*resistance)(const LawNumbers& law, double normal_force, double squared_velocity);
};

/// Lists the laws.
[[nodiscard]] const std::vector<FrictionRow>& friction_laws();
/// Finds a law; raises InputError for a name that no law has.
[[nodiscard]] const FrictionRow& friction_law_named(std::string_view name);

/// Friction of the chosen law.
class Friction {
 public:
  Friction(const ContactParameters& contact, double coefficient)
      : row_(&friction_law_named(contact.friction_law)), constants_(row_->make(contact, coefficient)) {}

  /// Returns the resistance in N s/m for a normal force in N and the square of the tangential velocity.
  [[nodiscard]] double operator()(double normal_force, double squared_velocity) const {
    return row_->resistance(constants_, normal_force, squared_velocity);
  }

  [[nodiscard]] int law() const { return row_->number; }
  [[nodiscard]] const LawNumbers& constants() const { return constants_; }

 private:
  const FrictionRow* row_;
  LawNumbers constants_;
};

}  // namespace fiberfate
