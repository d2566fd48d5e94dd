#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>

#include "commands/options/output_files.h"
#include "commands/photographs/mesh_options.h"
#include "raytracer/common/parallel.h"
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/gltf_write.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

using Triple = std::array<double, 3>;

struct CaptureOptions {
  std::string scene, out;
  int width_px = 2048;
  double yaw_texels = 0;
  Triple at{};
  bool at_given = false;
};

void run_capture(const CaptureOptions& options) {
  if (options.width_px % 2 != 0)
    throw input_error(
        {.field = "--width", .wanted = "an even width", .found = std::to_string(options.width_px)});
  const std::filesystem::path path = resolve_named_file(options.scene, "SCENE");
  const SceneFile file = read_scene_file(path);
  if (!options.at_given && !file.camera)
    throw input_error(
        {.file = path.string(), .wanted = "a camera in the scene, or --at X Y Z", .found = "neither"});
  const Eigen::Vector3d centre_m =
      options.at_given ? Eigen::Vector3d(options.at.data()) : file.camera->position_m;
  const Geometry geometry(place_meshes(file, Eigen::Affine3d::Identity(), centre_m, 0.5, 0));
  const DepthMap map = capture_depth(geometry, options.width_px, options.yaw_texels, default_thread_count());
  write_depth_map(options.out, map);
  fmt::print("{}: {} x {} texels, centred on ({:.3f}, {:.3f}, {:.3f}) m\n", options.out, map.width_px,
             map.height_px, centre_m.x(), centre_m.y(), centre_m.z());
}

void run_mesh(const MeshCommandOptions& options) {
  const DepthMesh mesh = panorama_mesh_of(options);
  write_depth_mesh(options.out, mesh);
  fmt::print("{}: {} triangles, {} vertices, largest relative error {:.2e}\n", options.out,
             mesh.triangles.size(), mesh.vertices_m.size(), mesh.max_relative_error);
}

}  // namespace

void need_extension(const std::string& file, std::initializer_list<const char*> endings, const char* option) {
  const std::string found = lower_case_ending(file);
  std::string wanted;
  for (const char* ending : endings) {
    if (found == ending) return;
    wanted += (wanted.empty() ? "" : " or ") + std::string(ending);
  }
  throw input_error({.field = option, .wanted = "a name ending in " + wanted, .found = "\"" + file + "\""});
}

void add_workbench_commands(CLI::App& app) {
  auto capture_options = std::make_shared<CaptureOptions>();
  CLI::App* capture = app.add_subcommand("capture", "capture a panoramic depth map of a scene file");
  capture->add_option("scene", capture_options->scene, ".glb, .gltf or builtin:NAME")->required();
  add_number(*capture, "--width", capture_options->width_px, {2, 16384, "px"}, "width W; the height is W / 2")
      ->capture_default_str();
  add_number(*capture, "--yaw", capture_options->yaw_texels, any_yaw_texels,
             "by which the sampling grid turns")
      ->capture_default_str();
  const CLI::Option* at = add_number(*capture, "--at", capture_options->at, any_place_m,
                                     "centre X Y Z (default: the scene's camera)");
  capture->add_option("--out", capture_options->out, "depth map to write: .exr and no other")->required();
  capture->callback([capture_options, at, capture] {
    need_extension(capture_options->out, {".exr"});
    require_outputs(*capture, {"--out"});
    capture_options->at_given = at->count() > 0;
    run_capture(*capture_options);
  });

  auto mesh_options = std::make_shared<MeshCommandOptions>();
  CLI::App* mesh = app.add_subcommand("mesh", "rebuild the local scene's mesh from a depth map");
  mesh->add_option("depth", mesh_options->depth, "equirectangular depth map (.exr, metres)")->required();
  mesh->add_option("--out", mesh_options->out, "mesh to write (.glb)")->required();
  add_mesh_options(*mesh, *mesh_options);
  add_yaw_option(*mesh, *mesh_options);
  mesh->callback([mesh_options, mesh] {
    need_extension(mesh_options->out, {".glb"});
    require_outputs(*mesh, {"--out"});
    run_mesh(*mesh_options);
  });
}

}  // namespace seamline::renderer
