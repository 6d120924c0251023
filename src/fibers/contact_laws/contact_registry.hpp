// The registry of laws of the normal force, and a law chosen from it.
#pragma once

#include <string_view>
#include <vector>

#include "base/law_math.hpp"
#include "base/law_text.hpp"
#include "fibers/contact_laws/contact_parameters.hpp"

namespace fiberfate {

/// Describes one law; its functions take the constants that `make` has made.
struct ContactRow {
  LawText text;
  int number;  ///< place in ContactLaws, by which kernels choose
  LawNumbers (*make)(const ContactParameters& contact, const ContactPair& pair);
  double (*force)(const LawNumbers& law, const ContactGap<double>& gap);
  double (*stiffness)(const LawNumbers& law, const ContactGap<double>& gap, double force);
  double (*reach)(const LawNumbers& law);
  double (*hold)(const LawNumbers& law);
  RestingContact (*resting)(const ContactParameters& contact, const ContactPair& pair);
};

/// Lists the laws.
[[nodiscard]] const std::vector<ContactRow>& contact_laws();
/// Finds a law; raises InputError for a name that no law has.
[[nodiscard]] const ContactRow& contact_law_named(std::string_view name);

/// Normal force of the chosen law between two fibers.
class NormalForce {
 public:
  NormalForce(const ContactParameters& contact, const ContactPair& pair)
      : row_(&contact_law_named(contact.law)), constants_(row_->make(contact, pair)) {}

  /// Returns F_N in N; where no sine is given, of rods that cross at right angles.
  [[nodiscard]] double operator()(const ContactGap<double>& gap) const {
    return row_->force(constants_, gap);
  }
  [[nodiscard]] double operator()(double distance) const { return (*this)({distance, 1}); }
  /// Returns an upper bound of −dF_N/dd in N/m at and around the gap, at which the force is `force`.
  [[nodiscard]] double stiffness(const ContactGap<double>& gap, double force) const {
    return row_->stiffness(constants_, gap, force);
  }
  /// Returns the distance from which on there is no force, m; 0 where there never is.
  [[nodiscard]] double reach() const { return row_->reach(constants_); }
  /// Returns the distance from which on rods are not held either, m: those about to close are (stiffness).
  [[nodiscard]] double hold() const { return row_->hold(constants_); }

  [[nodiscard]] int law() const { return row_->number; }
  [[nodiscard]] const LawNumbers& constants() const { return constants_; }

 private:
  const ContactRow* row_;
  LawNumbers constants_;
};

}  // namespace fiberfate
