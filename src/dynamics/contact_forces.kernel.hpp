// Evaluates contacts eight at a time; NormalForce and Friction are the specification.
#include "base/simd_rows.hpp"
#include "dynamics/contact_arrays.hpp"
#include "dynamics/contact_forces.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

#define FIBERFATE_INLINE static inline __attribute__((always_inline))

FIBERFATE_INLINE Pack read(const double* from) {
  typedef double Unaligned __attribute__((vector_size(64), aligned(8)));
  return *reinterpret_cast<const Unaligned*>(from);
}

/// Holds the law of each lane.
struct LawPack {
  Pack strength, decay, touch, cutoff, ramp, step;
};

FIBERFATE_INLINE LawPack same_law(const NormalForce::Constants& law) {
  return {broadcast(law.strength), broadcast(law.decay), broadcast(law.touch),
          broadcast(law.cutoff),   broadcast(law.ramp),  broadcast(law.step)};
}

FIBERFATE_INLINE LawPack laws_of(const ContactArrays& contacts, const ForceQuery& query, int i) {
  LawPack pack = same_law(query.laws[0]);
  for (int lane = 0; lane < lanes && i + lane < contacts.count; ++lane) {
    const NormalForce::Constants& law =
        query.laws[contacts.first_material[i + lane] * query.materials + contacts.second_material[i + lane]];
    pack.strength[lane] = law.strength;
    pack.decay[lane] = law.decay;
    pack.touch[lane] = law.touch;
    pack.cutoff[lane] = law.cutoff;
    pack.ramp[lane] = law.ramp;
    pack.step[lane] = law.step;
  }
  return pack;
}

FIBERFATE_INLINE Pack normal_force(const LawPack& law, const Pack& distance) {
  const Pack rise = law.step * (0.5 - (distance - law.cutoff) / law.ramp);
  const Pack exponential = law.strength * exponential_of(-law.decay * (distance - law.touch));
  const Pack lesser = choose(distance < law.cutoff - law.ramp, exponential, smaller(rise, exponential));
  return larger(choose(distance > law.cutoff - 0.4 * law.ramp, rise, lesser), broadcast(0));
}

/// Holds how each lane's rod moves at its place s: the velocity relative to the fluid, and what its turning
/// adds there, in the direction n away from the axis and for each unit of distance.
struct SkinMotion {
  Triple velocity, turning;
};

/// With q = (w_{i+1} − w_i)/l + D·p the rod turns at p × q relative to the fluid's rotation, and
/// (p × q) × n = q (p·n) − p (q·n).
FIBERFATE_INLINE SkinMotion motion_at(const ForceQuery& query, const Index* rods, const Pack& s,
                                      const Triple& n) {
  const double* begin[lanes];
  const double* end[lanes];
  const double* place[lanes];
  const double* next[lanes];
  for (int lane = 0; lane < lanes; ++lane) {
    const long at = 3 * static_cast<long>(rods[lane]);
    begin[lane] = query.relative_velocity + at;
    end[lane] = begin[lane] + 3;
    place[lane] = query.position + at;
    next[lane] = place[lane] + 3;
  }
  const Triple w = read_triples(begin);
  const Triple change = read_triples(end) - w;
  const Triple axis = read_triples(next) - read_triples(place);
  const Pack inverse_length = 1.0 / square_root(dot(axis, axis));
  const Triple p = inverse_length * axis;
  const Triple q = inverse_length * change + transform(query.strain_rate, p);
  return {w + s * change, dot(p, n) * q - dot(q, n) * p};
}

}  // namespace

void evaluate_forces(const ContactArrays& contacts, const ForceQuery& query, PairForce* forces) {
  const LawPack one_law = same_law(query.laws[0]);
  const double slip2 = query.friction.slip_velocity * query.friction.slip_velocity;
  for (int i = 0; i < contacts.count; i += lanes) {
    const LawPack law = query.materials == 1 ? one_law : laws_of(contacts, query, i);
    const Pack s = read(contacts.s + i), t = read(contacts.t + i);
    const Pack distance = read(contacts.distance + i);
    const Triple n = {read(contacts.normal[0] + i), read(contacts.normal[1] + i),
                      read(contacts.normal[2] + i)};
    const SkinMotion first = motion_at(query, contacts.first + i, s, n);
    const SkinMotion second = motion_at(query, contacts.second + i, t, n);
    // Turning moves the skins along each other, never apart.
    const Triple relative = first.velocity - second.velocity + distance * transform(query.strain_rate, n) -
                            (0.5 * distance) * (first.turning + second.turning);

    const Pack approach = dot(n, relative);
    const Triple slip = relative - approach * n;

    const Pack predicted = distance + query.step * approach;
    const Pack force = normal_force(law, predicted);
    const Pack friction = query.friction.coefficient * force / square_root(dot(slip, slip) + slip2);
    // Pairs about to close are held like closed ones, or they would overshoot the ramp within a step.
    const Mask near = predicted < law.cutoff + 1.5 * law.ramp;
    const Pack stiffness = choose(near, larger(law.step / law.ramp, law.decay * force), broadcast(0));
    const Triple on_first = force * n - friction * slip;
    const Pack along = 2.0 * query.step * stiffness;
    const Pack across = 2.0 * friction;
    for (int lane = 0; lane < lanes && i + lane < contacts.count; ++lane) {
      PairForce& to = forces[i + lane];
      to.force[0] = on_first.x[lane];
      to.force[1] = on_first.y[lane];
      to.force[2] = on_first.z[lane];
      to.normal[0] = n.x[lane];
      to.normal[1] = n.y[lane];
      to.normal[2] = n.z[lane];
      to.s = s[lane];
      to.t = t[lane];
      to.distance = distance[lane];
      to.along = along[lane];
      to.across = across[lane];
      to.first = contacts.first[i + lane];
      to.second = contacts.second[i + lane];
    }
  }
}

#undef FIBERFATE_INLINE

}  // namespace fiberfate::FIBERFATE_ISA
