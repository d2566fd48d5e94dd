#include "laboratory/stability/light/space_scale_cases.h"

#include <fmt/core.h>

#include "laboratory/stability/common/groups.h"
#include "laboratory/stability/common/small_render.h"
#include "stimuli/pictures/difference.h"
#include "support/files/temporary_folder.h"

namespace seamline::stability {
namespace {

/// A floor, two walls, a pillar; a ball as the object.
SceneDefinition write_corner(const std::filesystem::path& folder, const RootNode& root) {
  const std::vector<PartPointer> parts = {
      box_shape({-4, -1.4F, -8}, {4, -1.3F, 2}), box_shape({-4, -1.4F, -8.2F}, {4, 3, -8}),
      box_shape({-4.2F, -1.4F, -8}, {-4, 3, 2}), box_shape({0.7F, -1.3F, -5.3F}, {1.1F, 1.2F, -4.9F})};
  SceneDefinition scene;
  scene.name = "corner";
  scene.path = folder / "corner.gltf";
  write_gltf_scene(scene.path, parts, root);
  ObjectDefinition object;
  object.name = "ball";
  object.path = folder / "ball.gltf";
  object.position_m = root.translation_m + root.scale * Eigen::Vector3d(0, -0.8, -4.6);
  object.scale = root.scale;
  write_gltf_scene(object.path, {ball_shape({0, 0, 0}, 0.5F, 48)}, {});
  scene.objects = {object};
  SunDefinition sun;
  sun.to_sun = Eigen::Vector3d(0.7, 0.9, 0.5).normalized();
  sun.irradiance_w_m2 = {2, 2, 2};
  scene.sun = sun;
  scene.environment_radiance = {0.4, 0.4, 0.4};
  scene.bounces = 1;
  return scene;
}

SmallPicture render_corner(const RootNode& root, int threads, const LoadRule& load) {
  const TemporaryFolder folder;
  const TruthScene scene = load(write_corner(folder.path(), root), 80, 45);
  return render_small(scene,
                      {.artifact = Artifact::all, .depth_width_px = 256, .spp = 16, .threads = threads});
}

StabilityCase root_case(const std::string& name, const RootNode& root, const std::string& tried) {
  return {
      .group = "space",
      .name = name,
      .tried = "a scene file whose root node " + tried,
      .expected = "the picture of the same scene at scale 1 at the origin",
      .unit = "of the picture's own noise",
      .tolerance = 0.1,
      .reason =
          "both share their sample points; a tenth of the noise adds 0.5 % to it, as errors add in squares",
      .run = [root](const StabilityOptions& options) { return try_root_node(root, options.threads); }};
}

}  // namespace

Finding try_root_node(const RootNode& root, int threads, const LoadRule& load) {
  const SmallPicture usual = render_corner({}, threads, load_truth_scene);
  const SmallPicture moved = render_corner(root, threads, load);
  const double noise = estimated_noise(usual.sums, 0).value();
  const double difference = display_rmse(usual.composite.picture, moved.composite.picture, 0);
  return {difference / noise,
          fmt::format("differs by {:.2g} where the noise is {:.2g} (display units)", difference, noise)};
}

StabilityCases space_scale_cases() {
  return {
      root_case("scale-1", {}, "does nothing, rendered twice"),
      root_case("scale-1e-3", {.scale = 1e-3}, "scales it by 1e-3"),
      root_case("scale-1e3", {.scale = 1e3}, "scales it by 1e3"),
      root_case("scale-1e5", {.scale = 1e5}, "scales it by 1e5"),
      root_case("moved-1e6", {.translation_m = {1000000.3, -999999.7, 1000000.1}},
                "moves it by 1e6 m along each axis"),
      root_case("moved-1e6-scale-1e-3", {.translation_m = {-1000000.3, 999999.7, 1000000.1}, .scale = 1e-3},
                "scales it by 1e-3 and moves it by 1e6 m along each axis"),
  };
}

}  // namespace seamline::stability
