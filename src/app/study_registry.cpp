// Registers the studies: one line each.
#include "app/study_registry.hpp"

#include <algorithm>

#include "results/report_document.hpp"
#include "studies/attrition/run.hpp"
#include "studies/calibration/run.hpp"
#include "studies/cluster/case.hpp"
#include "studies/cluster/run.hpp"
#include "studies/measurement/run.hpp"
#include "studies/molding/run.hpp"
#include "studies/orientation/run.hpp"
#include "studies/properties/run.hpp"
#include "studies/shear_cell/case.hpp"
#include "studies/shear_cell/run.hpp"

namespace fiberfate {
namespace {

/// Wraps the functions of one study so that they take any case.
template <class Case>
Study erase_type(const StudyFunctions<Case>& typed) {
  const auto of = [](const CaseValues& values) -> const Case& { return *std::any_cast<Case>(&values); };
  Study study{case_kind(typed.name, typed.summary, typed.describe, typed.validate), {}, {}, {}, {}};
  study.estimate = [typed, of](const CaseValues& values) { return typed.estimate(of(values)); };
  study.run = [typed, of](const CaseValues& values, const RunOptions& options, ResultFolder& folder) {
    return typed.run(of(values), options, folder);
  };
  study.resume = [typed, of](const CaseValues& values, const RunOptions& options, ResultFolder& folder) {
    return typed.resume(of(values), options, folder);
  };
  study.report = [typed, of](const CaseValues& values, const ResultFolder& folder) {
    return typed.report(of(values), folder);
  };
  return study;
}

}  // namespace

const std::vector<Study>& studies() {
  static const std::vector<Study> all = {
      erase_type(StudyFunctions<ShearCellCase>{
          "shear_cell", "shear a cell full of fibers: they orient, touch, bend and break",
          describe_shear_cell, validate_shear_cell, estimate_shear_cell, run_shear_cell, resume_shear_cell,
          report_shear_cell}),
      erase_type(StudyFunctions<ClusterCase>{
          "cluster", "pack fibers with a wanted orientation, length and concentration", describe_cluster,
          validate_cluster, estimate_cluster, run_cluster, resume_cluster, report_cluster}),
      erase_type(StudyFunctions<AttritionCase>{
          "attrition", "follow fiber lengths through a history of flow and temperature by a length law",
          describe_attrition, validate_attrition, estimate_attrition, run_attrition, resume_attrition,
          report_attrition}),
      erase_type(StudyFunctions<CalibrationCase>{
          "calibration", "fit the parameters of a length or orientation law to measurements",
          describe_calibration, validate_calibration, estimate_calibration, run_calibration,
          resume_calibration, report_calibration}),
      erase_type(StudyFunctions<MoldingCase>{
          "molding", "fill a mold with melt: fibers orient and break on the way", describe_molding,
          validate_molding, estimate_molding, run_molding, resume_molding, report_molding}),
      erase_type(StudyFunctions<OrientationCase>{
          "orientation", "follow the orientation tensor through a flow history by an orientation law",
          describe_orientation, validate_orientation, estimate_orientation, run_orientation,
          resume_orientation, report_orientation}),
      erase_type(StudyFunctions<MeasurementCase>{
          "measurement", "evaluate lists of measured fiber lengths and directions, with intervals",
          describe_measurement, validate_measurement, estimate_measurement, run_measurement,
          resume_measurement, report_measurement}),
      erase_type(StudyFunctions<PropertiesCase>{
          "properties", "predict stiffness and thermal expansion from the lengths and orientation of fibers",
          describe_properties, validate_properties, estimate_properties, run_properties, resume_properties,
          report_properties}),
  };
  return all;
}

const Study* find_study(const std::string& name) {
  const auto found = std::find_if(studies().begin(), studies().end(),
                                  [&name](const Study& study) { return study.name == name; });
  return found == studies().end() ? nullptr : &*found;
}

std::vector<std::string> study_names() {
  std::vector<std::string> names;
  for (const Study& study : studies()) names.push_back(study.name);
  return names;
}

CaseKinds case_kinds() {
  CaseKinds kinds;
  for (const Study& study : studies()) kinds.push_back(&study);
  return kinds;
}

const Study& study_of(const LoadedCase& loaded) {
  return *find_study(loaded.kind->name);
}

}  // namespace fiberfate
