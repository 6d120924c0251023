// Assembles drag and bending of eight fibers side by side.
#include "base/pack_math.hpp"
#include "base/simd_rows.hpp"
#include "dynamics/chain_assembly.hpp"
#include "dynamics/chain_system.hpp"
#include "dynamics/hinge_laws/hinge_laws.hpp"

namespace fiberfate::FIBERFATE_ISA {

namespace {

#define FIBERFATE_INLINE static inline __attribute__((always_inline))

using System = ChainSystem;

FIBERFATE_INLINE double* part(double* record, int component) {
  return record + component * lanes;
}
FIBERFATE_INLINE void add_to(double* to, const Pack& value) {
  store(to, load(to) + value);
}
FIBERFATE_INLINE void add_to_diagonal(double* record, const Pack& value) {
  for (int c = 0; c < 3; ++c) add_to(part(record, System::diagonal + c), value);
}
FIBERFATE_INLINE void add_to_coupling(double* record, const Pack& value) {
  for (int c = 0; c < 3; ++c) add_to(part(record, System::coupling + 4 * c), value);
}
FIBERFATE_INLINE void add_triple(double* record, int component, const Triple& v) {
  add_to(part(record, component), v.x);
  add_to(part(record, component + 1), v.y);
  add_to(part(record, component + 2), v.z);
}
FIBERFATE_INLINE void add_dyad_to_diagonal(double* record, const Pack& f, const Triple& p) {
  double* to = part(record, System::diagonal);
  const Pack parts[6] = {p.x * p.x, p.y * p.y, p.z * p.z, p.y * p.z, p.z * p.x, p.x * p.y};
  for (int c = 0; c < 6; ++c) add_to(part(to, c), f * parts[c]);
}
FIBERFATE_INLINE void add_dyad_to_coupling(double* record, const Pack& f, const Triple& p) {
  const Pack parts[3] = {p.x, p.y, p.z};
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row)
      add_to(part(record, System::coupling + 3 * column + row), f * parts[column] * parts[row]);
  }
}

/// Reads eight fibers; lanes whose fiber has ended repeat its last node or rod.
struct Reader {
  const ChainGroup& group;

  FIBERFATE_INLINE long place(const ChainGroup& group, int lane, int k, int last) {
    return group.first[lane] + (k < last ? k : last);
  }
  inline __attribute__((always_inline)) Triple vectors(const double* from, int k) const {
    const double* rows[lanes];
    for (int lane = 0; lane < lanes; ++lane) rows[lane] = from + 3 * place(group, lane, k, group.rods[lane]);
    return read_triples(rows);
  }
  /// Sets the lanes whose fiber has more than k rods.
  inline __attribute__((always_inline)) Mask has_rod(int k) const {
    return __builtin_convertvector(read_indices(group.used) > k, Mask);
  }
};

FIBERFATE_INLINE Pack rod_number(const AssemblyQuery& query, RodNumber number, int k) {
  return load(query.rods + offset_of(number, k));
}

/// What a rod adds to the records of its two nodes.
struct RodPart {
  Pack diagonal, coupling, excess, stretch, regular;
  Triple direction, couple;
};

FIBERFATE_INLINE RodPart rod_part(const AssemblyQuery& query, const Reader& read, int k, const Triple& axis) {
  const Mask there = read.has_rod(k);
  const Pack zero = broadcast(0);
  const Pack length = rod_number(query, RodNumber::length, k);
  const Pack perpendicular = query.viscosity * rod_number(query, RodNumber::perpendicular, k);
  const Pack parallel =
      query.is_anisotropic ? query.viscosity * rod_number(query, RodNumber::parallel, k) : perpendicular;
  const Pack turning = query.viscosity * rod_number(query, RodNumber::rotational, k);
  const Pack shape = rod_number(query, RodNumber::shape, k);
  const Triple p = choose(there, 1.0 / square_root(dot(axis, axis)), zero) * axis;
  const Triple strain = transform(query.strain_rate, p);
  const Pack translation = 0.25 * perpendicular;
  const Pack inverse = 1.0 / length;
  const Pack rotation = turning * inverse * inverse;
  // Couple of the strain on the rod's thickness; the rest of kappa·p moves with w.
  return {choose(there, translation + rotation, zero),
          choose(there, translation - rotation, zero),
          choose(there, 0.25 * (parallel - perpendicular), zero),
          -length * dot(p, strain),
          choose(there, zero, broadcast(-1)),
          p,
          (turning * (1.0 - shape) * inverse) * strain};
}

