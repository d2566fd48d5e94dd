#include "renderer/commands/workbench_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>

#include "renderer/common/parallel.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/gltf_write.h"
#include "renderer/estimators/photo_composite.h"
#include "renderer/scene/visible_objects.h"
#include "renderer/set/set_layers.h"
#include "support/files/assets.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

using Triple = std::array<double, 3>;

constexpr NumberRange any_yaw_texels{-16384, 16384, "texels"};

Eigen::Vector3d vector(const Triple& v) {
  return {v[0], v[1], v[2]};
}

/// Refuses a file name whose ending does not say what will be in the file.
void need_extension(const std::string& file, std::initializer_list<const char*> endings) {
  std::string wanted;
  for (const char* ending : endings) {
    if (std::filesystem::path(file).extension() == ending) return;
    wanted += (wanted.empty() ? "" : " or ") + std::string(ending);
  }
  throw input_error({.field = "--out", .wanted = "a name ending in " + wanted, .found = "\"" + file + "\""});
}

struct CaptureOptions {
  std::string scene, out;
  int width_px = 2048;
  double yaw_texels = 0;
  Triple at{};
  bool at_given = false;
};

void run_capture(const CaptureOptions& options) {
  need_extension(options.out, {".exr"});
  if (options.width_px % 2 != 0)
    throw input_error(
        {.field = "--width", .wanted = "an even width", .found = std::to_string(options.width_px)});
  const std::filesystem::path path = resolve_named_file(options.scene, "SCENE");
  const SceneFile file = read_scene_file(path);
  if (!options.at_given && !file.camera)
    throw input_error(
        {.file = path.string(), .wanted = "a camera in the scene, or --at X Y Z", .found = "neither"});
  const Eigen::Vector3d centre_m = options.at_given ? vector(options.at) : file.camera->position_m;
  const Geometry geometry(place_meshes(file, Eigen::Affine3d::Identity(), centre_m, 0.5, 0));
  const DepthMap map = capture_depth(geometry, options.width_px, options.yaw_texels, default_thread_count());
  write_depth_map(options.out, map);
  fmt::print("{}: {} x {} texels, centred on ({:.3f}, {:.3f}, {:.3f}) m\n", options.out, map.width_px,
             map.height_px, centre_m.x(), centre_m.y(), centre_m.z());
}

struct MeshCommandOptions {
  std::string depth, out, density = "adaptive";
  double tolerance = 1e-4;
  double yaw_texels = 0;
};

DepthMesh mesh_of(const MeshCommandOptions& options) {
  const DepthMap map = read_depth_map(options.depth);
  if (map.cleaned_texels > 0)
    fmt::print(stderr, "{}: {} texels were 0, negative, not a number or beyond 1e9 m and are read as holes\n",
               options.depth, map.cleaned_texels);
  return build_depth_mesh(map,
                          {.density = options.density == "full" ? MeshDensity::full : MeshDensity::adaptive,
                           .tolerance = options.tolerance,
                           .yaw_texels = options.yaw_texels});
}

void run_mesh(const MeshCommandOptions& options) {
  need_extension(options.out, {".glb"});
  const DepthMesh mesh = mesh_of(options);
  write_depth_mesh(options.out, mesh);
  fmt::print("{}: {} triangles, {} vertices, largest relative error {:.2e}\n", options.out,
             mesh.triangles.size(), mesh.vertices_m.size(), mesh.max_relative_error);
}

struct CompositeOptions {
  MeshCommandOptions mesh;
  std::string photograph, object, out;
  Triple position_m{0, 0, -3}, rotation_deg{0, 0, 0}, look_at_m{0, 0, -1}, to_sun{0, 1, 0},
      irradiance{0, 0, 0}, environment{1, 1, 1};
  double scale = 1, fov_deg = 60, sun_radius_deg = 0, albedo = 0.5, exposure_ev = 0;
  int bounces = 4, spp = 64, seed = 1;
  bool additive = false;
};

