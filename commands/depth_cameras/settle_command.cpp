#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <numbers>

#include "commands/depth_cameras/rig_options.h"
#include "commands/options/output_files.h"
#include "laboratory/settling/sensed_depth.h"
#include "laboratory/settling/shake_report.h"
#include "physics/body_shape.h"
#include "raytracer/scene/resting_object.h"
#include "raytracer/scene/truth_scene.h"
#include "registration/files/camera_file.h"
#include "renderer/depth/gltf_write.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "sensors/files/depth_file.h"
#include "sensors/repair/repair.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/held/prepared_folder.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

using Coordinates = std::array<double, 3>;
using sensors::DepthFrame;

struct SettleOptions {
  DepthSubject sensed;
  std::string camera, object, filter = "none", out;
  std::vector<std::string> depth;
  Coordinates position_m{}, rotation_deg{};
  double scale = 1, ball_m = 0.1, tolerance_m = 0.03;
  bool has_look = false, has_ball = false, has_scale = false, has_noise = false;
  FallRequest fall;
};

Eigen::Vector3d settle_place_m(const Coordinates& v) {
  return {v[0], v[1], v[2]};
}

void refuse(const char* option, const char* wanted, const std::string& found) {
  throw input_error({.field = option, .wanted = wanted, .found = found});
}

void check(const SettleOptions& options) {
  if (options.sensed.scene.empty() == options.depth.empty())
    refuse("--depth", "one of SCENE and --depth FILES", options.sensed.scene.empty() ? "neither" : "both");
  if (options.object.empty() != options.has_ball)
    refuse("--object", "one of --object FILE and --ball RADIUS", options.has_ball ? "both" : "neither");
  if (!options.sensed.scene.empty() && options.sensed.sensor.empty())
    refuse("--sensor", "a sensor that looks at the scene", "none");
  if (options.has_ball && options.has_scale) refuse("--scale", "--object beside it", "--ball");
  if (!options.depth.empty()) {
    if (options.has_noise) refuse("--noise and --seed", "a SCENE beside them", "--depth");
    if (options.camera.empty()) refuse("--camera", "the camera file of the depth", "none");
    if (!options.sensed.sensor.empty()) refuse("--sensor", "a SCENE beside it", "--depth");
    if (options.sensed.has_place)
      refuse("--at", "a SCENE beside it: depth files are placed by their camera", "--depth");
  } else if (!options.camera.empty()) {
    refuse("--camera", "--depth beside it", "a SCENE, with --sensor");
  }
  if (options.sensed.has_place && !options.has_look) refuse("--at", "--look-at beside it", "none");
  if (options.fall.physics.steps_per_s % options.fall.frames_per_s != 0)
    refuse("--steps", "whole steps a frame: a multiple of --fps",
           fmt::format("{} steps at {} frames a second", options.fall.physics.steps_per_s,
                       options.fall.frames_per_s));
}

/// Files are frames, and stay the last one's when they end. Where the camera's file knows where it stands is
/// not asked: places are the photograph's, right, up and back, as `composite` has them where no pose is
/// stated.
SensedDepth depth_of_files(const SettleOptions& options) {
  const bool preset = registration::is_preset(options.camera) && !std::filesystem::exists(options.camera);
  const registration::RegistrationRig rig =
      registration::registration_rig(preset ? registration::camera_file_of_preset(options.camera, "--camera")
                                            : registration::read_camera_file(options.camera),
                                     options.camera);
  SceneDefinition scene;
  scene.camera = CameraDefinition{{0, 0, 0}, settle_place_m(options.sensed.look_at_m)};
  Eigen::Vector3d centre_m;
  const Camera axes = scene_camera(scene, {}, rig.colour.width_px, rig.colour.height_px, centre_m);
  SensedDepth depth;
  depth.world_from_depth = world_from_photograph(axes) * rig.colour_from_depth;
  depth.measured = [files = options.depth, form = rig.depth_form](int frame) {
    const std::size_t last = files.size() - 1;
    return sensors::read_depth_file(files[std::min(last, static_cast<std::size_t>(frame))], form).frame;
  };
  return depth;
}

