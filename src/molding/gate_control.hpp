// Opens and closes gates, fills their own control volumes, and tells when the next event is due.
#pragma once

#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/pressure_system.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Whether a gate hangs on the sprue by a runner or is the sprue itself.
enum class RunnerKind { none, resisting };

/// Follows the triggers of all gates, and fills those that have opened: before a gate feeds what lies around
/// it, its own control volumes must be full, with p = 0 where its runner ends.
class GateControl {
 public:
  GateControl(const ShellMesh& mesh, const FillingParams& params);

  [[nodiscard]] const std::vector<Index>& nodes(std::size_t gate) const { return nodes_[gate]; }
  /// Notes where the front has arrived, and opens and closes what is due.
  void update(FillingState& state) const;
  /// Whether all control volumes of a gate are full.
  [[nodiscard]] bool is_full(std::size_t gate, const FillingState& state) const;
  /// Links the open gates to the network; `open` receives their numbers.
  [[nodiscard]] std::vector<GateLink> links(const FillingState& state, std::vector<std::size_t>& open) const;
  /// The least filled fraction and time, above the present, at which a gate moves; infinity when none
  /// is known.
  [[nodiscard]] double next_fraction(const FillingState& state) const;
  [[nodiscard]] double next_time(const FillingState& state) const;

  /// The volume that the control volumes of a gate lack, m³.
  [[nodiscard]] double lacking(std::size_t gate, const FillingState& state) const;
  /// The volume that open gates lack, m³: those with a runner, or those that hang on the sprue without.
  [[nodiscard]] double lacking(RunnerKind runners, const FillingState& state) const;
  /// How long it takes until the first gate that fills through its runner is full, at the flow p/R from
  /// a sprue at the pressure p, s; infinity where none fills.
  [[nodiscard]] double time_to_fill(const FillingState& state, double sprue_pressure) const;
  /// Notes which gate feeds a node, -1 for none: all nodes of an open gate that is full, else those that are
  /// not.
  void note_fed_nodes(const FillingState& state, std::vector<int>& gate_of) const;
  /// Gives every node of the gates that fill without a runner this share of what it lacks: writes its
  /// `gate_volume`.
  void fill_at_sprue(double share, const FillingState& state, std::vector<double>& gate_volume) const;
  /// Gives the nodes of the gates that fill through runners what these carry in `duration`, at most what they
  /// lack.
  void fill_through_runners(double sprue_pressure, double duration, const FillingState& state,
                            std::vector<double>& gate_volume) const;

 private:
  void note_arrivals(FillingState& state) const;
  [[nodiscard]] bool fills(std::size_t gate, RunnerKind runner, const FillingState& state) const;
  void fill(std::size_t gate, double share, const FillingState& state,
            std::vector<double>& gate_volume) const;
  [[nodiscard]] const Trigger* next_trigger(std::size_t gate, const FillingState& state) const;
  [[nodiscard]] double arrival(const Trigger& trigger, std::size_t gate, const FillingState& state) const;
  [[nodiscard]] bool fires(const Trigger& trigger, std::size_t gate, const FillingState& state) const;

  const ShellMesh* mesh_;
  const FillingParams* params_;
  std::vector<std::vector<Index>> nodes_;
  std::vector<Index> sensors_;  ///< by sensor: its node
};

}  // namespace fiberfate
