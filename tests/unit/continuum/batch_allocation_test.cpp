// Counts allocations while laws evaluate and advance many points: none may depend on how many there are.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>
#include <vector>

#include "continuum/length_relaxation.hpp"
#include "continuum/orientation_law.hpp"
#include "continuum/orientation_registry.hpp"
#include "continuum/phelps_solver.hpp"
#include "continuum/unbreakable_length.hpp"
#include "microstructure/closure.hpp"

namespace {

std::atomic<long> allocations = 0;

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  const std::size_t whole = (size + alignment - 1) / alignment * alignment;
  if (void* memory = std::aligned_alloc(alignment, whole > 0 ? whole : alignment)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
// GCC sees through one of the pair only and takes them for a mismatch.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace fiberfate {
namespace {

template <class Work>
long allocations_in(const Work& work) {
  const long before = allocations;
  work();
  return allocations - before;
}

constexpr std::size_t few = 64, many = 4096;

/// Struct-of-arrays of points in a general flow, at an orientation of three different principal values.
struct Batch {
  std::vector<double> second, gradient, result;
  OrientationPoints points;
  explicit Batch(std::size_t count) : second(6 * count), gradient(9 * count), result(6 * count) {
    const double state[6] = {0.5, 0.3, 0.2, 0.02, 0.04, 0.1},
                 flow[9] = {0.1, 0.4, 2, -0.3, 0.2, 0.5, 0.1, 0, -0.3};
    points.count = count;
    for (std::size_t m = 0; m < 6; ++m) {
      std::fill_n(&second[m * count], count, state[m]);
      points.second[m] = &second[m * count];
      points.result[m] = &result[m * count];
    }
    for (std::size_t m = 0; m < 9; ++m) {
      std::fill_n(&gradient[m * count], count, flow[m]);
      points.gradient[m] = &gradient[m * count];
    }
  }
};

TEST(BatchAllocation, OrientationLawsAllocateNothing) {
  const Batch batch(many);
  for (const ClosureDescription& closure : closures()) {
    OrientationModel model = orientation_model_named("iard_rpr", closure.name);
    for (const auto& [name, value] : {std::pair("C_I", 0.02), std::pair("C_M", 0.5), std::pair("alpha", 0.9)})
      set_constant(model, name, value);
    const OrientationLaw law(model);
    EXPECT_EQ(allocations_in([&] { law.evaluate(batch.points); }), 0) << closure.name;
    if (closure.closure == closure_named("exact")) continue;  // the same loop, a hundred times slower
    EXPECT_EQ(allocations_in([&] { law.advance(batch.points, {0.1, 1e-6}); }), 0) << closure.name;
  }
}

TEST(BatchAllocation, LengthLawsAllocateNothingForAPoint) {
  const RelaxationLawOf relaxation(UnbreakableLength{0.06, 1.5e-3, 2e9, 19e-6});
  const PhelpsSolver solver({0.02, 3, 0.25, 73e9, 19e-6, 0, PhelpsBreakage::share}, {20, 15e-3});
  const auto counts_of = [&](std::size_t points) {
    const std::vector<double> rates(points, 100.0), viscosities(points, 300.0);
    std::vector<double> lengths(points, 15e-3), numbers(20 * points, 1.0);
    return std::pair(allocations_in([&] {
                       relax_lengths(relaxation, {rates, viscosities}, 0.1, lengths);
                     }),
                     allocations_in([&] {
                       solver.advance({rates, viscosities}, 0.1, numbers);
                     }));
  };
  EXPECT_EQ(counts_of(many).first, 0);
  // Phelps has a scratch for every thread.
  EXPECT_EQ(counts_of(many).second, counts_of(few).second);
}

}  // namespace
}  // namespace fiberfate
