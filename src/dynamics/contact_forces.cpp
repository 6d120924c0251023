// Chooses the kernel that evaluates contacts.
#include "dynamics/contact_forces.hpp"

#include "base/simd.hpp"
#include "dynamics/contact_arrays.hpp"

namespace fiberfate {

namespace baseline {
void evaluate_forces(const ContactArrays& contacts, const ForceQuery& query, PairForce* forces);
}
namespace avx2 {
void evaluate_forces(const ContactArrays& contacts, const ForceQuery& query, PairForce* forces);
}
namespace avx512 {
void evaluate_forces(const ContactArrays& contacts, const ForceQuery& query, PairForce* forces);
}

void evaluate_forces(const ContactChunk& contacts, const ForceQuery& query, PairForce* forces) {
  const ContactArrays arrays = {
      contacts.count,
      contacts.first.data(),
      contacts.second.data(),
      contacts.image.data(),
      contacts.first_material.data(),
      contacts.second_material.data(),
      contacts.s.data(),
      contacts.t.data(),
      {contacts.normal_x.data(), contacts.normal_y.data(), contacts.normal_z.data()},
      contacts.distance.data()};
  switch (instruction_set()) {
    case InstructionSet::avx512:
      return avx512::evaluate_forces(arrays, query, forces);
    case InstructionSet::avx2:
      return avx2::evaluate_forces(arrays, query, forces);
    default:
      return baseline::evaluate_forces(arrays, query, forces);
  }
}

}  // namespace fiberfate
