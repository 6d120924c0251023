// Assembles the system of one fiber: drag and couple of every rod, implicit bending of every hinge, loads.
#include "dynamics/chain_assembly.hpp"

#include "dynamics/bending.hpp"

namespace fiberfate {
namespace {

using System = ChainSystem;

/// Writes into one lane of a system; symmetric blocks are xx, yy, zz, yz, zx, xy.
class LaneWriter {
 public:
  LaneWriter(System& system, int lane) : system_(system), lane_(lane) {}

  void clear(int node) {
    double* r = record(node);
    for (int c = 0; c < System::size; ++c) r[c * System::lanes] = 0;
  }
  void set(int node, int component, double value) { record(node)[component * System::lanes] = value; }
  void add(int node, int component, double value) { record(node)[component * System::lanes] += value; }
  void add(int node, int component, const Vec3& v) {
    for (int c = 0; c < 3; ++c) add(node, component + c, v[c]);
  }
  void add_isotropic(int node, int component, double value) {
    for (int c = 0; c < 3; ++c) add(node, component + c, value);
  }
  void add_symmetric(int node, int component, double factor, const std::array<double, 6>& block) {
    for (int c = 0; c < 6; ++c) add(node, component + c, factor * block[static_cast<std::size_t>(c)]);
  }

 private:
  double* record(int node) { return system_.record(node) + lane_; }
  System& system_;
  int lane_;
};

std::array<double, 6> dyad(const Vec3& v) {
  return {v.x() * v.x(), v.y() * v.y(), v.z() * v.z(), v.y() * v.z(), v.z() * v.x(), v.x() * v.y()};
}

/// Assembles one fiber; local node numbers begin at 0.
class FiberAssembly {
 public:
  FiberAssembly(const ChainProblem& problem, Index fiber, ChainLane lane)
      : problem_(problem),
        strain_rate_(problem.flow.rate_of_strain()),
        hinge_{problem.state.material(fiber).bending_stiffness()},
        first_(problem.state.begin_node(fiber)),
        rods_(problem.state.rod_count(fiber)),
        write_(lane.system, lane.lane) {}

  void run() {
    for (int k = 0; k <= rods_; ++k) write_.clear(k);
    for (int i = 0; i < rods_; ++i) {
      add_drag(i);
      add_loads(i);
    }
    for (int k = 1; k < rods_; ++k) add_hinge(k);
    write_.set(rods_, System::regular, -1);
  }

 private:
  [[nodiscard]] std::size_t global(int node) const { return static_cast<std::size_t>(first_ + node); }
  [[nodiscard]] double length(int rod) const { return problem_.state.rod_length[global(rod)]; }

  void add_drag(int i) {
    const std::size_t n = global(i);
    const RodDrag& drag = problem_.unit_drag[n];
    const double l = length(i);
    const double viscosity = problem_.flow.viscosity;
    const Vec3 p = (problem_.geometry[n + 1] - problem_.geometry[n]).normalized();
    const double translation = viscosity * drag.perpendicular / 4;
    const double rotation = viscosity * drag.rotational / (l * l);
    write_.add_isotropic(i, System::diagonal, translation + rotation);
    write_.add_isotropic(i + 1, System::diagonal, translation + rotation);
    write_.add_isotropic(i, System::coupling, translation - rotation);
    if (drag.parallel != drag.perpendicular) {
      const double excess = viscosity * (drag.parallel - drag.perpendicular) / 4;
      for (const int node : {i, i + 1}) write_.add_symmetric(node, System::diagonal, excess, dyad(p));
      write_.add_symmetric(i, System::coupling, excess, dyad(p));
    }
    // Couple of the strain on the rod's thickness; the rest of kappa·p moves with w.
    const Vec3 strain = strain_rate_ * p;
    const Vec3 couple = viscosity * drag.rotational * (1 - drag.shape) / l * strain;
    write_.add(i, System::load, couple);
    write_.add(i + 1, System::load, -couple);
    for (int c = 0; c < 3; ++c) write_.set(i, System::direction + c, p[c]);
    write_.set(i, System::stretch, -l * p.dot(strain));
  }

  void add_loads(int i) {
    for (const RodLoad& load : problem_.loads.of_rod(static_cast<Index>(global(i)))) {
      const double s = load.lever;
      write_.add(i, System::load, (1 - s) * load.force);
      write_.add(i + 1, System::load, s * load.force);
      write_.add_symmetric(i, System::diagonal, (1 - s) * (1 - s), load.resistance);
      write_.add_symmetric(i + 1, System::diagonal, s * s, load.resistance);
      write_.add_symmetric(i, System::coupling, s * (1 - s), load.resistance);
    }
  }

  void add_hinge(int k) {
    const std::size_t n = global(k);
    const double before = 1 / length(k - 1);
    const double after = 1 / length(k);
    const std::array<double, 3> gamma = {before, -before - after, after};
    const auto& x = problem_.state.position;
    const Vec3 turn = before * (x[n - 1] - x[n]) + after * (x[n + 1] - x[n]);
    const double stiffness = hinge_(turn, 0.5 * (length(k - 1) + length(k)));
    const double implicit = stiffness * problem_.step;
    const Vec3 carried = turn + problem_.step * (problem_.flow.gradient * turn);
    for (int j = 0; j < 3; ++j) {
      const double g = gamma[static_cast<std::size_t>(j)];
      write_.add(k - 1 + j, System::load, -stiffness * g * carried);
      write_.add_isotropic(k - 1 + j, System::diagonal, implicit * g * g);
    }
    write_.add_isotropic(k - 1, System::coupling, implicit * gamma[0] * gamma[1]);
    write_.add_isotropic(k, System::coupling, implicit * gamma[1] * gamma[2]);
    write_.add(k - 1, System::second, implicit * gamma[0] * gamma[2]);
  }

  const ChainProblem& problem_;
  Mat3 strain_rate_;
  ElasticHinge hinge_;
  Index first_;
  int rods_;
  LaneWriter write_;
};

}  // namespace

void assemble_chain(const ChainProblem& problem, Index fiber, ChainLane lane) {
  FiberAssembly(problem, fiber, lane).run();
  pad_chain(lane, problem.state.rod_count(fiber) + 1);
}

void pad_chain(ChainLane lane, int first) {
  LaneWriter write(lane.system, lane.lane);
  for (int k = first; k < lane.nodes; ++k) {
    write.clear(k);
    write.add_isotropic(k, System::diagonal, 1);
    write.set(k, System::regular, -1);
  }
}

}  // namespace fiberfate
