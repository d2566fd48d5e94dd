#include "renderer/commands/composite_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <filesystem>
#include <memory>
#include <optional>

#include "registration/files/camera_file.h"
#include "renderer/commands/mesh_options.h"
#include "renderer/common/parallel.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/estimators/photo_composite.h"
#include "renderer/set/set_layers.h"
#include "sensors/files/depth_file.h"
#include "sensors/frame/depth_test.h"
#include "support/files/assets.h"
#include "support/running/progress.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

using Three = std::array<double, 3>;

Eigen::Vector3d as_vector(const Three& v) {
  return {v[0], v[1], v[2]};
}

struct CompositeOptions {
  MeshCommandOptions mesh;
  std::string photograph, object, out, camera, jumps = "stretch", occlusion = "mesh";
  Three position_m{0, 0, -3}, rotation_deg{0, 0, 0}, look_at_m{0, 0, -1}, to_sun{0, 1, 0},
      irradiance{0, 0, 0}, environment{1, 1, 1};
  double scale = 1, fov_deg = 60, sun_radius_deg = 0, albedo = 0.5, exposure_ev = 0, jump_ratio = 1.1;
  sensors::DepthBuffer buffer;
  int bounces = 4, spp = 64, seed = 1;
  bool additive = false;
};

/// Options that mean something only beside others.
struct GivenOptions {
  const CLI::Option *fov = nullptr, *yaw = nullptr, *jumps = nullptr, *jump_ratio = nullptr,
                    *occlusion = nullptr;
  std::vector<const CLI::Option*> buffer;
};

/// An option that would be ignored is refused.
void check_given(const CompositeOptions& options, const GivenOptions& given) {
  const auto refuse = [](const CLI::Option* option, const char* wanted, const std::string& found) {
    if (option->count() > 0)
      throw input_error({.field = option->get_name(), .wanted = wanted, .found = found});
  };
  if (options.camera.empty()) {
    for (const CLI::Option* option : {given.jumps, given.jump_ratio, given.occlusion})
      refuse(option, "--camera beside it: only registered depth has pixels of the photograph", "none");
  } else {
    refuse(given.fov, "no --camera beside it, whose file has the lens", options.camera);
    refuse(given.yaw, "a panoramic depth map", "depth of the camera " + options.camera);
  }
  if (options.jumps != "cut") refuse(given.jump_ratio, "--jumps cut beside it", "--jumps " + options.jumps);
  if (options.occlusion != "depth_buffer")
    for (const CLI::Option* option : given.buffer)
      refuse(option, "--occlusion depth_buffer beside it", "--occlusion " + options.occlusion);
}

SceneDefinition scene_of(const CompositeOptions& options) {
  SceneDefinition scene;
  scene.name = "composite";
  scene.path = options.object;
  scene.sun =
      SunDefinition{as_vector(options.to_sun).normalized(), options.irradiance, options.sun_radius_deg};
  scene.camera = CameraDefinition{Eigen::Vector3d::Zero(), as_vector(options.look_at_m), options.fov_deg};
  scene.environment_radiance = options.environment;
  scene.bounces = options.bounces;
  scene.albedo = options.albedo;
  return scene;
}

void check_directions(const CompositeOptions& options) {
  if (!(as_vector(options.to_sun).norm() > 0))
    throw input_error({.field = "--to-sun", .wanted = "a direction that is not zero", .found = "0 0 0"});
  const Eigen::Vector3d view = as_vector(options.look_at_m);
  if (!(view.cross(Eigen::Vector3d::UnitY()).norm() > 1e-9 * view.norm()))
    throw input_error({.field = "--look-at",
                       .wanted = "a point that is not straight above, below or at the centre",
                       .found = "one that is"});
}