SceneDefinition scene_of(const CompositeOptions& options) {
  SceneDefinition scene;
  scene.name = "composite";
  scene.path = options.object;
  scene.sun = SunDefinition{vector(options.to_sun).normalized(), options.irradiance, options.sun_radius_deg};
  scene.camera = CameraDefinition{Eigen::Vector3d::Zero(), vector(options.look_at_m), options.fov_deg};
  scene.environment_radiance = options.environment;
  scene.bounces = options.bounces;
  scene.albedo = options.albedo;
  return scene;
}

void check_directions(const CompositeOptions& options) {
  if (!(vector(options.to_sun).norm() > 0))
    throw input_error({.field = "--to-sun", .wanted = "a direction that is not zero", .found = "0 0 0"});
  const Eigen::Vector3d view = vector(options.look_at_m);
  if (!(view.cross(Eigen::Vector3d::UnitY()).norm() > 1e-9 * view.norm()))
    throw input_error({.field = "--look-at",
                       .wanted = "a point that is not straight above, below or at the centre",
                       .found = "one that is"});
}

bool covers_a_pixel(const Camera& camera, const Geometry& object) {
  const std::array<std::int64_t, 4> seen = visible_pixels(camera, object);
  return seen[1] > 0;
}

Image read_photograph(const std::string& file) {
  Image photograph = read_image(file, [&](const ImageHeader& header) {
    if (header.channels < 3)
      throw input_error({.file = file,
                         .wanted = "three colour channels",
                         .found = std::to_string(header.channels) + " channels"});
  });
  std::size_t wrong = 0;
  for (int y = 0; y < photograph.height_px; ++y)
    for (int x = 0; x < photograph.width_px; ++x) {
      const Rgb colour = photograph.rgb(x, y);
      wrong += (colour.abs() <= static_cast<float>(limits::strongest_light)).all() ? 0 : 1;
    }
  if (wrong > 0)
    throw input_error(
        {.file = file,
         .wanted = fmt::format("colours that are numbers, at most {:g}", limits::strongest_light),
         .found = fmt::format("{} pixels of another kind", wrong)});
  return photograph;
}

void run_composite(const CompositeOptions& options) {
  need_extension(options.out, {".png", ".exr"});
  check_directions(options);
  const Image photograph = read_photograph(options.photograph);
  const SceneDefinition scene = scene_of(options);
  const SceneFile object_file = read_scene_file(resolve_named_file(options.object, "--object"));
  Eigen::Vector3d centre_m;
  const Camera camera = scene_camera(scene, object_file, photograph.width_px, photograph.height_px, centre_m);
  const Geometry depth(mesh_of(options.mesh), Rgb::Constant(static_cast<float>(options.albedo)));
  const ObjectDefinition placement{.name = {},
                                   .file = {},
                                   .path = {},
                                   .position_m = vector(options.position_m),
                                   .rotation_deg = vector(options.rotation_deg),
                                   .scale = options.scale};
  const Geometry object(place_meshes(object_file, object_placement(placement), centre_m, options.albedo, 1));
  if (!covers_a_pixel(camera, object))
    throw input_error({.file = options.object,
                       .field = "--position",
                       .wanted = "an object that covers at least one pixel of the picture",
                       .found = "none"});
  Progress progress("composite", 1.0);
  const PassOptions pass{.spp = options.spp,
                         .seed = static_cast<std::uint64_t>(options.seed),
                         .threads = default_thread_count(),
                         .progress = [&, last = 0.0](double share) mutable {
                           progress.advance(share - last, "");
                           last = share;
                         }};
  const StimulusSums layers =
      render_onto_photograph(photograph, depth, object, camera, scene_light(scene, object_file), pass);
  const Composite composite = compose(layers, options.additive ? Compositing::additive : Compositing::ratio);
  if (std::filesystem::path(options.out).extension() == ".exr")
    write_picture_exr(options.out, composite.picture);
  else
    write_png(options.out, display_image(composite.picture, options.exposure_ev));
  fmt::print("{}: {} pixels had too little light for a ratio, {} were clamped\n", options.out,
             composite.tiny_denominators.floored_pixels, composite.tiny_denominators.clamped_pixels);
}

