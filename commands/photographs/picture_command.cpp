#include "commands/photographs/photograph_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>

#include "commands/options/command_help.h"
#include "commands/options/output_files.h"
#include "commands/options/setting_option.h"
#include "commands/photographs/mesh_options.h"
#include "commands/photographs/sun_options.h"
#include "commands/photographs/transparent_option.h"
#include "commands/photographs/view_options.h"
#include "composites/objects/objects_file.h"
#include "composites/objects/photo_objects.h"
#include "composites/photograph.h"
#include "raytracer/common/parallel.h"
#include "raytracer/light/bright_patches.h"
#include "raytracer/scene/eyes.h"
#include "raytracer/scene/scene_surfaces.h"
#include "raytracer/scene/truth_scene.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/estimators/rig_photograph.h"
#include "renderer/views/depth_image.h"
#include "renderer/views/view_picture.h"
#include "support/files/assets.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::renderer {
namespace {

using Three = std::array<double, 3>;

constexpr double usual_picture_fov_deg = 50;

struct PictureOptions {
  std::string scene, out, transparent, environment_map, objects;
  MaterialModel materials = MaterialModel::gltf;
  Three at_m{0, 0, 0}, look_at_m{0, 0, -1}, environment{0, 0, 0};
  SunOptions sun;
  std::optional<double> fov_deg;
  double rotation_deg = 0, albedo = 0.5, exposure_ev = 0;
  int width_px = 960, height_px = 540, bounces = 4, spp = 64;
  std::uint64_t seed = 1;
  bool has_place = false, has_sun = false, panorama = false;
  ViewOptions view;
};

Eigen::Vector3d vector_of(const Three& v) {
  return {v[0], v[1], v[2]};
}

/// A view from the front, to the right and above, that holds the whole scene.
CameraDefinition framing_camera(const SceneFile& file, const PictureOptions& options) {
  Eigen::AlignedBox3d box;
  for (const FileMesh& mesh : file.meshes)
    for (const Eigen::Vector3d& place_m : mesh.positions_m) box.extend(place_m);
  const double fov_deg = options.fov_deg.value_or(usual_picture_fov_deg);
  const double tangent = std::tan(0.5 * fov_deg * std::numbers::pi / 180);
  const double smaller = std::min(1.0, static_cast<double>(options.height_px) / options.width_px) * tangent;
  const double radius_m = std::max(0.5 * box.diagonal().norm(), 1e-6);
  const double distance_m =
      radius_m * std::sqrt(1 + 1 / (smaller * smaller));  // radius / sin of half the view
  const Eigen::Vector3d from = Eigen::Vector3d(0.45, 0.35, 1).normalized();
  return {box.center() + distance_m * from, box.center(), fov_deg};
}

/// The camera that was given, or the one that frames the scene; none: the file's own.
std::optional<CameraDefinition> camera_of(const SceneFile& file, const PictureOptions& options) {
  if (!options.has_place) {
    if (file.camera) return std::nullopt;
    return framing_camera(file, options);
  }
  const CameraDefinition camera{vector_of(options.at_m), vector_of(options.look_at_m),
                                options.fov_deg.value_or(usual_picture_fov_deg)};
  const Eigen::Vector3d view = camera.look_at_m - camera.position_m;
  if (!(view.cross(Eigen::Vector3d::UnitY()).norm() > 1e-9 * view.norm()))
    throw input_error({.field = "--look-at",
                       .wanted = "a point that is not straight above, below or at --at",
                       .found = "one that is"});
  return camera;
}

SceneDefinition scene_of(const PictureOptions& options, const std::filesystem::path& path) {
  SceneDefinition scene;
  scene.name = "picture";
  scene.path = path;
  scene.materials = options.materials;
  scene.environment_radiance = options.environment;
  scene.bounces = options.bounces;
  scene.albedo = options.albedo;
  if (options.has_sun) scene.sun = sun_of(options.sun);
  if (!options.environment_map.empty())
    scene.environment = EnvironmentDefinition{
        .file = options.environment_map,
        .path = resolve_named_file(options.environment_map, "--environment-map", BuiltinKind::environment),
        .rotation_deg = options.rotation_deg};
  return scene;
}

void require_light(const Light& light, const PictureOptions& options) {
  const bool shines = !light.suns.empty() || !light.lamps.empty() || light.environment != nullptr ||
                      light.emitters != nullptr || (light.environment_radiance > 0.0F).any();
  if (!shines)
    throw input_error({.file = options.scene,
                       .wanted = "a light, a lamp or a surface that emits, or one of --environment, "
                                 "--environment-map and --to-sun with --sun-irradiance",
                       .found = "none"});
}

/// The view that nobody gave, in the words of the options.
void print_framing(const SceneFile& file, const std::optional<CameraDefinition>& camera) {
  if (!camera) return;  // the file's own
  const double size_m = (camera->position_m - camera->look_at_m).norm();
  const auto place = [&](const Eigen::Vector3d& at) {
    const Eigen::Vector3d v = (at.array().abs() < 1e-5 * size_m).select(0.0, at);  // what rounding leaves
    return fmt::format("{:.4g} {:.4g} {:.4g}", v.x(), v.y(), v.z());
  };
  fmt::print("{} has no camera, so the whole scene is shown: --at {} --look-at {} --fov {:.4g}\n",
             printable(file.file), place(camera->position_m), place(camera->look_at_m),
             camera->horizontal_fov_deg);
  std::fflush(stdout);
}

/// What stands in the scene besides, as `composite` would put it there: places are from the camera.
void add_objects(const PictureOptions& options, const Eigen::Vector3d& centre_m,
                 std::vector<std::shared_ptr<const SurfaceMesh>>& meshes) {
  if (options.objects.empty()) return;
  ObjectsFile file = read_objects_file(options.objects, {});
  if (file.has_light || file.added)
    throw input_error({.file = options.objects,
                       .field = "light",
                       .wanted = "objects alone: the scene has its own light",
                       .found = "light"});
  for (PlacedModel& model : file.objects) {
    if (!model.has_place)
      throw input_error({.file = options.objects,
                         .field = "position_m",
                         .wanted = "where each object is: only `composite` puts one into the view's middle",
                         .found = "none of " + printable(model.file)});
    if (model.rest)
      throw input_error({.file = options.objects,
                         .field = "rest",
                         .wanted = "objects that stay at their place: things come to rest in `composite`",
                         .found = "true"});
    model.position_m += centre_m;
    if (model.transparency == Transparency::refused)
      model.transparency = transparency_of(options.transparent).value_or(Transparency::refused);
  }
  const PhotoObjects placed = place_objects(file.objects, centre_m);
  for (const std::string& sentence : placed.left_out) fmt::print("{}\n", sentence);
  meshes.insert(meshes.end(), placed.meshes.begin(), placed.meshes.end());
}

/// What the options stand for of the file's own camera and lights.
std::vector<std::string> unused_of_file(const SceneFile& file, const PictureOptions& options) {
  std::vector<std::string> unused;
  if (file.camera && options.has_place) unused.emplace_back("its camera (--at stands for it)");
  if (!file.suns.empty() && options.has_sun) unused.emplace_back("its suns (--to-sun stands for them)");
  return unused;
}

void print_left_out(const SceneFile& file, const PictureOptions& options) {
  if (const std::string sentence = left_out_sentence(file, unused_of_file(file, options)); !sentence.empty())
    fmt::print("{}\n", sentence);
  if (file.left_out_of_diffuse.empty()) return;
  std::string names;
  for (const std::string& one : file.left_out_of_diffuse)
    names += (names.empty() ? "" : ", ") + printable(one);
  fmt::print("{} has {}, which --materials diffuse leaves out\n", printable(file.file), names);
}

/// Of several eyes, or with depth.
void require_room(const PictureOptions& options, const View& view) {
  if (view.is_mono()) return;
  if (options.panorama)
    throw input_error({.field = "--view",
                       .wanted = "no --panorama beside it, which looks everywhere from one place",
                       .found = "both"});
  if (options.width_px % view.squeeze() != 0)
    throw input_error({.field = "--width",
                       .wanted = "an even width for --view " + options.view.kind,
                       .found = std::to_string(options.width_px)});
  if (view.eyes() * (options.width_px / view.squeeze()) > limits::largest_picture_side_px)
    throw input_error({.field = "--views",
                       .wanted = fmt::format("at most {} columns in all eyes' pictures together",
                                             limits::largest_picture_side_px),
                       .found = fmt::format("{} views of {}", view.eyes(), options.width_px)});
  if (view.kind == ViewKind::depth_image && lower_case_ending(options.out) != ".png")
    throw input_error({.field = "--out",
                       .wanted = "a .png, because such depth is of 8 bits",
                       .found = printable(options.out)});
}

void run_picture(const PictureOptions& options) {
  const View view = view_of(options.view);
  require_room(options, view);
  if (options.panorama && options.width_px != 2 * options.height_px)
    throw input_error({.field = "--height",
                       .wanted = "half of --width, of a panorama",
                       .found = fmt::format("{} x {}", options.width_px, options.height_px)});
  if (options.panorama && options.fov_deg)
    throw input_error(
        {.field = "--fov", .wanted = "no --panorama beside it, which looks everywhere", .found = "both"});
  const std::filesystem::path path = resolve_named_file(options.scene, "SCENE");
  SceneDefinition scene = scene_of(options, path);
  const Transparency transparency = transparency_of(options.transparent).value_or(Transparency::refused);
  const SceneFile file = read_scene_file(path, scene.materials, transparency);
  require_surface(file, options.scene, "a scene");
  scene.camera = camera_of(file, options);
  Eigen::Vector3d centre_m;
  Camera camera = scene_camera(scene, file, options.width_px, options.height_px, centre_m);
  if (options.fov_deg)
    camera.tan_half_horizontal =
        static_cast<float>(std::tan(0.5 * *options.fov_deg * std::numbers::pi / 180));
  auto meshes = place_meshes(file, Eigen::Affine3d::Identity(), centre_m, scene.albedo, 0);
  add_objects(options, centre_m, meshes);
  Light light = scene_light(scene, file, centre_m);
  add_emitters(meshes, light);
  require_light(light, options);
  if (!options.has_place) print_framing(file, scene.camera);
  print_left_out(file, options);
  const Geometry geometry(meshes);
  add_bright_patches(meshes, geometry, light);
  const double fov_deg =
      2 * std::atan(static_cast<double>(camera.tan_half_horizontal)) * 180 / std::numbers::pi;
  Progress progress("picture", 1.0);
  const PhotographOptions how{.spp = options.spp,
                              .seed = options.seed,
                              .threads = default_thread_count(),
                              .progress = [&, last = 0.0](double share) mutable {
                                progress.advance(share - last, "");
                                last = share;
                              }};
  Image planar_m;
  if (!view.is_mono()) camera = view_camera(camera, view);
  if (view.kind == ViewKind::depth_image)
    planar_m = planar_depth_m(camera, [&](const Ray& ray) {
      const auto hit = geometry.nearest(ray);
      return hit ? std::optional(hit->distance_m) : std::nullopt;
    });
  const Image picture =
      !view.is_mono() ? compose_view(view, photograph_scene(geometry, light, camera, how))
      : options.panorama
          ? photograph_scene(geometry, light, panorama_camera(options.width_px, options.height_px), how)
          : photograph_scene(geometry, light,
                             sensors::pinhole_of_field_of_view(options.width_px, options.height_px, fov_deg),
                             world_from_photograph(camera), how);
  if (lower_case_ending(options.out) == ".exr")
    write_picture_exr(options.out, picture);
  else
    write_png(options.out, shown_bytes(view, picture, options.exposure_ev, planar_m));
}

void add_camera_options(CLI::App& command, PictureOptions& options) {
  CLI::Option* at =
      add_number(command, "--at", options.at_m, any_place_m,
                 "the camera's place in the scene (default: the scene's first camera; without one, "
                 "a view of the whole scene)");
  CLI::Option* look_at =
      add_number(command, "--look-at", options.look_at_m, any_place_m, "the point it looks at; up is +Y");
  at->needs(look_at);
  look_at->needs(at);
  add_number(command, "--fov", options.fov_deg, {1, 170, "degrees"},
             "horizontal field of view (default: the camera's own, else 50)");
  command.add_flag(
      "--panorama", options.panorama,
      "all directions from the camera's place, equirectangular, +Y up, the middle column towards -Z; "
      "--height is then half of --width");
  add_number(command, "--width", options.width_px, {1, limits::largest_picture_side_px, "px"},
             "of the picture")
      ->capture_default_str();
  add_number(command, "--height", options.height_px, {1, limits::largest_picture_side_px, "px"},
             "of the picture")
      ->capture_default_str();
}

void add_light_options(CLI::App& command, PictureOptions& options) {
  CLI::Option* constant =
      add_number(command, "--environment", options.environment, {0, limits::strongest_light, "W/m2/sr"},
                 "radiance R G B from every direction")
          ->capture_default_str();
  CLI::Option* map = command.add_option(
      "--environment-map", options.environment_map,
      "radiance by direction: .exr, .hdr or builtin:NAME, equirectangular, +Y up, its middle "
      "column towards -Z");
  map->excludes(constant);
  add_number(command, "--environment-rotation", options.rotation_deg, {-360, 360, "degrees"},
             "of the map about +Y, counter-clockwise seen from above")
      ->capture_default_str()
      ->needs(map);
  add_sun_radius_option(
      command, options.sun,
      add_sun_options(command, options.sun, "direction towards a sun, in place of the scene's own",
                      "on a plane facing that sun, R G B"));
}

}  // namespace

