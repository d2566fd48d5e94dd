// Depth as it is captured: sensors that look at the truth, and the meshes of what they deliver.
#include "renderer/depth/sensor/sensor_scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/depth/local_scene.h"
#include "renderer/depth/panorama_chain.h"
#include "renderer/depth/sensor/pixel_bound.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "renderer/depth/sensor/second_layer.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "tests/renderer/shapes.h"

namespace seamline::renderer {
namespace {

/// A room with a ball and a box in it, all before the camera.
Geometry furnished_truth() {
  return Geometry(std::vector<std::shared_ptr<const SurfaceMesh>>{
      test::box({-3, -1.5F, -6}, {3, 2.5F, 4}, 0.6F),
      test::box({-1.6F, -1.5F, -4.5F}, {-0.6F, 0.2F, -3.5F}, 0.4F),
      test::sphere({0.9F, -0.6F, -3.2F}, 0.7F, 96, 0.8F)});
}

/// Planes alone: what two triangles a wall stand for exactly.
Geometry empty_room() {
  return Geometry(
      std::vector<std::shared_ptr<const SurfaceMesh>>{test::box({-3, -1.5F, -6}, {3, 2.5F, 4}, 0.6F)});
}

PinholeSource pinhole(int width_px = 160, int height_px = 120, double field_of_view_deg = 60) {
  PinholeSource source;
  source.camera = sensors::pinhole_of_field_of_view(width_px, height_px, field_of_view_deg);
  return source;
}

DepthSettings settings_of(const DepthChain& chain, MeshDensity mesh = MeshDensity::adaptive) {
  DepthSettings settings{.width_px = 160, .mesh = mesh};
  settings.chain = chain;
  return settings;
}

DepthChain chain_of(const DepthSource& source) {
  DepthChain chain;
  chain.sources = {source};
  return chain;
}

SourceNoise generic_noise(double relative_sigma, double scale = 1) {
  return {.model = sensors::GenericNoise{.relative_sigma = relative_sigma}, .scale = scale};
}

bool same(const DepthMesh& a, const DepthMesh& b) {
  return a.vertices_m == b.vertices_m && a.triangles == b.triangles;
}

/// Share of rays from the camera, through a field of view, on which two scenes are no more than a relative
/// distance apart.
double share_alike(const Geometry& a, const Geometry& b, double field_of_view_deg, double relative) {
  const int side = 101;
  const double half = std::tan(field_of_view_deg / 2 * std::numbers::pi / 180);
  int alike = 0;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const Eigen::Vector3d direction(half * (2.0 * (x + 0.5) / side - 1),
                                      half * 0.7 * (2.0 * (y + 0.5) / side - 1), -1);
      const Ray ray{Eigen::Vector3f::Zero(), direction.normalized().cast<float>()};
      const auto hit_a = a.nearest(ray), hit_b = b.nearest(ray);
      if (hit_a && hit_b &&
          std::abs(hit_a->distance_m - hit_b->distance_m) <=
              relative * static_cast<double>(hit_a->distance_m))
        ++alike;
    }
  return static_cast<double>(alike) / (side * side);
}

TEST(SensorPose, ThePhotographsFrameIsOpenCVsInTheWorld) {
  Camera camera;
  const Eigen::Isometry3d world = world_from_photograph(camera);
  EXPECT_TRUE((world * Eigen::Vector3d(1, 2, 3)).isApprox(Eigen::Vector3d(1, -2, -3)));
  EXPECT_NEAR(world.linear().determinant(), 1, 1e-12);
  // The direction through any place of the picture is the camera's own.
  camera.width_px = 640, camera.height_px = 360;
  const sensors::PinholeCamera pinhole = pinhole_of(camera);
  for (const Eigen::Vector2d& place :
       {Eigen::Vector2d(0, 0), Eigen::Vector2d(640, 10), Eigen::Vector2d(320, 180)}) {
    const Eigen::Vector3d direction =
        (world.linear() * *sensors::direction_through(pinhole, place)).normalized();
    EXPECT_TRUE(direction.cast<float>().isApprox(
        camera.direction(static_cast<float>(place.x()), static_cast<float>(place.y())), 1e-5F));
  }
  EXPECT_EQ(pinhole_of(camera, pinhole.fx_px / 2).width_px, 320);
}

TEST(SensorPose, ErrorsAndDelaysDisplaceWhatIsBelieved) {
  const SensorPose pose{.position_m = {0.1, 0, 0}, .rotation_deg = {10, 20, 30}};
  DepthChain chain = chain_of(pinhole());
  EXPECT_TRUE(believed_photograph_from_sensor(pose, chain).isApprox(photograph_from_sensor(pose)));
  chain.calibration_error_deg = 3;
  chain.calibration_error_m = 0.02;
  const Eigen::Isometry3d off =
      photograph_from_sensor(pose).inverse() * believed_photograph_from_sensor(pose, chain);
  EXPECT_NEAR(off.translation().norm(), 0.02, 1e-12);
  EXPECT_NEAR(Eigen::AngleAxisd(off.linear()).angle() * 180 / std::numbers::pi, 3, 1e-9);
  chain = chain_of(pinhole());
  chain.delay_ms = 50;
  chain.velocity_m_s = {0, 0, 2};
  EXPECT_TRUE((believed_photograph_from_sensor(pose, chain).translation() -
               photograph_from_sensor(pose).translation())
                  .isApprox(Eigen::Vector3d(0, 0, 0.1), 1e-12));
}

TEST(SensorView, SeesWhatIsThere) {
  const Geometry truth(
      std::vector<std::shared_ptr<const SurfaceMesh>>{test::box({-50, -50, -4}, {50, 50, -3}, 0.4F)});
  const Eigen::Isometry3d world = world_from_photograph(Camera{});
  const sensors::PinholeCamera camera = pinhole(64, 48).camera;
  const sensors::SeenFrame seen =
      see_truth(truth, camera, world,
                {.surfaces = true, .sub_rays_across = 2, .projector_m = Eigen::Vector3d(0.1, 0, 0)}, 2);
  for (int row = 0; row < 48; ++row)
    for (int column = 0; column < 64; ++column) {
      const sensors::SeenPixel pixel = sensors::seen_pixel(seen, column, row);
      EXPECT_NEAR(pixel.planar_m, 3, 1e-5);
      EXPECT_NEAR(pixel.centre.cosine, pixel.planar_m / pixel.centre.radial_m, 1e-5);
      EXPECT_NEAR(pixel.centre.albedo, 0.4, 1e-6);
      EXPECT_TRUE(pixel.lit_by_projector);
      EXPECT_EQ(pixel.sub_rays.size(), 4U);
    }
}

TEST(SensorView, AProjectorHasAShadow) {
  // A plate before a wall: what the projector at the right cannot see lies left of the plate's left edge.
  const Geometry truth(std::vector<std::shared_ptr<const SurfaceMesh>>{
      test::box({-50, -50, -5}, {50, 50, -4}, 0.5F),
      test::box({-0.5F, -0.5F, -2.1F}, {0.5F, 0.5F, -2}, 0.5F)});
  const sensors::PinholeCamera camera = pinhole(200, 100, 80).camera;
  const sensors::SeenFrame seen = see_truth(truth, camera, world_from_photograph(Camera{}),
                                            {.surfaces = true, .projector_m = Eigen::Vector3d(0.3, 0, 0)}, 1);
  int dark = 0;
  for (int column = 0; column < 200; ++column) {
    const sensors::SeenPixel pixel = sensors::seen_pixel(seen, column, 50);
    const Eigen::Vector3d at_m = *sensors::direction_through(camera, {column + 0.5, 50.5}) * pixel.planar_m;
    const bool on_wall = pixel.planar_m > 3;
    // Lines from the projector over the plate's back edge (z = 2.1) and front edge to the wall at 4 m.
    const double left_m = 0.3 + (-0.5 - 0.3) * 4 / 2.0, right_m = 0.3 + (0.5 - 0.3) * 4 / 2.1;
    if (!on_wall || std::min(std::abs(at_m.x() - left_m), std::abs(at_m.x() - right_m)) < 0.1) continue;
    EXPECT_EQ(pixel.lit_by_projector, at_m.x() < left_m || at_m.x() > right_m) << column;
    dark += pixel.lit_by_projector ? 0 : 1;
  }
  EXPECT_GT(dark, 3);
}

TEST(PixelMesh, AdaptiveHoldsItsBoundAtEveryPixel) {
  const Geometry truth = furnished_truth();
  for (const sensors::LensDistortion& lens :
       {sensors::LensDistortion{}, sensors::LensDistortion{.k1 = -0.15, .k2 = 0.02, .p1 = 0.002}})
    for (const double tolerance : {1e-4, 1e-2}) {
      PinholeSource source = pinhole(161, 97, 70);
      source.camera.distortion = lens;
      source.camera.skew_px = 3;
      const Eigen::Isometry3d pose =
          world_from_photograph(Camera{}) * photograph_from_sensor({{0.3, 0.1, -0.2}, {5, -8, 12}});
      const PlacedFrame placed{
          sensors::true_depth(see_truth(truth, source.camera, pose, {}, 2), sensors::DepthConvention::planar),
          pose};
      const PixelGrid grid = pixel_grid(placed, 2);
      const DepthMesh mesh = build_pixel_mesh(grid, {.tolerance = tolerance, .threads = 2});
      const DepthMesh full = build_pixel_mesh(grid, {.density = MeshDensity::full, .threads = 2});
      EXPECT_LT(mesh.triangles.size(), full.triangles.size() / 2) << tolerance;
      EXPECT_LE(mesh.max_relative_error, tolerance);
      const Geometry local(std::vector<std::shared_ptr<const SurfaceMesh>>{
          test::part_of(mesh.vertices_m, mesh.triangles, 0.5F, "local scene")});
      int missed = 0;
      double largest = 0;
      for (int row = 1; row + 1 < 97; ++row)
        for (int column = 1; column + 1 < 161; ++column) {
          const Eigen::Vector3d seen_m = grid.seen_m({row, column});
          const auto hit = local.nearest({grid.eye_m.cast<float>(), seen_m.normalized().cast<float>()});
          if (!hit) {
            ++missed;
            continue;
          }
          largest = std::max(largest, std::abs(static_cast<double>(hit->distance_m) / seen_m.norm() - 1));
        }
      EXPECT_LE(missed, 150);  // of 15105: a ray exactly through a vertex may slip
      EXPECT_LE(largest, tolerance + 2e-5) << tolerance << " " << lens.k1;
    }
}

TEST(PixelMesh, PlanesNeedFewTriangles) {
  const Eigen::Isometry3d pose = world_from_photograph(Camera{});
  const Geometry wall(
      std::vector<std::shared_ptr<const SurfaceMesh>>{test::box({-50, -50, -4}, {50, 50, -3}, 0.4F)});
  const PlacedFrame placed{sensors::true_depth(see_truth(wall, pinhole(257, 129).camera, pose, {}, 2),
                                               sensors::DepthConvention::planar),
                           pose};
  EXPECT_LE(build_pixel_mesh(pixel_grid(placed, 2), {.tolerance = 1e-5, .threads = 1}).triangles.size(), 64U);
}

TEST(PixelMesh, HolesHaveNoTriangleAndEveryTriangleFacesTheEye) {
  sensors::DepthFrame frame;
  frame.camera = pinhole(40, 30).camera;
  frame.depth_m.assign(1200, 2.0F);
  for (const int hole : {0, 41, 500, 501, 540, 1199})
    frame.depth_m[static_cast<std::size_t>(hole)] = sensors::hole;
  const PlacedFrame placed{frame, Eigen::Isometry3d::Identity()};
  const PixelGrid grid = pixel_grid(placed, 1);
  for (const MeshDensity density : {MeshDensity::adaptive, MeshDensity::full}) {
    const DepthMesh mesh = build_pixel_mesh(grid, {.density = density, .threads = 1});
    std::vector<bool> used(mesh.vertices_m.size());
    for (const Triangle& t : mesh.triangles) {
      Eigen::Vector3f p[3];
      for (std::size_t i = 0; i < 3; ++i) {
        p[i] = mesh.vertices_m[t[i]];
        used[t[i]] = true;
        EXPECT_TRUE(p[i].allFinite());
      }
      EXPECT_LT((p[1] - p[0]).cross(p[2] - p[0]).dot(p[0]), 0.0F);
    }
    EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool u) { return u; }));
    const Geometry local(mesh, Rgb::Constant(0.5F), TreeQuality::for_light, CentreRays::by_tree);
    for (int row = 0; row < 30; ++row)
      for (int column = 0; column < 40; ++column) {
        if (grid.valid({row, column})) continue;
        const Eigen::Vector3d direction =
            *sensors::direction_through(frame.camera, {column + 0.5, row + 0.5});
        EXPECT_FALSE(local.nearest({Eigen::Vector3f::Zero(), direction.normalized().cast<float>()}))
            << row << " " << column;
      }
  }
  // Of nothing but holes nothing is left, and rays find nothing.
  std::fill(frame.depth_m.begin(), frame.depth_m.end(), sensors::hole);
  const DepthMesh none =
      build_pixel_mesh(pixel_grid({frame, Eigen::Isometry3d::Identity()}, 1), {.threads = 1});
  EXPECT_TRUE(none.triangles.empty());
  const Geometry nothing(none, Rgb::Constant(0.5F));
  EXPECT_FALSE(nothing.nearest({Eigen::Vector3f::Zero(), Eigen::Vector3f(0, 0, 1)}));
  EXPECT_FALSE(nothing.occluded({Eigen::Vector3f::Zero(), Eigen::Vector3f(0, 0, 1)}));
}

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
