// Fills the molds of a calibration and reads lengths at their places.
#include "studies/calibration/mold_experiment.hpp"

#include <fmt/format.h>

#include <any>
#include <cmath>

#include "base/error.hpp"
#include "continuum/length_registry.hpp"
#include "keys/case_file.hpp"
#include "studies/molding/fields.hpp"

namespace fiberfate {

MoldExperiment::MoldExperiment(MoldingCase values, const std::string& law) : values_(std::move(values)) {
  values_.law = {law, {}};
  values_.compared = {};
  values_.sweep = {};
  // Orientation acts on lengths through the flow only.
  if (!is_coupled()) values_.orientation = {};
}

void MoldExperiment::choose(std::span<const double> parameters) {
  const LawMenuItem& law = *chosen_law(attrition_menu(), values_.law);
  for (std::size_t i = 0; i < parameters.size(); ++i)
    values_.law.parameters[law.parameters[i].name] = parameters[i];
}

void MoldExperiment::fill() {
  setup_ = setup_ ? molding_setup(values_, setup_->part.shell) : molding_setup(values_);
  filling_.emplace(ShellMesh(setup_->part.shell), setup_->params);
  if (!is_coupled()) filling_->keep_steps();
  filling_->run_to_end();
  ++fillings_;
}

std::vector<MeanLengths> MoldExperiment::predict(std::span<const double> parameters) {
  choose(parameters);
  if (!filling_ || is_coupled()) {
    fill();
  } else {
    filling_->follow_lengths_again({{values_.law.name, make_attrition_law(values_.law.name, parameters)}});
  }
  return lengths_at_places();
}

std::vector<MeanLengths> MoldExperiment::lengths_at_places() const {
  const MoldingFields fields(values_, *setup_, *filling_);
  std::vector<MeanLengths> all;
  for (const NamedPlace& place : places()) {
    all.push_back(fields.means(0, fields.sample_at(place)));
    if (!std::isfinite(all.back().number_average))
      throw InputError(fmt::format("no melt comes to \"{}\": the filling ended ({}) at {:.4g} %", place.name,
                                   name(filling_->state().stop_reason), 100 * filling_->filled_fraction()),
                       "mold a part that fills, or leave out what was measured there");
  }
  return all;
}

MoldingCase read_molding(const std::vector<std::string>& row) {
  CaseChanges changes;
  for (std::size_t i = 1; i < row.size(); ++i)
    (row[i].find('=') == std::string::npos ? changes.variants : changes.overrides).push_back(row[i]);
  static const CaseKind kind = molding_kind();
  return std::any_cast<MoldingCase>(load_case(row[0], {&kind}, changes).values);
}

}  // namespace fiberfate
