// Checks the fast search for contacts against all pairs of rods and images, one at a time.
#include "dynamics/contact_search.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>

#include "base/random.hpp"
#include "fibers/closest_points.hpp"

namespace fiberfate {
namespace {

constexpr double range = 2.5e-5;
using Key = std::array<int, 5>;  // first rod, second rod, image of the second

double number(std::uint32_t fiber, std::uint32_t node, int component) {
  return uniform4(7, RandomStream::position, {fiber, node, 0})[std::size_t(component)];
}

/// Forty bent fibers of two kinds, longer than their tilted cell; some ends have just broken apart.
FiberState crowded_cell() {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}, {5e-6, 230e9, 1800}};
  state.cell.lattice << 3e-4, 1e-4, 0, 0, 3e-4, 0, 0, 0, 3e-4;
  for (std::uint32_t f = 0; f < 40; ++f) {
    std::vector<Vec3> nodes = {state.cell.lattice * Vec3(number(f, 0, 0), number(f, 0, 1), number(f, 0, 2))};
    Vec3 axis = Vec3(number(f, 1, 0), number(f, 1, 1), number(f, 1, 2)) - Vec3::Constant(0.5);
    for (std::uint32_t k = 2; k < 10; ++k) {
      axis = axis.normalized() +
             0.5 * (Vec3(number(f, k, 0), number(f, k, 1), number(f, k, 2)) - Vec3::Constant(0.5));
      nodes.push_back(nodes.back() + 6e-5 * axis.normalized());
    }
    append_fiber(state, {nodes, std::uint16_t(f % 2)});
  }
  const std::array<NodeIndex, 3> broken = {NodeIndex(4), NodeIndex(13), NodeIndex(40)};
  split_fibers(state, broken);
  return state;
}

struct Found {
  double s, t, distance;
  Vec3 normal;
  std::array<int, 2> materials;
};

std::map<Key, Found> search(const FiberState& state) {
  NeighbourList list;
  list.build(state, range, IndexedVector<RodIndex, double>(state.rod_length.size(), 1e-5));
  EXPECT_TRUE(list.look_ahead(state, Flow{}, 0));
  ContactSearch fast;
  fast.find(state, list, range);
  std::map<Key, Found> found;
  for (const ContactChunk& chunk : fast.contacts()) {
    for (int i = 0; i < chunk.count; ++i) {
      const Contact one = chunk.at(i);
      const IntVec3 image = unpack_image(one.image);
      const Key key = {one.first.value(), one.second.value(), image[0], image[1], image[2]};
      EXPECT_EQ(found.count(key), 0u) << "twice: rods " << key[0] << " and " << key[1];
      found[key] = {one.s, one.t, one.distance, one.normal, {one.first_material, one.second_material}};
    }
  }
  return found;
}

/// Looks at every pair of rods in every image, by the rules of ContactSearch.
class AllPairs {
 public:
  explicit AllPairs(const FiberState& state) : state_(state) {
    for (const FiberIndex f : state.fibers()) {
      for (const RodIndex k : state.rods(f)) rods_.push_back({k, f});
    }
  }

  std::map<Key, Found> contacts() {
    for (const Rod& first : rods_) {
      for (const Rod& second : rods_) {
        for (int image = 0; image < 11 * 11 * 11; ++image)
          look_at(first, second, {image % 11 - 5, image / 11 % 11 - 5, image / 121 - 5});
      }
    }
    return found_;
  }
  int left_to_neighbours = 0;

 private:
  struct Rod {
    RodIndex index;
    FiberIndex fiber;
  };

  void look_at(const Rod& first, const Rod& second, const IntVec3& image) {
    const bool is_itself = image.isZero();
    if (second.index < first.index) return;
    if (second.index == first.index && !(image[0] > 0 || (image[0] == 0 && image[1] > 0) ||
                                         (image[0] == 0 && image[1] == 0 && image[2] > 0)))
      return;
    const Vec3 shift = state_.cell.shift(image);
    if ((begin_of(first) - begin_of(second) - shift).norm() > 2e-4) return;
    if (is_itself && is_own_neighbour(first, second)) return;
    const bool broke_off = is_itself && second.fiber == first.fiber + 1 && second.index == first.index + 2 &&
                           state_.touches_previous[second.fiber] != 0;
    if (broke_off) return;
    const ClosestPoints near =
        closest_points(state_.segment(first.index), shifted(state_.segment(second.index), shift));
    if (near.distance >= range) return;
    if (belongs_to_neighbour(first, near.s, -near.separation) ||
        belongs_to_neighbour(second, near.t, near.separation)) {
      ++left_to_neighbours;
      return;
    }
    found_[{first.index.value(), second.index.value(), image[0], image[1], image[2]}] = {
        near.s,
        near.t,
        near.distance,
        near.separation / near.distance,
        {state_.material_id[first.fiber], state_.material_id[second.fiber]}};
  }

