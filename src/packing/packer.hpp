// Runs the stages of packing: spread, untangle, relieve, bundle or compress, part or bend, settle, ease,
// rest.
#pragma once

#include <functional>

#include "microstructure/tensor.hpp"
#include "packing/chain_shapes.hpp"
#include "packing/minimiser.hpp"
#include "packing/packing.hpp"

namespace fiberfate {

/// Packs one request (docs/theory/packing.md has the reasons of the stages).
class Packer {
 public:
  Packer(const PackingRequest& request, const std::function<void(const PackingProgress&)>& progress);
  /// Finds a packing without overlap; raises SimulationFailure when there is none within the step limit.
  [[nodiscard]] Chains separate();
  /// Lets chains come to rest under the request's contact law and the fibers' own stiffness, without
  /// friction.
  void rest(Chains& chains);

  [[nodiscard]] const Mat3& asked() const { return asked_; }
  /// A4 of the directions that were drawn.
  [[nodiscard]] const Mat6& drawn4() const { return drawn4_; }
  [[nodiscard]] int steps() const { return steps_; }

 private:
  struct Goal {
    double overlap = 0;  ///< diameters
    double bend = 0;     ///< largest curvature, per unit of length
  };
  [[nodiscard]] PackingEnergy plain_energy() const;
  [[nodiscard]] bool may_stay_straight() const;
  [[nodiscard]] bool part_straight();
  [[nodiscard]] bool part(int steps);
  [[nodiscard]] Chains disperse();
  [[nodiscard]] Chains bundle_up();
  [[nodiscard]] Chains compress();
  void spread(Chains& chains);
  /// True where the request has a contact law to be at rest under.
  [[nodiscard]] bool has_rest_law() const;
  /// The energy of the fibers under the contact law, stiffer by `stress` than they are.
  [[nodiscard]] PackingEnergy law_energy(double stress) const;
  void untangle(Chains& chains);
  /// Moves fibers that press on others harder than contacts bear; tells whether a packing came of it that
  /// meets the goal and is nearly at rest under the contact law, else leaves the chains as they were.
  bool relieve(Chains& chains);
  bool move_overloaded(Chains& chains, Minimiser& minimiser);
  bool come_to_rest(Minimiser& minimiser, double mean_radius);
  void bend(Chains& chains);
  void ease(Minimiser& minimiser, PackingEnergy energy);
  [[nodiscard]] Goal goal() const;
  [[nodiscard]] bool is_met(const Goal& goal) const;
  /// Makes steps until the goal is met or `steps` are made; tells whether it was.
  bool relax(Minimiser& minimiser, const PackingEnergy& energy, int steps, const Goal& goal);
  [[noreturn]] void give_up() const;

  const PackingRequest& request_;
  const std::function<void(const PackingProgress&)>& progress_;
  const char* stage_ = "";
  double unit_;                         ///< thickest diameter, m
  RestingContact rest_;                 ///< between the thickest fibers
  Mat3 asked_ = Mat3::Identity() / 3;   ///< A2 that the request wants
  Mat3 target_ = Mat3::Identity() / 3;  ///< A2 that is held
  Mat6 drawn4_;
  Chains straight_;
  PackingMeasure last_;
  int steps_ = 0;
};

}  // namespace fiberfate
