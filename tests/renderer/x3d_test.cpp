// Pages in X3D: metres become window depth as a projection makes them, codes give their depths back, who is
// in front is what distances say.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "support/text/numbers.h"
#include "x3d/x3d_frame.h"
#include "x3d/x3d_openness.h"
#include "x3d/x3d_page.h"
#include "x3d/x3d_text.h"

namespace seamline::renderer {
namespace {

using testing::HasSubstr;

std::shared_ptr<const SurfaceMesh> upright_square(double left_m, double right_m, double z_m,
                                                  int object_index) {
  auto mesh = std::make_shared<SurfaceMesh>();
  mesh->object_index = object_index;
  for (const auto& [x, y] : {std::pair{left_m, -5.0}, {right_m, -5.0}, {right_m, 5.0}, {left_m, 5.0}})
    mesh->positions_m.push_back(Eigen::Vector3d(x, y, z_m).cast<float>());
  mesh->triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

/// A wall 4 m away, a post before the right half at 2 m, and an object between them.
X3dSubject post_before_object() {
  X3dSubject subject;
  subject.title = "<post>";
  subject.camera = {.tan_half_horizontal = 1, .width_px = 64, .height_px = 36};
  subject.photograph = Image(64, 36, 3, 0.25F);
  const std::vector real = {upright_square(-50, 50, -4, 0), upright_square(0, 1, -2, 0)};
  subject.depth = std::make_shared<const Geometry>(real);
  subject.objects = {upright_square(-1, 1.2, -3, 1)};
  subject.light.suns = {
      {.to_sun = Eigen::Vector3f(0.3F, 0.4F, 1).normalized(), .irradiance_w_m2 = Rgb::Constant(3)}};
  return subject;
}

TEST(X3dFrame, WindowDepthIsThatOfAPerspectiveProjection) {
  const ClipPlanes planes{.near_m = 0.2, .far_m = 40};
  for (const double planar_m : {0.2, 0.5, 1.0, 7.0, 39.0, 40.0}) {
    const double clip_z = (planes.far_m + planes.near_m) / (planes.far_m - planes.near_m) * planar_m -
                          2 * planes.far_m * planes.near_m / (planes.far_m - planes.near_m);
    EXPECT_NEAR(window_depth(planar_m, planes), 0.5 * clip_z / planar_m + 0.5, 1e-12) << planar_m;
  }
  EXPECT_EQ(window_depth(infinity, planes), 1);
  EXPECT_EQ(window_depth(0.1, planes), 0);
}

TEST(X3dFrame, CodesGiveTheirDepthsBack) {
  const double range_m = 12.5, step_m = range_m / 16777215;
  std::vector<float> depth_m;
  for (int i = 1; i <= 1000; ++i) depth_m.push_back(static_cast<float>(range_m * i / 1000));
  depth_m.push_back(sensors::hole);
  depth_m.push_back(1e-9F);
  const ByteImage codes = depth_codes(depth_m, 1002, 1, range_m);
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    const double found_m = depth_of_code(std::span<const std::uint8_t, 3>(&codes.values[3 * i], 3), range_m);
    if (std::isinf(depth_m[i]))
      EXPECT_EQ(found_m, infinity);
    else
      EXPECT_NEAR(found_m, static_cast<double>(depth_m[i]), step_m);  // never a hole, however near
  }
}

TEST(X3dFrame, WhoIsInFrontIsWhatDistancesSay) {
  const X3dSubject subject = post_before_object();
  const X3dFrame frame = frame_of(subject, 2);
  // At 3 m a pixel is 6 / 64 m wide; the object spans pixels 21.3 to 44.8 and the post, at 2 m, 32 to 48.
  const std::size_t row = 18 * 64;
  for (std::size_t x = 0; x < 64; ++x)
    EXPECT_EQ(frame.in_front[row + x], x >= 32 && x <= 44   ? InFront::real
                                       : x >= 21 && x <= 31 ? InFront::object
                                                            : InFront::nothing_virtual)
        << x;
  EXPECT_FLOAT_EQ(frame.depth.depth_m[row + 10], 4);
  EXPECT_FLOAT_EQ(frame.depth.depth_m[row + 40], 2);
  EXPECT_LT(frame.planes.near_m, 2);
  EXPECT_GT(frame.planes.far_m, 4);
  // Ghosts stand where the depth does, in X3D's frame: before the camera z is negative.
  float nearest_m = -1e9F, farthest_m = 0;
  for (const Eigen::Vector3f& vertex_m : frame.ghosts.vertices_m) {
    nearest_m = std::max(nearest_m, vertex_m.z());
    farthest_m = std::min(farthest_m, vertex_m.z());
  }
  EXPECT_NEAR(nearest_m, -2, 1e-4);
  EXPECT_NEAR(farthest_m, -4, 1e-4);
}

TEST(X3dPage, IsTheSameTwiceAndAsksForNothingOutside) {
  const X3dSubject subject = post_before_object();
  const X3dFrame frame = frame_of(subject, 1);
  const auto sun = x3d_sun(subject, frame, 1);
  ASSERT_TRUE(sun);
  const ByteImage photograph = display_image(subject.photograph);
  const auto openness = x3d_openness(subject, 1);
  const X3dPage page{
      .subject = subject, .frame = frame, .photograph = photograph, .openness = openness, .sun = &*sun};
  const std::filesystem::path folder = std::filesystem::path(SEAMLINE_SOURCE_DIR) / "x3d/page";
  const std::string text = x3d_page_text(page, folder);
  EXPECT_EQ(text, x3d_page_text(page, folder));
  EXPECT_THAT(text, HasSubstr("<h1>&lt;post&gt;</h1>"));
  EXPECT_EQ(text.find("http"), text.find("http-equiv"));  // the only one
  EXPECT_EQ(text.find("http", text.find("http-equiv") + 4), std::string::npos);
  EXPECT_EQ(text.find("unsafe"), std::string::npos);
  for (const char* proto : {"<ProtoDeclare name=\"DepthSensor\">", "<ProtoInstance name=\"NISensor\" "})
    EXPECT_THAT(text, HasSubstr(proto));
}

TEST(X3dOpenness, IsAllOnAPlaneAndHalfAtTheFootOfAWallOrBehindTheEdgeOfACover) {
  X3dSubject subject = post_before_object();
  const auto wall = upright_square(-50, 50, -4, 1);
  auto ground = std::make_shared<SurfaceMesh>();
  ground->positions_m = {{0, 0, -3.99F}, {-0.1F, 0, -3.9F}, {0.1F, 0, -3.9F}, {0, 4.9F, 30}};
  ground->normals.assign(4, Eigen::Vector3f::UnitY());
  ground->triangles = {{0, 1, 2}};
  const std::vector far = {upright_square(-50, 50, -400, 0)};
  subject.depth = std::make_shared<const Geometry>(far);
  subject.objects = {wall, ground};
  const auto open = x3d_openness(subject, 1);
  EXPECT_THAT(open[0], testing::Each(1));
  EXPECT_NEAR(open[1][0], 0.5, 0.04);  // the wall, 5 m high, hides nearly all of its side
  subject.objects = {wall};
  const std::vector cover = {upright_square(-5000, 5000, -3.8, 0)};
  subject.depth = std::make_shared<const Geometry>(cover);
  EXPECT_THAT(x3d_openness(subject, 2)[0],
              testing::Each(testing::FloatNear(0.5F, 0.04F)));  // 10 m high, like the wall
}

TEST(X3dSun, TheObjectsShadowMapShadesThePostBehindItAndNotWhatStandsBefore) {
  const X3dSubject subject = post_before_object();
  const X3dFrame frame = frame_of(subject, 1);
  const auto sun = x3d_sun(subject, frame, 1);
  const Eigen::Vector3f to_sun = sun->to_sun.cast<float>(), normal = Eigen::Vector3f::UnitZ();
  const Eigen::Vector3f on_object(-0.5F, 0, -3), behind = on_object - 1.2F * to_sun,
                                                 before = on_object + 0.5F * to_sun;
  EXPECT_EQ(arriving(sun->object, {}, behind, normal, 0), 0);
  EXPECT_EQ(arriving(sun->object, {}, before, normal, 0), 1);
  // Light reaches the wall beside the post: no sheet hangs between the post's right edge and the wall.
  EXPECT_EQ(arriving(sun->real, {}, {1.5F, 0, -4}, normal, 0), 1);
  EXPECT_EQ(arriving(sun->real, {}, {0, 0, -4}, normal, 0), 0);  // but the post's own shadow is there
  // 0.1 of the sun at least, where the sky gives less.
  EXPECT_GE(sun->sky_w_m2.minCoeff(), 0.3 - 1e-6);
}

}  // namespace
}  // namespace seamline::renderer
