// Virtual things that fall on the local scenes of a recording's frames.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "live/frame/moving_objects.h"
#include "live/physics/falling_bodies.h"
#include "live/running/times_table.h"
#include "small_world.h"
#include "tests/complaint.h"
#include "tests/renderer/falling_bodies.h"

namespace seamline::live {
namespace {

constexpr double floor_m = -1, interval_s = 1.0 / 30;
constexpr double half_m = 0.1;  ///< of the box that falls
constexpr float no_depth = std::numeric_limits<float>::infinity();

LoadedRecording room_frames(const sensors::Rig& rig, int frames = 1, PathKind kind = PathKind::still) {
  return test::recorded(test::room(), rig, test::definition_of(1), {.kind = kind, .distance_m = 0.2}, frames,
                        1);
}

DepthPoints points_of(const LoadedRecording& recording) {
  return {recording.rig.depth_form, recording.rig.colour_from_depth, 1};
}

FallingBody box_at(const Eigen::Vector3d& place_m) {
  return {.name = "box",
          .shape = renderer::HullShape{seamline::test::box_corners(Eigen::Vector3d::Constant(half_m))},
          .world_from_placed = seamline::test::pose_at(place_m)};
}

/// Above the floor, on the right, before the wall.
const Eigen::Vector3d above_floor_m(0.5, floor_m + half_m, -3.2);

/// A recording, and a box that falls on what it shows.
struct FallInRoom {
  LoadedRecording recording;
  DepthPoints points;
  FallingBodies bodies;

  FallInRoom(LoadedRecording of, const Eigen::Vector3d& place_m, const LocalMeshOptions& mesh = {})
      : recording(std::move(of)),
        points(points_of(recording)),
        bodies({box_at(place_m)}, DepthGround(points, mesh), 0.3) {
    bodies.begin(points, recording.frames[0].depth.depth_m, *recording.frames[0].world_from_colour);
  }

