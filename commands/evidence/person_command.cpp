#include "commands/evidence/evidence_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>

#include "laboratory/person/person_scene.h"
#include "laboratory/person/skeleton_picture.h"
#include "raytracer/common/parallel.h"
#include "raytracer/scene/truth_scene.h"
#include "registration/pictures/depth_picture.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "sensors/rig/presets.h"
#include "support/arithmetic/random.h"
#include "support/files/atomic_file.h"
#include "support/text/counted.h"
#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

struct PersonOptions {
  std::string sensor = "structured_light_640x480", out;
  double joint_noise_m = 0, noise_scale = 1;
  std::uint64_t seed = 1;
};

const sensors::Rig& rig_of(const PersonOptions& options) {
  const sensors::SensorPreset& preset = sensors::sensor_preset(options.sensor, "--sensor");
  if (const auto* rig = std::get_if<sensors::Rig>(&preset.sensor)) return *rig;
  throw input_error({.field = "--sensor",
                     .wanted = "a depth camera with a colour camera",
                     .found = options.sensor + ", a scanner"});
}

/// What tracking finds: the joints, each coordinate off by normal noise.
sensors::RecordedUser tracked_user(const PersonScene& person, const PersonOptions& options) {
  sensors::RecordedUser user = user_of(person);
  Random random(options.seed, 1);
  for (auto& joint_m : user.joints_m)
    for (int c = 0; c < 3; ++c) (*joint_m)[c] += options.joint_noise_m * random.normal();
  return user;
}

/// Planted and found angles of every hinge.
CsvTable angle_table(const PersonScene& person, const sensors::SkeletonPose& found) {
  constexpr double deg = 180 / std::numbers::pi;
  CsvTable table{.name = "angles",
                 .columns = {{"joint", "", "by its name"},
                             {"hinge", "", "from 1, in the order in which the joint turns"},
                             {"planted", "degrees", "what the figure was made with"},
                             {"found", "degrees", "by cyclic coordinate descent from the joints' places"}},
                 .rows = {}};
  std::size_t angle = 0;
  for (const sensors::Joint& joint : person.skeleton.joints)
    for (std::size_t h = 0; h < joint.hinges.size(); ++h, ++angle)
      table.rows.push_back({joint.name, static_cast<std::int64_t>(h + 1), deg * person.pose.angles_rad[angle],
                            deg * found.angles_rad[angle]});
  return table;
}

void run_person(const PersonOptions& options) {
  const std::filesystem::path folder = options.out;
  const sensors::Rig& rig = rig_of(options);
  const int threads = default_thread_count();
  prepare_output_folder(folder);
  const PersonScene person = greeting_person();
  write_person_scene(folder / "person.glb", person);
  const SceneFile file = read_scene_file(folder / "person.glb");
  const Geometry truth(place_meshes(file, Eigen::Affine3d::Identity(), Eigen::Vector3d::Zero(), 0.5, 0));
  const Eigen::Isometry3d world_from_depth = world_from_photograph(Camera{}) * rig.colour_from_depth;
  const sensors::SeenFrame seen =
      see_truth(truth, rig.depth, world_from_depth, sight_for(rig.noise, rig.projector_m), threads);
  const sensors::Measurement measured =
      sensors::measure(seen, rig.noise, {options.seed, 0}, options.noise_scale, threads);

  const sensors::RecordedUser user = tracked_user(person, options);
  const sensors::Skeleton skeleton = sensors::with_bones_of(person.skeleton, user.joints_m);
  const sensors::FittedPose fitted = sensors::fit_standing_pose(skeleton, user.joints_m);
  write_file_atomically(folder / "user.toml", sensors::user_file_text(user));
  write_file_atomically(folder / "angles.csv", csv_text(angle_table(person, fitted.pose)));
  write_png(folder / "skeleton.png", skeleton_over_depth(registration::depth_picture(measured.frame),
                                                         measured.frame, user, world_from_depth.inverse()));
  fmt::print(
      "{}: {}; angles by cyclic coordinate descent put them {:.2f} mm from where they were "
      "tracked (root mean square), after {}\n",
      options.out, counted(user.joints_m.size(), "joint"), 1000 * fitted.rms_m,
      counted(fitted.sweeps, "sweep"));
}

}  // namespace

void add_person_command(CLI::App& app) {
  auto options = std::make_shared<PersonOptions>();
  CLI::App* command = app.add_subcommand(
      "person", "a stand-in for a tracked person: a jointed figure in a room, its joints over depth");
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  command->add_option("--sensor", options->sensor, "preset of a rig (documentation/how-to/sensors.md)")
      ->capture_default_str();
  add_number(*command, "--noise", options->noise_scale, {0, 1e6},
             "scale of the sensor's noise; 0: none, its holes stay")
      ->capture_default_str();
  add_number(*command, "--joint-noise", options->joint_noise_m, {0, 1, "m"},
             "standard deviation of every coordinate of the joints, as tracking would have it")
      ->capture_default_str();
  add_number(*command, "--seed", options->seed, any_seed, "seed of the noise")->capture_default_str();
  command->callback([options] { run_person(*options); });
}

}  // namespace seamline::renderer
