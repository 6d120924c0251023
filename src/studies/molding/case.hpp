// A case of the study molding: a part, its gates, a material, a machine, and the fibers in the melt.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/fit_problem.hpp"
#include "continuum/attrition_law.hpp"
#include "continuum/homogenisation.hpp"
#include "keys/case_checker.hpp"
#include "keys/law_choice.hpp"
#include "keys/text_rows.hpp"
#include "microstructure/mean_lengths.hpp"
#include "molding/filling_params.hpp"
#include "studies/molding/part.hpp"
#include "studies/run_choices.hpp"
#include "studies/study.hpp"

namespace fiberfate {

/// One event of a valve as it is written: a trigger and the name of its sensor.
struct ValveEvent {
  Trigger trigger = {};
  std::string sensor;  ///< empty: the gate itself
};

/// When a gate of [gates] opens, closes, opens again, ...
struct ValveTimes {
  std::string gate;
  std::vector<ValveEvent> events;
};

/// The keys of [gates].
struct GateChoices {
  std::vector<NamedPlace> places;
  double radius = 1e-3;                   ///< m
  double resistance = 0;                  ///< of each gate's runner, Pa s/m³
  std::vector<NamedNumbers> resistances;  ///< of gates with a runner of their own, Pa s/m³
  std::vector<NamedPlace> sensors;
  std::vector<ValveTimes> valves;
  std::vector<NamedNumbers> orientations;  ///< three principal values along fibers.inlet_axes
  std::vector<NamedNumbers> lengths;       ///< one length a class of [fibers], m
  std::vector<NamedNumbers> numbers;       ///< of fibers, one a class of [fibers]
};

/// The keys of [material]: what the heat equation needs.
struct MaterialChoices {
  std::string preset;
  double density = 0;              ///< kg/m³
  double heat_capacity = 0;        ///< J/(kg K)
  double conductivity = 0;         ///< W/(m K)
  double no_flow_temperature = 0;  ///< K
};

/// The keys of [machine].
struct MachineChoices {
  std::optional<double> flow_rate;                                ///< m³/s
  std::optional<double> fill_time;                                ///< s
  std::vector<std::vector<double>> flow_profile, flow_by_filled;  ///< rows (s or share, m³/s)
  std::vector<std::vector<double>> ram_profile, ram_by_filled;    ///< rows (s or share, m/s)
  std::optional<double> barrel_diameter;                          ///< m
  ProfileForm profile_form = ProfileForm::steps;
  double switchover = 0.995;
  std::optional<double> switchover_pressure;  ///< Pa
  std::optional<double> pressure_limit;       ///< Pa
  double melt_temperature = 0;                ///< K
  double mold_temperature = 0;                ///< K
  std::optional<double> wall_transfer;        ///< W/(m² K)
  std::optional<double> longest_time;         ///< s
};

/// How the flow feels the fibers.
enum class CouplingChoice { none, informed_isotropic };

/// The keys of [fibers].
struct MoldingFiberChoices {
  std::optional<double> length;                   ///< m
  std::vector<std::vector<double>> distribution;  ///< rows (length m, number)
  std::optional<double> number_average;           ///< m
  std::optional<double> weight_average;           ///< m
  ClassWeight weight = ClassWeight::length;
  double diameter = 19e-6;     ///< m
  double volume_fraction = 0;  ///< 1
  std::string closure = "ibof";
  Mat3 inlet_orientation = Mat3::Identity() / 3;
  InletAxes inlet_axes = InletAxes::flow;
  CouplingChoice coupling = CouplingChoice::none;
  std::optional<double> trouton_term;    ///< R of the coupled viscosity, 1
  std::optional<double> trouton_length;  ///< at which R is that, m; not given: that at the gates
  DragViscosity drag = DragViscosity::matrix;
};

/// The keys of [composite]: what stiffness and expansion need.
struct CompositeChoices {
  Homogenisation model{};
  IsotropicElasticity fiber = {73e9, 0.22};
  IsotropicElasticity matrix = {1.5e9, 0.4};
  double fiber_expansion = 5e-6;     ///< 1/K
  double matrix_expansion = 1.1e-4;  ///< 1/K
};

/// One measured mean length.
struct MeasuredLength {
  std::string place;
  LengthMean mean = LengthMean::number_average;
  double length = 0;  ///< m
};

/// The keys of [sweep] and [measured].
struct MoldingSweep {
  std::string parameter;
  std::optional<double> lower, upper;
  std::int64_t count = 10;
  ParameterScale spacing = ParameterScale::logarithmic;
  std::vector<MeasuredLength> measured;
};

/// The keys of [output].
struct MoldingOutput {
  std::int64_t frames = 20;
  std::vector<NamedPlace> places;
  double place_radius = 5e-3;        ///< m
  double checkpoint_interval = 300;  ///< wall time, s
};

struct MoldingCase {
  PartChoices part;
  GateChoices gates;
  MaterialChoices material;
  LawChoice melt;
  MachineChoices machine;
  MoldingFiberChoices fibers;
  LawChoice orientation;  ///< no name: none
  LawChoice law;          ///< no name: lengths stay what they are
  LawChoice compared;     ///< a second length law
  CompositeChoices composite;
  MoldingSweep sweep;
  FillingNumerics numerics;
  MoldingOutput output;
  RunChoices run;
};

/// The kind of cases that fill a mold; other studies read such cases, too.
[[nodiscard]] CaseKind molding_kind();
void describe_molding(KeyTable& table, MoldingCase& values);
[[nodiscard]] KeyGroup<GateChoices> gate_keys();
[[nodiscard]] KeyGroup<MaterialChoices> material_keys();
[[nodiscard]] KeyGroup<MachineChoices> machine_keys();
void validate_molding(const MoldingCase& values, CaseChecker& checker);
[[nodiscard]] CaseEstimate estimate_molding(const MoldingCase& values);

}  // namespace fiberfate
