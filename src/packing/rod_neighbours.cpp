// Finds the rods near each rod with a grid in fractional coordinates of the cell.
#include "packing/rod_neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

// Slots are listed in chunks of this many, each into its own buffer, whatever the number of threads.
constexpr Index chunk_size = 128;
// A rod this far away, in diameters, touches nothing: padding of the lists.
constexpr double nowhere = 1e6;
constexpr int lanes = 8;

}  // namespace

/// The neighbours of one chunk of slots, padded for each of them.
struct RodNeighbours::ChunkLists {
  std::vector<SlotIndex> rod;
  std::vector<ImageIndex> image;
  std::vector<std::int32_t> count;
};

/// Candidates of one rod, padded to full packs for the distance kernel.
struct RodNeighbours::Candidates {
  std::vector<SlotIndex> rod;
  std::vector<ImageIndex> image;
  std::vector<std::int32_t> found;
  std::vector<double> distance;
  ImageIndex no_image;

  void pad(SlotIndex dummy) {
    while (rod.size() % lanes != 0) {
      rod.push_back(dummy);
      image.push_back(no_image);
    }
    distance.resize(rod.size());
  }
};

void RodNeighbours::sort(const Chains& chains, BoxGrid& grid) {
  const std::size_t nodes = chains.position.size();
  rods_ = chains.rod_count();
  slot_of_rod_.assign(nodes, SlotIndex(-1));
  wrap_.assign(nodes, Vec3::Zero());
  IndexedVector<RodIndex, BoxIndex> box_of_rod(nodes);
  parallel_for(chains.fibers(), [&](FiberIndex fiber) {
    for (const RodIndex rod : chains.rods(fiber)) {
      const Vec3 centre = chains.centre(rod);
      wrap_[rod] = chains.cell.shift(image_of(chains.cell, centre));
      box_of_rod[rod] = grid.number(grid.box(centre - wrap_[rod]));
    }
  });
  const Index boxes = grid.count().prod();
  grid.first_slot.assign(boxes + 1, SlotIndex(0));
  for (const FiberIndex fiber : chains.fibers()) {
    for (const RodIndex rod : chains.rods(fiber)) ++grid.first_slot[box_of_rod[rod] + 1];
  }
  for (const BoxIndex box : first_indices<BoxIndex>(boxes))
    grid.first_slot[box + 1] = grid.first_slot[box + 1] + grid.first_slot[box].value();
  IndexedVector<BoxIndex, SlotIndex> next = grid.first_slot;
  rod_of_slot_.resize(rods_);
  fiber_of_slot_.resize(rods_);
  for (const FiberIndex fiber : chains.fibers()) {
    for (const RodIndex rod : chains.rods(fiber)) {
      const SlotIndex slot = next[box_of_rod[rod]]++;
      slot_of_rod_[rod] = slot;
      rod_of_slot_[slot] = rod;
      fiber_of_slot_[slot] = fiber;
    }
  }
}

void RodNeighbours::refresh(const Chains& chains, FiberIndex fiber) {
  for (const RodIndex rod : chains.rods(fiber)) {
    const Vec3 centre = chains.centre(rod) - wrap_[rod];
    const Vec3 half = 0.5 * chains.axis(rod);
    RodRecord& record = records_[slot(rod)];
    for (int i = 0; i < 3; ++i) {
      record.centre[i] = centre[i];
      record.half[i] = half[i];
    }
    record.radius = chains.swelling[fiber] * chains.radius[fiber];
    record.firmness = chains.firmness[fiber];
  }
}

void RodNeighbours::arrange(const Search& search) {
  const Chains& chains = search.chains;
  records_.resize(rods_);
  records_.emplace_back().centre[0] = nowhere;
  for (auto* array : {&x_, &y_, &z_, &reach_}) array->assign(rods_ + lanes, 0.0);
  parallel_for(chains.fibers(), [&](FiberIndex fiber) {
    refresh(chains, fiber);
    for (const RodIndex rod : chains.rods(fiber)) {
      const SlotIndex at = slot(rod);
      x_[at] = records_[at].centre[0];
      y_[at] = records_[at].centre[1];
      z_[at] = records_[at].centre[2];
      reach_[at] = 0.5 * chains.rod_length[fiber] + search.range.swelling * records_[at].radius;
    }
  });
  number_images(search);
}

void RodNeighbours::number_images(const Search& search) {
  const int most = search.grid.farthest_image();
  shifts_.assign((2 * most + 1) * (2 * most + 1) * (2 * most + 1), ImageShift{});
  IntVec3 image;
  for (image[2] = -most; image[2] <= most; ++image[2]) {
    for (image[1] = -most; image[1] <= most; ++image[1]) {
      for (image[0] = -most; image[0] <= most; ++image[0]) {
        const Vec3 shift = search.chains.cell.shift(image);
        for (int i = 0; i < 3; ++i) shifts_[search.grid.number_of_image(image)].shift[i] = shift[i];
      }
    }
  }
}

bool RodNeighbours::is_own_neighbour(const Search& search, SlotIndex subject, const ImagedRod& other) const {
  const FiberIndex fiber = fiber_of_slot_[subject];
  if (fiber_of_slot_[other.slot] != fiber) return false;
  const RodIndex own_rod = rod_of_slot_[subject], other_rod = rod_of_slot_[other.slot];
  const Vec3 offset = wrap_[other_rod] - wrap_[own_rod];
  constexpr double same_place = 1e-3;  // images are many diameters apart
  if ((offset - shift_of(other.image)).norm() > same_place) return false;
  const double along = (std::abs(own_rod - other_rod) - 1) * search.chains.rod_length[fiber];
  return along < 2 * (search.range.swelling * 2 * search.chains.radius[fiber] + search.range.reach);
}

