// Packs fibers: spreads them as straight rods, then lets them bend until they no longer overlap.
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "base/constants.hpp"
#include "base/error.hpp"
#include "base/random.hpp"
#include "base/timer.hpp"
#include "packing/minimiser.hpp"
#include "packing/packing.hpp"

namespace fiberfate {
namespace {

// Stages (docs/theory/packing.md gives the reasons and what other values reach). Lengths in thickest
// diameters.
constexpr double spread_swelling =
    3.5;  // fibers repel each other at this many times their diameter while straight
constexpr double spread_stiffness = 0.01;  // softly, so that they pass through one another
constexpr int spread_steps = 400;
constexpr double straight_limit = 5;  // straight fibers fit below a volume fraction of about 5 D / L
constexpr int straight_steps = 2000;
constexpr double first_bending = 0.05;  // E I / l³ in units of contact stiffness where bending begins
constexpr double bending_decay = 0.1;
constexpr double least_bending = 1e-6;
constexpr int bending_steps = 100;
constexpr double barrier_stiffness = 0.5;
constexpr double barrier_share = 0.55;  // of the mean radius of curvature: the radius first aimed at
constexpr double barrier_decay = 0.97;  // by which the aim is lowered when fibers still overlap
constexpr int barrier_steps = 60;
constexpr double orientation_stiffness = 20;
constexpr int report_interval = 20;

/// Runs the stages of one request.
class Packer {
 public:
  Packer(const PackingRequest& request, const std::function<void(const PackingProgress&)>& progress)
      : request_(request), progress_(progress) {}
  FiberState pack();
  [[nodiscard]] const Mat3& target() const { return target_; }
  [[nodiscard]] int steps() const { return steps_; }

 private:
  struct Goal {
    double overlap = 0;
    double radius = 0;  ///< m
  };
  void place_straight();
  [[nodiscard]] Chains subdivide() const;
  [[nodiscard]] bool may_stay_straight() const;
  /// Makes steps until the goal is met or `steps` are made; tells whether it was.
  bool relax(Minimiser& minimiser, const PackingEnergy& energy, int steps, const Goal& goal);
  void bend(Chains& chains);
  [[nodiscard]] double mean_radius(const Chains& chains) const;
  [[nodiscard]] FiberState state_of(const Chains& chains) const;
  [[noreturn]] void give_up(const PackingMeasure& reached) const;

