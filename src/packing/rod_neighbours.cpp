// Finds the rods near each rod with a grid in fractional coordinates of the cell.
#include "packing/rod_neighbours.hpp"

#include <algorithm>
#include <cmath>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

// Slots are listed in chunks of this many, each into its own buffer, whatever the number of threads.
constexpr std::ptrdiff_t chunk_size = 128;
// A rod this far away, in diameters, touches nothing: padding of the lists.
constexpr double nowhere = 1e6;
constexpr int lanes = 8;

}  // namespace

/// The neighbours of one chunk of slots, padded for each of them.
struct RodNeighbours::ChunkLists {
  std::vector<std::int32_t> rod, image, count;
};

/// Candidates of one rod, padded to full packs for the distance kernel.
struct RodNeighbours::Candidates {
  std::vector<std::int32_t> rod, image, found;
  std::vector<double> distance;

  std::int32_t no_image = 0;

  void pad(std::int32_t dummy) {
    while (rod.size() % lanes != 0) {
      rod.push_back(dummy);
      image.push_back(no_image);
    }
    distance.resize(rod.size());
  }
};

void RodNeighbours::sort(const Chains& chains, BoxGrid& grid) {
  const std::size_t nodes = chains.position.size();
  rods_ = nodes - chains.rod_length.size();
  slot_of_node_.assign(nodes, -1);
  wrap_.assign(nodes, Vec3::Zero());
  std::vector<std::int32_t> box_of_node(nodes, -1);
  parallel_for(chains.fiber_count(), [&](std::ptrdiff_t f) {
    const auto fiber = static_cast<std::size_t>(f);
    for (std::size_t k = chains.begin_node(fiber); k + 1 < chains.end_node(fiber); ++k) {
      const Vec3 centre = 0.5 * (chains.position[k] + chains.position[k + 1]);
      wrap_[k] = chains.cell.shift(image_of(chains.cell, centre));
      box_of_node[k] = grid.number(grid.box(centre - wrap_[k]));
    }
  });
  const auto boxes = static_cast<std::size_t>(grid.count().prod());
  grid.first_slot.assign(boxes + 1, 0);
  for (const std::int32_t box : box_of_node) {
    if (box >= 0) ++grid.first_slot[static_cast<std::size_t>(box) + 1];
  }
  for (std::size_t b = 0; b < boxes; ++b) grid.first_slot[b + 1] += grid.first_slot[b];
  std::vector<std::int32_t> next(grid.first_slot.begin(), grid.first_slot.end() - 1);
  node_of_slot_.resize(rods_);
  fiber_of_slot_.resize(rods_);
  for (std::size_t fiber = 0; fiber < chains.rod_length.size(); ++fiber) {
    for (std::size_t k = chains.begin_node(fiber); k + 1 < chains.end_node(fiber); ++k) {
      const std::int32_t slot = next[static_cast<std::size_t>(box_of_node[k])]++;
      slot_of_node_[k] = slot;
      node_of_slot_[static_cast<std::size_t>(slot)] = static_cast<std::int32_t>(k);
      fiber_of_slot_[static_cast<std::size_t>(slot)] = static_cast<std::int32_t>(fiber);
    }
  }
}

void RodNeighbours::refresh(const Chains& chains, std::size_t fiber) {
  for (std::size_t k = chains.begin_node(fiber); k + 1 < chains.end_node(fiber); ++k) {
    const Vec3 centre = 0.5 * (chains.position[k] + chains.position[k + 1]) - wrap_[k];
    const Vec3 half = 0.5 * (chains.position[k + 1] - chains.position[k]);
    RodRecord& record = records_[slot(k)];
    for (int i = 0; i < 3; ++i) {
      record.centre[i] = centre[i];
      record.half[i] = half[i];
    }
    record.radius = chains.swelling[fiber] * chains.radius[fiber];
    record.firmness = chains.firmness[fiber];
  }
}

void RodNeighbours::arrange(const Chains& chains, const NeighbourRange& range, const BoxGrid& grid) {
  records_.resize(rods_ + 1);
  records_[rods_] = RodRecord{};
  records_[rods_].centre[0] = nowhere;
  for (std::vector<double>* array : {&x_, &y_, &z_, &reach_}) array->assign(rods_ + lanes, 0.0);
  parallel_for(chains.fiber_count(), [&](std::ptrdiff_t f) {
    const auto fiber = static_cast<std::size_t>(f);
    refresh(chains, fiber);
    for (std::size_t k = chains.begin_node(fiber); k + 1 < chains.end_node(fiber); ++k) {
      const std::size_t at = slot(k);
      x_[at] = records_[at].centre[0];
      y_[at] = records_[at].centre[1];
      z_[at] = records_[at].centre[2];
      reach_[at] = 0.5 * chains.rod_length[fiber] + range.swelling * records_[at].radius;
    }
  });
  const int most = grid.farthest_image();
  shifts_.assign(static_cast<std::size_t>((2 * most + 1) * (2 * most + 1) * (2 * most + 1)), ImageShift{});
  IntVec3 image;
  for (image[2] = -most; image[2] <= most; ++image[2]) {
    for (image[1] = -most; image[1] <= most; ++image[1]) {
      for (image[0] = -most; image[0] <= most; ++image[0]) {
        const Vec3 shift = chains.cell.shift(image);
        for (int i = 0; i < 3; ++i)
          shifts_[static_cast<std::size_t>(grid.number_of_image(image))].shift[i] = shift[i];
      }
    }
  }
}

