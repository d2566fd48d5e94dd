#include "commands/evidence/evidence_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <vector>

#include "laboratory/figures/marker_scene.h"
#include "raytracer/common/parallel.h"
#include "raytracer/scene/scene_file.h"
#include "raytracer/scene/truth_scene.h"
#include "registration/calibration/aruco.h"
#include "registration/points/register_by_points.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "renderer/estimators/rig_photograph.h"
#include "sensors/repair/nearest.h"
#include "sensors/rig/presets.h"
#include "support/arithmetic/units.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/plot_panels.h"
#include "support/running/progress.h"
#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

using registration::MarkerCorners;

constexpr double paper_distance_m = 1.156;  ///< of paper 002's marker, by vision
constexpr std::array distances_m = {0.5, 0.75, 1.0, paper_distance_m, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0};
constexpr std::array angles_deg = {0.0, 15.0, 30.0, 45.0, 60.0};
constexpr std::array refinements = {MarkerCorners::subpix, MarkerCorners::none};
constexpr double roll_deg = 7;  ///< so that no edge runs along the pixels
constexpr double most_percent = 2;

struct MarkerOptions {
  std::string sensor = "tof_160x120", out;
  double side_m = 0.16, noise_scale = 1;
  int spp = 16, frames = 25;
  std::uint64_t seed = 1;
};

/// Where depths are compared: the marker's middle, where black and white squares meet, and the white margin
/// to its left; metres from the middle, as shares of its side.
struct MarkerPlace {
  const char* name;
  double right;
};
constexpr std::array places = {MarkerPlace{"middle", 0},
                               MarkerPlace{"margin", -3.5 / registration::marker_squares}};

/// A marker at one distance and angle.
struct MarkerTrial {
  double distance_m = 1, angle_deg = 0;
  /// Planar, of each refinement at each place; none where the marker was not found.
  std::array<std::array<std::optional<double>, places.size()>, refinements.size()> vision_m = {};
  std::array<double, places.size()> true_m = {};
  /// Of each frame, at each place; holes are left out.
  std::array<std::vector<double>, places.size()> flight_m = {};
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  return values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
}

double percentile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::lround(share * (values.size() - 1)))];
}

ByteImage grey_of(const Image& radiance) {
  Image grey(radiance.width_px, radiance.height_px, 1);
  for (int y = 0; y < grey.height_px; ++y)
    for (int x = 0; x < grey.width_px; ++x) grey.at(x, y) = radiance.rgb(x, y).mean();
  return display_image(grey);
}

const sensors::Rig& rig_of(const MarkerOptions& options) {
  const sensors::SensorPreset& preset = sensors::sensor_preset(options.sensor, "--sensor");
  const auto* rig = std::get_if<sensors::Rig>(&preset.sensor);
  if (rig == nullptr)
    throw input_error({.field = "--sensor",
                       .wanted = "a depth camera with a colour camera",
                       .found = options.sensor + ", a scanner"});
  return *rig;
}

/// Takes the picture and the depth of the marker in every place.
class Laboratory {
 public:
  Laboratory(const MarkerOptions& options, const SceneFile& board)
      : options_(options), rig_(rig_of(options)), board_(board) {
    light_.environment_radiance = Rgb::Constant(1.0F);
    light_.bounces = 0;
  }

  MarkerTrial measure(double distance_m, double angle_deg) const {
    const ObjectDefinition placement{.name = {},
                                     .file = {},
                                     .path = {},
                                     .position_m = {0, 0, -distance_m},
                                     .rotation_deg = {0, angle_deg, roll_deg}};
    const Geometry truth(place_meshes(board_, object_placement(placement), Eigen::Vector3d::Zero(), 0.5, 0));
    MarkerTrial trial{.distance_m = distance_m, .angle_deg = angle_deg};
    const ByteImage grey =
        grey_of(photograph_scene(truth, light_, rig_.colour, world(),
                                 {.spp = options_.spp, .seed = options_.seed, .threads = threads_}));
    const Eigen::Isometry3d pose =
        world().inverse() * Eigen::Isometry3d(object_placement(placement).matrix());
    for (std::size_t p = 0; p < places.size(); ++p) trial.true_m[p] = (pose * point_m(places[p])).z();
    for (std::size_t i = 0; i < refinements.size(); ++i)
      if (const auto found = registration::find_marker(grey, rig_.colour, options_.side_m, refinements[i]))
        for (std::size_t p = 0; p < places.size(); ++p)
          trial.vision_m[i][p] = (*found * point_m(places[p])).z();
    sense(truth, pose, trial);
    return trial;
  }