void RodNeighbours::collect(const Search& search, SlotIndex subject, Candidates& candidates) const {
  const SearchKernel find = search_kernel();
  const NeighbourRange& range = search.range;
  const BoxGrid& grid = search.grid;
  const CentreArrays centres = {x_.data(), y_.data(), z_.data(), reach_.data()};
  const RodRecord& own = records_[subject];
  const double half = Vec3(own.half[0], own.half[1], own.half[2]).norm();
  const IntVec3 box = grid.box({own.centre[0], own.centre[1], own.centre[2]});
  SearchRod rod{};
  for (int i = 0; i < 3; ++i) rod.direction[i] = own.half[i] / half;
  rod.tube = range.swelling * own.radius + range.reach + range.skin;
  rod.sphere = rod.tube + half;
  candidates.rod.clear();
  candidates.image.clear();
  const BoxRange y = grid.around(box, 1), z = grid.around(box, 2);
  IntVec3 at;
  for (at[2] = z.low; at[2] <= z.high; ++at[2]) {
    for (at[1] = y.low; at[1] <= y.high; ++at[1]) {
      BoxRange x = grid.around(box, 0);
      while (x.low <= x.high) {
        at[0] = x.low;
        const IntVec3 image = grid.image(at);
        const IntVec3 inside = at - image.cwiseProduct(grid.count());
        const int run = std::min(x.high - x.low + 1, grid.count()[0] - inside[0]);
        x.low += run;
        const ImageIndex image_number = grid.number_of_image(image);
        for (int i = 0; i < 3; ++i) rod.centre[i] = own.centre[i] - shifts_[image_number].shift[i];
        const Index first = grid.first_slot[grid.number(inside)].value();
        const Index last = grid.first_slot[grid.number(inside) + run].value();
        candidates.found.resize(last - first + lanes);
        const int found = find(centres, rod, first, last, candidates.found.data());
        for (int k = 0; k < found; ++k) {
          const SlotIndex slot(candidates.found[k]);
          if (is_own_neighbour(search, subject, {slot, image_number})) continue;
          candidates.rod.push_back(slot);
          candidates.image.push_back(image_number);
        }
      }
    }
  }
}

void RodNeighbours::keep_near(const NeighbourRange& range, SlotIndex subject, const Candidates& candidates,
                              ChunkLists& lists) const {
  const SlotIndex dummy(rods_);
  std::int32_t kept = 0;
  for (std::size_t k = 0; k < candidates.rod.size(); ++k) {
    if (candidates.rod[k] == dummy) continue;
    const double touching = records_[subject].radius + records_[candidates.rod[k]].radius;
    if (candidates.distance[k] >= range.swelling * touching + range.reach + range.skin) continue;
    lists.rod.push_back(candidates.rod[k]);
    lists.image.push_back(candidates.image[k]);
    ++kept;
  }
  lists.count.push_back(kept);
  while (lists.rod.size() % lanes != 0) {
    lists.rod.push_back(dummy);
    lists.image.push_back(candidates.no_image);
  }
}

void RodNeighbours::list(const Search& search) {
  const Index chunks = (rods_ + chunk_size - 1) / chunk_size;
  std::vector<ChunkLists> found(chunks);
  const DistanceKernel measure = distance_kernel();
  parallel_for(chunks, [&](Index c) {
    Candidates candidates;
    candidates.no_image = search.grid.number_of_image(IntVec3::Zero());
    const Index last = std::min(rods_, (c + 1) * chunk_size);
    for (SlotIndex subject(c * chunk_size); subject < SlotIndex(last); ++subject) {
      collect(search, subject, candidates);
      candidates.pad(SlotIndex(rods_));
      const RepulsionInput arrays = {records_.data(), nullptr, numbers(candidates.rod).data(),
                                     numbers(candidates.image).data(), shifts_.data()};
      measure(arrays, subject.value(), static_cast<int>(candidates.rod.size()), candidates.distance.data());
      keep_near(search.range, subject, candidates, found[c]);
    }
  });
  join(found);
}

void RodNeighbours::join(const std::vector<ChunkLists>& found) {
  begin_.assign(rods_ + 1, 0);
  listed_ = 0;
  SlotIndex slot;
  rod_.clear();
  image_.clear();
  for (const ChunkLists& lists : found) {
    rod_.insert(rod_.end(), lists.rod.begin(), lists.rod.end());
    image_.insert(image_.end(), lists.image.begin(), lists.image.end());
    for (const std::int32_t count : lists.count) {
      begin_[slot + 1] = begin_[slot] + (count + lanes - 1) / lanes * lanes;
      listed_ += count;
      ++slot;
    }
  }
}

void RodNeighbours::build(const Chains& chains, const NeighbourRange& range) {
  BoxGrid grid(chains, range);
  sort(chains, grid);
  const Search search = {chains, range, grid};
  arrange(search);
  list(search);
}

RepulsionInput RodNeighbours::input() const {
  return {records_.data(), begin_.data(), numbers(rod_).data(), numbers(image_).data(), shifts_.data()};
}

std::vector<NeighbourRod> RodNeighbours::of(RodIndex rod) const {
  std::vector<NeighbourRod> near;
  const SlotIndex subject = slot(rod);
  for (std::int32_t i = begin_[subject]; i < begin_[subject + 1]; ++i) {
    if (rod_[i] == SlotIndex(rods_)) continue;
    const RodIndex other = rod_of_slot_[rod_[i]];
    near.push_back({fiber_of_slot_[rod_[i]], other, shift_of(image_[i]) + wrap_[rod] - wrap_[other]});
  }
  return near;
}

}  // namespace fiberfate
