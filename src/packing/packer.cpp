// Runs the stages of packing: spread, untangle, bundle or compress, part or bend, settle, ease, rest.
#include "packing/packer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "microstructure/orientation_statistics.hpp"
#include "packing/bundles.hpp"

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
constexpr double first_bending = 7;  // that of glass of 19 um under the default contact law
// Fibers that press harder than contacts of that law can bear pass through one another, the more of them the
// stiffer they are made; back at their own stiffness they have less to press for.
constexpr double untangle_stress[] = {16, 8, 4, 2, 1};  // times first_bending
constexpr int untangle_steps = 100;                     // each
constexpr double untangle_saturation = 1.0 / 19;        // the ramp of that law
constexpr double untangle_decay = -1.4;                 // the deeper they overlap, the less they repel
constexpr double bending_decay = 0.1;
constexpr double least_bending = 1e-4;
constexpr int bending_steps = 100;
constexpr double barrier_share = 0.5;   // of the mean radius of curvature: the smallest radius first aimed at
constexpr double barrier_decay = 0.97;  // by which the aim is lowered while fibers still overlap
constexpr double barrier_margin = 1.01;  // over the radius wanted
constexpr int barrier_steps = 60;
// The published route (thesis section 3.2.1): fibers in a plane but for a33 = 0.01, at 2.5 % by volume.
const Vec3 planar_start(0.495, 0.495, 0.01);
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
  for (std::size_t f = 0; f < straight.rod_length.size(); ++f)
    volume += pi * straight.radius[f] * straight.radius[f] * straight.rod_length[f];
  return volume / straight.cell.volume();
}

/// Makes the cell `ratio` times as large; the fibers keep their shapes and their places in it.
void resize_cell(Chains& chains, double ratio) {
  chains.cell.lattice *= ratio;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f) {
    const std::size_t begin = chains.begin_node(f), end = chains.end_node(f);
    const Vec3 shift = 0.5 * (ratio - 1) * (chains.position[begin] + chains.position[end - 1]);
    for (std::size_t k = begin; k < end; ++k) chains.position[k] += shift;
  }
}

}  // namespace

Packer::Packer(const PackingRequest& request, const std::function<void(const PackingProgress&)>& progress)
    : request_(request), progress_(progress), unit_(thickest_diameter(request)) {
  std::vector<double> lengths;
  for (const FiberBlank& fiber : request.fibers) lengths.push_back(fiber.length);
  const OrientationRequest& wanted = request.orientation;
  const bool measured = !wanted.directions.empty();
  const Mat3 start =
      request.start == PackingStart::compressed ? Mat3(planar_start.asDiagonal()) : wanted.tensor;
  const std::vector<Vec3> directions =
      measured ? deal_orientations(wanted.directions, lengths.size(), request.seed)
               : sample_orientations(start, lengths, wanted.law, request.seed);
  asked_ = measured ? second_moment(directions, lengths) : wanted.tensor;
  target_ = asked_;
  const double drawn_error = (second_moment(directions, lengths) - asked_).cwiseAbs().maxCoeff();
  if (holds_orientation(request.start) && drawn_error >= request.orientation_tolerance)
    throw InputError(
        fmt::format("{} fibers cannot have this orientation: the nearest that they have is off by {:.3g}",
                    lengths.size(), drawn_error),
        "ask for more fibers, or for an orientation tolerance above that");
  drawn4_ = fourth_moment({directions, lengths});
  straight_ = straight_chains(request, directions);
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
  bend(chains);
  return chains;
}

Chains Packer::bundle_up() {
  const BundlePlan plan = plan_bundles(request_);
  Packer packer(plan.bundles, progress_);
  const Chains bundles = packer.separate();
  steps_ += packer.steps();
  Chains chains = fibers_in_bundles(request_, plan, bundles);
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
  for (std::size_t f = 0; f < request_.fibers.size(); ++f) {
    longest = std::max(longest, 0.5 * straight_.rod_length[f] / straight_.radius[f]);
    one_rod = one_rod && request_.fibers[f].rods == 1;
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
  PackingEnergy energy = plain_energy();
  energy.repulsion.saturation = untangle_saturation;
  energy.repulsion.decay = untangle_decay;
  stage_ = "untangle";
  for (const double stress : untangle_stress) {
    energy.bending = stress * first_bending;
    relax(minimiser, energy, untangle_steps, {-1, 0});
  }
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
  const double reach = 0.5 * request_.rest.ramp / unit_;
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

void Packer::rest(Chains& chains) {
  double stiffest = 0;
  for (const FiberMaterial& material : request_.materials)
    stiffest = std::max(stiffest, material.bending_stiffness());
  const RestLaw& law = request_.rest;
  if (!(law.force_constant > 0) || !(law.ramp > 0)) return;
  const double stiffness = law.force_constant * unit_ * std::exp(-law.decay * (law.cutoff - 2)) / law.ramp;
  PackingEnergy energy = plain_energy();
  energy.bending = stiffest / (stiffness * std::pow(unit_, 3));
  energy.repulsion.swelling = law.cutoff / 2;
  energy.repulsion.reach = 0.5 * law.ramp / unit_;
  energy.repulsion.saturation = law.ramp / unit_;
  energy.repulsion.decay = 2 * law.decay;
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
