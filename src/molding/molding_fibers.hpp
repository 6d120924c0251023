// How fibers enter the mold, and which laws their orientation and length follow there.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/vector.hpp"
#include "continuum/attrition_law.hpp"
#include "continuum/orientation_model.hpp"

namespace fiberfate {

/// Chooses the axes in which an inlet's orientation is given.
enum class InletAxes {
  part,  ///< the axes of the part
  flow   ///< 1 along the flow out of the gate, 2 across it in the surface, 3 across the wall
};

/// The fibers that come in through a gate. The mirror symmetry of the gap drops the components 13 and
/// 23 in the frame of the surface.
struct InletFibers {
  Mat3 orientation = Mat3::Identity() / 3;  ///< A2
  InletAxes axes = InletAxes::part;
  std::vector<double> lengths = {};  ///< of each class, m; empty takes MoldingFibers::class_lengths
  /// Fibers in each class, or proportional; empty takes MoldingFibers::class_numbers. The volume fraction is
  /// the same at all gates: numbers are scaled to the fiber length of MoldingFibers.
  std::vector<double> numbers = {};
};

/// One length law with its constants: a "set" of a sweep.
struct LengthSet {
  std::string name = "length";
  std::shared_ptr<const AttritionLaw> law;  ///< of continuum/length_registry.hpp
};

/// Chooses the viscosity that drags at fibers where the flow feels them: that of the melt between them, or
/// that of the melt with them.
enum class DragViscosity { matrix, suspension };

/// Couples the flow to the fibers: eta = eta_matrix (1 + R (D:A4:D)/(D:D)), R = s phi N_p, N_p = r²/(3 ln
/// sqrt(pi/phi)) (informed isotropic viscosity: Favaloro, Tseng, Pipes, 2018; thesis 2.11).
struct FiberCoupling {
  double volume_fraction = 0.1;  ///< phi, 1
  double diameter = 19e-6;       ///< of the fibers, m
  /// Set whose length (of class `length_class`) gives the aspect ratio r; below 0 `aspect_ratio` does.
  int length_set = -1;
  int length_class = 0;
  double aspect_ratio = 100;
  double scale = 1;  ///< s: what is known of R over what the semi-dilute phi N_p tells
  DragViscosity drag = DragViscosity::matrix;  ///< that the length laws take
};

/// All about fibers. Every set follows every class of initial length, all in one filling. Lengths in
/// relaxation laws are means or classes alike: for means make L_N and L_W two classes.
struct MoldingFibers {
  std::optional<OrientationModel> orientation = {};
  std::vector<LengthSet> length_sets = {};
  std::vector<double> class_lengths = {};  ///< m; one a class
  std::vector<double> class_numbers = {};  ///< fibers in each class, or proportional; for Phelps' sets
  ClassWeight class_weight = ClassWeight::length;  ///< what a class keeps; where gates have own numbers
  std::size_t phelps_bins = 40;                    ///< length bins of sets whose law is Phelps'
  InletFibers inlet = {};                          ///< of gates that have none of their own
  std::vector<std::optional<InletFibers>> gate_inlets = {};  ///< by gate; may be empty
  std::optional<FiberCoupling> coupling = {};
};

}  // namespace fiberfate
