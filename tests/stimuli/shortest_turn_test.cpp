#include "support/arithmetic/shortest_turn.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/arithmetic/random.h"

namespace seamline {
namespace {

using Eigen::Vector3d;

TEST(ShortestTurn, TakesOneDirectionToTheOtherAboutAnAxisAcrossBoth) {
  Random random(7);
  const auto direction = [&] { return Vector3d(random.normal(), random.normal(), random.normal()); };
  for (int i = 0; i < 1000; ++i) {
    const Vector3d from = direction(), to = i % 4 == 0 ? Vector3d(-2 * from) : direction();
    const Eigen::Quaterniond turn = shortest_turn(from, to);
    EXPECT_NEAR(turn.norm(), 1, 1e-9);
    EXPECT_LT((turn * from.normalized() - to.normalized()).norm(), 1e-7);
    EXPECT_NEAR(turn.vec().dot(from.normalized()), 0, 1e-7);
    EXPECT_GE(turn.w(), 0);
  }
}

}  // namespace
}  // namespace seamline
