// Fills a thin cavity with melt: flow, front, heat, orientation and length of fibers, gates.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "continuum/length_classes.hpp"
#include "molding/filling_params.hpp"
#include "molding/filling_state.hpp"
#include "molding/gap_layers.hpp"
#include "molding/shell_mesh.hpp"

namespace fiberfate {

/// The parts of a step whose time is measured.
enum class FillingPhase : std::size_t { flow, front, heat, lengths, orientation };
inline constexpr std::size_t filling_phase_count = 5;
inline constexpr std::array<const char*, filling_phase_count> filling_phase_names = {
    "flow", "front", "heat", "lengths", "orientation"};

/// Steps a filling (docs/theory/molding.md). The state alone determines the future: a filling made from a
/// saved state continues bitwise, with any number of threads.
class Filling {
 public:
  /// Starts with an empty cavity; raises InputError as check_params.
  Filling(ShellMesh mesh, FillingParams params);
  /// Continues from a state; raises InputError as check_state.
  Filling(ShellMesh mesh, FillingParams params, FillingState state);
  ~Filling();
  Filling(Filling&&) noexcept;
  Filling& operator=(Filling&&) noexcept;

  /// Makes one step; does nothing once finished. Raises SimulationFailure when a pressure is not finite or a
  /// temperature is one that no polymer bears.
  void advance();
  /// Steps to the end; returns the state there.
  const FillingState& run_to_end();
  [[nodiscard]] bool finished() const { return state().stop_reason != FillingEnd::none; }

  /// Keeps every step from now on, for follow_lengths_again; call it before the first one.
  void keep_steps();
  /// Follows the lengths again through all steps that were kept, by laws of other constants, as many as there
  /// were; nothing else changes. That is what a filling with these laws gives, bitwise, where the flow does
  /// not feel the fibers, at a tenth of the cost; where it does, the flow stays that of the first laws.
  /// Raises InputError where the steps were not kept from the start on.
  void follow_lengths_again(std::vector<LengthSet> sets);

  [[nodiscard]] const ShellMesh& mesh() const;
  [[nodiscard]] const FillingParams& params() const;
  [[nodiscard]] const GapLayers& layers() const;
  [[nodiscard]] const FillingState& state() const;
  [[nodiscard]] double filled_fraction() const;
  /// Wall seconds spent in a phase so far.
  [[nodiscard]] double seconds(FillingPhase phase) const;

  /// Gives A2 of a point in the axes of the part; zero where there is no melt.
  [[nodiscard]] Mat3 orientation(std::size_t node, std::size_t layer) const;
  /// Gives A2 in the axes of the part, averaged over the gap.
  [[nodiscard]] Mat3 mean_orientation(std::size_t node) const;
  /// How many lengths a set transports: one a class, or one a bin for Phelps' law.
  [[nodiscard]] std::size_t field_count(std::size_t set) const;
  /// Gives the lengths (m) of a set's classes at a point; for Phelps' law the numbers of fibers in its bins.
  [[nodiscard]] std::span<const double> lengths(std::size_t set, std::size_t node, std::size_t layer) const;
  /// Gives how much of every class there is at a point (MoldingFibers::class_weight tells of what), in
  /// proportion; empty where it is the same at all gates.
  [[nodiscard]] std::span<const double> amounts(std::size_t node, std::size_t layer) const;
  /// Averages the lengths over the gap.
  [[nodiscard]] std::vector<double> mean_lengths_of(std::size_t set, std::size_t node) const;
  /// Gives the lengths of the bins of a set of Phelps' law, m; empty for other laws.
  [[nodiscard]] std::span<const double> bin_lengths(std::size_t set) const;
  /// Averages a field by point (temperature, rate) over the gap, by node; 0 where there is no melt.
  [[nodiscard]] std::vector<double> gap_average(std::span<const double> by_point) const;
  /// The viscosity of every point at the present state, Pa s.
  [[nodiscard]] std::vector<double> viscosity() const;
  /// The mean velocity of every node at the last solution of the flow, in the axes of the part, m/s.
  [[nodiscard]] std::vector<Vec3> velocity() const;
  /// Gives the heat in the melt above the mold's temperature, J.
  [[nodiscard]] double stored_heat() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace fiberfate
