// Chooses the kernel that evaluates contacts.
#include "dynamics/contact_forces.hpp"

#include "base/kernels.hpp"
#include "dynamics/contact_arrays.hpp"

namespace fiberfate {

FIBERFATE_DECLARE_KERNEL(void evaluate_forces(const ContactArrays& contacts, const ForceQuery& query,
                                              PairForce* forces))

void evaluate_forces(const ContactChunk& contacts, const ForceQuery& query, PairForce* forces) {
  const ContactArrays arrays = {
      contacts.count,
      numbers(contacts.first).data(),
      numbers(contacts.second).data(),
      contacts.image.data(),
      contacts.first_material.data(),
      contacts.second_material.data(),
      contacts.s.data(),
      contacts.t.data(),
      {contacts.normal_x.data(), contacts.normal_y.data(), contacts.normal_z.data()},
      contacts.distance.data()};
  return FIBERFATE_KERNEL(evaluate_forces)(arrays, query, forces);
}

}  // namespace fiberfate
