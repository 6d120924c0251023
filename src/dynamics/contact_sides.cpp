// Evaluates linearised contact forces at the solved velocities, as the kernels do.
#include "dynamics/contact_sides.hpp"

namespace fiberfate {
namespace {

const PairForce& pair_of(const SolvedStep& step, const PairForces::Share& share) {
  return step.loads.pairs().forces()[share.number / 2];
}

double sign_of(const PairForces::Share& share) {
  return share.number % 2 == 0 ? 1 : -1;
}

}  // namespace

RodSide::RodSide(const SolvedStep& step, const PairForce& pair, RodIndex rod, double sign)
    : rod_(rod),
      sign_(sign),
      place_(sign > 0 ? pair.s : pair.t),
      distance_(pair.distance),
      length_(step.problem.state.rod_length[rod]),
      normal_(pair.normal),
      direction_(step.problem.state.axis(rod) / length_) {
  const Vec3 change = skin_velocity(step.velocity) - skin_velocity(step.problem.pair_velocity);
  const Vec3 along = normal_.dot(change) * normal_;
  force_ = sign * Vec3(pair.force) - pair.along * along - pair.across * (change - along);
}

Vec3 RodSide::on_axis(IndexedSpan<NodeIndex, const Vec3> nodes) const {
  return (1 - place_) * nodes[first_end(rod_)] + place_ * nodes[second_end(rod_)];
}

Vec3 RodSide::turning(IndexedSpan<NodeIndex, const Vec3> w, const Mat3& strain_rate) const {
  const Vec3 p = direction_.normalized();
  const Vec3 turn = (w[second_end(rod_)] - w[first_end(rod_)]) / length_ + strain_rate * p;
  return p.dot(normal_) * turn - turn.dot(normal_) * p;
}

Vec3 RodSide::skin_velocity(IndexedSpan<NodeIndex, const Vec3> w) const {
  const Vec3 change = w[second_end(rod_)] - w[first_end(rod_)];
  const Vec3 turned = normal_.dot(change) * direction_ - normal_.dot(direction_) * change;
  return on_axis(w) + sign_ * 0.5 * distance_ / length_ * turned;
}

Mat3 RodSide::couple_moment(IndexedSpan<NodeIndex, const Vec3> nodes) const {
  const Vec3 axis = nodes[second_end(rod_)] - nodes[first_end(rod_)];
  const Vec3 end_force = sign_ * 0.5 * distance_ / length_ *
                         (direction_.dot(force_) * normal_ - normal_.dot(direction_) * force_);
  const Mat3 moment = axis * end_force.transpose();
  return 0.5 * (moment + moment.transpose());
}

Vec3 RodSide::lost_torque() const {
  const Vec3 couple = -0.5 * distance_ * sign_ * normal_.cross(force_);
  return direction_.dot(couple) * direction_;
}

ContactSides::ContactSides(const SolvedStep& step, RodIndex rod, const PairForces::Share& share)
    : own_(step, pair_of(step, share), rod, sign_of(share)),
      other_(step, pair_of(step, share), share.other(), -sign_of(share)),
      normal_(pair_of(step, share).normal) {
  const bool is_first = sign_of(share) > 0;
  const RodSide &first = is_first ? own_ : other_, &second = is_first ? other_ : own_;
  const Flow& flow = step.problem.flow;
  const Mat3 strain_rate = flow.rate_of_strain();
  const Vec3 axes = pair_of(step, share).distance * normal_;
  const auto& last = step.problem.state.relative_velocity;
  gap_ = axes + 0.5 * step.problem.step * (flow.gradient * axes + first.on_axis(last) - second.on_axis(last));
  slip_ = first.on_axis(step.velocity) - second.on_axis(step.velocity) + strain_rate * axes -
          0.5 * pair_of(step, share).distance *
              (first.turning(step.velocity, strain_rate) + second.turning(step.velocity, strain_rate));
}

Vec3 ContactSides::mean_force() const {
  return 0.5 * own_.sign() * (own_.force() - other_.force());
}

}  // namespace fiberfate
