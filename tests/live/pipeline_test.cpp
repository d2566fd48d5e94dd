// The live pipeline against slow computation by hand, and against traced light.
#include "live/frame/pipeline.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "live/frame/codes.h"
#include "live/frame/pixel_rays.h"
#include "registration/points/register_by_points.h"
#include "sensors/frame/depth_test.h"
#include "small_world.h"

namespace seamline::live {
namespace {

constexpr PathKind still = PathKind::still;

LoadedRecording room_recording(double environment, int frames = 1, PathKind kind = still) {
  return test::recorded(test::room(), test::exact_rig(), test::definition_of(environment),
                        {.kind = kind, .distance_m = 0.2}, frames, 16);
}

LivePipeline pipeline_of(const LoadedRecording& recording, const std::vector<renderer::FileMesh>& objects,
                         PipelineSettings settings = {}) {
  return {recording, test::scene_with(recording, objects), Eigen::Vector3d::Zero(), settings};
}

PipelineSettings all_pixels(int threads = 2) {
  PipelineSettings settings;
  settings.local_mesh.most_triangles = 0;
  settings.shadow_map_px = 1024;
  settings.depth_bias = 0.002;
  settings.surface_reach_px = 1;
  settings.threads = threads;
  return settings;
}

TEST(PointRegistration, IsRegistrationByPointsBitForBit) {
  for (const auto convention : {sensors::DepthConvention::planar, sensors::DepthConvention::radial}) {
    sensors::Rig rig = test::exact_rig(120, 90);
    rig.depth.skew_px = 0.7;
    rig.depth.distortion = {-0.1, 0.02, 0.001, -0.002, 0.003};
    rig.colour = sensors::pinhole_of_field_of_view(200, 150, 50);
    rig.colour_from_depth = sensors::pose_of({0.06, -0.02, 0.01}, {0.2, 1, 0.1}, 3);
    rig.noise = sensors::GenericNoise{.convention = convention, .dropout_share = 0.1};
    const LoadedRecording recording =
        test::recorded(test::room(), rig, test::definition_of(1), {.kind = still}, 1, 1);
    const DepthPoints points(recording.rig.depth_form, rig.colour_from_depth, 2);
    renderer::DepthPicture registered = renderer::empty_picture(200, 150);
    PointRegistration by_points(recording.view);
    by_points(points, recording.frames[0].depth.depth_m, 2, registered);
    const auto slow =
        registration::register_by_points(recording.frames[0].depth, rig.colour_from_depth, rig.colour);
    EXPECT_EQ(registered.depth_m, slow.frame.depth_m);
    EXPECT_GT(registration::count_of(slow.filled), 3000);
  }
}

TEST(LocalMesh, KeepsToItsNumberOfTrianglesAndToThePointsOfItsPixels) {
  const LoadedRecording recording = room_recording(1);
  const DepthPoints points(recording.rig.depth_form, recording.rig.colour_from_depth, 1);
  for (const int most : {200, 2000, 25000, 0}) {
    LocalMesh mesh(points, {.most_triangles = most});
    mesh.build(points, recording.frames[0].depth.depth_m, Eigen::Isometry3d::Identity(), 2);
    const std::size_t found = mesh.mesh().triangles.size();
    const std::size_t all = 2 * 159 * 119;
    EXPECT_LE(found, most == 0 ? all : static_cast<std::size_t>(most));
    EXPECT_EQ(found,
              2 * static_cast<std::size_t>(mesh.columns() - 1) * static_cast<std::size_t>(mesh.rows() - 1));
    EXPECT_EQ(mesh.mesh().vertices_m.front(),
              points.point_m(0, recording.frames[0].depth.depth_m[0]).cast<float>());
  }
}

TEST(LocalMesh, CutsOnlyWhereDepthJumps) {
  const LoadedRecording recording = room_recording(1);
  const DepthPoints points(recording.rig.depth_form, recording.rig.colour_from_depth, 1);
  LocalMesh sheet(points, {.most_triangles = 0}), cut(points, {.most_triangles = 0, .cut_ratio = 1.1F});
  for (LocalMesh* mesh : {&sheet, &cut})
    mesh->build(points, recording.frames[0].depth.depth_m, Eigen::Isometry3d::Identity(), 2);
  EXPECT_LT(cut.mesh().triangles.size(), sheet.mesh().triangles.size());
  for (const renderer::Triangle& triangle : cut.mesh().triangles) {
    float least = 1e9F, most = 0;
    for (const std::uint32_t corner : triangle) {
      least = std::min(least, cut.mesh().vertices_m[corner].z());
      most = std::max(most, cut.mesh().vertices_m[corner].z());
    }
    EXPECT_LE(most, 1.1001F * least);
  }
}

TEST(LivePipeline, TheMeshOfAllPixelsOfTheColourCameraItselfHasItsDepths) {
  const LoadedRecording recording = room_recording(1);
  LivePipeline pipeline = pipeline_of(recording, {test::virtual_box()}, all_pixels());
  const LiveFrame& frame = pipeline.compose(recording.frames[0], *recording.frames[0].world_from_colour, {});
  int differ = 0, compared = 0;
  for (std::size_t i = 0; i < frame.registered.depth_m.size(); ++i) {
    const float measured_m = recording.frames[0].depth.depth_m[i], drawn_m = frame.registered.depth_m[i];
    if (std::isinf(drawn_m)) continue;  // half a pixel along the border
    ++compared;
    differ += std::abs(drawn_m - measured_m) > 1e-3F * measured_m ? 1 : 0;
  }
  EXPECT_GT(compared, 157 * 117);
  EXPECT_LE(differ, 40) << "pixels at jumps, whose centre a sheet's rounding touches";
}

/// Which pixels a virtual thing covers is the test of paper 002, pixel by pixel, on the registered depth.
TEST(LivePipeline, DepthTestIsThePixelwiseTestOnRegisteredDepth) {
  const LoadedRecording recording = room_recording(1);
  // Half behind the real box.
  const std::vector<renderer::FileMesh> objects = {test::box("v", {-1, -0.9, -3.3}, {0.2, -0.1, -2.3}, 0.8F)};
  for (const Mapping mapping : {Mapping::points, Mapping::mesh}) {
    LivePipeline pipeline = pipeline_of(recording, objects);
    const Eigen::Isometry3d pose = *recording.frames[0].world_from_colour;
    const LiveFrame& frame =
        pipeline.compose(recording.frames[0], pose, {.mapping = mapping, .occlusion = Occlusion::depth_test});
    const PixelRays rays(frame.eyes[0].view, 160, 120);
    int covered = 0, hidden = 0;
    for (int y = 0; y < 120; ++y)
      for (int x = 0; x < 160; ++x) {
        const auto hit = pipeline.scene().geometry.nearest({rays.eye_m(), rays.direction(x, y).normalized()});
        const bool shown = frame.eyes[0].covered[static_cast<std::size_t>(y * 160 + x)] != 0;
        if (!hit) {
          EXPECT_FALSE(shown);
          continue;
        }
        const bool is_hidden = sensors::hides(static_cast<double>(frame.registered.at(x, y)),
                                              static_cast<double>(rays.planar_m(hit->position_m)), nullptr);
        EXPECT_EQ(shown, !is_hidden) << x << " " << y;
        covered += shown ? 1 : 0;
        hidden += is_hidden ? 1 : 0;
      }
    EXPECT_GT(covered, 300);
    EXPECT_GT(hidden, 100);
  }
}

TEST(LivePipeline, AllWaysOfOcclusionAgreeOnExactDepth) {
  const LoadedRecording recording = room_recording(1);
  const std::vector<renderer::FileMesh> objects = {test::box("v", {-1, -0.9, -3.3}, {0.2, -0.1, -2.3}, 0.8F)};
  const auto covered = [&](Occlusion occlusion) {
    LivePipeline pipeline = pipeline_of(recording, objects, all_pixels());
    return pipeline
        .compose(recording.frames[0], *recording.frames[0].world_from_colour, {.occlusion = occlusion})
        .eyes[0]
        .covered;
  };
  const auto test = covered(Occlusion::depth_test), mesh = covered(Occlusion::mesh),
             ghosts = covered(Occlusion::ghosts), none = covered(Occlusion::nobody);
  EXPECT_EQ(test, ghosts) << "the local scene is drawn once";
  int differ = 0, hidden = 0;
  for (std::size_t i = 0; i < test.size(); ++i) {
    differ += test[i] != mesh[i] ? 1 : 0;
    hidden += none[i] != test[i] ? 1 : 0;
    EXPECT_GE(none[i], test[i]);
  }
  EXPECT_GT(hidden, 100);
  EXPECT_LE(differ, 6) << "pixels that an edge of the mesh passes";
}

/// Pixels with no outline within two pixels, because all codes there are theirs: 1 for each. One pixel is the
/// outline's own, the other what shadows shift by: their rays leave 0.2 % of the distance from the surface,
/// and as much again is no other surface.
std::vector<std::uint8_t> away_from_outlines(const ByteImage& codes) {
  std::vector<std::uint8_t> away(codes.values.size() / 3, 0);
  const auto at = [&](int x, int y) {
    return static_cast<int>(codes.values[3 * static_cast<std::size_t>(y * codes.width_px + x)]);
  };
  constexpr int reach = 2;
  for (int y = reach; y + reach < codes.height_px; ++y)
    for (int x = reach; x + reach < codes.width_px; ++x) {
      bool is_flat = true;
      for (int down = -reach; down <= reach; ++down)
        for (int right = -reach; right <= reach; ++right)
          is_flat = is_flat && std::abs(at(x + right, y + down) - at(x, y)) <= 1;
      away[static_cast<std::size_t>(y * codes.width_px + x)] = is_flat ? 1 : 0;
    }
  return away;
}

/// The largest difference of codes where `counted` is 1.
int largest_difference(const ByteImage& a, const ByteImage& b, const std::vector<std::uint8_t>& counted) {
  int largest = 0;
  for (std::size_t i = 0; i < a.values.size(); ++i)
    if (counted[i / 3] != 0)
      largest = std::max(largest, std::abs(static_cast<int>(a.values[i]) - static_cast<int>(b.values[i])));
  return largest;
}

/// With exact depth and traced shadows the picture is that of the scene with the object in it, as far as suns
/// and the camera's rays go: it is rendered by `photograph_scene`, which knows nothing of the pipeline. What
/// differs are outlines, of which the pipeline has one sample a pixel and the photograph sixteen.
TEST(LivePipeline, ExactDepthAndTracedShadowsGiveTheTracedDirectLight) {
  const sensors::Rig rig = test::exact_rig(320, 240);
  const LoadedRecording recording =
      test::recorded(test::room(), rig, test::definition_of(0), {.kind = still}, 1, 16);
  renderer::SceneFile with_object = test::room();
  with_object.meshes.push_back(test::virtual_box());
  const LoadedRecording truth =
      test::recorded(with_object, rig, test::definition_of(0), {.kind = still}, 1, 16);
  const ByteImage &before = recording.frames[0].colour, &wanted = truth.frames[0].colour;
  const auto picture = [&](Shadows shadows) {
    LivePipeline pipeline = pipeline_of(recording, {test::virtual_box()}, all_pixels());
    return pipeline.compose(recording.frames[0], *recording.frames[0].world_from_colour, {.shadows = shadows})
        .eyes[0]
        .codes;
  };
  const ByteImage traced = picture(Shadows::traced), map = picture(Shadows::map),
                  none = picture(Shadows::none);
  const auto away = away_from_outlines(wanted);
  EXPECT_GT(std::count(away.begin(), away.end(), 1), 0.85 * 320 * 240);
  EXPECT_LE(largest_difference(traced, wanted, away), 1);
  EXPECT_GT(largest_difference(before, wanted, away), 64) << "the object is more than its outline";
  EXPECT_GT(largest_difference(none, wanted, away), 64) << "and so is its shadow";
  EXPECT_LT(test::difference(traced, wanted).rms, 0.02);
  EXPECT_LT(test::difference(map, wanted).rms, 0.025);
}

TEST(LivePipeline, ShadowMapsGoToTracedShadowsAsTheirTexelsShrink) {
  const LoadedRecording recording = room_recording(0.2);
  const auto picture = [&](Shadows shadows, int width_px) {
    PipelineSettings settings = all_pixels();
    settings.shadow_map_px = width_px;
    LivePipeline pipeline = pipeline_of(recording, {test::virtual_box()}, settings);
    return pipeline.compose(recording.frames[0], *recording.frames[0].world_from_colour, {.shadows = shadows})
        .eyes[0]
        .codes;
  };
  const ByteImage traced = picture(Shadows::traced, 16);
  const double coarse = test::difference(picture(Shadows::map, 32), traced).rms;
  const double fine = test::difference(picture(Shadows::map, 1024), traced).rms;
  EXPECT_GT(coarse, 0);
  EXPECT_LT(fine, 0.5 * coarse);
  // A hard sun has no soft shadow.
  EXPECT_LT(test::difference(picture(Shadows::pcss, 1024), picture(Shadows::map, 1024)).rms, 0.01);
}

TEST(LivePipeline, TheSamePicturesForAnyNumberOfThreads) {
  const LoadedRecording recording = room_recording(0.2, 2, PathKind::sweep);
  for (const Methods methods : {Methods{}, Methods{Mapping::points, Occlusion::ghosts, Shadows::pcss},
                                Methods{Mapping::mesh, Occlusion::mesh, Shadows::traced}}) {
    std::vector<std::vector<std::uint8_t>> before;
    for (const int threads : {1, 2, 3, 7}) {
      PipelineSettings settings;
      settings.threads = threads;
      settings.views = 2;
      LivePipeline pipeline = pipeline_of(recording, {test::virtual_box()}, settings);
      std::vector<std::vector<std::uint8_t>> pictures;
      for (const LoadedFrame& frame : recording.frames)
        for (const LiveEye& eye : pipeline.compose(frame, *frame.world_from_colour, methods).eyes)
          pictures.push_back(eye.codes.values);
      if (before.empty()) before = pictures;
      EXPECT_EQ(pictures, before) << threads << " threads";
    }
  }
}

/// What is at the distance of zero parallax has its place in all views; what is nearer moves to the left for
/// an eye on the right, by the share of its nearness.
TEST(LivePipeline, EyesSeeOffAxisFrusta) {
  const sensors::PinholeCamera camera = sensors::pinhole_of_field_of_view(200, 100, 60);
  const renderer::DepthPicture size = renderer::empty_picture(200, 100);
  const auto x_px = [&](double right_m, double far_m) {
    const renderer::DrawView view = eye_view(camera, Eigen::Isometry3d::Identity(), right_m, 2);
    return static_cast<double>(
        renderer::view_point(view, size, Eigen::Vector3d(0.1, 0, far_m).cast<float>()).x_px);
  };
  EXPECT_NEAR(x_px(0.1, 2), x_px(-0.1, 2), 1e-3);
  for (const double far_m : {1.0, 4.0})
    EXPECT_NEAR(x_px(0.1, far_m) - x_px(-0.1, far_m), -camera.fx_px * 0.2 * (1 / far_m - 1 / 2.0), 1e-2);
}

TEST(LivePipeline, AnotherEyeShowsTheLocalScenesColours) {
  const LoadedRecording recording = room_recording(1);
  PipelineSettings settings = all_pixels();
  settings.views = 3;
  settings.zero_parallax_m = 3;
  LivePipeline pipeline = pipeline_of(recording, {test::virtual_box()}, settings);
  const LiveFrame& frame = pipeline.compose(recording.frames[0], *recording.frames[0].world_from_colour,
                                            {.shadows = Shadows::none});
  // The same rig, moved to where the right eye is.
  CameraPath path{.kind = PathKind::sweep, .distance_m = settings.eye_spacing_m};
  const LoadedRecording moved =
      test::recorded(test::room(), test::exact_rig(), test::definition_of(1), path, 2, 16);
  const LiveEye& right = frame.eyes[2];
  // Off-axis: what the moved camera sees is shifted by f e / zero parallax.
  const double shift_px = recording.view.fx_px * settings.eye_spacing_m / settings.zero_parallax_m;
  int compared = 0, differ = 0;
  for (int y = 4; y < 116; ++y)
    for (int x = 8; x < 152; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y * 160 + x);
      const int from = static_cast<int>(std::lround(x - shift_px));
      if (right.covered[pixel] != 0 || from < 0) continue;
      ++compared;
      const int off =
          static_cast<int>(right.codes.values[3 * pixel]) -
          static_cast<int>(moved.frames[1].colour.values[3 * static_cast<std::size_t>(y * 160 + from)]);
      differ += std::abs(off) > 16 ? 1 : 0;
    }
  EXPECT_GT(compared, 10000);
  EXPECT_LT(differ, compared / 20) << "at edges and where the camera saw nothing";
}

TEST(CodeTables, AreTheCurve) {
  const CodeTables& tables = code_tables();
  for (int code = 0; code < 256; ++code)
    EXPECT_EQ(tables.code(tables.linear(static_cast<std::uint8_t>(code))), code);
  for (int i = 0; i <= 5000; ++i) {
    const float value = static_cast<float>(i) / 5000;
    const float exact = 255 * srgb_from_linear(value);
    EXPECT_LE(std::abs(static_cast<float>(tables.code(value)) - exact), 0.5F + 1.0F / 30);
  }
  EXPECT_EQ(tables.code(-1), 0);
  EXPECT_EQ(tables.code(7), 255);
  EXPECT_EQ(tables.code(std::nanf("")), 0);
}

}  // namespace
}  // namespace seamline::live
