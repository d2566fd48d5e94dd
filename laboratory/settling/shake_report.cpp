#include "laboratory/settling/shake_report.h"

#include <fmt/core.h>

#include <algorithm>

#include "raytracer/scene/resting_object.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"
#include "support/text/csv.h"

namespace seamline::renderer {
namespace {

CsvTable pose_table(const std::vector<Fall>& falls, const FallRequest& request) {
  CsvTable table{
      .name = "poses",
      .columns = {{"depth", "", "on which depth the body lies"},
                  {"frame", "", "of the depth, from 0"},
                  {"time_s", "s", "from when the body is let go to the frame's end"},
                  {"counts", "", "1: this frame is part of the shake; 0: the body was given time to rest"},
                  {"x_m", "m", "position of the object, as position_m of a study"},
                  {"y_m", "m", "likewise, upwards"},
                  {"z_m", "m", "likewise"},
                  {"pitch_deg", "degrees", "rotation about X, as rotation_deg of a study"},
                  {"yaw_deg", "degrees", "about Y"},
                  {"roll_deg", "degrees", "about Z"}},
      .rows = {}};
  for (const Fall& fall : falls)
    for (std::size_t i = 0; i < fall.poses.size(); ++i) {
      const Eigen::Vector3d at = fall.poses[i].translation(), turn = rotation_deg_of(fall.poses[i].linear());
      const std::int64_t frame = i;
      table.rows.push_back({fall.name, frame, static_cast<double>(i + 1) / request.frames_per_s,
                            std::int64_t{frame >= request.frames_to_rest ? 1 : 0}, at.x(), at.y(), at.z(),
                            turn.x(), turn.y(), turn.z()});
    }
  return table;
}

CsvTable shake_table(const std::vector<Fall>& falls, const std::vector<StepShake>& by_steps,
                     const FallRequest& request) {
  CsvTable table{
      .name = "shake",
      .columns = {{"depth", "", "on which depth the body lies"},
                  {"steps_per_s", "1/s", "steps of the physics"},
                  {"frames", "", "that count"},
                  {"shake_mm", "mm", "of its centre of mass from its mean place, root mean square"},
                  {"height_mm", "mm", "likewise, along Y alone"},
                  {"jump_mm", "mm", "from one frame to the next, root mean square"},
                  {"turn_deg", "degrees", "likewise, how far it turns"},
                  {"triangles", "", "of the depth mesh"}},
      .rows = {}};
  for (const Fall& fall : falls)
    table.rows.push_back({fall.name, std::int64_t{request.physics.steps_per_s}, std::int64_t{request.frames},
                          fall.shake_mm, fall.height_mm, fall.jump_mm, fall.turn_deg,
                          static_cast<std::int64_t>(fall.triangles)});
  for (const StepShake& other : by_steps)
    table.rows.push_back({std::string("exact"),
                          std::int64_t{other.steps_per_s},
                          std::int64_t{request.frames},
                          {},
                          {},
                          other.jump_mm,
                          {},
                          {}});
  return table;
}

void draw(const std::filesystem::path& svg, const std::vector<Fall>& falls,
          const std::vector<StepShake>& by_steps, const std::string& heading) {
  constexpr double least_mm = 1e-6;  // below it the axis says nothing
  std::vector<PlotPanel> panels(by_steps.empty() ? 1 : 2);
  panels[0].title = "a body that rests, frame by frame";
  panels[0].x_label = "frame";
  panels[0].y_label = "away from its mean place, mm";
  for (std::size_t i = 0; i < falls.size(); ++i) {
    PlotLine line{.title = "depth: " + falls[i].name, .points = {}, .style = i};
    for (std::size_t frame = 0; frame < falls[i].away_mm.size(); ++frame)
      line.points.emplace_back(static_cast<double>(frame), std::max(falls[i].away_mm[frame], least_mm));
    panels[0].lines.push_back(line);
  }
  if (!by_steps.empty()) {
    panels[1].title = "on exact depth, by steps a second";
    panels[1].x_label = "steps a second";
    panels[1].y_label = "from one frame to the next, mm (root mean square)";
    PlotLine line{.title = "depth: exact", .points = {}, .style = falls.size() - 1};
    for (const StepShake& other : by_steps) {
      line.points.emplace_back(other.steps_per_s, std::max(other.jump_mm, least_mm));
      panels[1].x_ticks.push_back({double{1} * other.steps_per_s, fmt::format("{}", other.steps_per_s)});
    }
    panels[1].lines.push_back(line);
  }
  for (PlotPanel& panel : panels) panel.linear_x = true;
  draw_svg(svg, panels_width_px(panels.size()), panels_height_px, panels_script(heading, panels));
}

}  // namespace

void write_falls(const std::filesystem::path& folder, const std::vector<Fall>& falls,
                 const std::vector<StepShake>& by_steps, const FallRequest& request,
                 const std::string& heading) {
  const CsvTable poses = pose_table(falls, request), shakes = shake_table(falls, by_steps, request);
  write_file_atomically(folder / "poses.csv", csv_text(poses));
  write_file_atomically(folder / "shake.csv", csv_text(shakes));
  write_file_atomically(folder / "data_dictionary.csv", csv_text(data_dictionary({poses, shakes})));
  draw(folder / "shake.svg", falls, by_steps, heading);
}

std::string fall_sentence(const Fall& fall) {
  const Eigen::Vector3d at = fall.poses.back().translation(),
                        turn = rotation_deg_of(fall.poses.back().linear());
  return fmt::format(
      "{:<9} shake {:.4g} mm, height {:.4g} mm; from frame to frame {:.4g} mm and {:.3g} degrees; last at "
      "{:.4f} {:.4f} {:.4f}, rotation {:.2f} {:.2f} {:.2f}",
      fall.name, fall.shake_mm, fall.height_mm, fall.jump_mm, fall.turn_deg, at.x(), at.y(), at.z(), turn.x(),
      turn.y(), turn.z());
}

}  // namespace seamline::renderer