DepthSequence filtered(const SettleOptions& options, const DepthSequence& measured) {
  if (options.filter == "none") return measured;
  return [=](int frame) {
    return sensors::repair(measured(frame), sensors::MedianRepair{.radius_px = 1, .fills = false}).frame;
  };
}

DepthSequence with_planes(const SettleOptions& options, const DepthSequence& measured) {
  return [=, tolerance_m = options.tolerance_m](int frame) {
    return sensors::replace_planes(measured(frame), {.tolerance_m = tolerance_m}).repaired.frame;
  };
}

/// A ball as a file, for `composite`.
void write_ball(const std::filesystem::path& path, double radius_m) {
  constexpr int rows = 96, columns = 2 * rows;
  DepthMesh ball;
  for (int row = 0; row <= rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double polar = std::numbers::pi * row / rows, around = 2 * std::numbers::pi * column / columns;
      ball.vertices_m.emplace_back(
          (radius_m * Eigen::Vector3d(std::sin(polar) * std::cos(around), std::cos(polar),
                                      -std::sin(polar) * std::sin(around)))
              .cast<float>());
    }
  const auto number = [](int row, int column) {
    return static_cast<std::uint32_t>(row * columns + column % columns);
  };
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      if (row > 0)
        ball.triangles.push_back({number(row, column), number(row + 1, column), number(row, column + 1)});
      if (row + 1 < rows)
        ball.triangles.push_back(
            {number(row, column + 1), number(row + 1, column), number(row + 1, column + 1)});
    }
  write_depth_mesh(path, ball);
}

BodyShape shape_of(const SettleOptions& options) {
  if (options.has_ball) return BallShape{Eigen::Vector3d::Zero(), options.ball_m};
  const SceneFile file = read_scene_file(resolve_named_file(options.object, "--object"));
  return body_shape_of(scaled_vertices_m(file, options.scale), "--object");
}

std::vector<StepShake> shake_by_steps(const DepthSequence& exact, FallRequest request, Progress& progress) {
  std::vector<StepShake> out;
  for (const int steps : {2, 4, 8, 16}) {
    request.physics.steps_per_s = steps * request.frames_per_s;
    request.name = "exact";
    const Fall fall = fall_on(exact, request, [&] { progress.advance(1, "exact depth, by steps"); });
    out.push_back({request.physics.steps_per_s, fall.jump_mm});
  }
  return out;
}

void run_settle(const SettleOptions& options) {
  check(options);
  require_physics();
  require_gnuplot();
  const std::filesystem::path folder = options.out;
  FallRequest request = options.fall;
  request.shape = shape_of(options);
  request.world_from_body =
      Eigen::Isometry3d(object_placement({.name = {},
                                          .file = {},
                                          .path = {},
                                          .position_m = settle_place_m(options.position_m),
                                          .rotation_deg = settle_place_m(options.rotation_deg)})
                            .matrix());
  const SensedDepth depth = options.depth.empty() ? sense_depth(options.sensed) : depth_of_files(options);
  request.world_from_depth = depth.world_from_depth;
  if (depth.may_be_z_up)
    request.when_lost = "glTF is Y-up, and the file may be Z-up (export it again with +Y up)";
  const PreparedFolder prepared(folder);
  const DepthSequence measured = filtered(options, depth.measured);
  std::vector<std::pair<std::string, DepthSequence>> sequences = {{"measured", measured},
                                                                  {"planes", with_planes(options, measured)}};
  if (depth.exact) sequences.emplace_back("exact", *depth.exact);
  constexpr std::size_t runs_by_steps = 4;
  const std::size_t runs = sequences.size() + (depth.exact ? runs_by_steps : 0);
  Progress progress("settle", static_cast<double>(request.frames_to_rest + request.frames) * runs);
  std::vector<Fall> falls;
  for (const auto& [name, sequence] : sequences) {
    request.name = name;
    falls.push_back(fall_on(sequence, request, [&, &of = name] { progress.advance(1, of + " depth"); }));
  }
  const std::vector<StepShake> by_steps =
      depth.exact ? shake_by_steps(*depth.exact, request, progress) : std::vector<StepShake>{};
  if (options.has_ball) write_ball(folder / "ball.glb", options.ball_m);
  write_falls(folder, falls, by_steps, request,
              fmt::format("{} on {}, {} steps a second", options.has_ball ? "A ball" : options.object,
                          options.depth.empty() ? options.sensed.scene + " seen by " + options.sensed.sensor
                                                : fmt::format("{} depth maps", options.depth.size()),
                          request.physics.steps_per_s));
  for (const Fall& fall : falls) fmt::print("{}\n", fall_sentence(fall));
  for (const StepShake& other : by_steps)
    fmt::print("exact     at {} steps a second: from frame to frame {:.4g} mm\n", other.steps_per_s,
               other.jump_mm);
  fmt::print("{}\n", options.out);
}