 private:
  [[nodiscard]] Eigen::Isometry3d world() const { return world_from_photograph(Camera{}); }

  [[nodiscard]] Eigen::Vector3d point_m(const MarkerPlace& place) const {
    return {place.right * options_.side_m, 0, 0};
  }

  /// 002 (section 4): registered by points, filled by the nearest neighbour, read at one pixel.
  void sense(const Geometry& truth, const Eigen::Isometry3d& colour_from_marker, MarkerTrial& trial) const {
    SensorSight sight{.surfaces = true, .projector_m = rig_.projector_m};
    const auto* flight = std::get_if<sensors::TimeOfFlightNoise>(&rig_.noise);
    if (flight != nullptr && flight->mixes) sight.sub_rays_across = 3;
    const sensors::SeenFrame seen =
        see_truth(truth, rig_.depth, world() * rig_.colour_from_depth, sight, threads_);
    for (int frame = 0; frame < options_.frames; ++frame) {
      const sensors::Measurement measured =
          sensors::measure(seen, rig_.noise, {options_.seed, static_cast<std::uint64_t>(frame)},
                           options_.noise_scale, threads_);
      const sensors::DepthFrame registered =
          sensors::fill_with_nearest(registration::register_by_points(measured.frame, rig_.colour_from_depth,
                                                                      rig_.colour, {}, threads_)
                                         .frame,
                                     threads_)
              .frame;
      for (std::size_t p = 0; p < places.size(); ++p) {
        const auto at_px = sensors::project(rig_.colour, colour_from_marker * point_m(places[p]));
        if (!at_px || !sensors::is_in_picture(rig_.colour, *at_px)) continue;
        const float depth_m = registered.at(static_cast<int>(at_px->x()), static_cast<int>(at_px->y()));
        if (!sensors::DepthFrame::is_hole(depth_m)) trial.flight_m[p].push_back(depth_m);
      }
    }
  }

  const MarkerOptions& options_;
  const sensors::Rig& rig_;
  const SceneFile& board_;
  Light light_;
  const int threads_ = default_thread_count();
};

/// Deviations of time of flight from vision, in percent of vision.
std::vector<double> deviations_percent(const MarkerTrial& trial, std::size_t refinement, std::size_t place) {
  std::vector<double> out;
  if (!trial.vision_m[refinement][place]) return out;
  const double vision_m = *trial.vision_m[refinement][place];
  for (const double flight_m : trial.flight_m[place]) out.push_back(100 * (flight_m - vision_m) / vision_m);
  return out;
}

double share_within(const std::vector<double>& percents) {
  const auto within = std::count_if(percents.begin(), percents.end(),
                                    [](double percent) { return std::abs(percent) < most_percent; });
  return static_cast<double>(within) / static_cast<double>(percents.size());
}

