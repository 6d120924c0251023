// Checks the parameters of a filling against each other and against the part.
#include "molding/filling_params.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/admissibility.hpp"
#include "molding/gap_layers.hpp"
#include "molding/gate_checks.hpp"
#include "molding/mesh_quality.hpp"

namespace fiberfate {
namespace {

using Problems = std::vector<InputProblem>;

/// Shear rate at which a melt must have a viscosity, 1/s.
constexpr double usual_rate = 10;

void add(Problems& problems, std::string key, double value, std::string complaint, std::string remedy) {
  problems.push_back(
      {"", 0, 0, std::move(key), fmt::format("{:g}", value), std::move(complaint), std::move(remedy)});
}

void require_positive(Problems& problems, const std::string& key, double value) {
  if (!(value > 0) || !std::isfinite(value))
    add(problems, key, value, "it is not positive", "give a number above zero");
}

void check_material(const FillingParams& params, Problems& problems) {
  const MoldingMaterial& m = params.material;
  if (!m.viscosity)
    problems.push_back({"", 0, 0, "material.viscosity", "", "it is missing", "choose a viscosity law"});
  require_positive(problems, "material.density", m.density);
  require_positive(problems, "material.heat_capacity", m.heat_capacity);
  require_positive(problems, "material.conductivity", m.conductivity);
  const double inlet = params.process.inlet_temperature;
  require_positive(problems, "process.inlet_temperature", inlet);
  require_positive(problems, "process.mold_temperature", params.process.mold_temperature);
  const double at_gates = m.viscosity ? m.viscosity->at({usual_rate, inlet, 0}) : 1;
  if (!(at_gates > 0) || !std::isfinite(at_gates))
    add(problems, "material.viscosity", at_gates,
        fmt::format("so many Pa s has the melt at {:g} 1/s and {:g} K", usual_rate, inlet),
        "check the constants of the viscosity law and the temperature of the melt");
  if (m.no_flow_temperature >= inlet)
    add(problems, "material.no_flow_temperature", m.no_flow_temperature,
        fmt::format("the melt comes in at {:g} K and stands still", inlet),
        "raise the inlet temperature or lower the no-flow temperature");
}

void check_process(const MoldingProcess& process, Problems& problems) {
  const std::vector<ProfileRow>& rows = process.flow.rows;
  if (rows.empty())
    problems.push_back({"", 0, 0, "process.flow", "", "it has no rows", "give at least one flow rate"});
  for (std::size_t i = 0; i < rows.size(); ++i) {
    require_positive(problems, "process.flow", rows[i].rate);
    if (i > 0 && !(rows[i].at > rows[i - 1].at))
      add(problems, "process.flow", rows[i].at, "the rows do not rise",
          "sort them by time or filled fraction");
  }
  if (!(process.switchover_fraction > 0) || process.switchover_fraction > 1)
    add(problems, "process.switchover_fraction", process.switchover_fraction, "it is no share of the cavity",
        "give a number above 0 and at most 1; 1 never switches over");
  if (!(process.switchover_pressure > 0) || !(process.pressure_limit > 0) || !(process.wall_transfer > 0) ||
      !(process.longest_time > 0))
    problems.push_back({"", 0, 0, "process", "",
                        "a pressure, the transfer to the wall or the longest time is not positive",
                        "leave it out to have no limit"});
}

void check_inlet(const InletFibers& inlet, const MoldingFibers& fibers, const std::string& key,
                 Problems& problems) {
  const std::string fault = fault_of(inlet.orientation, 1e-6);
  if (!fault.empty())
    problems.push_back({"", 0, 0, key + ".orientation", "", fault, "give a tensor of some distribution"});
  if (!inlet.lengths.empty() && inlet.lengths.size() != fibers.class_lengths.size())
    problems.push_back(
        {"", 0, 0, key + ".lengths", "",
         fmt::format("{} lengths for {} classes", inlet.lengths.size(), fibers.class_lengths.size()),
         "give one length a class, or none"});
  for (const double length : inlet.lengths) require_positive(problems, key + ".lengths", length);
  if (inlet.numbers.empty()) return;
  if (inlet.numbers.size() != fibers.class_lengths.size() ||
      fibers.class_numbers.size() != fibers.class_lengths.size())
    problems.push_back(
        {"", 0, 0, key + ".numbers", "",
         fmt::format("{} numbers for {} classes", inlet.numbers.size(), fibers.class_lengths.size()),
         "give one number a class, here and for all gates"});
  double sum = 0;
  for (const double number : inlet.numbers) sum += number >= 0 ? number : std::nan("");
  if (!(sum > 0) || !std::isfinite(sum))
    add(problems, key + ".numbers", sum, "some are negative, or none is positive",
        "give numbers of fibers, at least one above zero");
}

void check_inlet_of(const std::string& gate, const InletFibers& inlet, const MoldingFibers& fibers,
                    Problems& problems) {
  const std::size_t before = problems.size();
  check_inlet(inlet, fibers, "gates.inlet", problems);
  for (std::size_t i = before; i < problems.size(); ++i) problems[i].value = gate;
}

void check_fibers(const FillingParams& params, Problems& problems) {
  const MoldingFibers& fibers = params.fibers;
  if (!fibers.length_sets.empty() && fibers.class_lengths.empty())
    problems.push_back(
        {"", 0, 0, "fibers.class_lengths", "", "there are none", "give at least one initial length"});
  for (const double length : fibers.class_lengths) require_positive(problems, "fibers.class_lengths", length);
  for (const LengthSet& set : fibers.length_sets) {
    if (!set.law || (!set.law->relaxation() && !set.law->fragmentation()))
      problems.push_back({"", 0, 0, "length set " + set.name, "", "its law cannot be transported",
                          "choose a law of the registry"});
    if (set.law && set.law->fragmentation() && fibers.class_numbers.size() != fibers.class_lengths.size())
      problems.push_back({"", 0, 0, "fibers.class_numbers", "",
                          "the law of set " + set.name + " needs a length distribution",
                          "give the number of fibers of each class"});
  }
  check_inlet(fibers.inlet, fibers, "fibers.inlet", problems);
  if (!fibers.gate_inlets.empty() && fibers.gate_inlets.size() != params.gates.size())
    problems.push_back({"", 0, 0, "fibers.gate_inlets", "",
                        fmt::format("{} inlets for {} gates", fibers.gate_inlets.size(), params.gates.size()),
                        "give one a gate, or none"});
  for (std::size_t g = 0; g < std::min(fibers.gate_inlets.size(), params.gates.size()); ++g)
    if (fibers.gate_inlets[g]) check_inlet_of(params.gates[g].name, *fibers.gate_inlets[g], fibers, problems);
}

void check_coupling(const MoldingFibers& fibers, Problems& problems) {
  if (!fibers.coupling) return;
  const FiberCoupling& c = *fibers.coupling;
  if (!fibers.orientation)
    problems.push_back({"", 0, 0, "fibers.coupling", "", "the viscosity needs the orientation",
                        "choose an orientation law"});
  if (!(c.volume_fraction > 0) || !(c.volume_fraction < 1))
    add(problems, "fibers.coupling.volume_fraction", c.volume_fraction, "it is out of range",
        "give a number between 0 and 1");
  require_positive(problems, "fibers.coupling.diameter", c.diameter);
  if (!(c.scale >= 0))
    add(problems, "fibers.coupling.scale", c.scale, "it is negative",
        "give 1 for the semi-dilute R, less for what is known of R");
  if (c.length_set < 0 && !(c.aspect_ratio > 1))
    add(problems, "fibers.coupling.aspect_ratio", c.aspect_ratio, "it is not above 1",
        "give length/diameter");
  const auto sets = static_cast<int>(fibers.length_sets.size());
  const auto classes = static_cast<int>(fibers.class_lengths.size());
  if (c.length_set >= 0 && (c.length_set >= sets || c.length_class < 0 || c.length_class >= classes ||
                            !fibers.length_sets[c.length_set].law->relaxation()))
    add(problems, "fibers.coupling.length_set", c.length_set, "there is no such length",
        "name a set of a relaxation law and a class, counted from 0");
}

void check_numerics(const FillingNumerics& numerics, Problems& problems) {
  if (numerics.layers % 2 != 0 || numerics.layers < 4 ||
      numerics.layers > 2 * static_cast<int>(most_half_layers))
    add(problems, "numerics.layers", numerics.layers, "so many layers cannot be computed",
        "take an even number from 4 to 128");
  if (numerics.steps < 10) add(problems, "numerics.steps", numerics.steps, "too few", "take at least 10");
  if (numerics.most_iterations < 1)
    add(problems, "numerics.most_iterations", numerics.most_iterations, "too few", "take at least 1");
  require_positive(problems, "numerics.viscosity_tolerance", numerics.viscosity_tolerance);
  require_positive(problems, "numerics.orientation_tolerance", numerics.orientation_tolerance);
}

}  // namespace

void check_params(const FillingParams& params, const ShellMesh& mesh) {
  Problems problems;
  check_material(params, problems);
  check_process(params.process, problems);
  check_gates(params, mesh, problems);
  check_quality(mesh, params.gates, problems);
  check_fibers(params, problems);
  check_coupling(params.fibers, problems);
  check_numerics(params.numerics, problems);
  if (!problems.empty()) throw InputError(problems);
  if (params.fibers.orientation) require_admissible(*params.fibers.orientation);
}

}  // namespace fiberfate