void add_mesh_options(CLI::App* command, MeshCommandOptions& options) {
  command->add_option("--mesh", options.density, "adaptive or full")
      ->check(CLI::IsMember({"adaptive", "full"}));
  add_number(*command, "--tolerance", options.tolerance, {1e-9, 1}, "relative error of the adaptive mesh");
  add_number(*command, "--yaw", options.yaw_texels, any_yaw_texels, "by which the map was turned");
}

void add_composite(CLI::App& app) {
  auto options = std::make_shared<CompositeOptions>();
  CLI::App* command =
      app.add_subcommand("composite", "insert an object into a photograph through a panoramic depth map");
  command->add_option("--background", options->photograph, "photograph (EXR, HDR, PNG, JPEG)")->required();
  command->add_option("--depth", options->mesh.depth, "equirectangular depth map (.exr, metres)")->required();
  command->add_option("--object", options->object, "object (.glb, .gltf or builtin:NAME)")->required();
  command->add_option("--out", options->out, "picture to write (.png or .exr)")->required();
  add_number(*command, "--position", options->position_m, any_place_m,
             "object's place from the panorama's centre");
  add_number(*command, "--rotation", options->rotation_deg, {-1e9, 1e9, "degrees"}, "pitch yaw roll");
  add_number(*command, "--scale", options->scale, {1e-9, 1e9}, "object's scale");
  add_number(*command, "--look-at", options->look_at_m, any_place_m,
             "point that the photograph's centre shows, from the panorama's centre");
  add_number(*command, "--fov", options->fov_deg, {1, 170, "degrees"},
             "horizontal field of view of the photograph");
  add_number(*command, "--to-sun", options->to_sun, {-1e9, 1e9}, "direction towards the sun");
  add_number(*command, "--sun-irradiance", options->irradiance, {0, limits::strongest_light, "W/m2"},
             "on a plane facing the sun, R G B");
  add_number(*command, "--sun-radius", options->sun_radius_deg, {0, 45, "degrees"},
             "angular radius of the sun");
  add_number(*command, "--environment", options->environment, {0, limits::strongest_light, "W/m2/sr"},
             "environment radiance R G B");
  add_number(*command, "--albedo", options->albedo, {0, 1}, "albedo of the local scene");
  add_number(*command, "--bounces", options->bounces, {0, 1024}, "further diffuse scatterings");
  add_number(*command, "--spp", options->spp, {1, 65536}, "samples per pixel");
  add_number(*command, "--seed", options->seed, {0, 2147483647}, "seed");
  add_number(*command, "--exposure", options->exposure_ev, {-60, 60, "stops"}, "for .png");
  command->add_flag("--additive", options->additive, "Debevec's additive form instead of the ratio");
  add_mesh_options(command, options->mesh);
  command->callback([options] { run_composite(*options); });
}

}  // namespace

void add_workbench_commands(CLI::App& app) {
  auto capture_options = std::make_shared<CaptureOptions>();
  CLI::App* capture = app.add_subcommand("capture", "capture a panoramic depth map of a scene file");
  capture->add_option("scene", capture_options->scene, ".glb, .gltf or builtin:NAME")->required();
  add_number(*capture, "--width", capture_options->width_px, {2, 16384, "px"},
             "width W; the height is W / 2");
  add_number(*capture, "--yaw", capture_options->yaw_texels, any_yaw_texels,
             "by which the sampling grid turns");
  const CLI::Option* at = add_number(*capture, "--at", capture_options->at, any_place_m,
                                     "centre X Y Z (default: the scene's camera)");
  capture->add_option("--out", capture_options->out, "depth map to write (.exr)")->required();
  capture->callback([capture_options, at] {
    capture_options->at_given = at->count() > 0;
    run_capture(*capture_options);
  });

  auto mesh_options = std::make_shared<MeshCommandOptions>();
  CLI::App* mesh = app.add_subcommand("mesh", "rebuild the local scene's mesh from a depth map");
  mesh->add_option("depth", mesh_options->depth, "equirectangular depth map (.exr, metres)")->required();
  mesh->add_option("--out", mesh_options->out, "mesh to write (.glb)")->required();
  add_mesh_options(mesh, *mesh_options);
  mesh->callback([mesh_options] { run_mesh(*mesh_options); });

  add_composite(app);
}

}  // namespace seamline::renderer
