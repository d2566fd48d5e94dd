#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>

#include "commands/options/output_files.h"
#include "commands/photographs/mesh_options.h"
#include "sensors/skeleton/figure_motion.h"
#include "support/files/atomic_file.h"
#include "support/text/counted.h"
#include "support/text/csv.h"
#include "support/text/printable.h"

namespace seamline::sensors {
namespace {

struct AnimateOptions {
  std::string figure, joints, out, name = "recorded", gestures, angles;
};

CsvTable turned_table(const RecordedMotion& motion, const FigureMotion& moved) {
  CsvTable table{
      .name = "angles",
      .columns = {{"time", "s", "of the moment"},
                  {"joint", "", "by its name"},
                  {"turned", "degrees", "from the figure's rest, against the joint that holds it"}},
      .rows = {}};
  for (std::size_t t = 0; t < motion.times_s.size(); ++t)
    for (std::size_t j = 0; j < motion.joints.size(); ++j)
      table.rows.push_back({motion.times_s[t], motion.joints[j], moved.turned_deg[j][t]});
  return table;
}

void print_gesture(const Gesture& gesture, const FigureMotion& moved, const std::vector<double>& times_s) {
  std::string when;
  for (const auto& [from_s, to_s] : times_of(gesture, moved, times_s))
    when += fmt::format("{}{:.2f} to {:.2f} s", when.empty() ? "" : ", ", from_s, to_s);
  fmt::print("{}: {}\n", printable(gesture.name), when.empty() ? "never" : when);
}

void run_animate(const AnimateOptions& options) {
  renderer::need_extension(options.out, {".glb"}, "--out");
  const RecordedMotion motion = read_recorded_motion(options.joints);
  std::vector<Gesture> gestures;
  if (!options.gestures.empty()) gestures = read_gestures(options.gestures, motion.joints);
  FigureFile figure(options.figure);
  figure.need_place_of(options.out);
  const FigureMotion moved = move_figure(figure, motion);
  figure.add_animation(options.name, motion.times_s, moved.nodes);
  write_file_atomically(options.out, figure.bytes());
  if (!options.angles.empty()) write_file_atomically(options.angles, csv_text(turned_table(motion, moved)));
  double square = 0, most_m = 0;
  for (const double rms_m : moved.rms_m) square += rms_m * rms_m, most_m = std::max(most_m, rms_m);
  fmt::print("{}: animation \"{}\", {}, {} from {:.2f} to {:.2f} s\n", printable(options.out),
             printable(options.name), counted(motion.joints.size(), "joint"),
             counted(motion.times_s.size(), "moment"), motion.times_s.front(), motion.times_s.back());
  fmt::print(
      "its joints, on its own bones, are {:.1f} mm from the recorded ones (RMS), "
      "{:.1f} mm in the worst moment\n",
      1000 * std::sqrt(square / moved.rms_m.size()), 1000 * most_m);
  for (const Gesture& gesture : gestures) print_gesture(gesture, moved, motion.times_s);
}

}  // namespace

void add_animate_command(CLI::App& app) {
  auto options = std::make_shared<AnimateOptions>();
  CLI::App* command =
      app.add_subcommand("animate", "recorded joints move the nodes or the skin of a .glb file");
  command->add_option("figure", options->figure, "a .glb file, whose nodes have the joints' names")
      ->required();
  command
      ->add_option("joints", options->joints,
                   "table (.csv) of joints in the figure's own metres: time_s, joint, x_m, y_m, z_m")
      ->required();
  command->add_option("--out", options->out, "the file with the animation (.glb)")->required();
  command->add_option("--name", options->name, "of the animation")->capture_default_str();
  command->add_option("--gestures", options->gestures,
                      "say when gestures are made: a file (.toml) of named ranges of angles");
  command->add_option("--angles", options->angles, "also write how far each joint is turned (.csv)");
  command->callback([options, command] {
    require_outputs(*command, {"--out", "--angles"});
    run_animate(*options);
  });
}

}  // namespace seamline::sensors