  void run(int frames) {
    for (int i = 0; i < frames; ++i) {
      const LoadedFrame& frame = recording.frames[static_cast<std::size_t>(i) % recording.frames.size()];
      bodies.advance(points, frame.depth.depth_m, *frame.world_from_colour, i > 0 ? interval_s : 0);
    }
  }
  [[nodiscard]] Eigen::Vector3d place_m() const { return bodies.poses()[0].world_from_body.translation(); }
  [[nodiscard]] double lowest_m() const {
    double lowest = 1e9;
    for (const Eigen::Vector3d& corner_m : seamline::test::box_corners(Eigen::Vector3d::Constant(half_m)))
      lowest = std::min(lowest, (bodies.poses()[0].world_from_body * corner_m).y());
    return lowest;
  }
};

TEST(QuietDepth, IsExactOnAPlaneAndAFifthOfItsNoise) {
  constexpr int width = 40, height = 30;
  const auto plane_m = [](int x, int y) {
    return 1 / (0.3F + 0.004F * static_cast<float>(x) + 0.006F * static_cast<float>(y));
  };
  std::vector<float> exact, noisy;
  Random random(5);
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      exact.push_back(plane_m(x, y));
      noisy.push_back(plane_m(x, y) * static_cast<float>(1 + 0.02 * (random.uniform() - 0.5)));
    }
  double before = 0, after = 0;
  for (int y = 2; y < height - 2; ++y)
    for (int x = 2; x < width - 2; ++x) {
      const auto i = static_cast<std::size_t>(y * width + x);
      EXPECT_NEAR(quiet_depth_m(exact, width, x, y), exact[i], 1e-5F);
      before += std::pow(double{noisy[i]} / exact[i] - 1, 2);
      after += std::pow(double{quiet_depth_m(noisy, width, x, y)} / exact[i] - 1, 2);
    }
  EXPECT_NEAR(std::sqrt(after / before), 0.2, 0.03);
  exact[5 * width + 5] *= 2;
  EXPECT_EQ(quiet_depth_m(exact, width, 5, 5), no_depth) << "a wild value is none";
  EXPECT_NEAR(quiet_depth_m(exact, width, 6, 6), plane_m(6, 6), 1e-5F) << "and says nothing to others";
}

TEST(BridgedHoles, LieOnThePlaneAndEverythingElseStays) {
  const auto plane = [](std::size_t column, std::size_t row) {
    return 1 / (0.3F + 0.01F * static_cast<float>(column) + 0.02F * static_cast<float>(row));
  };
  std::vector<float> whole;
  for (std::size_t row = 0; row < 6; ++row)
    for (std::size_t column = 0; column < 8; ++column) whole.push_back(plane(column, row));
  std::vector<float> holes = whole;
  for (const std::size_t i : {1U, 2U, 10U, 13U, 14U, 20U}) holes[i] = no_depth;
  for (std::size_t column = 0; column < 8; ++column) holes[3 * 8 + column] = no_depth;  // a whole row
  ASSERT_TRUE(bridge_holes(8, holes));
  for (std::size_t i = 0; i < whole.size(); ++i) EXPECT_NEAR(holes[i], whole[i], 1e-5F) << i;

  std::vector<float> border = {no_depth, 2, 3, no_depth, no_depth, no_depth, no_depth, no_depth};
  ASSERT_TRUE(bridge_holes(4, border));
  EXPECT_EQ(border, (std::vector<float>{2, 2, 3, 3, 2, 2, 3, 3}));
  std::vector<float> nothing(4, no_depth);
  EXPECT_FALSE(bridge_holes(2, nothing));
}

TEST(DepthGround, HasTheSameTrianglesThroughNoiseAndHolesAndOthersOnlyWhereItIsCut) {
  sensors::Rig rig = test::exact_rig();
  rig.noise = sensors::GenericNoise{.relative_sigma = 0.01, .dropout_share = 0.1};
  LoadedRecording recording = room_frames(rig, 2, PathKind::sweep);
  const DepthPoints points = points_of(recording);
  DepthGround sheets(points, {}), cut(points, {.most_triangles = 25'000, .cut_ratio = 1.02F});
  const auto take = [&](DepthGround& ground, std::size_t i) {
    return ground.take(points, recording.frames[i].depth.depth_m, *recording.frames[i].world_from_colour);
  };
  EXPECT_EQ(take(sheets, 0), DepthGround::Change::triangles);
  EXPECT_EQ(take(sheets, 1), DepthGround::Change::moved);
  EXPECT_EQ(take(sheets, 1), DepthGround::Change::none);
  EXPECT_EQ(take(cut, 0), DepthGround::Change::triangles);
  EXPECT_EQ(take(cut, 1), DepthGround::Change::triangles);
  EXPECT_LT(cut.ground().triangles.size(), sheets.ground().triangles.size());
  recording.frames[0].depth.depth_m.assign(160 * 120, no_depth);
  const std::vector<Eigen::Vector3d> before_m = sheets.ground().vertices_m;
  EXPECT_EQ(take(sheets, 0), DepthGround::Change::none) << "a frame without depth";
  EXPECT_EQ(sheets.ground().vertices_m, before_m);
}

TEST(FallingBodies, ABoxRestsOnTheFloorOfARecording) {
  SKIP_WITHOUT_BULLET();
  FallInRoom fall(room_frames(test::exact_rig()), above_floor_m);
  fall.run(1);
  EXPECT_NEAR(fall.lowest_m(), floor_m + 0.3, 1e-9) << "the first frame shows where it is let go";
  fall.run(6);
  EXPECT_NEAR(fall.lowest_m(), floor_m + 0.3 - 0.5 * 9.81 / 36, 0.02) << "it falls";
  fall.run(60);
  EXPECT_GT(fall.lowest_m(), floor_m - 2e-4) << "it does not reach into the floor";
  EXPECT_LT(fall.lowest_m(), floor_m + 2e-3);
  EXPECT_LT(fall.bodies.poses()[0].speed_m_s, 1e-3);
  fall.bodies.let_go();
  EXPECT_NEAR(fall.lowest_m(), floor_m + 0.3, 1e-9);
  EXPECT_EQ(fall.bodies.poses()[0].times_let_go, 2);
}

TEST(FallingBodies, StayInTheWorldWhileTheCameraMoves) {
  SKIP_WITHOUT_BULLET();
  FallInRoom fall(room_frames(test::exact_rig(), 20, PathKind::sweep), above_floor_m);
  fall.run(40);
  const Eigen::Vector3d rests_m = fall.place_m();
  fall.run(40);
  EXPECT_LT((fall.place_m() - rests_m).norm(), 1e-3);
  EXPECT_LT((fall.place_m() - above_floor_m).norm(), 5e-3);
}

TEST(FallingBodies, DoNotFallThroughHoles) {
  SKIP_WITHOUT_BULLET();
  sensors::Rig rig = test::exact_rig();
  rig.noise = sensors::GenericNoise{.dropout_share = 0.3};
  FallInRoom fall(room_frames(rig, 3), above_floor_m);
  fall.run(90);
  EXPECT_NEAR(fall.lowest_m(), floor_m, 5e-3);
  EXPECT_FALSE(fall.bodies.poses()[0].is_held);
}

TEST(FallingBodies, WaitWhileNothingIsSeenBelowThem) {
  SKIP_WITHOUT_BULLET();
  FallInRoom fall(room_frames(test::exact_rig()), above_floor_m);
  fall.run(5);
  const LoadedFrame& frame = fall.recording.frames[0];
  const Eigen::Matrix4d before = fall.bodies.poses()[0].world_from_body.matrix();
  const Eigen::Isometry3d elsewhere = Eigen::Translation3d(50, 0, 0) * *frame.world_from_colour;
  for (int i = 0; i < 100; ++i) fall.bodies.advance(fall.points, frame.depth.depth_m, elsewhere, interval_s);
  EXPECT_TRUE(fall.bodies.poses()[0].is_held);
  EXPECT_EQ(fall.bodies.poses()[0].world_from_body.matrix(), before);
  fall.run(60);
  EXPECT_FALSE(fall.bodies.poses()[0].is_held);
  EXPECT_NEAR(fall.lowest_m(), floor_m, 2e-3);
}

TEST(FallingBodies, AGroundThatIsRefittedIsAGroundThatIsRebuilt) {
  SKIP_WITHOUT_BULLET();
  sensors::Rig rig = test::exact_rig();
  rig.noise = sensors::GenericNoise{.relative_sigma = 0.003};
  const LoadedRecording recording = room_frames(rig, 10);
  const DepthPoints points = points_of(recording);
  DepthGround ground(points, {});
  const auto take = [&](std::size_t i) {
    (void)ground.take(points, recording.frames[i].depth.depth_m, *recording.frames[i].world_from_colour);
  };
  take(0);
  const FallingBody box = box_at(above_floor_m + Eigen::Vector3d(0, 0.1, 0));
  renderer::RigidWorld refitted(ground.ground(), box.shape, box.world_from_placed, {});
  renderer::RigidWorld rebuilt(ground.ground(), box.shape, box.world_from_placed, {});
  for (std::size_t i = 0; i < 60; ++i) {
    take(i % recording.frames.size());
    refitted.move_ground(ground.ground().vertices_m);
    rebuilt.set_ground(ground.ground());
    seamline::test::run(refitted, 8);
    seamline::test::run(rebuilt, 8);
    const Eigen::Isometry3d one = refitted.body().world_from_body, other = rebuilt.body().world_from_body;
    EXPECT_LT((one.matrix() - other.matrix()).norm(), 1e-6) << "frame " << i;
  }
  EXPECT_LT(std::abs(refitted.body().middle_m.y() - floor_m - half_m), 0.05);
}

TEST(FallingBodies, AreRefusedWhereTheyCannotBegin) {
  const auto complaint = [](const Eigen::Vector3d& place_m) {
    return seamline::test::complaint_of([&] { FallInRoom(room_frames(test::exact_rig()), place_m); });
  };
  SKIP_WITHOUT_BULLET();
  EXPECT_NE(complaint({0.5, -0.5, -4}).find("into the surface"), std::string::npos);
  EXPECT_NE(complaint({0.5, -0.5, -8}).find("straight below"), std::string::npos);
  LoadedRecording blind = room_frames(test::exact_rig());
  blind.frames[0].depth.depth_m.assign(160 * 120, no_depth);
  EXPECT_NE(seamline::test::complaint_of([&] { FallInRoom(blind, above_floor_m); }).find("with depth"),
            std::string::npos);
}

TEST(RecordingTime, IsTheInterval) {
  LoadedRecording recording;
  for (const double time_s : {1.0, 1.1, 1.1, 9.4}) recording.frames.emplace_back().time_s = time_s;
  EXPECT_NEAR(interval_before_s(recording, 1), 0.1, 1e-12);
  EXPECT_EQ(interval_before_s(recording, 2), 0);
  EXPECT_EQ(interval_before_s(recording, 3), 1) << "a break";
  EXPECT_EQ(interval_before_s(recording, 0), 1);
  recording.frames.resize(1);
  EXPECT_EQ(interval_before_s(recording, 0), 1.0 / 30);
}

TEST(TimesTable, HasTheStageOfPhysicsOnlyWhereThingsFall) {
  const std::vector<TimedFrame> frames(1);
  const CsvTable with = times_table(frames, true), without = times_table(frames, false);
  const auto has = [](const CsvTable& table) {
    return std::any_of(table.columns.begin(), table.columns.end(),
                       [](const CsvColumn& column) { return column.name == "physics_ms"; });
  };
  EXPECT_TRUE(has(with));
  EXPECT_FALSE(has(without));
  EXPECT_EQ(with.columns.size(), with.rows[0].size());
  EXPECT_EQ(without.columns.size(), without.rows[0].size());
}

/// A scene of boxes that can be moved, as `make_movable` makes it.
LiveScene movable(const LoadedRecording& recording, const std::vector<renderer::FileMesh>& objects) {
  LiveScene scene = test::scene_with(recording, objects);
  std::vector<std::shared_ptr<const renderer::SurfaceMesh>> moved;
  for (const auto& mesh : scene.objects.meshes) {
    const std::vector<std::shared_ptr<const renderer::SurfaceMesh>> one = {mesh};
    scene.moving.push_back({.placed = renderer::Geometry(one, renderer::Edges::loose),
                            .meshes = {std::make_shared<renderer::SurfaceMesh>(*mesh)}});
    moved.push_back(scene.moving.back().meshes[0]);
  }
  scene.objects.meshes = moved;
  return scene;
}

TEST(MovingObjects, LookAsTheyDoWherePlacedThere) {
  LoadedRecording recording = room_frames(test::exact_rig(320, 240));
  const Eigen::Isometry3d turned = Eigen::Translation3d(0.1, 0.2, -3) *
                                   Eigen::AngleAxisd(0.4, Eigen::Vector3d(0.2, 1, 0.3).normalized()) *
                                   Eigen::Translation3d(0, 0.1, 2.5);
  const std::vector<renderer::FileMesh> placed = {test::virtual_box(),
                                                  test::box("other", {0.6, -1, -3}, {0.9, -0.6, -2.7}, 0.6F)};
  std::vector<renderer::FileMesh> there = placed;
  for (Eigen::Vector3d& place_m : there[0].positions_m) place_m = turned * place_m;
  const std::vector<Eigen::Isometry3d> stay(2, Eigen::Isometry3d::Identity());
  const std::vector<Eigen::Isometry3d> moves = {turned, Eigen::Isometry3d::Identity()};
  for (const Shadows shadows : {Shadows::pcf, Shadows::traced}) {
    const auto picture = [&](LiveScene scene, const std::vector<Eigen::Isometry3d>& by) {
      LivePipeline pipeline(recording, std::move(scene), Eigen::Vector3d::Zero(), {});
      if (!by.empty()) pipeline.move(by);
      return pipeline
          .compose(recording.frames[0], *recording.frames[0].world_from_colour, {.shadows = shadows})
          .eyes[0]
          .codes;
    };
    const ByteImage still = picture(test::scene_with(recording, placed), {});
    EXPECT_EQ(picture(movable(recording, placed), stay).values, still.values);
    const ByteImage wanted = picture(test::scene_with(recording, there), {});
    EXPECT_GT(test::difference(still, wanted).rms, 0.02);
    EXPECT_LT(test::difference(picture(movable(recording, placed), moves), wanted).rms, 0.002);
  }
}

}  // namespace
}  // namespace seamline::live
