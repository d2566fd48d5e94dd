// Search trees that frames of a clip share: rays find what they find without.
#include "raytracer/tracing/kept_trees.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

#include "shapes.h"

namespace seamline::renderer {
namespace {

using Bodies = std::vector<std::shared_ptr<const SurfaceMesh>>;

/// A background of two meshes around the origin, and two bodies, the second in front of it.
Bodies four_meshes() {
  return {test::sphere({0, 0, 0}, 9.0F, 48, 0.5F), test::sphere({3, 0, 0}, 1.0F, 24, 0.4F),
          test::sphere({-3, 0, 0}, 1.5F, 32, 0.3F, 1), test::sphere({0, 0, -3}, 1.0F, 32, 0.2F, 2)};
}

std::vector<Ray> rays_from_everywhere(std::size_t count) {
  std::mt19937 random(3);
  std::normal_distribution<float> normal;
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < count; ++i)
    rays.push_back({Eigen::Vector3f(normal(random), normal(random), normal(random)) * 2.0F,
                    Eigen::Vector3f(normal(random), normal(random), normal(random)).normalized(),
                    i % 5 == 0 ? 2.0F : std::numeric_limits<float>::infinity()});
  return rays;
}

void expect_same(const std::optional<SurfacePoint>& a, const std::optional<SurfacePoint>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  if (!a) return;
  EXPECT_EQ(a->distance_m, b->distance_m);
  EXPECT_EQ(a->object_index, b->object_index);
  EXPECT_EQ(a->normal, b->normal);
  EXPECT_TRUE((a->albedo == b->albedo).all());
}

}  // namespace

TEST(KeptTrees, AGeometryOfManyTreesFindsWhatOneTreeFinds) {
  const Bodies meshes = four_meshes();
  const std::vector<Ray> rays = rays_from_everywhere(20'001);
  for (const Edges edges : {Edges::tight, Edges::loose}) {
    const Geometry whole(meshes, edges);
    const KeptTrees kept;
    const Geometry parts(meshes, edges);
    std::vector<std::optional<SurfacePoint>> found(rays.size()), wanted(rays.size());
    std::vector<std::uint8_t> blocked(rays.size()), wanted_blocked(rays.size());
    std::vector<float> far_m(rays.size()), wanted_far_m(rays.size());
    for (const Coherence coherence : {Coherence::together, Coherence::scattered}) {
      whole.nearest(rays, wanted, coherence);
      parts.nearest(rays, found, coherence);
      whole.occluded(rays, wanted_blocked, coherence);
      parts.occluded(rays, blocked, coherence);
      EXPECT_EQ(blocked, wanted_blocked);
      for (std::size_t i = 0; i < rays.size(); ++i) expect_same(found[i], wanted[i]);
    }
    whole.distances(rays, wanted_far_m);
    parts.distances(rays, far_m);
    EXPECT_EQ(far_m, wanted_far_m);
    for (std::size_t i = 0; i < 1000; ++i) {
      expect_same(parts.nearest(rays[i]), whole.nearest(rays[i]));
      EXPECT_EQ(parts.occluded(rays[i]), whole.occluded(rays[i]));
    }
  }
}

TEST(KeptTrees, WhatStandsIsBuiltOnceAndWhatMovedAnew) {
  KeptTrees kept;
  Bodies meshes = four_meshes();
  const auto ask = [&] { const Geometry all(meshes); };
  ask();
  EXPECT_EQ(kept.counts().built, 3) << "the background is one body";
  ask();
  EXPECT_EQ(kept.counts().built, 6) << "a body is held from its second use on";
  ask();
  EXPECT_EQ(kept.counts().built, 6);
  meshes[3] = test::sphere({0.5F, 0, -3}, 1.0F, 32, 0.2F, 2);
  ask();
  EXPECT_EQ(kept.counts().built, 7);
  EXPECT_EQ(kept.counts().asked, 12);
  const Geometry again(meshes, Edges::loose);
  EXPECT_EQ(kept.counts().built, 10) << "trees of loose edges are others";
  const Geometry at_once(Bodies{meshes[2]}, Edges::loose);
  EXPECT_EQ(kept.counts().built, 10) << "somebody holds that tree";
}

TEST(KeptTrees, NobodyFindsTheTreeOfAMeshThatIsGone) {
  const KeptTrees kept;
  for (int i = 0; i < 50; ++i) {
    const float x_m = 2.0F + 0.1F * static_cast<float>(i);
    const Bodies ball = {test::sphere({x_m, 0, 0}, 0.5F, 16, 0.5F, 1)};
    for (int use = 0; use < 3; ++use) {
      const auto hit = Geometry(ball).nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f::UnitX()});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(hit->distance_m, x_m - 0.5F, 0.02F);
    }
  }
}

}  // namespace seamline::renderer
