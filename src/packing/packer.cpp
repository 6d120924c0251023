// Runs the stages of packing: spread, untangle, relieve, bundle or compress, part or bend, settle, ease,
// rest.
#include "packing/packer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "fibers/contact_laws/contact_registry.hpp"
#include "packing/bundles.hpp"
#include "packing/drawn_directions.hpp"
#include "packing/relief.hpp"

namespace fiberfate {
namespace {

// Lengths are in thickest diameters D, stiffness in units of the contact stiffness k, bending stiffness B of
// the stiffest fiber in k D³.
constexpr double spread_stiffness = 0.01;  // so softly that they pass through one another
constexpr double spread_bending = 70;      // and stay nearly straight
constexpr double spread_rod = 9;           // long rods do while fibers spread: fewer of them
constexpr Index spread_rods = 4;           // but at least this many a fiber
constexpr int spread_steps = 200;
constexpr double straight_limit = 5;       // straight fibers fit below a volume fraction of about 5 D / L
constexpr int first_straight_steps = 400;  // from where they fell: spreading would space them more evenly
constexpr int straight_steps = 2000;
constexpr int clearance_steps = 200;
constexpr double first_bending = 7;     // that of glass of 19 um under the default contact law
constexpr double soft_ramp = 1.0 / 19;  // the ramp of that law; its saturation too, as k is 1
constexpr double soft_decay = -1.4;     // the deeper fibers overlap, the less they repel: they can pass
// Fibers that press harder than contacts can bear pass through one another, the more of them the stiffer they
// are made; back at their own stiffness they have less to press for.
struct Stress {
  double stiffness;  // times first_bending
  int steps;
};
constexpr Stress untangle_stress[] = {{16, 100}, {8, 100}, {4, 100}, {2, 100}, {1, 100}};
// What presses too hard even then is taken out and put back elsewhere, if it is not too much.
constexpr double relief_stress = 1.1;       // leaves a margin below what contacts bear
constexpr double relief_overlap = 0.0205;   // of the soft ramp: contacts that carry more than 0.89 of F0
constexpr double relief_hold = 0.1;         // of the hold on orientation, which contacts would have to bear
constexpr double most_moved = 0.2;          // share of the fibers
constexpr double insertion_swelling = 4;    // a fiber that is put back first finds the middle of the gap,
constexpr double insertion_firmness = 0.2;  // pressing softly
constexpr int insertion_steps = 40;
constexpr Stress insertion_stress[] = {{16, 40}, {8, 40}, {4, 40}, {2, 40}, {relief_stress, 60}};
constexpr int first_relief_steps = 120;
constexpr int calm_steps = 60;
constexpr int relief_rounds = 40;
constexpr int first_rest_steps = 120;
constexpr int rest_rounds = 12;
constexpr double rest_barrier_margin = 1.12;  // over the radius wanted: contacts press on
constexpr double rest_barrier_share = 0.25;   // of the mean radius: the smallest radius aimed at at rest
constexpr double core_share = 0.9;            // of the overlap tolerance: where the hard core of rods begins
constexpr double core_hardness = 4;
constexpr double bending_decay = 0.1;
constexpr double least_bending = 1e-4;
constexpr int bending_steps = 100;
constexpr double barrier_share = 0.5;   // of the mean radius of curvature: the smallest radius first aimed at
constexpr double barrier_decay = 0.97;  // by which the aim is lowered while fibers still overlap
constexpr double barrier_margin = 1.01;  // over the radius wanted
constexpr int barrier_steps = 60;
// The published route (thesis section 3.2.1) begins at 2.5 % by volume.
constexpr double dilute_fraction = 0.025;
constexpr double most_compression = 0.02;  // strain of the cell's edges in one go
constexpr double compress_bending = 1;
constexpr int compression_steps = 60;  // at most, in one go
constexpr int rest_steps = 400;
constexpr int report_interval = 20;
constexpr double unlimited = std::numeric_limits<double>::infinity();

Index final_rods(const FiberBlank& fiber) {
  return fiber.rods;
}

/// Volume of the fibers over that of the cell, fibers being single rods.
double volume_share(const Chains& straight) {
  double volume = 0;
  for (const FiberIndex fiber : straight.fibers())
    volume += pi * straight.radius[fiber] * straight.radius[fiber] * straight.rod_length[fiber];
  return volume / straight.cell.volume();
}

/// Makes the cell `ratio` times as large; the fibers keep their shapes and their places in it.
void resize_cell(Chains& chains, double ratio) {
  chains.cell.lattice *= ratio;
  for (const FiberIndex fiber : chains.fibers()) {
    const Vec3 ends = chains.position[chains.begin_node(fiber)] + chains.position[chains.last_node(fiber)];
    const Vec3 shift = 0.5 * (ratio - 1) * ends;
    for (const NodeIndex node : chains.nodes(fiber)) chains.position[node] += shift;
  }
}

RestingContact resting_contact(const PackingRequest& request) {
  ContactBody thickest;
  for (const FiberBlank& fiber : request.fibers) {
    const FiberMaterial& material = request.materials[fiber.material_id];
    if (material.radius > thickest.radius) thickest = contact_body(material);
  }
  return contact_law_named(request.rest.law).resting(request.rest, {thickest, thickest});
}

}  // namespace

Packer::Packer(const PackingRequest& request, const std::function<void(const PackingProgress&)>& progress)
    : request_(request),
      progress_(progress),
      unit_(thickest_diameter(request)),
      rest_(resting_contact(request)) {
  const DrawnDirections drawn = draw_directions(request);
  asked_ = target_ = drawn.asked;
  drawn4_ = drawn.fourth_moment;
  straight_ = straight_chains(request, drawn.directions);
}

PackingEnergy Packer::plain_energy() const {
  PackingEnergy energy;
  energy.orientation = holds_orientation(request_.start) ? request_.weights.orientation : 0;
  energy.barrier = request_.weights.curvature;
  return energy;
}

Chains Packer::separate() {
  switch (request_.start) {
    case PackingStart::bundles:
      return bundle_up();
    case PackingStart::compressed:
      return compress();
    case PackingStart::dispersed:
      break;
  }
  return disperse();
}

Chains Packer::disperse() {
  if (may_stay_straight() && part_straight()) return divide_chains(straight_, request_, final_rods);
  Chains coarse = divide_chains(straight_, request_, [this](const FiberBlank& fiber) {
    const auto wanted = static_cast<Index>(std::lround(fiber.length / unit_ / spread_rod));
    return std::min(fiber.rods, std::max(wanted, spread_rods));
  });
  spread(coarse);
  Chains chains = divide_chains(coarse, request_, final_rods);
  untangle(chains);
  if (!relieve(chains)) bend(chains);
  return chains;
}

Chains Packer::bundle_up() {
  const BundlePlan plan = plan_bundles(request_);
  Packer packer(plan.bundles, progress_);
  const Chains bundles = packer.separate();
  steps_ += packer.steps();
  Chains chains = fibers_in_bundles(request_, plan, bundles);
  if (relieve(chains)) return chains;
  last_ = Minimiser(chains, target_).measure();
  if (!is_met(goal())) bend(chains);
  return chains;
}

Chains Packer::compress() {
  Chains chains = divide_chains(straight_, request_, final_rods);
  const Cell final_cell = chains.cell;
  const double expansion = std::max(1.0, std::cbrt(volume_share(straight_) / dilute_fraction));
  const int rounds = static_cast<int>(std::ceil(std::log(expansion) / most_compression));
  const double ratio = rounds > 0 ? std::pow(expansion, -1.0 / rounds) : 1;
  PackingEnergy energy = plain_energy();
  energy.bending = compress_bending;
  stage_ = "compress";
  resize_cell(chains, expansion);
  for (int round = 0; round <= rounds; ++round) {
    if (round > 0) resize_cell(chains, ratio);
    Minimiser minimiser(chains, target_);
    relax(minimiser, energy, compression_steps, {request_.overlap_tolerance, unlimited});
  }
  chains.cell = final_cell;
  bend(chains);
  return chains;
}

bool Packer::may_stay_straight() const {
  double longest = 0;
  bool one_rod = true;
  for (const FiberIndex fiber : straight_.fibers()) {
    longest = std::max(longest, 0.5 * straight_.rod_length[fiber] / straight_.radius[fiber]);
    one_rod = one_rod && request_.fibers[fiber.value()].rods == 1;
  }
  return one_rod || volume_share(straight_) < straight_limit / longest;
}

void Packer::spread(Chains& chains) {
  Minimiser minimiser(chains, target_);
  PackingEnergy energy = plain_energy();
  energy.bending = spread_bending;
  energy.repulsion.swelling = request_.swelling;
  energy.repulsion.stiffness = spread_stiffness;
  stage_ = "spread";
  relax(minimiser, energy, spread_steps, {-1, 0});
}

void Packer::untangle(Chains& chains) {
  Minimiser minimiser(chains, target_);
  minimiser.finish();
  stage_ = "untangle";
  for (const Stress& stress : untangle_stress) {
    PackingEnergy energy = law_energy(stress.stiffness);
    energy.bending = stress.stiffness * first_bending;
    energy.repulsion.reach = 0;
    relax(minimiser, energy, stress.steps, {-1, 0});
  }
}

bool Packer::relieve(Chains& chains) {
  if (!has_rest_law()) return false;
  const auto untangled = chains.position;
  stage_ = "relieve";
  Minimiser minimiser(chains, target_);
  if (move_overloaded(chains, minimiser) && come_to_rest(minimiser, mean_radius(chains))) return true;
  chains.position = untangled;
  return false;
}

bool Packer::move_overloaded(Chains& chains, Minimiser& minimiser) {
  PackingEnergy energy = law_energy(relief_stress);
  energy.orientation *= relief_hold;
  Relief relief(chains, minimiser, request_.seed);
  relax(minimiser, energy, first_relief_steps, {-1, 0});
  const double most = most_moved * chains.fiber_count();
  bool calm = false;
  for (int round = 0; round < relief_rounds; ++round) {
    const std::size_t found = relief.find(relief_overlap);
    if (found == 0 && calm) return true;
    if (static_cast<double>(found) > most) return false;
    calm = found == 0;
    if (calm) {  // it may not have come to rest yet: look twice
      relax(minimiser, energy, calm_steps, {-1, 0});
      continue;
    }
    relief.move();
    relief.alter({insertion_stress[0].stiffness / relief_stress, insertion_swelling, insertion_firmness});
    relax(minimiser, energy, insertion_steps, {-1, 0});
    for (const Stress& stress : insertion_stress) {
      relief.alter({stress.stiffness / relief_stress, 1, 1});
      relax(minimiser, energy, stress.steps, {-1, 0});
    }
  }
  return false;
}

bool Packer::come_to_rest(Minimiser& minimiser, double mean_radius) {
  PackingEnergy energy = law_energy(1);
  energy.orientation *= relief_hold;
  energy.repulsion.decay = 2 * rest_.decay;
  relax(minimiser, energy, first_rest_steps, {-1, 0});
  energy.repulsion.hardness = core_hardness;
  energy.repulsion.core = 1 - core_share * request_.overlap_tolerance;
  energy.barrier_radius =
      std::max(rest_barrier_margin * request_.minimum_radius / unit_, rest_barrier_share * mean_radius);
  bool met = false;
  for (int round = 0; round < rest_rounds && !met; ++round) {
    met = relax(minimiser, energy, barrier_steps, goal());
    if (last_.largest_bend > goal().bend) energy.barrier_radius /= barrier_decay;
    if (last_.largest_overlap >= goal().overlap)
      energy.repulsion.core += (1 - core_share) * request_.overlap_tolerance;
  }
  minimiser.finish();
  last_ = minimiser.measure();
  return is_met(goal());
}

bool Packer::part_straight() {
  const Chains scattered = straight_;
  if (part(first_straight_steps)) return true;
  straight_ = scattered;
  spread(straight_);
  return part(straight_steps);
}

bool Packer::part(int steps) {
  Minimiser minimiser(straight_, target_);
  PackingEnergy energy = plain_energy();
  // Straight fibers hold no contacts: part them beyond the reach of the contact law where there is room.
  const double reach = 0.5 * rest_.ramp / unit_;
  energy.repulsion.reach = 1.5 * reach;
  stage_ = "part";
  const bool parted = relax(minimiser, energy, steps, {request_.overlap_tolerance, unlimited});
  if (parted) relax(minimiser, energy, clearance_steps, {-reach, unlimited});
  minimiser.finish();
  return parted;
}

void Packer::bend(Chains& chains) {
  Minimiser minimiser(chains, target_);
  minimiser.finish();
  PackingEnergy energy = plain_energy();
  energy.bending = first_bending;
  energy.barrier_radius = request_.minimum_radius / unit_;
  const double wanted = request_.minimum_radius / unit_;
  stage_ = "bend";
  relax(minimiser, energy, bending_steps, {-1, 0});
  energy.barrier_radius = std::max(barrier_share * mean_radius(chains), barrier_margin * wanted);
  stage_ = "settle";
  for (energy.bending *= bending_decay; energy.bending > least_bending; energy.bending *= bending_decay) {
    if (relax(minimiser, energy, bending_steps, goal())) break;
  }
  ease(minimiser, energy);
  minimiser.finish();
}

void Packer::ease(Minimiser& minimiser, PackingEnergy energy) {
  stage_ = "ease";
  const double wanted = barrier_margin * request_.minimum_radius / unit_;
  while (!is_met(goal())) {
    if (steps_ >= request_.step_limit) give_up();
    if (relax(minimiser, energy, barrier_steps, goal())) return;
    energy.barrier_radius = std::max(wanted, barrier_decay * energy.barrier_radius);
  }
}

bool Packer::has_rest_law() const {
  return rest_.force > 0 && rest_.ramp > 0;
}

PackingEnergy Packer::law_energy(double stress) const {
  PackingEnergy energy = plain_energy();
  energy.repulsion.reach = 0.5 * soft_ramp;
  energy.repulsion.saturation = soft_ramp;
  energy.repulsion.decay = soft_decay;
  energy.bending = stress * first_bending;
  if (!has_rest_law()) return energy;
  double stiffest = 0;
  for (const FiberMaterial& material : request_.materials)
    stiffest = std::max(stiffest, material.bending_stiffness());
  energy.bending = stress * stiffest * soft_ramp / (rest_.force * unit_ * unit_);
  energy.repulsion.swelling = rest_.cutoff / 2;
  return energy;
}

void Packer::rest(Chains& chains) {
  if (!has_rest_law()) return;
  PackingEnergy energy = law_energy(1);
  const double ramp = rest_.ramp / unit_;
  energy.bending *= ramp / soft_ramp;
  energy.repulsion.reach = 0.5 * ramp;
  energy.repulsion.saturation = ramp;
  energy.repulsion.decay = 2 * rest_.decay;
  stage_ = "rest";
  Minimiser minimiser(chains, target_);
  relax(minimiser, energy, rest_steps, {-1, 0});
  minimiser.finish();
}

Packer::Goal Packer::goal() const {
  const double radius = request_.minimum_radius / unit_;
  return {request_.overlap_tolerance, radius > 0 ? 1 / radius : unlimited};
}

bool Packer::is_met(const Goal& goal) const {
  const bool oriented =
      !holds_orientation(request_.start) || last_.orientation_error < request_.orientation_tolerance;
  return last_.largest_overlap < goal.overlap && last_.largest_bend <= goal.bend && oriented;
}

bool Packer::relax(Minimiser& minimiser, const PackingEnergy& energy, int steps, const Goal& goal) {
  minimiser.use(energy);
  for (int i = 0; i < steps && steps_ < request_.step_limit; ++i, ++steps_) {
    last_ = minimiser.step();
    if (progress_ && steps_ % report_interval == 0)
      progress_({stage_, steps_, std::max(0.0, last_.largest_overlap), unit_ / last_.largest_bend,
                 last_.orientation_error});
    if (!is_met(goal)) continue;
    // What step() tells is of the positions before it: look at the present ones.
    last_ = minimiser.measure();
    if (is_met(goal)) return true;
  }
  last_ = minimiser.measure();
  return false;
}

void Packer::give_up() const {
  throw SimulationFailure(
      fmt::format(
          "no packing was found in {} steps: overlap {:.3g} diameters at a smallest radius of {:.4g} m; "
          "ask for a smaller radius, a lower concentration or a larger overlap tolerance",
          steps_, std::max(0.0, last_.largest_overlap), unit_ / last_.largest_bend),
      {});
}

}  // namespace fiberfate
