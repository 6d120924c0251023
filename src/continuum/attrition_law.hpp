// What every law of fiber attrition can do: start from a population and follow it through a flow.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "continuum/length_classes.hpp"
#include "continuum/length_flow.hpp"
#include "continuum/length_relaxation.hpp"
#include "continuum/phelps_solver.hpp"

namespace fiberfate {

/// Chooses what is known of the lengths.
enum class LengthForm {
  means,        ///< only L_N and L_W: each decays by its own equation, as the thesis' simulations do
  distribution  ///< a population of classes (relaxation laws) or bins (Phelps)
};

/// Chooses what a class of fibers keeps while its length decays (thesis 4.4).
enum class ClassWeight {
  length,  ///< the fiber length of the class: fibers become more as they become shorter, nothing is lost
  number   ///< the number of its fibers, as if ends vanished: the thesis' own evaluation, which loses fiber
           ///< length
};

/// How a population is followed.
struct LengthStart {
  LengthClasses initial;
  std::optional<MeanLengths> means = {};  ///< with LengthForm::means, instead of those of `initial`
  LengthForm form = LengthForm::distribution;
  ClassWeight weight = ClassWeight::length;  ///< relaxation laws only
  LengthBins bins{100, 0};  ///< Phelps only; largest_length 0 takes the longest initial fiber
};

/// Follows one population through time.
class LengthEvolution {
 public:
  LengthEvolution() = default;
  LengthEvolution(const LengthEvolution&) = delete;
  LengthEvolution& operator=(const LengthEvolution&) = delete;
  virtual ~LengthEvolution() = default;

  /// Advances by `duration` s of constant flow, exactly.
  virtual void advance(const LengthFlow& flow, double duration) = 0;
  [[nodiscard]] virtual MeanLengths means() const = 0;
  /// Gives the present population; with LengthForm::means it is empty.
  [[nodiscard]] virtual const LengthClasses& population() const = 0;
};

/// Predicts what becomes of fiber lengths: a law with its constants.
class AttritionLaw {
 public:
  AttritionLaw() = default;
  AttritionLaw(const AttritionLaw&) = delete;
  AttritionLaw& operator=(const AttritionLaw&) = delete;
  virtual ~AttritionLaw() = default;

  /// Starts following a population. Raises InputError when it cannot: an inadmissible population, or only
  /// mean lengths for a law that needs a distribution.
  [[nodiscard]] virtual std::unique_ptr<LengthEvolution> start(const LengthStart& start) const = 0;
  /// The length below which nothing breaks in this flow, m: L_inf, or L_ub.
  [[nodiscard]] virtual double unbreakable_length(const LengthFlow& flow) const = 0;
  /// Gives k_f and L_inf, for solvers that transport lengths; null for laws of another form.
  [[nodiscard]] virtual const RelaxationLaw* relaxation() const { return nullptr; }
  /// Gives the constants of the Phelps-Tucker model; null for laws of another form.
  [[nodiscard]] virtual const PhelpsConstants* fragmentation() const { return nullptr; }
};

/// Makes an attrition law of k_f and L_inf.
[[nodiscard]] std::unique_ptr<AttritionLaw> make_relaxation_law(std::unique_ptr<RelaxationLaw> relaxation);
/// Makes an attrition law of the Phelps-Tucker model.
[[nodiscard]] std::unique_ptr<AttritionLaw> make_fragmentation_law(const PhelpsConstants& constants);

}  // namespace fiberfate
