// Takes fibers out that press on others harder than their contact law can bear, and puts them back where
// there is room.
#include "packing/relief.hpp"

#include <algorithm>

#include "base/random.hpp"
#include "base/threads.hpp"
#include "fibers/closest_points.hpp"

namespace fiberfate {
namespace {

constexpr std::uint32_t places_tried = 10000;
constexpr std::uint32_t places_a_chunk = 250;
constexpr std::uint32_t placing = 7;  // tells the random numbers from those of other placements

}  // namespace

Relief::Relief(Chains& chains, Minimiser& minimiser, std::uint64_t seed)
    : chains_(chains),
      minimiser_(minimiser),
      seed_(seed),
      stiffness_(chains.bending_stiffness),
      moves_(chains.rod_length.size(), 0) {}

std::vector<Relief::Contact> Relief::overloaded(double overlap) const {
  std::vector<Contact> contacts;
  for (const FiberIndex fiber : chains_.fibers()) {
    for (const RodIndex rod : chains_.rods(fiber)) {
      if (minimiser_.overlap(rod) <= overlap) continue;
      for (const NeighbourRod& other : minimiser_.near(rod)) {
        const double touching = chains_.radius[fiber] + chains_.radius[other.fiber];
        const Segment near = shifted(chains_.segment(other.rod), other.shift);
        if (closest_points(chains_.segment(rod), near).distance < (1 - overlap) * touching)
          contacts.push_back({fiber, other.fiber});
      }
    }
  }
  return contacts;
}

std::size_t Relief::find(double overlap) {
  found_.clear();
  std::vector<Contact> contacts = overloaded(overlap);
  while (!contacts.empty()) {
    IndexedVector<FiberIndex, double> merit(chains_.fiber_count(), 0);
    for (const Contact& contact : contacts) merit[contact.fiber] += 1.0 / (1 + moves_[contact.fiber]);
    const FiberIndex worst(std::max_element(merit.begin(), merit.end()) - merit.begin());
    found_.push_back(worst);
    std::erase_if(contacts, [worst](const Contact& contact) {
      return contact.fiber == worst || contact.other == worst;
    });
  }
  return found_.size();
}

void Relief::put_straight(FiberIndex fiber, const StraightAxis& axis) {
  const NodeIndex begin = chains_.begin_node(fiber);
  const double middle = 0.5 * chains_.rod_count(fiber);
  for (const NodeIndex node : chains_.nodes(fiber)) {
    const double along = (node - begin - middle) * chains_.rod_length[fiber];
    chains_.position[node] = axis.centre + along * axis.direction;
    chains_.velocity[node].setZero();
  }
}

StraightAxis Relief::roomiest_place(FiberIndex fiber, const Vacancies& vacancies) const {
  const Vec3 ends = chains_.position[chains_.last_node(fiber)] - chains_.position[chains_.begin_node(fiber)];
  std::vector<StraightAxis> places(places_tried, {Vec3::Zero(), ends.normalized(), chains_.length(fiber)});
  std::vector<double> filled(places_tried);
  parallel_for(places_tried / places_a_chunk, [&](std::uint32_t chunk) {
    double least = 1;
    for (std::uint32_t i = 0; i < places_a_chunk; ++i) {
      const std::uint32_t at = chunk * places_a_chunk + i;
      const auto u = uniform4(seed_, RandomStream::position,
                              {static_cast<std::uint32_t>(fiber.value()), placing + round_, at});
      places[at].centre = chains_.cell.lattice * Vec3(u[0], u[1], u[2]);
      filled[at] = vacancies.filled_share(places[at], least);
      least = std::min(least, filled[at]);
    }
  });
  return places[std::min_element(filled.begin(), filled.end()) - filled.begin()];
}

void Relief::move() {
  Vacancies vacancies(chains_);
  IndexedVector<FiberIndex, char> moved(chains_.fiber_count(), 0);
  for (const FiberIndex fiber : found_) moved[fiber] = 1;
  for (const FiberIndex fiber : chains_.fibers()) {
    if (moved[fiber] == 0) vacancies.fill(chains_, fiber);
  }
  for (const FiberIndex fiber : found_) {
    put_straight(fiber, roomiest_place(fiber, vacancies));
    vacancies.fill(chains_, fiber);
    ++moves_[fiber];
  }
  ++round_;
  minimiser_.forget_neighbours();
}

void Relief::alter(const Alteration& alteration) {
  for (const FiberIndex f : found_) {
    if (alteration.swelling > chains_.swelling[f]) minimiser_.forget_neighbours();
    chains_.bending_stiffness[f] = alteration.stiffness * stiffness_[f];
    chains_.swelling[f] = alteration.swelling;
    chains_.firmness[f] = alteration.firmness;
    minimiser_.refresh(f);
  }
}

}  // namespace fiberfate