CsvTable table_of(const std::vector<MarkerTrial>& trials) {
  CsvTable table{
      .name = "deviations",
      .columns = {{"distance_mm", "mm", "of the marker's middle from the colour camera, along its axis"},
                  {"angle_deg", "degrees", "between the marker's normal and the camera's axis"},
                  {"place", "", "middle: black and white squares meet; margin: white, left of the marker"},
                  {"refinement", "", "of the marker's corners, OpenCV's name"},
                  {"true_mm", "mm", "planar distance of the place"},
                  {"vision_mm", "mm", "the same by the marker's pose; empty where it was not found"},
                  {"vision_error_mm", "mm", "vision_mm - true_mm"},
                  {"flight_frames", "", "frames of the depth camera that have a depth there"},
                  {"flight_median_mm", "mm", "registered depth at the place, median of the frames"},
                  {"flight_low_mm", "mm", "2.5th percentile"},
                  {"flight_high_mm", "mm", "97.5th percentile"},
                  {"deviation_percent", "%", "median of (flight - vision) / vision"},
                  {"share_under_2_percent", "", "of the frames"}},
      .rows = {}};
  for (const MarkerTrial& trial : trials)
    for (std::size_t p = 0; p < places.size(); ++p)
      for (std::size_t i = 0; i < refinements.size(); ++i) {
        std::vector<CsvValue> row = {trial.distance_m * mm_per_m, trial.angle_deg,
                                     std::string(places[p].name), std::string(word(refinements[i])),
                                     trial.true_m[p] * mm_per_m};
        const auto add = [&](bool known, double value) {
          row.push_back(known ? CsvValue(value) : CsvValue(std::monostate()));
        };
        const std::vector<double>& flight_m = trial.flight_m[p];
        const bool seen = trial.vision_m[i][p].has_value(), measured = !flight_m.empty();
        add(seen, trial.vision_m[i][p].value_or(0) * mm_per_m);
        add(seen, (trial.vision_m[i][p].value_or(0) - trial.true_m[p]) * mm_per_m);
        row.emplace_back(static_cast<std::int64_t>(flight_m.size()));
        add(measured, measured ? median(flight_m) * mm_per_m : 0);
        add(measured, measured ? percentile(flight_m, 0.025) * mm_per_m : 0);
        add(measured, measured ? percentile(flight_m, 0.975) * mm_per_m : 0);
        const std::vector<double> percents = deviations_percent(trial, i, p);
        add(!percents.empty(), percents.empty() ? 0 : median(percents));
        add(!percents.empty(), percents.empty() ? 0 : share_within(percents));
        table.rows.push_back(row);
      }
  return table;
}

std::string millimetres_text(double distance_m) {
  return fmt::format("{:.0f}", distance_m * mm_per_m);
}

/// Left and middle: what 80 % of the deviations stay below, at the two places; right: the error of vision.
void draw(const std::filesystem::path& svg, const std::vector<MarkerTrial>& trials,
          const MarkerOptions& options) {
  constexpr double share = 0.8;
  std::array<PlotPanel, 3> panels;
  for (std::size_t p = 0; p < places.size(); ++p) {
    panels[p].title = fmt::format("time of flight against vision (SUBPIX), {}", places[p].name);
    panels[p].y_label = "80 % of the deviations are below, %";
    panels[p].y_room = {0.3, 30};
    panels[p].marks.push_back({.vertical = false, .at = most_percent, .label = "002: under 2 %"});
    for (std::size_t a = 0; a < angles_deg.size(); ++a) {
      PlotLine line{.title = fmt::format("{:.0f} degrees", angles_deg[a]), .points = {}, .style = a};
      for (const MarkerTrial& trial : trials) {
        std::vector<double> percents = deviations_percent(trial, 0, p);
        if (trial.angle_deg != angles_deg[a] || percents.empty()) continue;
        for (double& percent : percents) percent = std::abs(percent);
        line.points.emplace_back(trial.distance_m * mm_per_m, percentile(percents, share));
      }
      panels[p].lines.push_back(line);
    }
  }
  panels[2].title = "vision against the truth, middle";
  panels[2].y_label = "error of the distance, mm";
  for (std::size_t i = 0; i < refinements.size(); ++i)
    for (const double angle_deg : {0.0, 45.0}) {
      PlotLine line{.title = fmt::format("{}, {:.0f} degrees", word(refinements[i]), angle_deg),
                    .points = {},
                    .style = 2 * i + (angle_deg > 0 ? 1 : 0)};
      for (const MarkerTrial& trial : trials)
        if (trial.angle_deg == angle_deg && trial.vision_m[i][0])
          line.points.emplace_back(trial.distance_m * mm_per_m,
                                   std::abs(*trial.vision_m[i][0] - trial.true_m[0]) * mm_per_m);
      panels[2].lines.push_back(line);
    }
  for (PlotPanel& panel : panels) {
    panel.x_label = "distance, mm";
    panel.linear_x = true;
    panel.key_left = true;
  }
  const std::string heading = fmt::format("A marker of {} mm before the rig {}, {} frames a place",
                                          millimetres_text(options.side_m), options.sensor, options.frames);
  draw_svg(svg, panels_width_px(panels.size()), panels_height_px, panels_script(heading, panels));
}