bool covers_a_pixel(const PhotographCamera& camera, const Geometry& object) {
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const Eigen::Vector3f direction =
          camera.direction(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      if (!direction.isZero() && object.nearest({Eigen::Vector3f::Zero(), direction})) return true;
    }
  return false;
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

/// What is known of the photograph's world: whence it was taken, the local scene, and who is in front where
/// the mesh does not say it.
struct PhotographedWorld {
  PhotographCamera camera;
  DepthMesh mesh;
  Occlusion occlusion;
};

/// Depth that `seamline register` wrote: planar metres in the pixels of the colour camera.
sensors::DepthFrame registered_frame(const CompositeOptions& options, const Image& photograph) {
  const bool preset = registration::is_preset(options.camera) && !std::filesystem::exists(options.camera);
  const registration::CameraFile cameras =
      preset ? registration::camera_file_of_preset(options.camera, "--camera")
             : registration::read_camera_file(options.camera);
  const sensors::PinholeCamera colour = registration::registration_rig(cameras, options.camera).colour;
  if (colour.width_px != photograph.width_px || colour.height_px != photograph.height_px)
    throw input_error({.file = options.photograph,
                       .wanted = fmt::format("{} x {} pixels, as the colour camera of {} has",
                                             colour.width_px, colour.height_px, options.camera),
                       .found = fmt::format("{} x {}", photograph.width_px, photograph.height_px)});
  return sensors::read_depth_file(options.mesh.depth, {.camera = colour,
                                                       .convention = sensors::DepthConvention::planar,
                                                       .metres_per_step = std::nullopt,
                                                       .unusual_distances = cameras.unusual_distances})
      .frame;
}

/// Who is in front, pixel for pixel; nothing where the mesh decides.
Occlusion occlusion_of(const CompositeOptions& options, const sensors::DepthFrame& frame,
                       const Eigen::Vector3f& forward) {
  if (options.occlusion == "none")
    return {.hides = [](float, float, const Eigen::Vector3f&) { return false; }, .real_shades_object = false};
  if (options.occlusion == "depth_test")
    return {.hides = [&frame, forward](float x, float y, const Eigen::Vector3f& point_m) {
      return sensors::hides_in_metres(frame, static_cast<double>(x), static_cast<double>(y),
                                      static_cast<double>(forward.dot(point_m)));
    }};
  if (options.occlusion == "depth_buffer")
    return {.hides = [&frame, forward, buffer = options.buffer](float x, float y,
                                                                const Eigen::Vector3f& point_m) {
      return sensors::hides_in_buffer(frame, static_cast<double>(x), static_cast<double>(y),
                                      static_cast<double>(forward.dot(point_m)), buffer);
    }};
  return {};
}

PhotographedWorld world_of_frame(const CompositeOptions& options, const sensors::DepthFrame& frame,
                                 const Camera& axes) {
  const Eigen::Isometry3d world_from_photograph = renderer::world_from_photograph(axes);
  PhotographedWorld world;
  world.camera = {frame.camera.width_px, frame.camera.height_px,
                  [camera = frame.camera, world_from_photograph](float x, float y) -> Eigen::Vector3f {
                    const auto direction = sensors::direction_through(camera, {x, y});
                    if (!direction) return Eigen::Vector3f::Zero();
                    return (world_from_photograph.linear() * *direction).normalized().cast<float>();
                  }};
  world.mesh = build_pixel_mesh(
      pixel_grid({frame, world_from_photograph}, default_thread_count()),
      {.density = density_of(options.mesh),
       .tolerance = options.mesh.tolerance,
       .cut_ratio = options.jumps == "cut" ? std::optional(options.jump_ratio) : std::nullopt,
       .threads = default_thread_count()});
  if (options.occlusion == "depth_buffer")
    require_valid(options.buffer, "--depth-buffer-near and --depth-buffer-far");
  world.occlusion = occlusion_of(options, frame, -axes.axes.col(2));
  return world;
}

void write_composite(const CompositeOptions& options, const StimulusSums& layers) {
  const Composite composite = compose(layers, options.additive ? Compositing::additive : Compositing::ratio);
  if (std::filesystem::path(options.out).extension() == ".exr")
    write_picture_exr(options.out, composite.picture);
  else
    write_png(options.out, display_image(composite.picture, options.exposure_ev));
  fmt::print("{}: {} pixels had too little light for a ratio, {} were clamped\n", options.out,
             composite.tiny_denominators.floored_pixels, composite.tiny_denominators.clamped_pixels);
}

void run_composite(const CompositeOptions& options, const GivenOptions& given) {
  check_given(options, given);
  need_extension(options.out, {".png", ".exr"});
  check_directions(options);
  const Image photograph = read_photograph(options.photograph);
  const SceneDefinition scene = scene_of(options);
  const SceneFile object_file = read_scene_file(resolve_named_file(options.object, "--object"));
  Eigen::Vector3d centre_m;
  const Camera camera = scene_camera(scene, object_file, photograph.width_px, photograph.height_px, centre_m);
  std::optional<sensors::DepthFrame> frame;  // outlives the world, which looks at it
  if (!options.camera.empty()) frame = registered_frame(options, photograph);
  const PhotographedWorld world =
      frame ? world_of_frame(options, *frame, camera)
            : PhotographedWorld{photograph_camera(camera), panorama_mesh_of(options.mesh), {}};
  const Geometry depth(world.mesh, Rgb::Constant(static_cast<float>(options.albedo)));
  const ObjectDefinition placement{.name = {},
                                   .file = {},
                                   .path = {},
                                   .position_m = as_vector(options.position_m),
                                   .rotation_deg = as_vector(options.rotation_deg),
                                   .scale = options.scale};
  const Geometry object(place_meshes(object_file, object_placement(placement), centre_m, options.albedo, 1));
  if (!covers_a_pixel(world.camera, object))
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
  write_composite(options,
                  render_onto_photograph(photograph, depth, object, world.camera,
                                         scene_light(scene, object_file, centre_m), pass, world.occlusion));
}

void add_place_options(CLI::App& command, CompositeOptions& options) {
  add_number(command, "--position", options.position_m, any_place_m,
             "object's place from the panorama's centre, or the camera");
  add_number(command, "--rotation", options.rotation_deg, {-1e9, 1e9, "degrees"}, "pitch yaw roll");
  add_number(command, "--scale", options.scale, {1e-9, 1e9}, "object's scale");
  add_number(command, "--look-at", options.look_at_m, any_place_m,
             "point that the photograph's centre shows, from the same place");
}

void add_light_options(CLI::App& command, CompositeOptions& options) {
  add_number(command, "--to-sun", options.to_sun, {-1e9, 1e9}, "direction towards the sun");
  add_number(command, "--sun-irradiance", options.irradiance, {0, limits::strongest_light, "W/m2"},
             "on a plane facing the sun, R G B");
  add_number(command, "--sun-radius", options.sun_radius_deg, {0, 45, "degrees"},
             "angular radius of the sun");
  add_number(command, "--environment", options.environment, {0, limits::strongest_light, "W/m2/sr"},
             "environment radiance R G B");
  add_number(command, "--albedo", options.albedo, {0, 1}, "albedo of the local scene");
  add_number(command, "--bounces", options.bounces, {0, 1024}, "further diffuse scatterings");
  add_number(command, "--spp", options.spp, {1, 65536}, "samples per pixel");
  add_number(command, "--seed", options.seed, {0, 2147483647}, "seed");
  add_number(command, "--exposure", options.exposure_ev, {-60, 60, "stops"}, "for .png");
  command.add_flag("--additive", options.additive, "Debevec's additive form instead of the ratio");
}

void add_frame_options(CLI::App& command, CompositeOptions& options, GivenOptions& given) {
  command.add_option("--camera", options.camera,
                     "the photograph's camera (TOML file or preset, as of register): then --depth is the "
                     "registered.exr that register writes");
  given.jumps =
      command
          .add_option("--jumps", options.jumps, "where registered depth jumps: stretch a sheet, or cut a gap")
          ->check(CLI::IsMember({"stretch", "cut"}))
          ->capture_default_str();
  given.jump_ratio = add_number(command, "--jump-ratio", options.jump_ratio, {1.0001, 1000},
                                "of depths between which --jumps cut cuts")
                         ->capture_default_str();
  given.occlusion =
      command
          .add_option(
              "--occlusion", options.occlusion,
              "who is in front: the mesh, a depth test in metres a pixel, the same in a depth buffer, "
              "or always the object (none)")
          ->check(CLI::IsMember({"mesh", "depth_test", "depth_buffer", "none"}))
          ->capture_default_str();
  given.buffer = {add_number(command, "--depth-buffer-bits", options.buffer.bits, {8, 32, "bits"},
                             "of --occlusion depth_buffer")
                      ->capture_default_str(),
                  add_number(command, "--depth-buffer-near", options.buffer.nearest_m, {1e-6, 1e9, "m"},
                             "its nearer plane")
                      ->capture_default_str(),
                  add_number(command, "--depth-buffer-far", options.buffer.farthest_m, {1e-6, 1e9, "m"},
                             "its farther plane")
                      ->capture_default_str()};
}

}  // namespace

void add_composite_command(CLI::App& app) {
  auto options = std::make_shared<CompositeOptions>();
  GivenOptions given;
  CLI::App* command = app.add_subcommand("composite", "insert an object into a photograph through its depth");
  command->add_option("--background", options->photograph, "photograph (EXR, HDR, PNG, JPEG)")->required();
  command
      ->add_option("--depth", options->mesh.depth,
                   "depth in metres (.exr): an equirectangular map, or registered to --camera")
      ->required();
  command->add_option("--object", options->object, "object (.glb, .gltf or builtin:NAME)")->required();
  command->add_option("--out", options->out, "picture to write (.png or .exr)")->required();
  add_place_options(*command, *options);
  given.fov = add_number(*command, "--fov", options->fov_deg, {1, 170, "degrees"},
                         "horizontal field of view of the photograph (without --camera)");
  add_light_options(*command, *options);
  add_mesh_options(*command, options->mesh);
  given.yaw = add_yaw_option(*command, options->mesh);
  add_frame_options(*command, *options, given);
  command->callback([options, given] { run_composite(*options, given); });
}

}  // namespace seamline::renderer
