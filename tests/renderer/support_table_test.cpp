// The farthest of some points, from a table, is the farthest of all.
#include "physics/support_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "support/arithmetic/random.h"

namespace seamline {
namespace {

TEST(SupportTable, FindsThePointThatAskingAllFinds) {
  Random random(11);
  const auto any = [&] {
    return Eigen::Vector3d(random.uniform() - 0.5, random.uniform() - 0.5, random.uniform() - 0.5);
  };
  std::vector<Eigen::Vector3d> points_m;
  for (int i = 0; i < 150; ++i) points_m.push_back(any().normalized());
  for (int i = 0; i < 8; ++i)  // a box, many of whose corners are equally far
    points_m.emplace_back((i & 1) != 0 ? 0.7 : -0.7, (i & 2) != 0 ? 0.7 : -0.7, (i & 4) != 0 ? 0.7 : -0.7);
  points_m.push_back(points_m.back());
  const renderer::SupportTable table(points_m);
  const auto check = [&](const Eigen::Vector3d& direction) {
    std::size_t best = 0;
    double best_m = -std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < points_m.size(); ++i) {
      const Eigen::Vector3d& p = points_m[i];
      const double reach_m = p.x() * direction.x() + p.y() * direction.y() + p.z() * direction.z();
      if (reach_m > best_m) best = i, best_m = reach_m;
    }
    EXPECT_EQ(table.farthest(direction), points_m[best]) << direction.transpose();
  };
  for (int i = 0; i < 20000; ++i) check(any());
  for (int x = -4; x <= 4; ++x)  // along axes and borders of cells
    for (int y = -4; y <= 4; ++y)
      for (int z = -4; z <= 4; ++z) check(0.25 * Eigen::Vector3d(x, y, z));
}

}  // namespace
}  // namespace seamline
