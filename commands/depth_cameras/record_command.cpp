#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <memory>

#include "commands/depth_cameras/rig_options.h"
#include "commands/options/setting_option.h"
#include "live/recording/make_recording.h"
#include "raytracer/common/parallel.h"
#include "support/files/assets.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::live {
namespace {

using Coordinates = std::array<double, 3>;

struct RecordOptions {
  std::string scene, preset, out;
  Coordinates at_m{}, look_at_m{0, 0, -1};
  bool has_place = false, angle_given = false, distance_given = false, no_poses = false;
  double noise_scale = 1;
  std::uint64_t seed = 1;
  RigPhotographOptions photograph{.bounces = 2, .spp = 16};
  MakeOptions make;
};

Eigen::Vector3d point_of(const Coordinates& v) {
  return {v[0], v[1], v[2]};
}

/// An option that would be ignored is refused.
void check(const RecordOptions& options) {
  const PathKind kind = options.make.path.kind;
  const auto refuse = [&](const char* option, const char* wanted) {
    throw input_error({.field = option, .wanted = wanted, .found = "--path " + std::string(word(kind))});
  };
  if (options.angle_given && kind != PathKind::orbit) refuse("--angle", "--path orbit beside it");
  if (options.distance_given && kind != PathKind::sweep && kind != PathKind::approach)
    refuse("--distance", "--path sweep or approach beside it");
}

void run_record(RecordOptions options) {
  check(options);
  const sensors::Rig& rig = renderer::preset_rig(options.preset, "--preset");
  const renderer::SceneFile file = renderer::read_scene_file(resolve_named_file(options.scene, "SCENE"));
  SceneDefinition definition;
  definition.name = "record";
  definition.environment_radiance = options.photograph.environment;
  definition.bounces = options.photograph.bounces;
  if (options.has_place) {
    definition.camera = CameraDefinition{point_of(options.at_m), point_of(options.look_at_m)};
    options.make.orbit_m = point_of(options.look_at_m);
  }
  options.make.keeps_poses = !options.no_poses;
  options.make.exposure_ev = options.photograph.exposure_ev;
  const std::uint64_t seed = options.seed;
  options.make.sense = {
      .key = {.seed = seed, .frame = 0},
      .noise_scale = options.noise_scale,
      .photograph = {.spp = options.photograph.spp, .seed = seed, .threads = default_thread_count()}};
  const Recording recording =
      make_recording(file, definition, rig, options.preset, options.make, options.out);
  fmt::print("{}: {}, depth {} x {}, colour {} x {}\n", options.out,
             counted(recording.frames.size(), "frame"), rig.depth.width_px, rig.depth.height_px,
             rig.colour.width_px, rig.colour.height_px);
}

}  // namespace

void add_record_command(CLI::App& app) {
  auto options = std::make_shared<RecordOptions>();
  CLI::App* command =
      app.add_subcommand("record", "depth and colour of a scene as a rig of cameras records them");
  command->add_option("scene", options->scene, ".glb, .gltf or builtin:NAME")->required();
  command->add_option("--preset", options->preset, "preset of a rig (documentation/how-to/sensors.md)")
      ->required();
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  add_number(*command, "--frames", options->make.frames, {1, static_cast<double>(most_recorded_frames)},
             "how many moments")
      ->capture_default_str();
  add_number(*command, "--rate", options->make.frames_per_s, {0.001, 1000}, "frames per second")
      ->capture_default_str();
  add_choice(*command, "--path", options->make.path.kind, every_path_kind, "how the camera moves");
  CLI::Option* angle = add_number(*command, "--angle", options->make.path.angle_deg, {-360, 360, "degrees"},
                                  "of an orbit, from the first frame to the last")
                           ->capture_default_str();
  CLI::Option* distance = add_number(*command, "--distance", options->make.path.distance_m, any_place_m,
                                     "of a sweep or an approach")
                              ->capture_default_str();
  command->add_flag("--without-poses", options->no_poses, "leave out of the index where the camera stood");
  CLI::Option* at = add_rig_place(*command, options->at_m, options->look_at_m);
  at->description("the colour camera's first place (default: the scene's camera)");
  command->get_option("--look-at")->description("the point it looks at, and orbits about");
  add_noise_options(*command, options->noise_scale, options->seed);
  add_photograph_options(*command, options->photograph);
  command->callback([options, at, angle, distance] {
    options->has_place = at->count() > 0;
    options->angle_given = angle->count() > 0;
    options->distance_given = distance->count() > 0;
    run_record(*options);
  });
}

}  // namespace seamline::live
