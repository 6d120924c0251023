// Tests that numbers of one kind cannot be taken for those of another, and count like integers.
#include "base/index.hpp"

#include <gtest/gtest.h>

#include <concepts>
#include <numeric>
#include <vector>

#include "base/threads.hpp"

namespace fiberfate {
namespace {

using Apple = IndexOf<struct AppleTag>;
using Tree = IndexOf<struct TreeTag>;
using AppleWeights = IndexedVector<Apple, double>;

template <class A, class B>
concept Comparable = requires(A a, B b) {
  a == b;
}
|| requires(A a, B b) {
  a < b;
};
template <class A, class B>
concept Subtractable = requires(A a, B b) {
  a - b;
};
template <class Range, class I>
concept Subscriptable = requires(Range range, I index) {
  range[index];
};

static_assert(sizeof(Apple) == sizeof(Index));
static_assert(std::constructible_from<Apple, int> && std::constructible_from<Apple, std::size_t>);
static_assert(!std::convertible_to<int, Apple> && !std::convertible_to<Apple, int>);
static_assert(!std::constructible_from<Apple, Tree> && !std::constructible_from<Apple, double>);
static_assert(Comparable<Apple, Apple> && !Comparable<Apple, Tree> && !Comparable<Apple, int>);
static_assert(Subtractable<Apple, Apple> && Subtractable<Apple, int> && !Subtractable<Apple, Tree>);
static_assert(Subscriptable<AppleWeights, Apple> && Subscriptable<IndexedSpan<Apple, double>, Apple>);
static_assert(!Subscriptable<AppleWeights, Tree> && !Subscriptable<IndexedSpan<Apple, double>, Tree>);
static_assert(!Subscriptable<AppleWeights, int> && !Subscriptable<AppleWeights, std::size_t>);
static_assert(!std::constructible_from<IndexedVector<Tree, double>, AppleWeights>);
static_assert(!std::convertible_to<AppleWeights&, IndexedSpan<Tree, double>>);
static_assert(!std::convertible_to<std::vector<double>&, IndexedSpan<Apple, double>>);
static_assert(std::convertible_to<const AppleWeights&, IndexedSpan<Apple, const double>>);
static_assert(!std::convertible_to<const AppleWeights&, IndexedSpan<Apple, double>>);

TEST(IndexOf, CountsAndMeasuresDistances) {
  Apple apple(3);
  EXPECT_EQ((apple++).value(), 3);
  EXPECT_EQ((++apple).value(), 5);
  EXPECT_EQ((apple - 2).value(), 3);
  EXPECT_EQ((apple + 2) - apple, 2);
  EXPECT_LT(apple, Apple(6));
  EXPECT_EQ(Apple(), Apple(0));
}

TEST(IndexRange, RunsFromItsBeginUpToItsEnd) {
  std::vector<Index> visited;
  for (const Apple apple : IndexRange<Apple>(Apple(2), Apple(5))) visited.push_back(apple.value());
  EXPECT_EQ(visited, (std::vector<Index>{2, 3, 4}));
  for (const Apple apple : first_indices<Apple>(0)) FAIL() << apple.value();
}

TEST(IndexedVector, HoldsAnEntryForEachNumber) {
  AppleWeights weights(3, 0.5);
  for (const Apple apple : weights.indices()) weights[apple] += apple.value();
  EXPECT_EQ(weights, (std::vector<double>{0.5, 1.5, 2.5}));
  const IndexedSpan<Apple, const double> seen = weights;
  EXPECT_EQ(&seen[Apple(1)], &weights[Apple(1)]);
  EXPECT_EQ(std::accumulate(seen.begin(), seen.end(), 0.0), 4.5);
}

TEST(Numbers, AreThePlainIntegersInPlace) {
  std::vector<Apple> apples = {Apple(7), Apple(5)};
  EXPECT_EQ(numbers(apples)[1], 5);
  numbers(apples)[1] = 6;
  EXPECT_EQ(apples[1], Apple(6));
}

// Every thing of a kind once, on any number of threads, whether they weigh alike or own others.
TEST(ParallelFor, VisitsTheThingsOfAKind) {
  const int before = thread_count();
  const IndexedVector<Tree, Apple> first_apple = {Apple(0), Apple(4), Apple(4), Apple(5), Apple(9)};
  for (const int threads : {1, 3, 8}) {
    use_threads(threads);
    IndexedVector<Tree, int> visits(first_apple.size() - 1, 0);
    parallel_for(visits.indices(), [&](Tree tree) { ++visits[tree]; });
    parallel_for_weighted(first_apple, [&](Tree tree) { ++visits[tree]; });
    EXPECT_EQ(visits, std::vector<int>(visits.size(), 2)) << threads << " threads";
  }
  use_threads(before);
}

}  // namespace
}  // namespace fiberfate
