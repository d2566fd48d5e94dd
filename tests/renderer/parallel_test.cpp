// Work shared out, and what the calling thread keeps of it.
#include "renderer/common/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <stdexcept>
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
