// Registers the studies: one line each.
#include "app/study_registry.hpp"

#include <algorithm>

#include "base/law_text.hpp"
#include "results/report_document.hpp"
#include "studies/attrition/run.hpp"
#include "studies/calibration/run.hpp"
#include "studies/cluster/case.hpp"
#include "studies/cluster/run.hpp"
#include "studies/measurement/run.hpp"
#include "studies/molding/run.hpp"
#include "studies/orientation/run.hpp"
#include "studies/properties/run.hpp"
#include "studies/rheometer/run.hpp"
#include "studies/shear_cell/case.hpp"
#include "studies/shear_cell/run.hpp"

namespace fiberfate {

namespace {

constexpr MethodText shear_cell_method = {
    "Every fiber is a chain of rigid rods in a periodic cell of melt in simple shear (direct fiber "
    "simulation). "
    "The melt drags the rods, hinges between them bend, rods that touch push and rub each other, and hinges "
    "break; "
    "inertia and Brownian motion are neglected.",
    thesis_title};
constexpr MethodText cluster_method = {
    "Fibers of given lengths and orientation are packed into a periodic cell without overlap, bent where "
    "straight ones do not fit.",
    thesis_title};
constexpr MethodText attrition_method = {
    "Fiber lengths at a point follow a law of attrition through a given history of flow and temperature.",
    ""};
constexpr MethodText calibration_method = {
    "Parameters of the law are those of the least weighted squares of the differences to the measurements "
    "(Levenberg-Marquardt); intervals are linearised, of profile likelihoods, or of a bootstrap, as the "
    "report says.",
    ""};
constexpr MethodText molding_method = {
    "The melt fills a thin cavity as Hele-Shaw flow of a fluid that shears thin and cools, on the triangles "
    "of the middle surface and in "
    "layers across the gap; orientation and fiber lengths are carried along, with fountain flow at the "
    "front.",
    ""};
constexpr MethodText orientation_method = {
    "The second-order orientation tensor follows its evolution equation through a given history of flow.",
    "Advani, Tucker, J. Rheol. 31, 751 (1987)"};
constexpr MethodText measurement_method = {
    "Averages of measured fiber lengths and directions have intervals from a bootstrap of the fibers.", ""};
constexpr MethodText properties_method = {
    "Stiffness and thermal expansion are those of aligned fibers of the same lengths, averaged over the "
    "orientation.",
    "Advani, Tucker, J. Rheol. 31, 751 (1987)"};

constexpr MethodText rheometer_method = {
    "The stress that fibers add to the melt is averaged over the stationary part of direct simulations of "
    "periodic cells, each with a packing of its own for every replica; N_p is that of the least squares of "
    "the "
    "deviatoric stress, R_T that of a linear regression of the viscosity.",
    "Tucker, J. Non-Newton. Fluid Mech. 39, 239 (1991); Favaloro, Tseng, Pipes, Composites A 115, 207 "
    "(2018)"};

}  // namespace

const std::vector<Study>& studies() {
  static const std::vector<Study> all = {
      make_study(StudyFunctions<ShearCellCase>{
          "shear_cell", "shear a cell full of fibers: they orient, touch, bend and break",
          describe_shear_cell, validate_shear_cell, estimate_shear_cell, compute_shear_cell,
          report_shear_cell, TakenOptions{.threads = true, .until = true, .steps = true}, shear_cell_method}),
      make_study(StudyFunctions<ClusterCase>{
          "cluster", "pack fibers with a wanted orientation, length and concentration", describe_cluster,
          validate_cluster, estimate_cluster, compute_cluster, report_cluster, TakenOptions{.threads = true},
          cluster_method}),
      make_study(StudyFunctions<AttritionCase>{
          "attrition", "follow fiber lengths through a history of flow and temperature by a length law",
          describe_attrition, validate_attrition, estimate_attrition, compute_attrition, report_attrition,
          TakenOptions{}, attrition_method}),
      make_study(StudyFunctions<CalibrationCase>{
          "calibration", "fit the parameters of a length or orientation law to measurements",
          describe_calibration, validate_calibration, estimate_calibration, compute_calibration,
          report_calibration, TakenOptions{.threads = true}, calibration_method}),
      make_study(StudyFunctions<MoldingCase>{
          "molding", "fill a mold with melt: fibers orient and break on the way", describe_molding,
          validate_molding, estimate_molding, compute_molding, report_molding,
          TakenOptions{.threads = true, .until = true, .steps = true}, molding_method}),
      make_study(StudyFunctions<OrientationCase>{
          "orientation", "follow the orientation tensor through a flow history by an orientation law",
          describe_orientation, validate_orientation, estimate_orientation, compute_orientation,
          report_orientation, TakenOptions{}, orientation_method}),
      make_study(StudyFunctions<MeasurementCase>{
          "measurement", "evaluate lists of measured fiber lengths and directions, with intervals",
          describe_measurement, validate_measurement, estimate_measurement, compute_measurement,
          report_measurement, TakenOptions{}, measurement_method}),
      make_study(StudyFunctions<PropertiesCase>{
          "properties", "predict stiffness and thermal expansion from the lengths and orientation of fibers",
          describe_properties, validate_properties, estimate_properties, compute_properties,
          report_properties, TakenOptions{}, properties_method}),
      make_study(StudyFunctions<RheometerCase>{
          "rheometer",
          "measure the viscosity and normal stresses of fibers in melt over rates, flows and fibers",
          describe_rheometer, validate_rheometer, estimate_rheometer, compute_rheometer, report_rheometer,
          TakenOptions{.threads = true, .steps = true}, rheometer_method}),
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
