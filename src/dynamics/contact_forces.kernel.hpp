// Evaluates contacts eight at a time.
#include "base/pack_math.hpp"
#include "base/simd_rows.hpp"
#include "dynamics/contact_arrays.hpp"
#include "dynamics/contact_forces.hpp"
#include "dynamics/friction_laws/friction_laws.hpp"
#include "fibers/contact_laws/contact_laws.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

#define FIBERFATE_INLINE static inline __attribute__((always_inline))

FIBERFATE_INLINE Pack read(const double* from) {
  typedef double Unaligned __attribute__((vector_size(64), aligned(8)));
  return *reinterpret_cast<const Unaligned*>(from);
}

/// Gives every lane the law of its pair of materials.
template <class Law>
FIBERFATE_INLINE Law law_of_pairs(const ContactArrays& contacts, const ForceQuery& query, int i) {
  Law law = same_law<Law>(query.laws);
  for (int lane = 0; lane < lanes && i + lane < contacts.count; ++lane) {
    const int pair = contacts.first_material[i + lane] * query.materials + contacts.second_material[i + lane];
    set_lane(law, lane, query.laws + query.law_stride * pair);
  }
  return law;
}

/// How each lane's rod moves at its place s: the velocity relative to the fluid, and what its turning
/// adds there, in the direction n away from the axis and for each unit of distance; and how the rod lies.
struct SkinMotion {
  Triple velocity, turning, direction;
};

/// The forces of eight contacts, as PairForce has them.
struct ForcePack {
  Triple force, normal;
  Pack s, t, distance, along, across;
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
  return {w + s * change, dot(p, n) * q - dot(q, n) * p, p};
}

/// Sine of the angle between two unit vectors.
FIBERFATE_INLINE Pack sine_between(const Triple& p, const Triple& q) {
  const Pack cosine = dot(p, q);
  return square_root(larger(1.0 - cosine * cosine, broadcast(0)));
}

FIBERFATE_INLINE void store_forces(const ContactArrays& contacts, int i, const ForcePack& from,
                                   PairForce* forces) {
  for (int lane = 0; lane < lanes && i + lane < contacts.count; ++lane) {
    PairForce& to = forces[i + lane];
    to.force[0] = from.force.x[lane];
    to.force[1] = from.force.y[lane];
    to.force[2] = from.force.z[lane];
    to.normal[0] = from.normal.x[lane];
    to.normal[1] = from.normal.y[lane];
    to.normal[2] = from.normal.z[lane];
    to.s = from.s[lane];
    to.t = from.t[lane];
    to.distance = from.distance[lane];
    to.along = from.along[lane];
    to.across = from.across[lane];
  }
}

template <class Law, class FrictionLaw>
void evaluate(const ContactArrays& contacts, const ForceQuery& query, PairForce* forces) {
  const Law one_law = same_law<Law>(query.laws);
  const FrictionLaw friction_law = same_law<FrictionLaw>(query.friction_constants);
  for (int i = 0; i < contacts.count; i += lanes) {
    const Law law = query.materials == 1 ? one_law : law_of_pairs<Law>(contacts, query, i);
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

    const ContactGap<Pack> gap = {distance + query.step * approach,
                                  sine_between(first.direction, second.direction)};
    const Pack force = law(gap);
    const Pack friction = friction_law(force, dot(slip, slip));
    const Pack stiffness = law.stiffness(gap, force);
    store_forces(
        contacts, i,
        {force * n - friction * slip, n, s, t, distance, 2.0 * query.step * stiffness, 2.0 * friction},
        forces);
  }
}

template <class Law, template <class> class... FrictionLaws>
FIBERFATE_INLINE void choose_friction(FrictionLawList<FrictionLaws...>, const ContactArrays& contacts,
                                      const ForceQuery& query, PairForce* forces) {
  int number = 0;
  ((query.friction == number++ ? evaluate<Law, FrictionLaws<PackMath>>(contacts, query, forces) : void()),
   ...);
}

template <template <class> class... Laws>
FIBERFATE_INLINE void choose_law(ContactLawList<Laws...>, const ContactArrays& contacts,
                                 const ForceQuery& query, PairForce* forces) {
  int number = 0;
  ((query.law == number++ ? choose_friction<Laws<PackMath>>(FrictionLaws{}, contacts, query, forces)
                          : void()),
   ...);
}

}  // namespace

void evaluate_forces(const ContactArrays& contacts, const ForceQuery& query, PairForce* forces) {
  choose_law(ContactLaws{}, contacts, query, forces);
}

#undef FIBERFATE_INLINE

}  // namespace fiberfate::FIBERFATE_ISA
