// Depth as it is captured: local scenes of sensors and panoramas.
#include "renderer/depth/sensor/sensor_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "renderer/depth/local_scene.h"
#include "renderer/depth/panorama_chain.h"
#include "renderer/depth/sensor/second_layer.h"
#include "tests/renderer/sensor_rooms.h"

namespace seamline::renderer {
namespace {

using sensor_rooms::chain_of;
using sensor_rooms::empty_room;
using sensor_rooms::furnished_truth;
using sensor_rooms::generic_noise;
using sensor_rooms::pinhole;
using sensor_rooms::same;
using sensor_rooms::settings_of;
using sensor_rooms::share_alike;

TEST(SensorScene, GenericNoiseOfScaleZeroIsTheSourceWithoutNoise) {
  const Geometry truth = furnished_truth();
  PinholeSource clean = pinhole(), zero = pinhole(), noisy = pinhole();
  clean.convention = sensors::DepthConvention::planar;
  zero.noise = generic_noise(0.02, 0);
  noisy.noise = generic_noise(0.02, 1);
  const DepthMesh mesh = sensor_mesh(truth, settings_of(chain_of(clean)), Camera{}, 1).mesh;
  EXPECT_TRUE(same(sensor_mesh(truth, settings_of(chain_of(zero)), Camera{}, 2).mesh, mesh));
  EXPECT_TRUE(same(sensor_mesh(truth, settings_of(*meaningful(chain_of(zero))), Camera{}, 2).mesh, mesh));
  EXPECT_FALSE(same(sensor_mesh(truth, settings_of(chain_of(noisy)), Camera{}, 2).mesh, mesh));
}

TEST(SensorScene, SameBytesForAnyNumberOfThreads) {
  const Geometry truth = furnished_truth();
  PinholeSource source = pinhole();
  source.noise = SourceNoise{sensors::TimeOfFlightNoise{}, 1};
  for (const sensors::RepairMethod& repair :
       {sensors::RepairMethod(sensors::NoRepair{}), sensors::RepairMethod(sensors::NearestRepair{}),
        sensors::RepairMethod(sensors::JointBilateralRepair{})})
    for (const Jumps jumps : {Jumps::stretch, Jumps::cut, Jumps::layer}) {
      DepthChain chain = chain_of(source);
      chain.repair = repair;
      chain.jumps = jumps;
      EXPECT_TRUE(same(sensor_mesh(truth, settings_of(chain), Camera{}, 1).mesh,
                       sensor_mesh(truth, settings_of(chain), Camera{}, 5).mesh));
    }
  PanoramaSource all_round;
  all_round.noise = generic_noise(0.01);
  DepthChain around = chain_of(all_round);
  around.repair = sensors::MedianRepair{};
  around.jumps = Jumps::cut;
  EXPECT_TRUE(same(panorama_mesh(truth, settings_of(around), 1).mesh,
                   panorama_mesh(truth, settings_of(around), 3).mesh));
}

TEST(SensorScene, NoiseLoosensTheBoundByItsSigma) {
  const Geometry truth = empty_room();
  PinholeSource source = pinhole();
  source.noise = generic_noise(0.005);
  DepthChain chain = chain_of(source);
  const std::size_t full =
      sensor_mesh(truth, settings_of(chain, MeshDensity::full), Camera{}, 2).mesh.triangles.size();
  chain.noise_sigmas = 0;
  EXPECT_GT(sensor_mesh(truth, settings_of(chain), Camera{}, 2).mesh.triangles.size(), full * 9 / 10);
  chain.noise_sigmas = 4;
  const DepthMesh loose = sensor_mesh(truth, settings_of(chain), Camera{}, 2).mesh;
  EXPECT_LT(loose.triangles.size(), full / 2);
  EXPECT_LE(loose.max_relative_error, 4 * 0.005 + 1e-12);
}

TEST(SensorScene, CutLeavesOutWhatJumpsAndLayerPutsTheTruthBehindIt) {
  // A plate 2 m before a wall.
  const Geometry truth(std::vector<std::shared_ptr<const SurfaceMesh>>{
      test::box({-50, -50, -5}, {50, 50, -4}, 0.5F),
      test::box({-0.5F, -0.5F, -2.1F}, {0.5F, 0.5F, -2}, 0.5F)});
  DepthChain chain = chain_of(pinhole(160, 120, 70));
  const auto local = [&](Jumps jumps) {
    chain.jumps = jumps;
    chain.layer_px = 8;
    return Geometry(sensor_mesh(truth, settings_of(chain), Camera{}, 2).mesh, Rgb::Constant(0.5F),
                    TreeQuality::for_light, CentreRays::by_tree);
  };
  const Geometry sheets = local(Jumps::stretch), gaps = local(Jumps::cut), layer = local(Jumps::layer);
  // From the left, 3 m away, parallel to the wall: sheets are in the way; gaps are not.
  const Ray across{{-3, 0, -3}, {1, 0, 0}};
  EXPECT_TRUE(sheets.occluded(across));
  EXPECT_FALSE(gaps.occluded(across));
  EXPECT_FALSE(layer.occluded(across));
  // Behind the plate's edge, where the wall is hidden from the sensor by 8 pixels and no more.
  const double pixel_m =
      4 / chain_of(pinhole(160, 120, 70)).sources.size() / camera_of(chain.sources.front())->fx_px;
  const auto wall_at = [&](const Geometry& geometry, double x_m) {
    return geometry.nearest({{static_cast<float>(x_m), 0, -3}, {0, 0, -1}}).has_value();
  };
  EXPECT_FALSE(wall_at(gaps, -1 + 4 * pixel_m));
  EXPECT_TRUE(wall_at(layer, -1 + 4 * pixel_m));
  EXPECT_FALSE(wall_at(layer, -1 + 12 * pixel_m));
  EXPECT_NEAR(layer.nearest({{static_cast<float>(-1 + 4 * pixel_m), 0, -3}, {0, 0, -1}})->distance_m, 1,
              1e-4);
}

TEST(SensorScene, SeveralSourcesAreUnited) {
  const Geometry truth = furnished_truth();
  PinholeSource left = pinhole(64, 48, 40), right = pinhole(96, 48, 40);
  left.pose.rotation_deg = {0, -20, 0};
  right.pose.rotation_deg = {0, 20, 0};
  DepthChain both;
  both.sources = {left, right};
  const MeasuredMesh one = sensor_mesh(truth, settings_of(chain_of(left)), Camera{}, 2),
                     other = sensor_mesh(truth, settings_of(chain_of(right)), Camera{}, 2),
                     united = sensor_mesh(truth, settings_of(both), Camera{}, 2);
  EXPECT_EQ(united.mesh.triangles.size(), one.mesh.triangles.size() + other.mesh.triangles.size());
  EXPECT_EQ(united.counts.measured, 64 * 48 + 96 * 48);
  EXPECT_FALSE(is_seen_from_its_place(both));
}

/// Both stand at the photograph's camera with 4 texels per degree on the axis: at least 97 % of the rays
/// differ by less than half a percent of their distance; the others pass along edges, where each map has its
/// own sheets.
TEST(SensorScene, APinholeThatCoversTheViewIsNearlyThePanorama) {
  const Geometry truth = furnished_truth();
  PinholeSource source = pinhole();
  source.camera = sensors::pinhole_of_field_of_view(2, 2, 90);
  source.camera.fx_px = source.camera.fy_px = 4 * 180 / std::numbers::pi;
  source.camera = with_field_of_view(source.camera, 80);
  const LocalScene seen = make_local_scene(truth, settings_of(chain_of(source)), {.threads = 2});
  const LocalScene around = make_local_scene(truth, {.width_px = 1440}, {.threads = 2});
  EXPECT_GE(share_alike(seen.geometry, around.geometry, 70, 0.005), 0.97);
  EXPECT_GE(share_alike(seen.geometry, truth, 70, 0.005), 0.97);
}

TEST(SensorScene, OutsideTheFieldOfViewNothingIsKnownAndNothingBlocks) {
  const LocalScene scene =
      make_local_scene(furnished_truth(), settings_of(chain_of(pinhole(80, 60, 40))), {.threads = 2});
  EXPECT_TRUE(scene.geometry.occluded({Eigen::Vector3f::Zero(), {0, 0, -1}}));
  for (const Eigen::Vector3f& aside :
       {Eigen::Vector3f(1, 0, 0), Eigen::Vector3f(0, 1, 0), Eigen::Vector3f(0, 0, 1)})
    EXPECT_FALSE(scene.geometry.occluded({Eigen::Vector3f::Zero(), aside}));
}

TEST(SensorScene, PixelsAreCounted) {
  const Geometry truth = furnished_truth();
  PinholeSource source = pinhole();
  source.noise = SourceNoise{
      sensors::GenericNoise{.relative_sigma = 0.01, .dropout_share = 0.1, .outliers = {.share = 0.05}}, 1};
  DepthChain chain = chain_of(source);
  const SensorCounts counts = sensor_mesh(truth, settings_of(chain), Camera{}, 2).counts;
  EXPECT_EQ(counts.measured + counts.holes + counts.outliers, 160 * 120);
  EXPECT_NEAR(static_cast<double>(counts.holes), 1920, 4 * std::sqrt(1920));
  EXPECT_NEAR(static_cast<double>(counts.outliers), 864, 4 * std::sqrt(864));
  EXPECT_EQ(counts.invented, 0);
  chain.repair = sensors::NearestRepair{};
  EXPECT_EQ(sensor_mesh(truth, settings_of(chain), Camera{}, 2).counts.invented, counts.holes);
}

TEST(SensorScene, ACalibrationErrorDisplacesTheMeshAsARigidThing) {
  const Geometry truth = furnished_truth();
  DepthChain chain = chain_of(pinhole());
  const DepthMesh exact = sensor_mesh(truth, settings_of(chain, MeshDensity::full), Camera{}, 2).mesh;
  chain.calibration_error_m = 0.1;
  const DepthMesh off = sensor_mesh(truth, settings_of(chain, MeshDensity::full), Camera{}, 2).mesh;
  ASSERT_EQ(off.vertices_m.size(), exact.vertices_m.size());
  for (std::size_t i = 0; i < off.vertices_m.size(); i += 97)
    EXPECT_NEAR((off.vertices_m[i] - exact.vertices_m[i]).norm(), 0.1, 1e-5);
}

/// Registered depth of a sensor beside the camera is the same scene seen from the camera: exactly on planes
/// by mesh; by points within half of a pixel's slope.
TEST(SensorScene, RegisteredDepthIsTheSceneSeenFromThePhotograph) {
  const Geometry truth = empty_room();
  PinholeSource source = pinhole(400, 300, 80);
  source.pose = {.position_m = {0.08, 0.02, 0.03}, .rotation_deg = {1, -2, 3}};
  Camera photograph;
  photograph.width_px = 96;
  photograph.height_px = 54;
  const double fov_deg =
      2 * std::atan(static_cast<double>(photograph.tan_half_horizontal)) * 180 / std::numbers::pi;
  for (const auto& [registration, relative] :
       {std::pair{Registration::mesh, 1e-3}, std::pair{Registration::points, 0.05}}) {
    DepthChain chain = chain_of(source);
    chain.registration = registration;
    EXPECT_TRUE(is_seen_from_its_place(chain));
    const LocalScene local =
        make_local_scene(truth, settings_of(chain), {.threads = 2, .photograph = photograph});
    EXPECT_GE(share_alike(local.geometry, truth, fov_deg * 0.75, relative), 0.97) << word(registration);
    EXPECT_EQ(local.mesh.sensor.value().measured, 400 * 300);
  }
}

/// Registered point by point into a picture of as many texels per degree, depth has holes where no point
/// lands; filled after it, the picture has none within the sensor's view (002, section 4).
TEST(SensorScene, ARepairAfterRegistrationFillsThePhotographsPicture) {
  const Geometry truth = furnished_truth();
  PinholeSource source = pinhole(200, 150, 70);
  source.pose.position_m = {0.1, 0.03, 0};
  DepthChain chain = chain_of(source);
  chain.registration = Registration::points;
  Camera photograph;
  photograph.width_px = 160;
  photograph.height_px = 90;
  const auto holes = [&] {
    const MeasuredMesh made = sensor_mesh(truth, settings_of(chain), photograph, 2);
    const std::vector<float>& depth_m = made.frames.at(0).frame.depth_m;
    const auto empty = std::count(depth_m.begin(), depth_m.end(), sensors::hole);
    EXPECT_EQ(made.counts.invented > 0, chain.repair_after);
    return empty;
  };
  EXPECT_GT(holes(), 100);
  chain.repair = sensors::NearestRepair{};
  EXPECT_GT(holes(), 100);  // the sensor's own picture has none to fill
  chain.repair_after = true;
  EXPECT_EQ(holes(), 0);
}

/// A photograph that shows where depth jumps keeps the jump; a blank one blurs it.
TEST(SensorScene, APhotographGuidesAJointBilateralRepair) {
  const Geometry truth = furnished_truth();
  Camera camera;
  camera.width_px = 120;
  camera.height_px = 90;
  PinholeSource source;
  source.camera = sensors::pinhole_of_field_of_view(
      120, 90, 2 * std::atan(static_cast<double>(camera.tan_half_horizontal)) * 180 / std::numbers::pi);
  source.noise = generic_noise(0.01);
  DepthChain chain = chain_of(source);
  chain.repair = sensors::JointBilateralRepair{};
  chain.guide = RepairGuide::photograph;
  Image blank(120, 90, 3), shows(120, 90, 3);
  for (int y = 0; y < 90; ++y)
    for (int x = 0; x < 120; ++x)
      if (const auto hit = truth.nearest(centre_ray(camera, x, y))) shows.set_rgb(x, y, hit->albedo);
  const auto wrong = [&](const SeenPhotograph& photograph, bool after) {
    chain.repair_after = after;
    chain.registration = after ? Registration::mesh : Registration::none;
    const MeasuredMesh made = sensor_mesh(truth, settings_of(chain), photograph, 2);
    int count = 0;
    for (int y = 0; y < 90; ++y)
      for (int x = 0; x < 120; ++x) {
        const Ray ray = centre_ray(camera, x, y);
        const auto hit = truth.nearest(ray);
        const float planar_m = hit ? -hit->distance_m * ray.direction.z() : 0;
        count += hit && std::abs(made.frames.at(0).frame.at(x, y) - planar_m) > 0.05F * planar_m ? 1 : 0;
      }
    return count;
  };
  for (const bool after : {false, true}) {
    EXPECT_LT(2 * wrong({camera, &shows}, after), wrong({camera, &blank}, after)) << after;
    EXPECT_GT(wrong({camera, &blank}, after), 50) << after;
  }
}

TEST(PanoramaChain, ReductionsAreWhatTheyAreCalled) {
  DepthMap finer{.width_px = 8, .height_px = 4, .distance_m = {}, .cleaned_texels = 0};
  for (int i = 0; i < 32; ++i) finer.distance_m.push_back(static_cast<float>(1 + i));
  finer.distance_m[1] = sensors::hole;
  EXPECT_EQ(reduced(finer, Reduction::minimum, 2, 1).distance_m[0], 1);
  EXPECT_EQ(reduced(finer, Reduction::maximum, 2, 1).distance_m[0], sensors::hole);
  EXPECT_EQ(reduced(finer, Reduction::median, 2, 1).distance_m[0], 9);
  EXPECT_EQ(reduced(finer, Reduction::maximum, 2, 1).at(3, 1), 32);
  EXPECT_EQ(reduced(finer, Reduction::minimum, 4, 1).width_px, 2);
}

/// Each texel's distance is one of the larger surface's under it, never of the gap between two.
TEST(PanoramaChain, AnEdgeAwareReductionKeepsToTheLargerSide) {
  const auto one = [](std::vector<float> distances_m) {
    const DepthMap finer{
        .width_px = 4, .height_px = 4, .distance_m = std::move(distances_m), .cleaned_texels = 0};
    return reduced(finer, Reduction::edge_aware, 4, 1).distance_m.at(0);
  };
  const float hole = sensors::hole;
  EXPECT_EQ(one({2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 5, 5, 5, 5, 5, 5}), 2);
  EXPECT_EQ(one({2, 2, 2, 2, 2, 2, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5}), 5);
  EXPECT_EQ(one({5, 5, 5, 5, 5, 5, 5, 5, 2, 2, 2, 2, 2, 2, 2, 2}), 2);  // of equal sides the near one
  EXPECT_EQ(one({9, 2, hole, hole, hole, hole, hole, hole, hole, hole, hole, hole, 2, 2, 2, 2}), hole);
  EXPECT_EQ(one({hole, hole, hole, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2}), 2);
  EXPECT_EQ(one(std::vector<float>(16, hole)), hole);
  // A slope without a jump: the lower median, as `median` has it.
  EXPECT_EQ(one({1.00F, 1.01F, 1.02F, 1.03F, 1.04F, 1.05F, 1.06F, 1.07F, 1.08F, 1.09F, 1.10F, 1.11F, 1.12F,
                 1.13F, 1.14F, 1.15F}),
            1.07F);
}

TEST(PanoramaChain, ACutMeshHasNoSheets) {
  const Geometry truth = furnished_truth();
  DepthChain chain;
  chain.jumps = Jumps::cut;
  chain.jump_ratio = 1.15;
  for (const int width_px : {256, 2048}) {
    DepthSettings settings = settings_of(chain);
    settings.width_px = width_px;
    const DepthMesh cut = panorama_mesh(truth, settings, 2).mesh;
    settings.chain->jumps = Jumps::stretch;
    const DepthMesh whole = panorama_mesh(truth, settings, 2).mesh;
    EXPECT_LT(cut.triangles.size(), whole.triangles.size());
    const Geometry local(cut, Rgb::Constant(0.5F)), sheets(whole, Rgb::Constant(0.5F));
    // What is left is the truth; behind the ball there is a gap instead of a sheet.
    EXPECT_GE(share_alike(local, truth, 80, 0.03), 0.9) << width_px;
    const Ray past{{2.6F, -0.6F, -4.8F}, Eigen::Vector3f(-1, 0, 0)};
    EXPECT_GT(local.nearest(past).has_value() ? local.nearest(past)->distance_m : 100.0F,
              sheets.nearest(past).has_value() ? sheets.nearest(past)->distance_m : 0.0F);
  }
}

}  // namespace
}  // namespace seamline::renderer