  [[nodiscard]] bool is_own_neighbour(const Rod& first, const Rod& second) const {
    if (first.fiber != second.fiber) return false;
    double between = 0;
    for (RodIndex k = first.index + 1; k < second.index; ++k) between += state_.rod_length[k];
    return between < range;
  }

  [[nodiscard]] bool belongs_to_neighbour(const Rod& rod, double place, const Vec3& other) const {
    if (place <= 0) return first_end(rod.index) != state_.begin_node(rod.fiber);
    if (place < 1 || second_end(rod.index) == state_.last_node(rod.fiber)) return false;
    return state_.axis(rod.index + 1).dot(other) > 0;
  }

  [[nodiscard]] const Vec3& begin_of(const Rod& rod) const { return state_.position[first_end(rod.index)]; }

  const FiberState& state_;
  std::vector<Rod> rods_;
  std::map<Key, Found> found_;
};

TEST(ContactSearch, FindsWhatAllPairsOfRodsAndImagesHave) {
  const FiberState state = crowded_cell();
  AllPairs pairs(state);
  const std::map<Key, Found> expected = pairs.contacts();
  const std::map<Key, Found> found = search(state);
  ASSERT_GT(expected.size(), 200u);
  ASSERT_GT(pairs.left_to_neighbours, 50);
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [key, want] : expected) {
    const auto have = found.find(key);
    ASSERT_NE(have, found.end()) << "missed: rods " << key[0] << " and " << key[1];
    EXPECT_NEAR(have->second.s, want.s, 1e-9);
    EXPECT_NEAR(have->second.t, want.t, 1e-9);
    EXPECT_NEAR(have->second.distance, want.distance, 1e-17);
    EXPECT_LT((have->second.normal - want.normal).norm(), 1e-9);
    EXPECT_EQ(have->second.materials, want.materials);
  }
}

TEST(ContactSearch, PushesAxesThatCrossApartAcrossBoth) {
  FiberState state;
  state.materials = {{9.5e-6, 73e9, 2550}};
  state.cell = rectangular_cell({1e-3, 1e-3, 1e-3});
  // Powers of two: they cross without rounding.
  const Vec3 centre = Vec3::Constant(std::ldexp(1.0, -11));
  const double half = std::ldexp(1.0, -13);
  append_fiber(state, {std::array<Vec3, 2>{centre - half * Vec3::UnitX(), centre + half * Vec3::UnitX()}, 0});
  append_fiber(state, {std::array<Vec3, 2>{centre - half * Vec3::UnitY(), centre + half * Vec3::UnitY()}, 0});
  const std::map<Key, Found> found = search(state);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.begin()->second.distance, 0);
  EXPECT_EQ(std::abs(found.begin()->second.normal.z()), 1);
}

/// A straight fiber 171 times as long as its cell, in 40 rods, that runs beside its image (150, 47, 27).
FiberState fiber_of_many_cells() {
  FiberState state;
  state.materials = {{1e-6, 73e9, 2550}};
  state.cell = rectangular_cell(Vec3::Constant(3e-4));
  const Vec3 towards_image = state.cell.shift({150, 47, 27}) + Vec3(0, 1e-5, 0);
  const Vec3 step = 171 * 3e-4 / 40 * towards_image.normalized();
  std::vector<Vec3> nodes;
  for (int k = 0; k <= 40; ++k) nodes.emplace_back((k - 20) * step);
  append_fiber(state, {nodes, 0});
  return state;
}

// Images used to wrap at 128: contacts were then measured where nothing is.
TEST(ContactSearch, TellsFarImagesApart) {
  const FiberState state = fiber_of_many_cells();
  int farthest = 0;
  for (const auto& [key, found] : search(state)) {
    const RodIndex first(key[0]), second(key[1]);
    const IntVec3 image(key[2], key[3], key[4]);
    const Vec3 shift = state.cell.shift(image);
    const ClosestPoints exact = closest_points(state.segment(first), shifted(state.segment(second), shift));
    EXPECT_NEAR(found.distance, exact.distance, 1e-12);
    EXPECT_LT(exact.distance, range);
    farthest = std::max(farthest, image.cwiseAbs().maxCoeff());
  }
  EXPECT_GT(farthest, 127);
}

}  // namespace
}  // namespace fiberfate
