// Follows populations by relaxation of their lengths or by fragmentation over bins.
#include "continuum/attrition_law.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "base/number_checks.hpp"

namespace fiberfate {
namespace {

const LengthClasses& no_population() {
  static const LengthClasses empty;
  return empty;
}

void check_means(const MeanLengths& means) {
  require_number("number_average", means.number_average, positive);
  require_number("weight_average", means.weight_average, positive);
  if (means.weight_average < means.number_average * (1 - 1e-9))
    throw InputError("the weight average length is below the number average", "exchange them");
}

class MeansRelaxation final : public LengthEvolution {
 public:
  MeansRelaxation(const RelaxationLaw& law, const MeanLengths& initial) : law_(law), means_(initial) {}
  void advance(const LengthFlow& flow, double duration) override {
    const LengthRelaxation relaxation = law_.at(flow);
    means_.number_average = relax_length(means_.number_average, relaxation, duration);
    means_.weight_average = relax_length(means_.weight_average, relaxation, duration);
  }
  [[nodiscard]] MeanLengths means() const override { return means_; }
  [[nodiscard]] const LengthClasses& population() const override { return no_population(); }

 private:
  const RelaxationLaw& law_;
  MeanLengths means_;
};

class ClassesRelaxation final : public LengthEvolution {
 public:
  ClassesRelaxation(const RelaxationLaw& law, LengthClasses initial, ClassWeight weight)
      : law_(law), classes_(std::move(initial)), weight_(weight) {}
  void advance(const LengthFlow& flow, double duration) override {
    const LengthRelaxation relaxation = law_.at(flow);
    for (std::size_t i = 0; i < classes_.lengths.size(); ++i) {
      const double relaxed = relax_length(classes_.lengths[i], relaxation, duration);
      if (weight_ == ClassWeight::length) classes_.numbers[i] *= classes_.lengths[i] / relaxed;
      classes_.lengths[i] = relaxed;
    }
  }
  [[nodiscard]] MeanLengths means() const override { return mean_lengths(classes_); }
  [[nodiscard]] const LengthClasses& population() const override { return classes_; }

 private:
  const RelaxationLaw& law_;
  LengthClasses classes_;
  ClassWeight weight_;
};

class BinsFragmentation final : public LengthEvolution {
 public:
  BinsFragmentation(const PhelpsConstants& constants, const LengthClasses& initial, const LengthBins& bins)
      : solver_(constants, bins), classes_{bins.lengths(), sort_into_bins(initial, bins), bins.width()} {}
  void advance(const LengthFlow& flow, double duration) override {
    solver_.advance(flow, duration, classes_.numbers);
  }
  [[nodiscard]] MeanLengths means() const override { return mean_lengths(classes_); }
  [[nodiscard]] const LengthClasses& population() const override { return classes_; }

 private:
  PhelpsSolver solver_;
  LengthClasses classes_;
};

class RelaxationAttrition final : public AttritionLaw {
 public:
  explicit RelaxationAttrition(std::unique_ptr<RelaxationLaw> law) : law_(std::move(law)) {}
  [[nodiscard]] std::unique_ptr<LengthEvolution> start(const LengthStart& start) const override {
    if (start.form == LengthForm::means && start.means) {
      check_means(*start.means);
      return std::make_unique<MeansRelaxation>(*law_, *start.means);
    }
    start.initial.check();
    if (start.form == LengthForm::means)
      return std::make_unique<MeansRelaxation>(*law_, mean_lengths(start.initial));
    return std::make_unique<ClassesRelaxation>(*law_, start.initial, start.weight);
  }
  [[nodiscard]] double unbreakable_length(const LengthFlow& flow) const override {
    return law_->at(flow).equilibrium_length;
  }
  [[nodiscard]] const RelaxationLaw* relaxation() const override { return law_.get(); }

 private:
  std::unique_ptr<RelaxationLaw> law_;
};

class FragmentationAttrition final : public AttritionLaw {
 public:
  explicit FragmentationAttrition(const PhelpsConstants& constants) : constants_(constants) {}
  [[nodiscard]] std::unique_ptr<LengthEvolution> start(const LengthStart& start) const override {
    if (start.form == LengthForm::means)
      throw InputError("the Phelps model cannot follow mean lengths alone",
                       "give a length or a distribution and take form = \"distribution\"");
    LengthBins bins = start.bins;
    if (!(bins.largest_length > 0)) {
      start.initial.check();
      bins.largest_length = *std::max_element(start.initial.lengths.begin(), start.initial.lengths.end());
    }
    return std::make_unique<BinsFragmentation>(constants_, start.initial, bins);
  }
  [[nodiscard]] double unbreakable_length(const LengthFlow& flow) const override {
    return fiberfate::unbreakable_length(constants_, flow);
  }
  [[nodiscard]] const PhelpsConstants* fragmentation() const override { return &constants_; }

 private:
  PhelpsConstants constants_;
};

}  // namespace

std::unique_ptr<AttritionLaw> make_relaxation_law(std::unique_ptr<RelaxationLaw> relaxation) {
  return std::make_unique<RelaxationAttrition>(std::move(relaxation));
}

std::unique_ptr<AttritionLaw> make_fragmentation_law(const PhelpsConstants& constants) {
  return std::make_unique<FragmentationAttrition>(constants);
}

}  // namespace fiberfate
