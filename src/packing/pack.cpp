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
#include "base/threads.hpp"
#include "base/timer.hpp"
#include "packing/minimiser.hpp"
#include "packing/packing.hpp"

namespace fiberfate {
namespace {

// Stages; docs/theory/packing.md gives the reasons and what other values reach. Lengths are in thickest
// diameters D, stiffness in units of the contact stiffness k, bending stiffness B of the stiffest fiber in k
// D³.
constexpr double spread_stiffness = 0.01;  // so softly that they pass through one another
constexpr double spread_bending = 70;      // and stay nearly straight
constexpr double spread_rod = 9;           // long rods do while fibers spread: fewer of them
constexpr Index spread_rods = 4;           // but at least this many a fiber
constexpr int spread_steps = 200;
constexpr double straight_limit = 5;  // straight fibers fit below a volume fraction of about 5 D / L
constexpr int straight_steps = 2000;
constexpr double first_bending =
    7;  // glass of 19 um under the default contact law: bending begins as in nature
constexpr double bending_decay = 0.1;
constexpr double least_bending = 1e-4;
constexpr int bending_steps = 100;
constexpr double barrier_stiffness = 0.5;
constexpr double barrier_share = 0.5;   // of the mean radius of curvature: the smallest radius first aimed at
constexpr double barrier_decay = 0.97;  // by which the aim is lowered while fibers still overlap
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
  /// Cuts the fibers in other numbers of rods; a smooth curve through the old nodes is followed.
  [[nodiscard]] Chains divide(const Chains& chains,
                              const std::function<Index(const FiberBlank&)>& rods_of) const;
  [[nodiscard]] Index spread_rods_of(const FiberBlank& fiber) const;
  void spread(Chains& chains);
  [[nodiscard]] bool part_straight();
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
  if (!(request.swelling >= 1) || !(request.swelling <= 10))
    throw InputError(fmt::format("the swelling is {:.4g} diameters", request.swelling),
                     "give a number from 1 to 10");
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

/// Point at share x of a fiber's length on the Catmull-Rom spline through its nodes, continued straight at
/// the ends.
Vec3 point_on(const Chains& chains, std::size_t fiber, double x) {
  const auto begin = static_cast<std::ptrdiff_t>(chains.begin_node(fiber));
  const auto last = static_cast<std::ptrdiff_t>(chains.end_node(fiber)) - 1;
  const auto node = [&](std::ptrdiff_t k) -> Vec3 {
    const auto at = [&](std::ptrdiff_t i) { return chains.position[static_cast<std::size_t>(i)]; };
    if (k < begin) return 2 * at(begin) - at(begin + 1);
    if (k > last) return 2 * at(last) - at(last - 1);
    return at(k);
  };
  const double place = x * static_cast<double>(last - begin);
  const std::ptrdiff_t k = std::min(begin + static_cast<std::ptrdiff_t>(place), last - 1);
  const double t = place - static_cast<double>(k - begin);
  const Vec3 a = node(k - 1), b = node(k), c = node(k + 1), d = node(k + 2);
  return b + 0.5 * t * ((c - a) + t * ((2 * a - 5 * b + 4 * c - d) + t * (3 * b - a - 3 * c + d)));
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

Index Packer::spread_rods_of(const FiberBlank& fiber) const {
  const Index wanted = static_cast<Index>(std::lround(fiber.length / unit_ / spread_rod));
  return std::min(fiber.rods, std::max(wanted, spread_rods));
}

Chains Packer::divide(const Chains& chains, const std::function<Index(const FiberBlank&)>& rods_of) const {
  Chains divided;
  divided.cell = chains.cell;
  divided.radius = chains.radius;
  double stiffest = 0;
  for (const FiberMaterial& material : request_.materials)
    stiffest = std::max(stiffest, material.bending_stiffness());
  for (std::size_t f = 0; f < request_.fibers.size(); ++f) {
    const FiberBlank& fiber = request_.fibers[f];
    const Index rods = rods_of(fiber);
    for (Index k = 0; k <= rods; ++k)
      divided.position.push_back(point_on(chains, f, static_cast<double>(k) / rods));
    divided.first_node.push_back(static_cast<Index>(divided.position.size()));
    const double length = fiber.length / unit_ / rods;
    divided.rod_length.push_back(length);
    const double stiffness = request_.materials[fiber.material_id].bending_stiffness();
    divided.bending_stiffness.push_back((stiffest > 0 ? stiffness / stiffest : 1) /
                                        (length * length * length));
  }
  return divided;
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
  minimiser.finish();
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

void Packer::spread(Chains& chains) {
  Minimiser minimiser(chains, target_);
  PackingEnergy energy;
  energy.orientation = orientation_stiffness;
  energy.bending = spread_bending;
  energy.repulsion.swelling = request_.swelling;
  energy.repulsion.stiffness = spread_stiffness;
  stage_ = "spread";
  relax(minimiser, energy, spread_steps, {-1, 0});
}

bool Packer::part_straight() {
  spread(straight_);
  Minimiser minimiser(straight_, target_);
  PackingEnergy energy;
  energy.orientation = orientation_stiffness;
  stage_ = "part";
  const bool parted = relax(minimiser, energy, straight_steps, {request_.overlap_tolerance, 0});
  minimiser.finish();
  return parted;
}

FiberState Packer::pack() {
  const auto final_rods = [](const FiberBlank& fiber) { return fiber.rods; };
  place_straight();
  if (may_stay_straight() && part_straight()) return state_of(divide(straight_, final_rods));
  Chains coarse = divide(straight_, [this](const FiberBlank& fiber) { return spread_rods_of(fiber); });
  spread(coarse);
  Chains chains = divide(coarse, final_rods);
  bend(chains);
  return state_of(chains);
}

/// Uses only as many threads as small packings keep busy: waiting for each other costs more than it saves.
/// The result is the same for any number.
class SuitableThreads {
 public:
  explicit SuitableThreads(std::int64_t rods) : before_(thread_count()) {
    use_threads(static_cast<int>(std::min<std::int64_t>(before_, 1 + rods / rods_a_thread)));
  }
  ~SuitableThreads() { use_threads(before_); }
  SuitableThreads(const SuitableThreads&) = delete;
  SuitableThreads& operator=(const SuitableThreads&) = delete;

 private:
  static constexpr std::int64_t rods_a_thread = 1000;
  int before_;
};

std::int64_t rods_in(const PackingRequest& request) {
  std::int64_t rods = 0;
  for (const FiberBlank& fiber : request.fibers) rods += fiber.rods;
  return rods;
}

}  // namespace

PackingResult pack(const PackingRequest& request,
                   const std::function<void(const PackingProgress&)>& progress) {
  const double start = wall_seconds();
  require_sensible(request);
  const SuitableThreads threads(rods_in(request));
  Packer packer(request, progress);
  PackingResult result;
  result.state = packer.pack();
  result.report = measure_packing(result.state, packer.target());
  result.report.steps = packer.steps();
  result.report.wall_seconds = wall_seconds() - start;
  return result;
}

}  // namespace fiberfate