void add_picture_command(CLI::App& app) {
  auto options = std::make_shared<PictureOptions>();
  CLI::App* command =
      app.add_subcommand("picture", "a scene file alone, with its own camera, lights and materials");
  command->add_option("scene", options->scene, ".glb, .gltf or builtin:NAME")->required();
  command->add_option("--out", options->out, "picture to write: .png for the screen, .exr of linear radiance")
      ->required();
  command->add_option("--objects", options->objects,
                      "TOML file of objects that stand in the scene, too, as composite --objects reads it: "
                      "places are metres from the camera");
  add_camera_options(*command, *options);
  add_view_options(*command, options->view);
  add_light_options(*command, *options);
  add_choice(*command, "--materials", options->materials,
             std::array{MaterialModel::gltf, MaterialModel::diffuse},
             "gltf: metals, gloss and normal maps; diffuse: base colours alone");
  add_transparent_option(*command, options->transparent, "of the scene and the objects");
  add_number(*command, "--albedo", options->albedo, {0, 1}, "of meshes without a material")
      ->capture_default_str();
  add_number(*command, "--bounces", options->bounces, {0, 1024}, "further scatterings after the first")
      ->capture_default_str();
  add_number(*command, "--spp", options->spp, {1, 65536}, "samples per pixel")->capture_default_str();
  add_number(*command, "--seed", options->seed, any_seed, "seed of the samples")->capture_default_str();
  add_number(*command, "--exposure", options->exposure_ev, {-60, 60, "stops"}, "for .png")
      ->capture_default_str();
  group_options(*command, {{"Several eyes",
                            {"--view", "--separation", "--zero-parallax", "--views", "--pitch", "--slant",
                             "--offset", "--anaglyph", "--max-depth"}}});
  command->callback([options, command] {
    options->has_place = command->get_option("--at")->count() > 0;
    options->has_sun = command->get_option("--to-sun")->count() > 0;
    need_extension(options->out, {".png", ".exr"});
    require_outputs(*command, {"--out"});
    run_picture(*options);
  });
}

}  // namespace seamline::renderer
