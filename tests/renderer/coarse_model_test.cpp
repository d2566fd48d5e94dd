// Planes and boxes in place of a depth map.
#include "renderer/depth/coarse_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/depth/capture.h"
#include "renderer/depth/local_scene.h"
#include "sensors/noise/noise_stream.h"
#include "support/arithmetic/random.h"
#include "tests/renderer/shapes.h"

namespace seamline::renderer {
namespace {

using Parts = std::vector<std::shared_ptr<const SurfaceMesh>>;

const std::array<Eigen::Vector3f, 2> room_m = {Eigen::Vector3f(-3, -1.5F, -6), Eigen::Vector3f(3, 2.5F, 4)};

Geometry bare_room() {
  return Geometry(Parts{test::box(room_m[0], room_m[1], 0.6F)});
}

Eigen::Vector3d drawn_direction(Random& random) {
  return Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
}

DepthSettings boxes_of(int width_px) {
  DepthSettings settings{.width_px = width_px};
  settings.chain = DepthChain{};
  PanoramaSource source;
  source.reduction = Reduction::boxes;
  source.reduction_factor = 4;
  settings.chain->sources = {source};
  return settings;
}

/// Plane for plane, from the centre and from elsewhere: corners too, where a map of so few texels has sheets.
TEST(CoarseModel, AnEmptyRoomIsItsSixPlanes) {
  const Geometry truth = bare_room();
  const LocalScene local = make_local_scene(truth, boxes_of(64), {.threads = 2});
  const ModelRecord record = local.mesh.model.value();
  EXPECT_EQ(record.planes, 6);
  EXPECT_EQ(record.boxes, 0);
  EXPECT_EQ(record.explained_share, 1);
  EXPECT_LT(record.relative_residual, 1e-5);
  Random random(1);
  for (int i = 0; i < 5000; ++i) {
    const Eigen::Vector3f direction = drawn_direction(random).cast<float>();
    const Eigen::Vector3f from = i % 2 == 0 ? Eigen::Vector3f(0, 0, 0) : Eigen::Vector3f(1.5F, -1, -3);
    const auto hit = truth.nearest({from, direction}), found = local.geometry.nearest({from, direction});
    ASSERT_TRUE(hit && found);
    ASSERT_NEAR(found->distance_m, hit->distance_m, 1e-4F * hit->distance_m) << direction.transpose();
  }
}

/// The faces that are seen lie where they are, the others within what texels say, and the floor reaches under
/// it.
TEST(CoarseModel, ABoxOnAFloorBecomesABox) {
  const Eigen::Vector3f least(-1.6F, -1.5F, -4.5F), most(-0.6F, -0.5F, -3.2F);
  const Geometry truth(Parts{test::box(room_m[0], room_m[1], 0.6F), test::box(least, most, 0.4F)});
  for (const double yaw_texels : {0.0, 0.4}) {
    const DepthMap map = capture_depth(truth, 1024, yaw_texels, 2);
    const CoarseModel model = fit_coarse_model(map, yaw_texels, {});
    ASSERT_EQ(model.boxes.size(), 1U);
    EXPECT_EQ(model.rectangles.size(), 6U);
    const ModelBox& box = model.boxes.front();
    Eigen::Vector3d low = Eigen::Vector3d::Constant(1e9), high = -low;
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3d share(corner & 1, corner >> 1 & 1, corner >> 2);
      const Eigen::Vector3d at = box.axes * (box.least_m + share.cwiseProduct(box.most_m - box.least_m));
      low = low.cwiseMin(at), high = high.cwiseMax(at);
    }
    EXPECT_NEAR(high.x(), -0.6, 1e-3);
    EXPECT_NEAR(high.y(), -0.5, 1e-3);
    EXPECT_NEAR(high.z(), -3.2, 1e-3);
    EXPECT_NEAR(low.x(), -1.6, 0.06);
    EXPECT_NEAR(low.z(), -4.5, 0.25);  // behind the top, seen at a grazing angle
    EXPECT_NEAR(low.y(), -1.5, 0.08);
    EXPECT_LE(low.y(), -1.49);
    const ModelRecord record = judge(model, map, yaw_texels, 2);
    EXPECT_GT(record.explained_share, 0.99);
    const Geometry fitted(model_mesh(model), Rgb::Constant(0.5F));
    EXPECT_TRUE(fitted.occluded({{-1.1F, -1, -3.85F}, {-1, 0, 0}, 0.7F}));  // it has a side that is not seen
  }
}

/// The error of a fitted plane at the middle of its texels has the standard deviation s / sqrt(n).
TEST(CoarseModel, NoiseIsAveragedAway) {
  const Geometry truth = bare_room();
  constexpr double sigma = 0.005;
  DepthMap map = capture_depth(truth, 1024, 0, 2);
  for (std::size_t i = 0; i < map.distance_m.size(); ++i)
    map.distance_m[i] *=
        static_cast<float>(1 + sigma * sensors::NoiseStream({.seed = 3, .frame = 0}, i).normals(0).first);
  const PlaneFaces found = find_plane_faces(map, 0, {.tolerance = 3 * sigma});
  ASSERT_EQ(found.faces.size(), 6U);
  for (const PlaneFace& face : found.faces) {
    Eigen::Index axis = 0;
    face.inverse.cwiseAbs().maxCoeff(&axis);
    const double wall_m = static_cast<double>(room_m[face.inverse[axis] > 0 ? 1 : 0][axis]);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    std::int64_t texels = 0;
    for (std::size_t i = 0; i < found.directions.size(); ++i) {
      const Eigen::Vector3d& direction = found.directions[i];
      const Eigen::Vector3d at_m = wall_m / direction[axis] * direction;
      const bool on_wall = (at_m.array() >= room_m[0].cast<double>().array() - 1e-9).all() &&
                           (at_m.array() <= room_m[1].cast<double>().array() + 1e-9).all() &&
                           wall_m / direction[axis] > 0;
      if (on_wall) sum += at_m, ++texels;
    }
    const double error = face.inverse.dot(sum / static_cast<double>(texels)) - 1;
    EXPECT_LE(std::abs(error), 3 * sigma / std::sqrt(static_cast<double>(face.fitted_texels))) << axis;
    EXPECT_GT(face.fitted_texels, 10000);
  }
}

/// A ball is no plane: its texels follow the samples, and the model says how many.
TEST(CoarseModel, WhatNothingExplainsFollowsTheSamples) {
  const Geometry truth(
      Parts{test::box(room_m[0], room_m[1], 0.6F), test::sphere({0.9F, -0.2F, -2.5F}, 0.8F, 96, 0.8F)});
  const LocalScene local = make_local_scene(truth, boxes_of(512), {.threads = 2});
  const ModelRecord record = local.mesh.model.value();
  EXPECT_LT(record.explained_share, 0.995);
  EXPECT_GT(record.explained_share, 0.9);
  int alike = 0, all = 0;
  Random random(2);
  for (int i = 0; i < 4000; ++i) {
    const Ray ray{Eigen::Vector3f::Zero(), drawn_direction(random).cast<float>()};
    const auto hit = truth.nearest(ray), found = local.geometry.nearest(ray);
    ++all;
    alike += hit && found && std::abs(hit->distance_m - found->distance_m) < 0.011F * hit->distance_m ? 1 : 0;
  }
  EXPECT_GT(static_cast<double>(alike) / all, 0.985);
}

TEST(CoarseModel, TheSameForAnyNumberOfThreads) {
  const Geometry truth(
      Parts{test::box(room_m[0], room_m[1], 0.6F), test::box({0.5F, -1.5F, -3}, {1.5F, -0.7F, -2}, 0.8F)});
  DepthSettings settings = boxes_of(128);
  std::get<PanoramaSource>(settings.chain->sources.front()).noise =
      SourceNoise{.model = sensors::GenericNoise{.relative_sigma = 0.004}, .scale = 1};
  const LocalScene one = make_local_scene(truth, settings, {.threads = 1}),
                   three = make_local_scene(truth, settings, {.threads = 3});
  EXPECT_EQ(one.mesh.triangles, three.mesh.triangles);
  EXPECT_EQ(one.mesh.model->relative_residual, three.mesh.model->relative_residual);
  EXPECT_NEAR(one.mesh.model->relative_residual, 0.004, 4e-4);
}

/// Nothing to fit: a sky has no model and no mesh.
TEST(CoarseModel, HolesHaveNoModel) {
  const DepthMap sky{.width_px = 64, .height_px = 32, .distance_m = std::vector<float>(2048, sensors::hole)};
  const CoarseModel model = fit_coarse_model(sky, 0, {});
  EXPECT_TRUE(model.rectangles.empty() && model.boxes.empty());
  EXPECT_TRUE(model_mesh(model).triangles.empty());
  EXPECT_EQ(judge(model, sky, 0, 1).explained_share, 0);
}

}  // namespace
}  // namespace seamline::renderer
