// Rays that miss the boxes around virtual objects miss the objects.
#include "raytracer/tracing/bounding_boxes.h"

#include <gtest/gtest.h>

#include "shapes.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

using Parts = std::vector<std::shared_ptr<const SurfaceMesh>>;

Parts three_objects() {
  return {test::sphere({2, 0, -3}, 0.7F, 16, 0.5F, 1), test::box({-3, -1, -4}, {-2, 1, -3}, 0.5F, 2),
          test::sphere({0, 4, 5}, 1.2F, 12, 0.5F, 3)};
}

Ray random_ray(Random& random) {
  const auto within = [&](double most) { return static_cast<float>((2 * random.uniform() - 1) * most); };
  Ray ray{{within(6), within(6), within(6)}, Eigen::Vector3f(within(1), within(1), within(1)).normalized()};
  if (random.uniform() < 0.3) ray.direction = Eigen::Vector3f::Unit(static_cast<int>(random.uniform() * 3));
  if (random.uniform() < 0.2) ray.direction = -ray.direction;
  // Along a face of the box, and from its very plane.
  if (random.uniform() < 0.2) ray.origin_m.x() = -2.0F;
  if (random.uniform() < 0.3) ray.far_m = static_cast<float>(5 * random.uniform());
  return ray;
}

TEST(BoundingBoxes, AnswersAreThoseWithoutThem) {
  Parts parts = three_objects();
  const Geometry with_boxes(parts);
  // A speck of the same object at the camera: nothing is told by boxes any more.
  parts.push_back(test::sphere({0, 0, 0}, 1e-6F, 6, 0.5F, 2));
  const Geometry without(parts);
  const BoundingBoxes boxes(three_objects());
  EXPECT_TRUE(BoundingBoxes(parts).may_meet(Ray{{50, 50, 50}, {0, 1, 0}}));
  Random random(3);
  int left_out = 0;
  for (int i = 0; i < 20000; ++i) {
    const Ray ray = random_ray(random);
    const auto found = with_boxes.nearest(ray), wanted = without.nearest(ray);
    ASSERT_EQ(found.has_value(), wanted.has_value()) << i;
    ASSERT_EQ(with_boxes.occluded(ray), without.occluded(ray)) << i;
    if (found) {
      ASSERT_EQ(found->distance_m, wanted->distance_m) << i;
      ASSERT_TRUE(boxes.may_meet(ray)) << i;
    }
    left_out += boxes.may_meet(ray) ? 0 : 1;
  }
  EXPECT_GT(left_out, 10000);
}

TEST(BoundingBoxes, OfManyRaysOneIsEnough) {
  const BoundingBoxes boxes(three_objects());
  const Ray away{{0, 0, 0}, {0, 1, 0}}, towards{{0, 0, 0}, Eigen::Vector3f(2, 0, -3).normalized()};
  EXPECT_FALSE(boxes.may_meet(std::vector<Ray>{away, away}));
  EXPECT_TRUE(boxes.may_meet(std::vector<Ray>{away, towards}));
  EXPECT_TRUE(BoundingBoxes().may_meet(away));
}

}  // namespace
}  // namespace seamline::renderer