void add_body_options(CLI::App& command, SettleOptions& options) {
  command.add_option("--object", options.object,
                     "what falls: .glb, .gltf or builtin:NAME; its convex hull touches");
  add_number(
      command, "--position", options.position_m, any_place_m,
      "where its origin is let go: in the scene's world; with --depth from the photograph's camera, right, "
      "up, back");
  add_number(command, "--rotation", options.rotation_deg, {-1e9, 1e9, "degrees"}, "pitch, yaw and roll")
      ->capture_default_str();
  add_number(command, "--scale", options.scale, {1e-9, 1e9}, "of the object")->capture_default_str();
  PhysicsSettings& physics = options.fall.physics;
  add_number(command, "--steps", physics.steps_per_s, {1, 100000, "1/s"}, "steps of the physics a second")
      ->capture_default_str();
  add_number(command, "--friction", physics.friction, {0, 100}, "between body and ground")
      ->capture_default_str();
  add_number(command, "--fps", options.fall.frames_per_s, {1, 1000, "1/s"}, "depth frames a second")
      ->capture_default_str();
  add_number(command, "--frames", options.fall.frames, {2, 100000}, "over which the shake is taken")
      ->capture_default_str();
  add_number(command, "--frames-to-rest", options.fall.frames_to_rest, {0, 100000}, "before those")
      ->capture_default_str();
}

}  // namespace

void add_settle_command(CLI::App& app) {
  auto options = std::make_shared<SettleOptions>();
  CLI::App* command =
      app.add_subcommand("settle", "let a body fall on depth; how much it shakes (needs Bullet)");
  command->add_option("scene", options->sensed.scene, ".glb, .gltf or builtin:NAME; or --depth");
  command->add_option("--sensor", options->sensed.sensor,
                      "what sees the scene: preset of a rig (documentation/how-to/sensors.md)");
  CLI::Option* at = add_number(*command, "--at", options->sensed.at_m, any_place_m,
                               "the colour camera's place (default: the scene's camera)");
  CLI::Option* look_at =
      add_number(*command, "--look-at", options->sensed.look_at_m, any_place_m, "the point it looks at");
  add_noise_options(*command, options->sensed.noise_scale, options->sensed.seed);
  command->add_option("--depth", options->depth,
                      "in place of a scene: depth maps, one a frame, as register reads them");
  command->add_option("--camera", options->camera,
                      "of --depth: the camera file (documentation/how-to/registration.md) or preset");
  command
      ->add_option("--filter", options->filter,
                   "what is done to measured depth first: none, or the median of 3 x 3")
      ->check(CLI::IsMember({"none", "median"}))
      ->capture_default_str();
  add_number(*command, "--plane-tolerance", options->tolerance_m, {1e-6, 10, "m"},
             "what lies so near to a plane is replaced by it")
      ->capture_default_str();
  CLI::Option* ball = add_number(*command, "--ball", options->ball_m, {1e-3, 100, "m"},
                                 "a ball of this radius falls, in place of --object");
  add_body_options(*command, *options);
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  command->callback([options, command, at, look_at, ball] {
    options->sensed.has_place = at->count() > 0;
    options->has_look = look_at->count() > 0;
    options->has_ball = ball->count() > 0;
    options->has_scale = command->count("--scale") > 0;
    options->has_noise = command->count("--noise") + command->count("--seed") > 0;
    std::vector<std::string> files{"poses.csv", "shake.csv", "data_dictionary.csv", "shake.svg"};
    if (options->has_ball) files.emplace_back("ball.glb");
    require_outputs_in_folder(*command, files);
    run_settle(*options);
  });
}

}  // namespace seamline::renderer
