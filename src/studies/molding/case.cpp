// Checks a case of the study molding.
#include "studies/molding/case.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "studies/length_choices.hpp"
#include "studies/molding/effort.hpp"
#include "studies/molding/setup.hpp"

#include "base/error.hpp"
#include "base/timer.hpp"
#include "continuum/attrition_law.hpp"
#include "molding/filling.hpp"
#include "molding/gate_nodes.hpp"
#include "molding/mesh_quality.hpp"
#include "results/memory_recorder.hpp"
#include "studies/pace.hpp"

namespace fiberfate {
namespace {

/// Error of the pressure by the mesh that users are told of.
constexpr double noticed_error = 0.01;

/// The work done grows with this power of the filled share: steps are of equal volume, and their work is that
/// of the melt that is there.
constexpr double work_power = 2;

/// All keys that can give the flow, and whether they do.
struct FlowKey {
  const char* key;
  bool given;
};
std::vector<FlowKey> flow_keys(const MachineChoices& machine) {
  return {{"machine.flow_rate", machine.flow_rate.has_value()},
          {"machine.fill_time", machine.fill_time.has_value()},
          {"machine.flow_profile", !machine.flow_profile.empty()},
          {"machine.flow_by_filled", !machine.flow_by_filled.empty()},
          {"machine.ram_profile", !machine.ram_profile.empty()},
          {"machine.ram_by_filled", !machine.ram_by_filled.empty()}};
}

void validate_machine(const MachineChoices& machine, CaseChecker& checker) {
  const std::vector<FlowKey> keys = flow_keys(machine);
  const auto given = std::ranges::count_if(keys, &FlowKey::given);
  // A profile that could not be read is no second fault.
  const auto is_sound = [&checker](const FlowKey& one) { return checker.is_sound(one.key); };
  if (given != 1 && std::ranges::all_of(keys, is_sound))
    checker.error(
        "machine.flow_rate", given == 0 ? "no flow is given" : "the flow is given in more than one way",
        "give one of flow_rate, fill_time, flow_profile, flow_by_filled, ram_profile, ram_by_filled");
  const bool ram = !machine.ram_profile.empty() || !machine.ram_by_filled.empty();
  if (ram && !machine.barrel_diameter)
    checker.error("machine.barrel_diameter", "not given; speeds of the ram need it",
                  "add barrel_diameter = \"50 mm\" under [machine]");
  if (!ram) checker.warn_unused({"machine.barrel_diameter"}, "ram_profile and ram_by_filled");
  if (machine.melt_temperature > 0 && !(machine.mold_temperature < machine.melt_temperature))
    checker.error("machine.mold_temperature", "not less than " + checker.cite("machine.melt_temperature"),
                  "give the temperature of the cooled mold");
}

void validate_lengths(const MoldingCase& values, CaseChecker& checker) {
  const MoldingFiberChoices& fibers = values.fibers;
  const bool means = fibers.number_average || fibers.weight_average;
  const int given = (fibers.length ? 1 : 0) + (fibers.distribution.empty() ? 0 : 1) + (means ? 1 : 0);
  if (given > 1)
    checker.error("fibers.length", "lengths are given in more than one way",
                  "give length, or distribution, or number_average and weight_average");
  if (given == 0 && lengths_are_read(checker) &&
      (!values.law.name.empty() || fibers.coupling != CouplingChoice::none))
    checker.error("fibers.length", "no lengths are given, but a law of length or the coupling needs them",
                  "give length, or distribution, or number_average and weight_average");
  if (means && !(fibers.number_average && fibers.weight_average))
    checker.error(fibers.number_average ? "fibers.weight_average" : "fibers.number_average", "not given",
                  "give both mean lengths");
  else if (means && !(*fibers.number_average <= *fibers.weight_average))
    checker.error("fibers.number_average", "more than " + checker.cite("fibers.weight_average"),
                  "L_N is never more than L_W");
  if (means && (needs_bins(values.law) || needs_bins(values.compared)))
    checker.error("fibers.number_average", laws_of_bins() + " follow distributions only",
                  "give fibers.distribution");
  if (values.law.name.empty() && !values.compared.name.empty())
    checker.error("compare.name", "there is no first law", "choose one in [law]");
}

void validate_coupling(const MoldingCase& values, CaseChecker& checker) {
  const MoldingFiberChoices& fibers = values.fibers;
  if (fibers.coupling != CouplingChoice::none && values.orientation.name.empty())
    checker.error("fibers.coupling", "the coupled viscosity needs the orientation",
                  "choose a law in [orientation]");
  if (fibers.coupling == CouplingChoice::none)
    checker.warn_unused({"fibers.trouton_term", "fibers.trouton_length", "fibers.drag"},
                        "fibers.coupling = \"informed_isotropic\"");
  if (fibers.trouton_length && !fibers.trouton_term)
    checker.error("fibers.trouton_length", "it belongs to fibers.trouton_term, which is not given",
                  "give both, or none");
  if (fibers.trouton_length && !(*fibers.trouton_length > fibers.diameter))
    checker.error("fibers.trouton_length", "not more than " + checker.cite("fibers.diameter"),
                  "give the length of the fibers");
}

void validate_sweep(const MoldingCase& values, CaseChecker& checker) {
  const MoldingSweep& sweep = values.sweep;
  for (const MeasuredLength& one : sweep.measured)
    if (std::none_of(values.output.places.begin(), values.output.places.end(),
                     [&](const NamedPlace& place) { return place.name == one.place; }))
      checker.error_in_row("sweep.measured", one.place, fmt::format("there is no place \"{}\"", one.place),
                           "add it to output.places");
  if (sweep.parameter.empty()) {
    checker.warn_unused({"sweep.lower", "sweep.upper", "sweep.count", "sweep.spacing", "sweep.measured"},
                        "sweep.parameter");
    return;
  }
  const LawMenuItem* law = chosen_law(attrition_menu(), values.law);
  const auto is_swept = [&](const LawParameter& one) { return one.name == sweep.parameter; };
  if (law == nullptr || std::none_of(law->parameters.begin(), law->parameters.end(), is_swept))
    checker.error("sweep.parameter", fmt::format("the law {} has no such parameter", values.law.name),
                  "name one of [law]");
  if (!sweep.lower || !sweep.upper || !(*sweep.lower < *sweep.upper))
    checker.error("sweep.lower", "not given, or not less than sweep.upper", "give lower and upper");
  else if (sweep.spacing == ParameterScale::logarithmic && !(*sweep.lower > 0))
    checker.error("sweep.lower", "not positive", "give a positive value, or spacing = \"linear\"");
  if (values.fibers.coupling != CouplingChoice::none)
    checker.warn(
        "sweep.parameter", "the flow is coupled to the fibers of [law] only",
        "where every value shall have its own flow, name this case under conditions.moldings of the study "
        "calibration");
}

/// Requires three coordinates of places on a part that has no flat drawing.
void validate_coordinates(const MoldingCase& values, CaseChecker& checker) {
  if (values.part.kind != PartKind::file) return;
  const auto check = [&checker](const char* key, const std::vector<NamedPlace>& places) {
    for (const NamedPlace& place : places)
      if (place.numbers.size() % 3 != 0)
        checker.error_in_row(key, place.name, "two coordinates, but a part from a file lies in space",
                             "give x, y and z");
  };
  check("gates.places", values.gates.places);
  check("gates.sensors", values.gates.sensors);
  check("output.places", values.output.places);
}

/// Whether a fault is of one gate or sensor; its value is then the name with which a row of the key begins.
bool is_of_row(const InputProblem& problem) {
  return (problem.key.starts_with("gates.") || problem.key.starts_with("sensors.")) && !problem.value.empty();
}

/// Finds the key of such a fault; those of [gates] are named alike.
std::string key_of_row(const std::string& fault) {
  constexpr std::pair<std::string_view, const char*> keys[] = {
      {"gates.events", "gates.valves"},
      {"gates.position", "gates.places"},
      {"gates.inlet.orientation", "gates.inlet_orientations"},
      {"gates.inlet.lengths", "gates.inlet_lengths"},
      {"gates.inlet.numbers", "gates.inlet_numbers"},
      {"sensors.position", "gates.sensors"}};
  const auto found = std::ranges::find(keys, fault, &std::pair<std::string_view, const char*>::first);
  return found == std::end(keys) ? fault : found->second;
}

/// Finds the key in the case of a fault of the solver's parameters.
std::string key_of(const InputProblem& problem, const MoldingCase& values) {
  const std::string& fault = problem.key;
  if (is_of_row(problem)) return key_of_row(fault);
  const std::vector<FlowKey> flows = flow_keys(values.machine);
  const bool meshed = values.part.kind != PartKind::file;
  // The first that the fault begins with.
  const std::pair<const char*, std::string> keys[] = {
      {"material.viscosity", "melt.name"},
      {"material.", fault},
      {"part.", fault},
      {"numerics", fault},
      {"output.", fault},
      {"gate", "gates.places"},
      {"process.flow", std::ranges::find_if(flows, &FlowKey::given)->key},
      {"process.inlet_temperature", "machine.melt_temperature"},
      {"process.mold", "machine.mold_temperature"},
      {"process", "machine.switchover"},
      {"fibers.inlet.orientation", "fibers.inlet_orientation"},
      {"fibers.coupling", "fibers.coupling"},
      {"fibers", "fibers.length"},
      {"length", "fibers.length"},
      {"mesh", meshed ? "part.mesh_size" : "part.file"},
      {"", meshed ? "part.kind" : "part.file"}};
  return std::ranges::find_if(keys, [&](const auto& one) { return fault.starts_with(one.first); })->second;
}

/// Warns of a mesh that costs more than a little accuracy.
void warn_of_mesh(const MoldingCase& values, const ShellMesh& mesh, std::span<const Gate> gates,
                  CaseChecker& checker) {
  const MeshQuality quality = quality_of(mesh, gates);
  if (quality.pressure_error() < noticed_error) return;
  const bool cut_off = quality.cut_off > noticed_error / 4;  // less, down to round-off, is not worth a word
  const std::string loss =
      cut_off ? fmt::format(", and {:.2g} % of what leads the flow lies between obtuse triangles and is lost",
                            100 * quality.cut_off)
              : "";
  checker.warn(
      values.part.kind == PartKind::file ? "part.file" : "part.mesh_size",
      fmt::format("the melt passes {} edges of the mesh on its longest way{}: pressures are wrong by "
                  "about {:.1f} %",
                  quality.reach, loss, 100 * quality.pressure_error()),
      cut_off ? "make a Delaunay mesh" : "make a finer mesh");
}

/// Meshes the part and lets the solver check what it will be given.
void validate_filling(const MoldingCase& values, CaseChecker& checker) {
  try {
    const MoldingSetup setup = molding_setup(values);
    const ShellMesh mesh(setup.part.shell);
    check_params(setup.params, mesh);
    for (const std::string& remark : setup.part.remarks)
      checker.warn("part.file", remark, "look at the mesh if that is not what it should be");
    warn_of_mesh(values, mesh, setup.params.gates, checker);
    for (const NamedPlace& place : values.output.places) {
      Gate probe;
      probe.position = position_of(place, setup.part);
      const double gap = distance_from_part(probe, mesh);
      if (gap > std::max(values.output.place_radius, 1e-3))
        checker.error_in_row("output.places", place.name,
                             fmt::format("\"{}\" lies {:.4g} mm off the part", place.name, 1e3 * gap),
                             "move it onto the part");
    }
  } catch (const InputError& error) {
    for (const InputProblem& problem : error.problems()) {
      const std::string key = key_of(problem, values);
      if (problem.line > 0) {  // of a file that the key names
        InputProblem there = problem;
        const std::string remedy = std::exchange(there.remedy, {});
        checker.error(key, there.message(), remedy);
        continue;
      }
      if (is_of_row(problem)) {
        checker.error_in_row(key, problem.value, problem.complaint, problem.remedy);
        continue;
      }
      std::string subject;
      if (key != problem.key && !problem.key.empty())
        subject = problem.key + (problem.value.empty() ? "" : " = " + problem.value) + ": ";
      checker.error(key, subject + problem.complaint, problem.remedy);
    }
  }
}

}  // namespace

void validate_molding(const MoldingCase& values, CaseChecker& checker) {
  validate_part(values.part, checker);
  validate_law(viscosity_menu(), "melt", values.melt, checker);
  validate_law(orientation_menu(), "orientation", values.orientation, checker);
  validate_law(attrition_menu(), "law", values.law, checker);
  validate_law(attrition_menu(), "compare", values.compared, checker);
  validate_machine(values.machine, checker);
  validate_lengths(values, checker);
  validate_coupling(values, checker);
  validate_sweep(values, checker);
  validate_coordinates(values, checker);
  // A part from a file that may be gone is in the checkpoint.
  const bool meshed_before = values.part.kind == PartKind::file && checker.files_may_be_gone();
  if (checker.is_sound() && !meshed_before) validate_filling(values, checker);
}

namespace {

/// Foretells the wall seconds of a filling from its first steps. The work of a step grows with the melt that
/// is there.
double expected_seconds(const MoldingCase& values, const MoldingSetup& setup, const ShellMesh& mesh) {
  MemoryRecorder recorder;
  Session(recorder).use_threads(values.run.threads);
  Pace trial(0.15);
  Filling filling(mesh, setup.params);
  while (trial.has_time() && !filling.finished()) {
    filling.advance();
    trial.reached(filling.finished() ? 1 : std::pow(filling.filled_fraction(), work_power));
  }
  return trial.whole();
}

}  // namespace

double filling_bytes(const MoldingSetup& setup) {
  const MoldingFibers& fibers = setup.params.fibers;
  const auto nodes = static_cast<double>(setup.part.shell.nodes.size());
  const double points = 0.5 * nodes * static_cast<double>(setup.params.numerics.layers);
  std::size_t fields = 0, bins = 0;
  for (const LengthSet& set : fibers.length_sets) {
    fields += set.law->fragmentation() != nullptr ? fibers.phelps_bins
                                                  : std::max<std::size_t>(1, fibers.class_lengths.size());
    if (set.law->fragmentation() != nullptr) bins = fibers.phelps_bins;
  }
  return static_cast<double>(peak_memory_bytes()) + points * (200 + 24 * static_cast<double>(fields)) +
         5e3 * nodes + PhelpsSolver::memory_bytes(bins);
}

CaseEstimate estimate_molding(const MoldingCase& values) {
  const MoldingSetup setup = molding_setup(values);
  // A file is read for the checks and for the filling.
  const double meshing = setup.part.meshing_s * (values.part.kind == PartKind::file ? 2 : 1);
  const ShellMesh mesh(setup.part.shell);
  Vec3 low = setup.part.shell.nodes.front(), high = low;
  for (const Vec3& node : setup.part.shell.nodes) {
    low = low.cwiseMin(node);
    high = high.cwiseMax(node);
  }
  const double rate = setup.params.process.flow.at(0, 0);
  const Vec3 size = 1e3 * (high - low);
  CaseEstimate estimate;
  estimate.facts = {
      {"nodes", fmt::format("{}", mesh.node_count())},
      {"triangles", fmt::format("{}", mesh.triangle_count())},
      {"size of the part", fmt::format("{:.4g} x {:.4g} x {:.4g} mm", size.x(), size.y(), size.z())},
      {"volume", fmt::format("{:.6g} cm^3", 1e6 * mesh.total_volume())},
      {"area", fmt::format("{:.6g} cm^2", 1e4 * mesh.total_area())},
      {"regions", fmt::format("{}", fmt::join(setup.part.regions, ", "))},
      {"gates", fmt::format("{}", setup.params.gates.size())},
      {"flow rate at the start", fmt::format("{:.6g} cm^3/s", 1e6 * rate)},
      {"fill time at that rate", fmt::format("{:.6g} s", mesh.total_volume() / rate)},
      {"length laws", fmt::format("{}", setup.params.fibers.length_sets.size())}};
  estimate.memory_bytes = filling_bytes(setup);
  const double outputs = seconds_a_frame * static_cast<double>(values.output.frames);
  foretell(
      estimate, [&] { return meshing + outputs + expected_seconds(values, setup, mesh); },
      "from a trial of its first steps");
  return estimate;
}

CaseKind molding_kind() {
  return case_kind("molding", "fill a mold with melt: fibers orient and break on the way", describe_molding,
                   validate_molding);
}

}  // namespace fiberfate
