#include "commands/photographs/photograph_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands/photographs/sun_options.h"
#include "support/files/assets.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"
#include "x3d/x3d_export.h"

namespace seamline::renderer {
namespace {

using Three = std::array<double, 3>;

constexpr std::initializer_list<const char*> of_scenes = {
    "--object", "--position",       "--rotation", "--scale",  "--height",
    "--at",     "--look-at",        "--fov",      "--size",   "--environment",
    "--to-sun", "--sun-irradiance", "--bounces",  "--albedo", "--exposure"};
constexpr std::initializer_list<const char*> of_sets = {"--stimulus", "--asset-root"};

struct X3dOptions {
  X3dRequest request;
  std::string folder, object, size = "640x360";
  Three position_m{0, 0, 0}, rotation_deg{0, 0, 0}, at_m{0, 0, 0}, look_at_m{0, 0, -1}, environment{1, 1, 1};
  SunOptions sun;
  double scale = 1, height_m = 1, exposure_ev = 0, albedo = 0.5;
  int bounces = 4;
};

Eigen::Vector3d option_vector(const Three& v) {
  return {v[0], v[1], v[2]};
}

void refuse(const CLI::App& command, std::initializer_list<const char*> names, const std::string& wanted,
            const std::string& found) {
  for (const char* name : names)
    if (command.get_option(name)->count() > 0)
      throw input_error({.field = name, .wanted = wanted, .found = found});
}

PlacedModel model_of(const X3dOptions& options, bool has_height) {
  PlacedModel model;
  model.file = options.object;
  model.path = resolve_named_file(options.object, "--object");
  model.position_m = option_vector(options.position_m);
  model.rotation_deg = option_vector(options.rotation_deg);
  model.scale = options.scale;
  model.materials = MaterialModel::diffuse;
  if (has_height) {
    model.height_m = options.height_m;
    model.stands = true;
  }
  return model;
}

void take_scene(const X3dOptions& options, const CLI::App& command, X3dRequest& request) {
  const auto given = [&](const char* name) { return command.get_option(name)->count() > 0; };
  if (given("--object")) request.object = model_of(options, given("--height"));
  const auto size = whole_pair(options.size, 'x');
  request.width_px = size->first;
  request.height_px = size->second;
  SceneDefinition& light = request.light;
  light.name = "x3d";
  light.environment_radiance = options.environment;
  light.bounces = options.bounces;
  light.albedo = options.albedo;
  light.exposure_ev = options.exposure_ev;
  if (given("--at")) {
    light.camera = CameraDefinition{option_vector(options.at_m), option_vector(options.look_at_m)};
    const Eigen::Vector3d view = light.camera->look_at_m - light.camera->position_m;
    if (!(view.cross(Eigen::Vector3d::UnitY()).norm() > 1e-9 * view.norm()))
      throw input_error({.field = "--look-at",
                         .wanted = "a point that is not straight above, below or at --at",
                         .found = "one that is"});
  }
  if (given("--to-sun")) light.sun = sun_of(options.sun);
}

void run_x3d(const X3dOptions& options, const CLI::App& command) {
  X3dRequest request = options.request;
  const std::string& source = request.source;
  request.out_folder = options.folder;
  std::error_code error;
  const bool is_set = std::filesystem::is_directory(source, error);
  if (is_set)
    refuse(command, of_scenes, "a scene to export, whose set says all this", "the set " + source);
  else
    refuse(command, of_sets, "a set to export", "the scene " + source);
  if (!is_set) take_scene(options, command, request);
  const X3dSummary summary = export_x3d(request);
  for (const std::string& note : summary.notes) fmt::print("{}\n", printable(note));
  fmt::print("{}: {}, {:.1f} MB; the object has {}, {} of them behind something real\n", options.folder,
             counted(summary.files, "file"), summary.bytes / 1e6, counted(summary.object_pixels, "pixel"),
             summary.hidden_pixels);
}

void check_size(const std::string& text) {
  constexpr int least_px = 16, most_px = 4096;
  const auto size = whole_pair(text, 'x');
  const bool fits = size && size->first >= least_px && size->first <= most_px && size->second >= least_px &&
                    size->second <= most_px;
  if (!fits)
    throw input_error({.field = "--size",
                       .wanted = "a width and a height from 16 to 4096 px, like 640x360",
                       .found = text.empty() ? "nothing" : text});
}

void add_scene_options(CLI::App& command, X3dOptions& options) {
  command.add_option("--object", options.object,
                     "of a scene: what is put into it, .glb, .gltf or builtin:NAME");
  add_number(command, "--position", options.position_m, any_place_m,
             "where the object's origin is (with --height: the middle of its lowest level), in the scene");
  add_number(command, "--rotation", options.rotation_deg, {-1e9, 1e9, "degrees"},
             "of it: pitch about X, yaw about Y, roll about Z");
  CLI::Option* scale = add_number(command, "--scale", options.scale, {1e-9, 1e9}, "of it (1)");
  add_number(command, "--height", options.height_m, {1e-9, 1e9, "m"},
             "in place of --scale: it is so tall, and stands on --position")
      ->excludes(scale);
  CLI::Option* at = add_number(command, "--at", options.at_m, any_place_m,
                               "the camera's place in the scene (the scene's first camera)");
  CLI::Option* look_at =
      add_number(command, "--look-at", options.look_at_m, any_place_m, "the point it looks at; up is +Y");
  at->needs(look_at);
  look_at->needs(at);
  add_number(command, "--fov", options.request.fov_deg, {1, 170, "degrees"},
             "its horizontal field of view (its own, else 60)");
  add_formed_text(command, "--size", options.size, "WxH", "pixels of the photograph (640x360)", check_size);
  add_number(command, "--environment", options.environment, {0, limits::strongest_light, "W/m2/sr"},
             "radiance R G B from every direction (1 1 1)");
  add_sun_options(command, options.sun, "direction towards a sun, in place of the scene's own",
                  "on a plane facing that sun, R G B");
  add_number(command, "--bounces", options.bounces, {0, 1024}, "further scatterings after the first (4)");
  add_number(command, "--albedo", options.albedo, {0, 1}, "of meshes without a material (0.5)");
  add_number(command, "--exposure", options.exposure_ev, {-60, 60, "stops"}, "of the photograph (0)");
}

}  // namespace

void add_x3d_command(CLI::App& group) {
  const auto options = std::make_shared<X3dOptions>();
  CLI::App* command =
      group.add_subcommand("x3d", "a stimulus of a set, or a scene with an object in it, as a page in X3DOM");
  command
      ->add_option("source", options->request.source,
                   "folder of a set, or a scene: .glb, .gltf, builtin:NAME")
      ->required();
  command->add_option("folder", options->folder, "folder for the page")->required();
  command->add_option("--stimulus", options->request.stimulus, "of a set: the stimulus' id (the first)");
  command->add_option("--asset-root", options->request.asset_root,
                      "folder whose scene files the set's study may name besides those below its own folder");
  add_scene_options(*command, *options);
  command->add_option("--user", options->request.user,
                      "a recorded person in the scene: a TOML file of joints (documentation/how-to/x3d.md)");
  add_number(*command, "--spp", options->request.spp, {1, 65536}, "samples per pixel of the photograph (64)");
  add_number(*command, "--seed", options->request.seed, any_seed, "seed of the samples (1)");
  command->callback([options, command] { run_x3d(*options, *command); });
}

}  // namespace seamline::renderer