/// One refinement at one place, over all distances and angles, and at the paper's distance.
void print_summary(const std::vector<MarkerTrial>& trials, std::size_t refinement, std::size_t place) {
  std::vector<double> all, errors_mm;
  int missed = 0;
  const std::string what = fmt::format("{:<7} {:<7}", word(refinements[refinement]), places[place].name);
  for (const MarkerTrial& trial : trials) {
    const std::vector<double> percents = deviations_percent(trial, refinement, place);
    all.insert(all.end(), percents.begin(), percents.end());
    const std::optional<double>& vision_m = trial.vision_m[refinement][place];
    missed += vision_m ? 0 : 1;
    if (vision_m) errors_mm.push_back(std::abs(*vision_m - trial.true_m[place]) * mm_per_m);
    const bool papers = trial.distance_m == paper_distance_m && trial.angle_deg == 0;
    if (papers && vision_m && !percents.empty())
      fmt::print("{} at {} mm, frontal: vision {:.1f} mm, time of flight {:.1f} mm ({:.1f} to {:.1f})\n",
                 what, millimetres_text(trial.distance_m), *vision_m * mm_per_m,
                 median(trial.flight_m[place]) * mm_per_m,
                 percentile(trial.flight_m[place], 0.025) * mm_per_m,
                 percentile(trial.flight_m[place], 0.975) * mm_per_m);
  }
  if (all.empty()) {
    fmt::print("{} the marker was found nowhere\n", what);
    return;
  }
  fmt::print(
      "{} {} distances and angles, {} without the marker; vision off by {:.1f} mm (median); {:.0f} % of the "
      "frames deviate by under {} %\n",
      what, trials.size(), missed, median(errors_mm), 100 * share_within(all), most_percent);
}

void run_marker(const MarkerOptions& options) {
  registration::require_aruco();
  require_gnuplot();
  const sensors::Rig& rig = rig_of(options);
  if (!rig.colour.distortion.is_none())
    throw input_error({.field = "--sensor", .wanted = "a colour camera without a lens", .found = "one with"});
  const std::filesystem::path folder = options.out;
  prepare_output_folder(folder);
  write_marker_scene(folder / "marker.glb", {.side_m = options.side_m, .camera_m = paper_distance_m});
  const SceneFile board = read_scene_file(folder / "marker.glb");
  const Laboratory laboratory(options, board);
  std::vector<MarkerTrial> trials;
  Progress progress("marker", distances_m.size() * angles_deg.size());
  for (const double distance_m : distances_m)
    for (const double angle_deg : angles_deg) {
      trials.push_back(laboratory.measure(distance_m, angle_deg));
      progress.advance(1, fmt::format("{} mm, {:.0f} degrees", millimetres_text(distance_m), angle_deg));
    }
  const CsvTable table = table_of(trials);
  write_file_atomically(folder / "deviations.csv", csv_text(table));
  write_file_atomically(folder / "data_dictionary.csv", csv_text(data_dictionary({table})));
  draw(folder / "deviations.svg", trials, options);
  for (std::size_t p = 0; p < places.size(); ++p)
    for (std::size_t i = 0; i < refinements.size(); ++i) print_summary(trials, i, p);
}

}  // namespace

void add_marker_command(CLI::App& app) {
  auto options = std::make_shared<MarkerOptions>();
  CLI::App* command = app.add_subcommand(
      "marker", "how far a marker is, by vision and by time of flight (needs OpenCV's ArUco)");
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  command->add_option("--sensor", options->sensor, "preset of a rig (documentation/how-to/sensors.md)")
      ->capture_default_str();
  add_number(*command, "--side", options->side_m, {0.01, 1, "m"}, "of the marker")->capture_default_str();
  add_number(*command, "--noise", options->noise_scale, {0, 1e6},
             "scale of the sensor's noise; 0: none, its holes stay")
      ->capture_default_str();
  add_number(*command, "--frames", options->frames, {1, 10000}, "of the depth camera, for each place")
      ->capture_default_str();
  add_number(*command, "--spp", options->spp, {1, 65536}, "samples per pixel of the photograph")
      ->capture_default_str();
  add_number(*command, "--seed", options->seed, any_seed, "seed of noise and samples")->capture_default_str();
  command->callback([options] { run_marker(*options); });
}

}  // namespace seamline::renderer