bool RodNeighbours::is_own_neighbour(const Chains& chains, const NeighbourRange& range, std::size_t subject,
                                     const ImagedRod& other) const {
  const auto fiber = static_cast<std::size_t>(fiber_of_slot_[subject]);
  if (fiber_of_slot_[other.slot] != fiber_of_slot_[subject]) return false;
  const std::int32_t own_node = node_of_slot_[subject], other_node = node_of_slot_[other.slot];
  const double* shift = shifts_[static_cast<std::size_t>(other.image)].shift;
  const Vec3 offset = wrap_[static_cast<std::size_t>(other_node)] - wrap_[static_cast<std::size_t>(own_node)];
  constexpr double same_place = 1e-3;  // images are many diameters apart
  if ((offset - Vec3(shift[0], shift[1], shift[2])).norm() > same_place) return false;
  const double along = (std::abs(own_node - other_node) - 1) * chains.rod_length[fiber];
  return along < 2 * (range.swelling * 2 * chains.radius[fiber] + range.reach);
}

void RodNeighbours::collect(const Chains& chains, const NeighbourRange& range, const BoxGrid& grid,
                            std::size_t subject, Candidates& candidates) const {
  const SearchKernel search = search_kernel();
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
        const auto number = static_cast<std::size_t>(grid.number(inside));
        const std::int32_t image_number = grid.number_of_image(image);
        const double* shift = shifts_[static_cast<std::size_t>(image_number)].shift;
        for (int i = 0; i < 3; ++i) rod.centre[i] = own.centre[i] - shift[i];
        const std::int32_t first = grid.first_slot[number];
        const std::int32_t last = grid.first_slot[number + static_cast<std::size_t>(run)];
        candidates.found.resize(static_cast<std::size_t>(last - first + lanes));
        const int found = search(centres, rod, first, last, candidates.found.data());
        for (int k = 0; k < found; ++k) {
          const std::int32_t slot = candidates.found[static_cast<std::size_t>(k)];
          if (is_own_neighbour(chains, range, subject, {static_cast<std::size_t>(slot), image_number}))
            continue;
          candidates.rod.push_back(slot);
          candidates.image.push_back(image_number);
        }
      }
    }
  }
}

void RodNeighbours::keep_near(const NeighbourRange& range, std::size_t subject, const Candidates& candidates,
                              ChunkLists& lists) const {
  const auto dummy = static_cast<std::int32_t>(rods_);
  std::int32_t kept = 0;
  for (std::size_t k = 0; k < candidates.rod.size(); ++k) {
    if (candidates.rod[k] == dummy) continue;
    const double touching =
        records_[subject].radius + records_[static_cast<std::size_t>(candidates.rod[k])].radius;
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

void RodNeighbours::list(const Chains& chains, const NeighbourRange& range, const BoxGrid& grid) {
  const auto chunks = (rod_count() + chunk_size - 1) / chunk_size;
  std::vector<ChunkLists> found(static_cast<std::size_t>(chunks));
  const DistanceKernel measure = distance_kernel();
  parallel_for(chunks, [&](std::ptrdiff_t c) {
    Candidates candidates;
    candidates.no_image = grid.number_of_image(IntVec3::Zero());
    const std::ptrdiff_t last = std::min(rod_count(), (c + 1) * chunk_size);
    for (std::ptrdiff_t s = c * chunk_size; s < last; ++s) {
      const auto subject = static_cast<std::size_t>(s);
      collect(chains, range, grid, subject, candidates);
      candidates.pad(static_cast<std::int32_t>(rods_));
      const RepulsionInput arrays = {records_.data(), nullptr, candidates.rod.data(), candidates.image.data(),
                                     shifts_.data()};
      measure(arrays, static_cast<int>(s), static_cast<int>(candidates.rod.size()),
              candidates.distance.data());
      keep_near(range, subject, candidates, found[static_cast<std::size_t>(c)]);
    }
  });
  join(found);
}

void RodNeighbours::join(const std::vector<ChunkLists>& found) {
  begin_.assign(rods_ + 1, 0);
  listed_ = 0;
  std::size_t slot = 0;
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
  arrange(chains, range, grid);
  list(chains, range, grid);
}

RepulsionInput RodNeighbours::input() const {
  return {records_.data(), begin_.data(), rod_.data(), image_.data(), shifts_.data()};
}

std::vector<NeighbourRod> RodNeighbours::of(std::size_t node) const {
  std::vector<NeighbourRod> near;
  const std::size_t subject = slot(node);
  for (std::int32_t at = begin_[subject]; at < begin_[subject + 1]; ++at) {
    const auto i = static_cast<std::size_t>(at);
    const auto other = static_cast<std::size_t>(rod_[i]);
    if (other == rods_) continue;
    const auto other_node = static_cast<std::size_t>(node_of_slot_[other]);
    const double* shift = shifts_[static_cast<std::size_t>(image_[i])].shift;
    near.push_back({static_cast<std::size_t>(fiber_of_slot_[other]), other_node,
                    Vec3(shift[0], shift[1], shift[2]) + wrap_[node] - wrap_[other_node]});
  }
  return near;
}

}  // namespace fiberfate
