// Opens and closes gates, and tells when the next event is due.
#pragma once

#include <vector>

#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/pressure_system.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// Follows the triggers of all gates.
class GateControl {
 public:
  GateControl(const ShellMesh& mesh, const FillingParams& params);

  [[nodiscard]] const std::vector<Index>& nodes(std::size_t gate) const { return nodes_[gate]; }
  /// Notes where the front has arrived, and opens and closes what is due; tells whether anything changed.
  bool update(FillingState& state) const;
  /// Links the open gates to the network; `open` receives their numbers.
  [[nodiscard]] std::vector<GateLink> links(const FillingState& state, std::vector<std::size_t>& open) const;
  /// Tells the least filled fraction and time, above the present, at which a gate moves; infinity when none
  /// is known.
  [[nodiscard]] double next_fraction(const FillingState& state) const;
  [[nodiscard]] double next_time(const FillingState& state) const;

 private:
  void note_arrivals(FillingState& state) const;
  [[nodiscard]] const Trigger* next_trigger(std::size_t gate, const FillingState& state) const;
  [[nodiscard]] double arrival(const Trigger& trigger, std::size_t gate, const FillingState& state) const;
  [[nodiscard]] bool fires(const Trigger& trigger, std::size_t gate, const FillingState& state) const;

  const ShellMesh* mesh_;
  const FillingParams* params_;
  std::vector<std::vector<Index>> nodes_;
  std::vector<Index> sensors_;  ///< by sensor: its node
};

}  // namespace fiberfate
