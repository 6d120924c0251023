// The flow of a cell: what moves, how fast over time, in keys and as a history.
#pragma once

#include <optional>
#include <vector>

#include "fibers/lattice_frame.hpp"
#include "keys/case_checker.hpp"
#include "keys/key_rows.hpp"
#include "microstructure/flow_history.hpp"

namespace fiberfate {

/// What the melt does.
enum class FlowType { shear, planar, uniaxial, biaxial, mixed, gradient };
/// How fast over time.
enum class FlowKind { constant, ramp, oscillation, table };

/// [flow]: the velocity gradient is rate(t) times that of the type.
struct FlowChoices {
  FlowType type = FlowType::shear;
  FlowKind kind = FlowKind::constant;
  std::optional<double> rate;                 ///< 1/s
  double alpha = 0;                           ///< of type "mixed"
  std::vector<std::vector<double>> gradient;  ///< of type "gradient": one row L11, L12, … L33, 1/s
  std::optional<double> viscosity;            ///< of the matrix, Pa s
  double ramp_duration = 1;                   ///< s
  int ramp_steps = 10;
  std::optional<double> period;  ///< of kind "oscillation", s
  int period_steps = 100;
  /// Rows (end time s, rate 1/s, viscosity Pa s); the last one lasts.
  std::vector<std::vector<double>> table;
  /// Of type "gradient" and kind "table": rows (end time s, L11, … L33 1/s, viscosity Pa s).
  std::vector<std::vector<double>> gradient_table;
};

inline constexpr const char* flow_text =
    "The homogeneous flow of the melt; positive rates of elongation stretch along x.";

[[nodiscard]] KeyGroup<FlowChoices> flow_keys();
/// The types with their names.
[[nodiscard]] const Choices<FlowType>& flow_types();
/// The key `type`, and those of a flow that is constant, of which a case may have to give the rate.
[[nodiscard]] KeyRow<FlowChoices> flow_type_row();
[[nodiscard]] KeyRows<FlowChoices> constant_flow_rows(Given rate);
/// Finds what contradicts what within [flow].
void validate_flow(const FlowChoices& flow, double duration, CaseChecker& checker);

/// The velocity gradient of a type at the rate 1/s: u_x = y; diag(1, −1, 0); diag(1, −1/2, −1/2); diag(1, 1,
/// −2);
/// [[0, 1], [alpha, 0]]; flow.gradient as it stands.
[[nodiscard]] Mat3 unit_gradient(const FlowChoices& flow);
/// Makes the flow history of a valid case.
[[nodiscard]] FlowHistory flow_history(const FlowChoices& flow);
/// The rate of a flow of this type, 1/s: that of its keys, with its sign; of any gradient sqrt(2 D:D).
[[nodiscard]] double flow_rate(const FlowChoices& flow, const Mat3& gradient);
/// The integral of the rate from the start until `time`: the shear strain, the Hencky strain along x.
[[nodiscard]] double flow_strain(const FlowChoices& flow, const FlowHistory& history, double time);
/// The integral of twice the largest principal rate until `time`: in simple shear of the rate's size.
[[nodiscard]] double total_strain(const FlowHistory& history, double time);
/// The largest logarithmic strain along the axes of the flow until `time`; 0 in simple shear, and in flows
/// that turn.
[[nodiscard]] double hencky_strain(const LatticeFrame& frame, const FlowHistory& history, double time);
/// The viscosity that the total stress 2 eta D + stress shows in an elongation, Pa s: sigma_11 − sigma_22
/// over the rate (planar), sigma_11 − (sigma_22 + sigma_33)/2 (uniaxial), (sigma_11 + sigma_22)/2 − sigma_33
/// (biaxial); NaN in other flows.
[[nodiscard]] double elongational_viscosity(FlowType type, const Flow& flow, const Mat3& stress);

}  // namespace fiberfate
