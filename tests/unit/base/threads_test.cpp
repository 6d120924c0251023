// Checks how work is shared among threads.
#include "base/threads.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <stdexcept>
#include <string>
#include <vector>

namespace fiberfate {
namespace {

TEST(ShareBegin, CutsItemsIntoSharesOfEqualWeight) {
  const std::vector<Index> running = {0, 4, 4, 5, 6, 7, 8, 12};
  EXPECT_EQ(share_begin(running, 0, 3), 0);
  EXPECT_EQ(share_begin(running, 1, 3), 1);
  EXPECT_EQ(share_begin(running, 2, 3), 6);
  EXPECT_EQ(share_begin(running, 3, 3), 7);
}

TEST(ParallelForWeighted, VisitsEveryItemOnceWhateverTheWeights) {
  const int before = thread_count();
  for (const int threads : {1, 2, 3, 8}) {
    use_threads(threads);
    for (const std::vector<Index>& running :
         {std::vector<Index>{0}, {0, 3}, {0, 0, 0}, {0, 0, 5, 5, 6}, {0, 9, 9, 10, 11, 12}}) {
      std::vector<int> visits(running.size() - 1, 0);
      parallel_for_weighted(running, [&](std::ptrdiff_t i) { ++visits[std::size_t(i)]; });
      EXPECT_EQ(visits, std::vector<int>(running.size() - 1, 1)) << threads << " threads";
    }
  }
  use_threads(before);
}

TEST(PerThread, GivesEveryThreadLinesOfItsOwn) {
  const int before = thread_count();
  use_threads(3);
  PerThread<int> scratch;
  scratch.fit();
  std::vector<const int*> places(3);
  parallel_for(3, [&](std::ptrdiff_t i) { places[std::size_t(i)] = &scratch.mine(); });
  use_threads(before);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_GE(std::abs(places[i] - places[(i + 1) % 3]) * std::ptrdiff_t{sizeof(int)}, 128) << i;
}

// An exception that leaves a thread ends the program; of several the first item's is thrown, with any number
// of threads.
TEST(ParallelFor, CarriesTheFirstFailureOut) {
  const int before = thread_count();
  const auto fail_from_five_on = [](std::ptrdiff_t i) {
    if (i >= 5) throw std::out_of_range(std::to_string(i));
  };
  for (const int threads : {1, 2, 3, 8}) {
    use_threads(threads);
    const auto message_of = [](const auto& loop) {
      try {
        loop();
      } catch (const std::out_of_range& error) {
        return std::string(error.what());
      }
      return std::string("nothing");
    };
    EXPECT_EQ(message_of([&] { parallel_for(20, fail_from_five_on); }), "5") << threads;
    const std::vector<Index> running = {0, 1, 2, 3, 4, 5, 6, 7, 100};
    EXPECT_EQ(message_of([&] { parallel_for_weighted(running, fail_from_five_on); }), "5") << threads;
    EXPECT_EQ(message_of([&] { parallel_for(5, fail_from_five_on); }), "nothing") << threads;
  }
  use_threads(before);
}

TEST(SuitableThreads, AreAsManyAsTheWorkKeepsBusyWhileTheyLast) {
  const int before = thread_count();
  use_threads(4);
  {
    const SuitableThreads few(20, 1000);
    EXPECT_EQ(thread_count(), 1);
    const SuitableThreads none_more(100000, 1000);
    EXPECT_EQ(thread_count(), 1);
  }
  {
    const SuitableThreads some(2500, 1000);
    EXPECT_EQ(thread_count(), 3);
  }
  {
    const SuitableThreads all(1000000, 1000);
    EXPECT_EQ(thread_count(), 4);
  }
  EXPECT_EQ(thread_count(), 4);
  use_threads(before);
}

}  // namespace
}  // namespace fiberfate
