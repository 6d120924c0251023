// Takes fibers out that press on others harder than their contact law can bear, and puts them back where
// there is room.
#include "packing/relief.hpp"

#include <algorithm>

#include "base/random.hpp"
#include "base/threads.hpp"
#include "fibers/closest_points.hpp"
#include "packing/vacancies.hpp"

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
  const auto& position = chains_.position;
  for (std::size_t f = 0; f < chains_.rod_length.size(); ++f) {
    for (std::size_t k = chains_.begin_node(f); k + 1 < chains_.end_node(f); ++k) {
      if (minimiser_.overlap(k) <= overlap) continue;
      for (const NeighbourRod& other : minimiser_.near(k)) {
        const Segment near = {position[other.node] + other.shift, position[other.node + 1] + other.shift};
        const double touching = chains_.radius[f] + chains_.radius[other.fiber];
        if (closest_points({position[k], position[k + 1]}, near).distance < (1 - overlap) * touching)
          contacts.push_back({f, other.fiber});
      }
    }
  }
  return contacts;
}

std::size_t Relief::find(double overlap) {
  found_.clear();
  std::vector<Contact> contacts = overloaded(overlap);
  while (!contacts.empty()) {
    std::vector<double> merit(chains_.rod_length.size(), 0);
    for (const Contact& contact : contacts) merit[contact.fiber] += 1.0 / (1 + moves_[contact.fiber]);
    const auto worst = static_cast<std::size_t>(std::max_element(merit.begin(), merit.end()) - merit.begin());
    found_.push_back(worst);
    std::erase_if(contacts, [worst](const Contact& contact) {
      return contact.fiber == worst || contact.other == worst;
    });
  }
  return found_.size();
}

void Relief::put_straight(std::size_t fiber, const Vec3& centre, const Vec3& direction) {
  const std::size_t begin = chains_.begin_node(fiber), end = chains_.end_node(fiber);
  const double middle = 0.5 * static_cast<double>(end - begin - 1);
  for (std::size_t k = begin; k < end; ++k) {
    const double along = (static_cast<double>(k - begin) - middle) * chains_.rod_length[fiber];
    chains_.position[k] = centre + along * direction;
    chains_.velocity[k].setZero();
  }
}

void Relief::move() {
  Vacancies vacancies(chains_);
  std::vector<char> moved(chains_.rod_length.size(), 0);
  for (const std::size_t f : found_) moved[f] = 1;
  for (std::size_t f = 0; f < moved.size(); ++f) {
    if (moved[f] == 0) vacancies.fill(chains_, f);
  }
  std::vector<StraightAxis> places(places_tried);
  std::vector<double> filled(places_tried);
  for (const std::size_t f : found_) {
    const std::size_t begin = chains_.begin_node(f), last = chains_.end_node(f) - 1;
    const Vec3 direction = (chains_.position[last] - chains_.position[begin]).normalized();
    const double length = chains_.rod_length[f] * static_cast<double>(last - begin);
    parallel_for(places_tried / places_a_chunk, [&](std::ptrdiff_t chunk) {
      double least = 1;
      for (std::uint32_t i = 0; i < places_a_chunk; ++i) {
        const auto at = static_cast<std::uint32_t>(chunk) * places_a_chunk + i;
        const auto u =
            uniform4(seed_, RandomStream::position, {static_cast<std::uint32_t>(f), placing + round_, at});
        places[at] = {chains_.cell.lattice * Vec3(u[0], u[1], u[2]), direction, length};
        filled[at] = vacancies.filled_share(places[at], least);
        least = std::min(least, filled[at]);
      }
    });
    const auto best = std::min_element(filled.begin(), filled.end()) - filled.begin();
    put_straight(f, places[static_cast<std::size_t>(best)].centre, direction);
    vacancies.fill(chains_, f);
    ++moves_[f];
  }
  ++round_;
  minimiser_.forget_neighbours();
}

void Relief::alter(const Alteration& alteration) {
  for (const std::size_t f : found_) {
    if (alteration.swelling > chains_.swelling[f]) minimiser_.forget_neighbours();
    chains_.bending_stiffness[f] = alteration.stiffness * stiffness_[f];
    chains_.swelling[f] = alteration.swelling;
    chains_.firmness[f] = alteration.firmness;
    minimiser_.refresh(f);
  }
}

}  // namespace fiberfate
