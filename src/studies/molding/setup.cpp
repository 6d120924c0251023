// Translates cases of the study molding.
#include "studies/molding/setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "calibration/sweep.hpp"
#include "continuum/anisotropic_stress.hpp"
#include "continuum/length_classes.hpp"
#include "continuum/length_registry.hpp"
#include "continuum/orientation_registry.hpp"
#include "microstructure/closure.hpp"
#include "studies/molding/gates.hpp"

namespace fiberfate {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

/// Makes the profile of rows (at, rate), or with a barrel the rates of ram speeds.
FlowProfile profile_of(const std::vector<std::vector<double>>& rows, ProfileAgainst against,
                       ProfileForm form) {
  FlowProfile profile;
  profile.against = against;
  profile.form = form;
  for (const std::vector<double>& row : rows) profile.rows.push_back({row[0], row[1]});
  return profile;
}

FlowProfile flow_of(const MachineChoices& machine, double volume) {
  const double barrel = machine.barrel_diameter.value_or(0);
  const ProfileForm form = machine.profile_form;
  if (!machine.flow_profile.empty()) return profile_of(machine.flow_profile, ProfileAgainst::time, form);
  if (!machine.flow_by_filled.empty())
    return profile_of(machine.flow_by_filled, ProfileAgainst::filled_fraction, form);
  if (!machine.ram_profile.empty())
    return flow_of_ram(profile_of(machine.ram_profile, ProfileAgainst::time, form), barrel);
  if (!machine.ram_by_filled.empty())
    return flow_of_ram(profile_of(machine.ram_by_filled, ProfileAgainst::filled_fraction, form), barrel);
  return FlowProfile::constant(machine.flow_rate ? *machine.flow_rate
                                                 : volume / machine.fill_time.value_or(1));
}

MoldingProcess process_of(const MachineChoices& machine, double volume) {
  MoldingProcess process;
  process.flow = flow_of(machine, volume);
  process.switchover_fraction = machine.switchover;
  process.switchover_pressure = machine.switchover_pressure.value_or(unlimited);
  process.pressure_limit = machine.pressure_limit.value_or(unlimited);
  process.inlet_temperature = machine.melt_temperature;
  process.mold_temperature = machine.mold_temperature;
  process.wall_transfer = machine.wall_transfer.value_or(unlimited);
  process.longest_time = machine.longest_time.value_or(unlimited);
  return process;
}

MoldingMaterial material_of(const MoldingCase& values) {
  MoldingMaterial material;
  material.viscosity = make_viscosity_law(values.melt.name, law_values(viscosity_menu(), values.melt));
  material.density = values.material.density;
  material.heat_capacity = values.material.heat_capacity;
  material.conductivity = values.material.conductivity;
  material.no_flow_temperature = values.material.no_flow_temperature;
  return material;
}

OrientationModel orientation_of(const MoldingCase& values) {
  OrientationModel model = orientation_model_named(values.orientation.name, values.fibers.closure);
  const LawMenuItem& law = *chosen_law(orientation_menu(), values.orientation);
  const std::vector<double> constants = law_values(orientation_menu(), values.orientation);
  for (std::size_t i = 0; i < constants.size(); ++i)
    set_constant(model, law.parameters[i].name, constants[i]);
  return model;
}

std::shared_ptr<const AttritionLaw> length_law(const LawChoice& choice) {
  return make_attrition_law(choice.name, law_values(attrition_menu(), choice));
}

void add_length_sets(const MoldingCase& values, MoldingSetup& setup) {
  std::vector<LengthSet>& sets = setup.params.fibers.length_sets;
  if (values.law.name.empty()) return;
  sets.push_back({values.law.name, length_law(values.law)});
  if (const MoldingSweep& sweep = values.sweep; !sweep.parameter.empty())
    setup.sweep_values = swept_values({0, sweep.lower.value_or(0), sweep.upper.value_or(0),
                                       static_cast<std::size_t>(sweep.count), sweep.spacing});
  for (const double value : setup.sweep_values) {
    LawChoice varied = values.law;
    varied.parameters[values.sweep.parameter] = value;
    sets.push_back({fmt::format("{} {:.6g}", values.sweep.parameter, value), length_law(varied)});
  }
  if (values.compared.name.empty()) return;
  setup.compared_set = static_cast<int>(sets.size());
  sets.push_back({values.compared.name, length_law(values.compared)});
}

void add_classes(const MoldingFiberChoices& choices, MoldingSetup& setup) {
  MoldingFibers& fibers = setup.params.fibers;
  fibers.class_weight = choices.weight;
  if (choices.number_average && choices.weight_average) {
    fibers.class_lengths = {*choices.number_average, *choices.weight_average};
    setup.reading = LengthReading::means;
  }
  if (choices.length) fibers.class_lengths = {*choices.length};
  fibers.class_numbers.assign(fibers.class_lengths.size(), 1.0);
  for (const std::vector<double>& row : choices.distribution) {
    fibers.class_lengths.push_back(row[0]);
    fibers.class_numbers.push_back(row[1]);
  }
}

/// Finds the class whose length the flow feels: the one nearest to L_W at the gates.
int driving_class(const MoldingSetup& setup) {
  if (setup.reading == LengthReading::means) return 1;
  const std::vector<double>& lengths = setup.params.fibers.class_lengths;
  const double wanted = mean_lengths(lengths, setup.params.fibers.class_numbers).weight_average;
  const auto nearest = std::min_element(lengths.begin(), lengths.end(), [wanted](double a, double b) {
    return std::abs(a - wanted) < std::abs(b - wanted);
  });
  return static_cast<int>(nearest - lengths.begin());
}

void add_coupling(const MoldingFiberChoices& choices, MoldingSetup& setup) {
  if (choices.coupling == CouplingChoice::none) return;
  MoldingFibers& fibers = setup.params.fibers;
  FiberCoupling coupling;
  coupling.volume_fraction = choices.volume_fraction;
  coupling.diameter = choices.diameter;
  coupling.length_set = fibers.length_sets.empty() ? -1 : 0;
  coupling.length_class = driving_class(setup);
  const std::size_t driving = coupling.length_class;
  coupling.aspect_ratio = fibers.class_lengths[driving] / choices.diameter;
  coupling.drag = choices.drag;
  if (choices.trouton_term) {
    const double ratio = choices.trouton_length.value_or(fibers.class_lengths[driving]) / choices.diameter;
    coupling.scale =
        *choices.trouton_term / (choices.volume_fraction * particle_number(ratio, choices.volume_fraction));
  }
  fibers.coupling = coupling;
}

MoldingSetup setup_of(const MoldingCase& values, MoldingPart part) {
  MoldingSetup setup;
  setup.part = std::move(part);
  FillingParams& params = setup.params;
  params.material = material_of(values);
  params.process = process_of(values.machine, volume_of(setup.part.shell));
  params.sensors = sensors_of(values.gates, setup.part);
  params.gates = gates_of(values.gates, setup.part);
  params.numerics = values.numerics;
  if (!values.orientation.name.empty()) params.fibers.orientation = orientation_of(values);
  params.fibers.inlet.orientation = values.fibers.inlet_orientation;
  params.fibers.inlet.axes = values.fibers.inlet_axes;
  add_classes(values.fibers, setup);
  add_gate_inlets(values.gates, setup);
  add_length_sets(values, setup);
  add_coupling(values.fibers, setup);
  return setup;
}

}  // namespace

Vec3 position_of(const NamedPlace& place, const MoldingPart& part) {
  const std::vector<double>& x = place.numbers;
  if (x.size() == 3) return {x[0], x[1], x[2]};
  if (!part.place)
    throw InputError(
        fmt::format("place \"{}\" has two coordinates, but a part from a file lies in space", place.name),
        "give x, y and z");
  return part.place({x[0], x[1]});
}

MoldingSetup molding_setup(const MoldingCase& values) {
  return setup_of(values, make_part(values.part));
}

MoldingSetup molding_setup(const MoldingCase& values, const Shell& shell) {
  MoldingPart part = part_around(values.part);
  part.shell = shell;
  return setup_of(values, std::move(part));
}

}  // namespace fiberfate
