// Work shared out, and what the calling thread keeps of it.
#include "raytracer/common/parallel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

namespace seamline::renderer {
namespace {

/// Half of the smallest normal number: 0 where denormals are flushed.
float denormal() {
  volatile float smallest = std::numeric_limits<float>::min();
  return smallest * 0.5F;
}

TEST(ParallelFor, DoesEveryPieceOnceForAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 5}) {
    std::vector<std::atomic<int>> done(100);
    parallel_for(100, threads, [&](int i) { ++done[static_cast<std::size_t>(i)]; });
    for (const auto& times : done) EXPECT_EQ(times, 1);
  }
}

TEST(ParallelFor, TellsHowManyPiecesAreFinishedAndDoesThemAllBesideTheCaller) {
  const std::thread::id caller = std::this_thread::get_id();
  for (const int threads : {1, 3}) {
    std::atomic<int> done = 0;
    std::atomic<bool> beside = true;
    std::vector<int> told;
    const auto work = [&](int) {
      if (std::this_thread::get_id() == caller) beside = false;
      ++done;
    };
    parallel_for(50, threads, work, [&](int finished) { told.push_back(finished); });
    EXPECT_EQ(done, 50);
    EXPECT_TRUE(beside);
    ASSERT_FALSE(told.empty());
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_EQ(told.back(), 50);
    EXPECT_THROW(parallel_for(
                     8, threads, [](int) { throw std::runtime_error("of the work"); }, [](int) {}),
                 std::runtime_error);
  }
}

TEST(RunParallel, OneThreadIsTheCallersAndKeepsDenormals) {
  run_parallel(4, 1, [caller = std::this_thread::get_id()](int) {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_GT(denormal(), 0.0F);
  });
}

TEST(ParallelFor, FlushesDenormalsInTheWorkAndLeavesTheCallerAsItWas) {
  for (const int threads : {1, 2}) {
    ASSERT_GT(denormal(), 0.0F);
    std::atomic<bool> flushed = true;
    parallel_for(8, threads, [&](int) {
      if (denormal() > 0.0F) flushed = false;
    });
    EXPECT_TRUE(flushed);
    EXPECT_GT(denormal(), 0.0F);
    EXPECT_THROW(parallel_for(8, threads, [](int) { throw std::runtime_error("of the work"); }),
                 std::runtime_error);
    EXPECT_GT(denormal(), 0.0F);
  }
}

}  // namespace
}  // namespace seamline::renderer
