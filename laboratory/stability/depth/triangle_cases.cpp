#include <fmt/core.h>

#include <limits>
#include <new>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/shapes.h"
#include "laboratory/stability/common/small_render.h"
#include "laboratory/stability/common/stability_case.h"
#include "laboratory/stability/common/worst.h"
#include "stimuli/pictures/difference.h"
#include "support/arithmetic/random.h"
#include "support/text/numbers.h"

namespace seamline::stability {
namespace {

SmallScene room() {
  return {.background = {plane_shape({}), box_shape({-4, -1, -9}, {4, 3, -8.5F})},
          .object = {ball_shape({0, -0.4F, -4}, 0.6F, 32, {.object_index = 1})},
          .light = sun_and_sky({0.6F, 1, 0.5F}, 3, 0.5F, 1)};
}

SmallPicture render_room(const SmallScene& scene, int threads) {
  return render_small(truth_scene_of(scene),
                      {.artifact = Artifact::all, .depth_width_px = 256, .threads = threads});
}

int changed_pixels(const Image& a, const Image& b) {
  int changed = 0;
  for (int y = 0; y < a.height_px; ++y)
    for (int x = 0; x < a.width_px; ++x)
      changed += ((a.rgb(x, y) - b.rgb(x, y)).abs() <= 1e-6F).all() ? 0 : 1;
  return changed;
}

/// A scene's picture must not change when triangles are added that have no area: three equal corners, three
/// corners in a line. Counts pixels that do.
Finding try_zero_area(int threads) {
  SmallScene scene = room();
  const SmallPicture usual = render_room(scene, threads);
  Random random(4);
  std::vector<Eigen::Vector3f> corners;
  std::vector<Triangle> triangles;
  const auto somewhere = [&] {
    return Eigen::Vector3d(4 * random.uniform() - 2, 2 * random.uniform() - 1, -6 * random.uniform() - 1);
  };
  for (std::uint32_t i = 0; i < 3000; i += 3) {
    const Eigen::Vector3d a = somewhere(), b = i % 2 == 0 ? a : somewhere();
    for (const double t : {0.0, 0.5, 1.0}) corners.push_back((a + t * (b - a)).cast<float>());
    triangles.push_back({i, i + 1, i + 2});
    triangles.push_back({i, i, i + 2});
  }
  scene.background.push_back(shape_of(corners, triangles));
  scene.object.push_back(shape_of(corners, triangles, {.object_index = 1}));
  const SmallPicture with = render_room(scene, threads);
  const int changed = changed_pixels(usual.composite.picture, with.composite.picture) +
                      changed_pixels(usual.reference, with.reference);
  return {static_cast<double>(changed), fmt::format("{} of {} pixels changed", changed, 2 * 64 * 36)};
}

/// The same for 2,000 needles, 10 m long and `width_m` wide, before everything. The error is the difference
/// over the picture's noise; a pixel that is not a number fails.
Finding try_needles(float width_m, int threads) {
  SmallScene scene = room();
  const SmallPicture usual = render_room(scene, threads);
  Random random(4);
  std::vector<Eigen::Vector3f> corners;
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < 6000; i += 3) {
    const auto x = static_cast<float>(6 * random.uniform() - 3),
               z = static_cast<float>(-1 - 7 * random.uniform());
    corners.insert(corners.end(), {{x, -1, z}, {x + width_m, -1, z}, {x + 1, 9, z}});
    triangles.push_back({i, i + 1, i + 2});
  }
  scene.background.push_back(shape_of(corners, triangles));
  const SmallPicture with = render_room(scene, threads);
  if (const int wrong = pixels_out_of_range(with.composite.picture, 1e6); wrong > 0)
    return {nan, fmt::format("{} pixels that are no numbers", wrong)};
  const double noise = estimated_noise(usual.sums, 0).value();
  const double difference = display_rmse(usual.reference, with.reference, 0);
  return {difference / noise,
          fmt::format("differs by {:.2g} where the noise is {:.2g} (display units)", difference, noise)};
}

/// Shading normals that are zero or no numbers: the picture must be that with geometric normals.
Finding try_broken_normals(int threads) {
  SmallScene scene = room();
  const SmallPicture usual = render_room(scene, threads);
  int changed = 0;
  for (const float broken : {0.0F, std::numeric_limits<float>::quiet_NaN()}) {
    auto ball = std::make_shared<SurfaceMesh>(*room().object[0]);
    ball->normals.assign(ball->positions_m.size(), Eigen::Vector3f::Constant(broken));
    scene.object = {ball};
    changed += changed_pixels(usual.reference, render_room(scene, threads).reference);
  }
  return {static_cast<double>(changed), fmt::format("{} pixels changed", changed)};
}

/// So many triangles in one place: rays must hit them where they are. Throws what the product throws.
Finding try_coincident(int triangles) {
  auto part = std::make_shared<SurfaceMesh>();
  part->positions_m = {{-9, -9, -5}, {9, -9, -5}, {0, 9, -5}};
  part->triangles.assign(triangles, Triangle{0, 1, 2});
  try {
    const Geometry geometry(std::vector<PartPointer>{part});
    double error = 0;
    for (int i = 0; i < 20; ++i) {
      const Eigen::Vector3f direction = Eigen::Vector3f(0.01F * static_cast<float>(i), 0, -1).normalized();
      const auto hit = geometry.nearest({Eigen::Vector3f::Zero(), direction});
      error = worse(error, hit ? relative_error(hit->position_m.z(), -5) : 1);
    }
    return {error, "handled: 20 rays hit them where they are"};
  } catch (const std::bad_alloc&) {
    return {0, "refused: more than there is memory for"};
  }
}

}  // namespace

StabilityCases triangle_cases() {
  return {
      {.group = "space",
       .name = "zero-area-triangles",
       .tried = "2,000 triangles without area among scene and object",
       .expected = "the picture without them",
       .unit = "pixels",
       .tolerance = 0,
       .reason = exact_count + ": any change above 1e-6",
       .run = [](const StabilityOptions& options) { return try_zero_area(options.threads); }},
      {.group = "space",
       .name = "needle-triangles",
       .tried = "2,000 triangles 10 m long and 1e-7 m wide before everything",
       .expected = "the picture without them, as they cover a ten-thousandth of a pixel",
       .unit = "of the picture's own noise",
       .tolerance = 0.1,
       .reason =
           "both share their sample points; a tenth of the noise adds 0.5 % to it, as errors add in squares",
       .run = [](const StabilityOptions& options) { return try_needles(1e-7F, options.threads); }},
      {.group = "space",
       .name = "broken-normals",
       .tried = "an object whose shading normals are zero, or no numbers",
       .expected = "the picture with geometric normals",
       .unit = "pixels",
       .tolerance = 0,
       .reason = exact_count + ": any change above 1e-6",
       .run = [](const StabilityOptions& options) { return try_broken_normals(options.threads); }},
      {.group = "space",
       .name = "coincident-triangles-1e7",
       .tried = "1e7 triangles in one place",
       .expected = "refused, or hit where they are",
       .unit = "relative",
       .tolerance = 1e-6,
       .reason = "a product and a sum in float, 8 roundings of 6e-8, twice that",
       .run = [](const StabilityOptions&) { return try_coincident(10'000'000); },
       .slow = true},
  };
}

}  // namespace seamline::stability