FIBERFATE_INLINE void store_node(double* record, const RodPart& before, const RodPart& after,
                                 const Pack& own) {
  const Pack zero = broadcast(0);
  const Pack diagonal = before.diagonal + after.diagonal + own;
  const Triple load_here = after.couple - before.couple;
  const Pack values[System::size] = {diagonal,
                                     diagonal,
                                     diagonal,
                                     zero,
                                     zero,
                                     zero,
                                     after.coupling,
                                     zero,
                                     zero,
                                     zero,
                                     after.coupling,
                                     zero,
                                     zero,
                                     zero,
                                     after.coupling,
                                     zero,
                                     load_here.x,
                                     load_here.y,
                                     load_here.z,
                                     after.direction.x,
                                     after.direction.y,
                                     after.direction.z,
                                     after.stretch,
                                     after.regular};
  for (int c = 0; c < System::size; ++c) store(part(record, c), values[c]);
}

FIBERFATE_INLINE void add_excess(double* record, const RodPart& before, const RodPart& after) {
  add_dyad_to_diagonal(record, before.excess, before.direction);
  add_dyad_to_diagonal(record, after.excess, after.direction);
  add_dyad_to_coupling(record, after.excess, after.direction);
}

/// Three nodes in a row, and the inverse lengths of the rods between them.
struct Bend {
  Triple x[3];
  Pack inverse_length[2];
};

/// Adds the hinge between the rods k − 1 and k to the records of its three nodes; `bending` is E I.
template <class Law>
FIBERFATE_INLINE void add_hinge(const AssemblyQuery& query, const Law& law, const Pack& bending, int k,
                                const Mask& there, const Bend& bend) {
  const Triple* x = bend.x;
  const Pack before = bend.inverse_length[0];
  const Pack after = bend.inverse_length[1];
  const Pack gamma[3] = {before, -before - after, after};
  const Triple turn = before * (x[0] - x[1]) + after * (x[2] - x[1]);
  const Pack y = smaller(0.25 * dot(turn, turn), broadcast(0.999 * 0.999));
  const Pack ratio = law(y);
  const Pack stiffness =
      choose(there, bending * 2.0 * before * after / (before + after) * ratio, broadcast(0));
  const Pack implicit = query.step * stiffness;
  const Triple carried = turn + broadcast(query.step) * transform(query.gradient, turn);
  double* record = query.records + static_cast<long>(k - 1) * System::size * lanes;
  for (int j = 0; j < 3; ++j) {
    double* node = record + static_cast<long>(j) * System::size * lanes;
    add_triple(node, System::load, (-stiffness * gamma[j]) * carried);
    add_to_diagonal(node, implicit * gamma[j] * gamma[j]);
  }
  add_to_coupling(record, implicit * gamma[0] * gamma[1]);
  add_to_coupling(record + System::size * lanes, implicit * gamma[1] * gamma[2]);
  add_to(part(record, System::second), implicit * gamma[0] * gamma[2]);
}

template <class Law>
void add_hinges(const AssemblyQuery& query, const Reader& read) {
  const ChainGroup& group = read.group;
  const Law law = same_law<Law>(query.hinge_constants);
  const Pack bending = load(group.bending_stiffness);
  const Pack zero = broadcast(0);
  Bend bend = {{{zero, zero, zero}, read.vectors(query.position, 0), read.vectors(query.position, 1)},
               {zero, 1.0 / rod_number(query, RodNumber::length, 0)}};
  for (int k = 1; k + 1 < group.nodes; ++k) {
    bend.x[0] = bend.x[1];
    bend.x[1] = bend.x[2];
    bend.x[2] = read.vectors(query.position, k + 1);
    bend.inverse_length[0] = bend.inverse_length[1];
    bend.inverse_length[1] = 1.0 / rod_number(query, RodNumber::length, k);
    add_hinge(query, law, bending, k, read.has_rod(k), bend);
  }
}

template <template <class> class... Laws>
FIBERFATE_INLINE void add_hinges_by_law(HingeLawList<Laws...>, const AssemblyQuery& query,
                                        const Reader& read) {
  int number = 0;
  ((query.hinge == number++ ? add_hinges<Laws<PackMath>>(query, read) : void()), ...);
}

}  // namespace

void assemble_chains(const AssemblyQuery& query, const ChainGroup& group) {
  const Reader read{group};
  const Pack zero = broadcast(0);
  const Triple none = {zero, zero, zero};
  RodPart before = {zero, zero, zero, zero, zero, none, none};
  Triple here = read.vectors(query.geometry, 0);
  for (int k = 0; k < group.nodes; ++k) {
    const Triple next = read.vectors(query.geometry, k + 1);
    const RodPart after = rod_part(query, read, k, next - here);
    // A node beyond the fiber's own becomes an identity.
    const Pack own = k == 0 ? choose(read.has_rod(0), zero, broadcast(1))
                            : choose(read.has_rod(k - 1), zero, broadcast(1));
    double* record = query.records + static_cast<long>(k) * System::size * lanes;
    store_node(record, before, after, own);
    if (query.is_anisotropic) add_excess(record, before, after);
    before = after;
    here = next;
  }
  add_hinges_by_law(HingeLaws{}, query, read);
}

#undef FIBERFATE_INLINE

}  // namespace fiberfate::FIBERFATE_ISA
