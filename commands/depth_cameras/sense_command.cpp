#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

#include "commands/depth_cameras/rig_options.h"
#include "commands/options/output_files.h"
#include "raytracer/common/parallel.h"
#include "registration/files/camera_file.h"
#include "registration/pictures/depth_picture.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "renderer/estimators/sensed_scene.h"
#include "sensors/noise/measurement.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

using Coordinates = std::array<double, 3>;

struct SenseOptions {
  std::string scene, sensor, out;
  Coordinates at_m{}, look_at_m{0, 0, -1};
  bool has_place = false;
  double noise_scale = 1;
  std::uint64_t seed = 1;
  int frame = 0;
  RigPhotographOptions photograph;
};

Eigen::Vector3d point_of(const Coordinates& v) {
  return {v[0], v[1], v[2]};
}

SceneDefinition scene_of(const SenseOptions& options) {
  SceneDefinition scene;
  scene.name = "sense";
  scene.environment_radiance = options.photograph.environment;
  scene.bounces = options.photograph.bounces;
  if (options.has_place) scene.camera = CameraDefinition{point_of(options.at_m), point_of(options.look_at_m)};
  return scene;
}

/// Planar depth that the colour camera truly sees, which is what `seamline register` is to find out.
std::vector<float> true_registered_m(const SensedScene& scene, const sensors::Rig& rig) {
  const sensors::SeenFrame seen =
      see_truth(scene.truth, rig.colour, scene.world_from_colour, {}, default_thread_count());
  return sensors::true_depth(seen, sensors::DepthConvention::planar).depth_m;
}

/// The value that this share of them does not exceed.
float percentile(std::vector<float> values, double share) {
  const auto at =
      values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Amplitudes for people: the 99th percentile is white.
ByteImage amplitude_picture(const sensors::DepthFrame& frame) {
  const float white = percentile(frame.amplitude, 0.99);
  Image linear(frame.camera.width_px, frame.camera.height_px, 3);
  const float scale = white > 0 ? 1 / white : 0;
  for (std::size_t i = 0; i < frame.amplitude.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c) linear.values[3 * i + c] = frame.amplitude[i] * scale;
  return display_image(linear);
}

Image plane_of(const sensors::PinholeCamera& camera, const std::vector<float>& values) {
  Image image(camera.width_px, camera.height_px, 1);
  image.values = values;
  return image;
}

void print_states(const sensors::Measurement& measured) {
  for (int i = 0; i < sensors::pixel_state_count; ++i) {
    const auto state = static_cast<sensors::PixelState>(i);
    if (measured.count(state) == 0) continue;
    fmt::print("  {:<24}{:>8}  {:5.1f} %\n", sensors::name_of(state), measured.count(state),
               100.0 * measured.count(state) / measured.states.size());
  }
}

void run_sense(const SenseOptions& options) {
  const std::filesystem::path folder = options.out;
  const sensors::Rig& rig = preset_rig(options.sensor, "--sensor");
  const SceneFile file = read_scene_file(resolve_named_file(options.scene, "SCENE"));
  const SensedScene scene = sensed_scene(file, scene_of(options), rig);
  prepare_output_folder(folder);

  Progress progress("colour", 1.0);
  const auto [seen, measured, colour] =
      sense_frame(scene, rig, scene.world_from_colour,
                  {.key = {options.seed, static_cast<std::uint64_t>(options.frame)},
                   .noise_scale = options.noise_scale,
                   .photograph = {.spp = options.photograph.spp,
                                  .seed = options.seed,
                                  .threads = default_thread_count(),
                                  .progress = [&, last = 0.0](double share) mutable {
                                    progress.advance(share - last, "");
                                    last = share;
                                  }}});
  write_exr(folder / "depth.exr", plane_of(rig.depth, measured.frame.depth_m));
  write_exr(folder / "true_depth.exr",
            plane_of(rig.depth, sensors::true_depth(seen, measured.frame.convention).depth_m));
  write_exr(folder / "true_registered.exr", plane_of(rig.colour, true_registered_m(scene, rig)));
  write_png(folder / "depth.png", registration::depth_picture(measured.frame));
  if (!measured.frame.amplitude.empty()) {
    write_exr(folder / "amplitude.exr", plane_of(rig.depth, measured.frame.amplitude));
    write_png(folder / "amplitude.png", amplitude_picture(measured.frame));
    write_exr(folder / "confidence.exr", plane_of(rig.depth, measured.frame.confidence));
  }
  write_picture_exr(folder / "colour.exr", colour);
  write_png(folder / "colour.png", display_image(colour, options.photograph.exposure_ev));
  registration::CameraFile cameras;
  cameras.depth = rig.depth;
  cameras.colour = rig.colour;
  cameras.colour_from_depth = rig.colour_from_depth;
  cameras.convention = measured.frame.convention;
  write_file_atomically(folder / "camera.toml",
                        registration::camera_file_text(cameras, "The rig " + options.sensor));
  fmt::print("{}: {} x {} pixels of depth\n", options.out, rig.depth.width_px, rig.depth.height_px);
  print_states(measured);
}

}  // namespace

void add_sense_command(CLI::App& app) {
  auto options = std::make_shared<SenseOptions>();
  CLI::App* command =
      app.add_subcommand("sense", "what a depth camera and its colour camera deliver of a scene");
  command->add_option("scene", options->scene, ".glb, .gltf or builtin:NAME")->required();
  command->add_option("--sensor", options->sensor, "preset of a rig (documentation/how-to/sensors.md)")
      ->required();
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  CLI::Option* at = add_rig_place(*command, options->at_m, options->look_at_m);
  add_noise_options(*command, options->noise_scale, options->seed);
  add_number(*command, "--frame", options->frame, {0, 2147483647},
             "number of the moment: another one has other noise")
      ->capture_default_str();
  add_photograph_options(*command, options->photograph);
  command->callback([options, at, command] {
    require_outputs_in_folder(
        *command, {"depth.exr", "true_depth.exr", "true_registered.exr", "depth.png", "amplitude.exr",
                   "amplitude.png", "confidence.exr", "colour.exr", "colour.png", "camera.toml"});
    options->has_place = at->count() > 0;
    run_sense(*options);
  });
}

}  // namespace seamline::renderer
