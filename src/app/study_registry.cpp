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

const std::vector<Study>& studies() {
  static const std::vector<Study> all = {
      make_study(
          StudyFunctions<ShearCellCase>{"shear_cell",
                                        "shear a cell full of fibers: they orient, touch, bend and break",
                                        describe_shear_cell,
                                        validate_shear_cell,
                                        estimate_shear_cell,
                                        compute_shear_cell,
                                        report_shear_cell,
                                        {.threads = true, .until = true, .steps = true}}),
      make_study(
          StudyFunctions<ClusterCase>{"cluster",
                                      "pack fibers with a wanted orientation, length and concentration",
                                      describe_cluster,
                                      validate_cluster,
                                      estimate_cluster,
                                      compute_cluster,
                                      report_cluster,
                                      {.threads = true}}),
      make_study(StudyFunctions<AttritionCase>{
          "attrition", "follow fiber lengths through a history of flow and temperature by a length law",
          describe_attrition, validate_attrition, estimate_attrition, compute_attrition, report_attrition}),
      make_study(
          StudyFunctions<CalibrationCase>{"calibration",
                                          "fit the parameters of a length or orientation law to measurements",
                                          describe_calibration,
                                          validate_calibration,
                                          estimate_calibration,
                                          compute_calibration,
                                          report_calibration,
                                          {.threads = true}}),
      make_study(StudyFunctions<MoldingCase>{"molding",
                                             "fill a mold with melt: fibers orient and break on the way",
                                             describe_molding,
                                             validate_molding,
                                             estimate_molding,
                                             compute_molding,
                                             report_molding,
                                             {.threads = true, .until = true, .steps = true}}),
      make_study(StudyFunctions<OrientationCase>{
          "orientation", "follow the orientation tensor through a flow history by an orientation law",
          describe_orientation, validate_orientation, estimate_orientation, compute_orientation,
          report_orientation}),
      make_study(StudyFunctions<MeasurementCase>{
          "measurement", "evaluate lists of measured fiber lengths and directions, with intervals",
          describe_measurement, validate_measurement, estimate_measurement, compute_measurement,
          report_measurement}),
      make_study(StudyFunctions<PropertiesCase>{
          "properties", "predict stiffness and thermal expansion from the lengths and orientation of fibers",
          describe_properties, validate_properties, estimate_properties, compute_properties,
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