  const PackingRequest& request_;
  const std::function<void(const PackingProgress&)>& progress_;
  const char* stage_ = "";
  double unit_ = 0;  ///< thickest diameter, m
  Mat3 target_ = Mat3::Identity() / 3;
  Chains straight_;
  PackingMeasure last_;
  int steps_ = 0;
};

void require_sensible(const PackingRequest& request) {
  if (request.fibers.empty()) throw InputError("there are no fibers to pack", "ask for at least one");
  if (!(request.overlap_tolerance > 0) || !(request.overlap_tolerance < 1))
    throw InputError(fmt::format("the overlap tolerance is {:.4g} diameters", request.overlap_tolerance),
                     "give a number between 0 and 1");
  double volume = 0, thickest = 0;
  for (const FiberBlank& fiber : request.fibers) {
    if (fiber.material_id >= request.materials.size())
      throw InputError("a fiber has an unknown material", "name one of the materials that are defined");
    if (!(fiber.length > 0) || fiber.rods < 1)
      throw InputError("a fiber has no length or no rods", "give a length above zero and at least one rod");
    const double radius = request.materials[fiber.material_id].radius;
    if (!(radius > 0)) throw InputError("a fiber has no diameter", "give a diameter above zero");
    thickest = std::max(thickest, 2 * radius);
    volume += pi * radius * radius * fiber.length;
  }
  constexpr double densest = 0.9068996821171089;  // parallel cylinders, pi / sqrt(12)
  if (volume / request.cell.volume() >= densest)
    throw InputError(fmt::format("the fibers fill {:.4g} of the cell", volume / request.cell.volume()),
                     fmt::format("even parallel fibers fill at most {:.4g} (pi / sqrt 12)", densest));
  for (int i = 0; i < 3; ++i) {
    if (request.cell.height(i) < 2 * thickest)
      throw InputError(fmt::format("the cell is {:.4g} m high", request.cell.height(i)),
                       fmt::format("give at least two fiber diameters, {:.4g} m", 2 * thickest));
  }
}

Cell scaled(Cell cell, double unit) {
  cell.lattice /= unit;
  return cell;
}

void Packer::place_straight() {
  std::vector<double> lengths;
  for (const FiberBlank& fiber : request_.fibers) {
    lengths.push_back(fiber.length);
    unit_ = std::max(unit_, request_.materials[fiber.material_id].diameter());
  }
  const OrientationRequest& asked = request_.orientation;
  const std::vector<Vec3> directions =
      asked.directions.empty() ? sample_orientations(asked.tensor, lengths, asked.law, request_.seed)
                               : deal_orientations(asked.directions, lengths.size(), request_.seed);
  target_ = asked.directions.empty() ? asked.tensor : second_moment(directions, lengths);
  straight_.cell = scaled(request_.cell, unit_);
  for (std::size_t f = 0; f < lengths.size(); ++f) {
    const auto u = uniform4(request_.seed, RandomStream::position, {static_cast<std::uint32_t>(f), 0, 0});
    const Vec3 centre = straight_.cell.lattice * Vec3(u[0], u[1], u[2]);
    const Vec3 half = 0.5 * lengths[f] / unit_ * directions[f];
    straight_.position.push_back(centre - half);
    straight_.position.push_back(centre + half);
    straight_.first_node.push_back(static_cast<Index>(straight_.position.size()));
    straight_.rod_length.push_back(lengths[f] / unit_);
    straight_.radius.push_back(request_.materials[request_.fibers[f].material_id].radius / unit_);
    straight_.bending_stiffness.push_back(0);
  }
}

Chains Packer::subdivide() const {
  Chains chains;
  chains.cell = straight_.cell;
  chains.radius = straight_.radius;
  double stiffest = 0;
  for (std::size_t f = 0; f < request_.fibers.size(); ++f) {
    const FiberBlank& fiber = request_.fibers[f];
    const Vec3 begin = straight_.position[2 * f], end = straight_.position[2 * f + 1];
    for (Index k = 0; k <= fiber.rods; ++k)
      chains.position.push_back(begin + (end - begin) * (static_cast<double>(k) / fiber.rods));
    chains.first_node.push_back(static_cast<Index>(chains.position.size()));
    chains.rod_length.push_back(fiber.length / unit_ / fiber.rods);
    const double stiffness = request_.materials[fiber.material_id].bending_stiffness();
    chains.bending_stiffness.push_back((stiffness > 0 ? stiffness : 1) /
                                       std::pow(fiber.length / fiber.rods, 3));
    stiffest = std::max(stiffest, chains.bending_stiffness.back());
  }
  for (double& stiffness : chains.bending_stiffness) stiffness /= stiffest;
  return chains;
}

bool Packer::may_stay_straight() const {
  double volume = 0, longest = 0;
  bool one_rod = true;
  for (std::size_t f = 0; f < request_.fibers.size(); ++f) {
    volume += pi * straight_.radius[f] * straight_.radius[f] * straight_.rod_length[f];
    longest = std::max(longest, 0.5 * straight_.rod_length[f] / straight_.radius[f]);
    one_rod = one_rod && request_.fibers[f].rods == 1;
  }
  return one_rod || volume / straight_.cell.volume() < straight_limit / longest;
}

bool Packer::relax(Minimiser& minimiser, const PackingEnergy& energy, int steps, const Goal& goal) {
  minimiser.use(energy);
  const double sharpest = goal.radius > 0 ? unit_ / goal.radius : std::numeric_limits<double>::infinity();
  for (int i = 0; i < steps && steps_ < request_.step_limit; ++i, ++steps_) {
    last_ = minimiser.step();
    if (progress_ && steps_ % report_interval == 0)
      progress_({stage_, steps_, std::max(0.0, last_.largest_overlap), unit_ / last_.largest_bend,
                 last_.orientation_error});
    const bool met = last_.largest_overlap < goal.overlap && last_.largest_bend <= sharpest &&
                     last_.orientation_error < request_.orientation_tolerance;
    // The measure is that of the positions before the step: look at the present ones.
    if (!met) continue;
    last_ = minimiser.measure();
    if (last_.largest_overlap < goal.overlap && last_.largest_bend <= sharpest) return true;
  }
  return false;
}

double Packer::mean_radius(const Chains& chains) const {
  double sum = 0;
  std::int64_t hinges = 0;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f) {
    const double squared = chains.rod_length[f] * chains.rod_length[f];
    for (std::size_t k = chains.begin_node(f) + 1; k + 1 < chains.end_node(f); ++k) {
      sum += (chains.position[k + 1] - 2 * chains.position[k] + chains.position[k - 1]).norm() / squared;
      ++hinges;
    }
  }
  return sum > 0 ? static_cast<double>(hinges) / sum : std::numeric_limits<double>::infinity();
}

void Packer::give_up(const PackingMeasure& reached) const {
  throw SimulationFailure(
      fmt::format("no packing was found in {} steps: overlap {:.3g} diameters at a smallest radius of {:.4g} "
                  "m; ask for a "
                  "smaller radius, a lower concentration or a larger overlap tolerance",
                  steps_, std::max(0.0, reached.largest_overlap), unit_ / reached.largest_bend),
      {});
}

void Packer::bend(Chains& chains) {
  Minimiser minimiser(chains, target_);
  PackingEnergy energy;
  energy.orientation = orientation_stiffness;
  energy.barrier = barrier_stiffness;
  energy.bending = first_bending;
  energy.barrier_radius = request_.minimum_radius / unit_;
  const Goal goal = {request_.overlap_tolerance, request_.minimum_radius};
  stage_ = "bend";
  relax(minimiser, energy, bending_steps, {0, 0});
  const double aim = barrier_share * mean_radius(chains);
  const double wanted = 1.01 * request_.minimum_radius / unit_;
  energy.barrier_radius = std::max(aim, wanted);
  for (energy.bending *= bending_decay; energy.bending > least_bending; energy.bending *= bending_decay) {
    stage_ = "settle";
    if (relax(minimiser, energy, bending_steps, goal)) break;
  }
  stage_ = "ease";
  while (last_.largest_overlap >= goal.overlap || last_.orientation_error >= request_.orientation_tolerance ||
         (goal.radius > 0 && last_.largest_bend * goal.radius > unit_)) {
    if (relax(minimiser, energy, barrier_steps, goal)) break;
    if (steps_ >= request_.step_limit) give_up(last_);
    energy.barrier_radius = std::max(wanted, barrier_decay * energy.barrier_radius);
  }
  minimiser.finish();
}

FiberState Packer::state_of(const Chains& chains) const {
  FiberState state;
  state.materials = request_.materials;
  state.cell = request_.cell;
  std::vector<Vec3> nodes;
  for (std::size_t f = 0; f < chains.rod_length.size(); ++f) {
    nodes.clear();
    for (std::size_t k = chains.begin_node(f); k < chains.end_node(f); ++k)
      nodes.push_back(unit_ * chains.position[k]);
    append_fiber(state, {nodes, request_.fibers[f].material_id});
    for (std::size_t k = chains.begin_node(f); k + 1 < chains.end_node(f); ++k)
      state.rod_length[k] = request_.fibers[f].length / request_.fibers[f].rods;
  }
  wrap_fibers(state);
  return state;
}

FiberState Packer::pack() {
  place_straight();
  Minimiser minimiser(straight_, target_);
  PackingEnergy energy;
  energy.orientation = orientation_stiffness;
  energy.repulsion.swelling = spread_swelling;
  energy.repulsion.stiffness = spread_stiffness;
  stage_ = "spread";
  relax(minimiser, energy, spread_steps, {-1, 0});
  if (may_stay_straight()) {
    stage_ = "part";
    energy.repulsion = RepulsionLaw{};
    if (relax(minimiser, energy, straight_steps, {request_.overlap_tolerance, 0})) {
      minimiser.finish();
      return state_of(subdivide());
    }
  }
  Chains chains = subdivide();
  bend(chains);
  return state_of(chains);
}

}  // namespace

PackingResult pack(const PackingRequest& request,
                   const std::function<void(const PackingProgress&)>& progress) {
  const double start = wall_seconds();
  require_sensible(request);
  Packer packer(request, progress);
  PackingResult result;
  result.state = packer.pack();
  result.report = measure_packing(result.state, packer.target());
  result.report.steps = packer.steps();
  result.report.wall_seconds = wall_seconds() - start;
  return result;
}

}  // namespace fiberfate
