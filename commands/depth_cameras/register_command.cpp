#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <optional>

#include "commands/options/output_files.h"
#include "commands/options/setting_option.h"
#include "raytracer/common/stopwatch.h"
#include "registration/errors/error_report.h"
#include "registration/files/camera_file.h"
#include "registration/files/point_cloud.h"
#include "registration/mesh/register_by_mesh.h"
#include "registration/pictures/photograph.h"
#include "registration/pictures/points_picture.h"
#include "registration/pictures/section.h"
#include "registration/points/register_by_points.h"
#include "sensors/files/depth_values.h"
#include "sensors/repair/named_repair.h"
#include "sensors/repair/several_frames.h"
#include "stimuli/settings/repair_settings.h"
#include "support/files/atomic_file.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::registration {
namespace {

namespace fs = std::filesystem;

constexpr double edge_ratio = 1.05;  ///< of depths that edges.png draws a line between

struct RegisterOptions {
  std::vector<std::string> depth;  ///< one, or several of a rig that stands still
  std::string camera, colour, out;
  std::string by = "mesh", repair = "none";
  MeshRegistration mesh;
  bool repair_after = false;  ///< in the photograph's pixels, once registered (002, section 5)
  std::optional<int> section_row;
  std::string true_depth;  ///< empty: the truth is not known
  double tolerance = ErrorSettings{}.tolerance;
  bool tolerance_given = false;
  bool jumps_given = false, ratio_given = false, extrusion_given = false;
};

/// An option that would be ignored is refused.
void check(const RegisterOptions& options) {
  const auto refuse = [](const char* option, const char* wanted, const std::string& found) {
    throw input_error({.field = option, .wanted = wanted, .found = found});
  };
  if (options.by == "points") {
    if (options.jumps_given) refuse("--jumps", "--by mesh beside it", "--by points, which has no triangles");
    if (options.section_row) refuse("--section", "--by mesh beside it", "--by points, which has no mesh");
    if (options.extrusion_given)
      refuse("--extrude", "--by mesh beside it", "--by points, which has no border");
  }
  if (options.ratio_given && (options.by == "points" || options.mesh.jumps != Jumps::cut))
    refuse(
        "--jump-ratio", "--jumps cut beside it",
        options.by == "points" ? "--by points" : "--jumps " + std::string(stimuli::word(options.mesh.jumps)));
  if (options.tolerance_given && options.true_depth.empty())
    refuse("--error-tolerance", "--true-depth beside it", "none");
  if (options.repair_after && options.repair == "none")
    refuse("--repair-after", "a repair beside it", "--repair none");
}

CameraFile cameras_of(const RegisterOptions& options) {
  const bool preset = is_preset(options.camera) && !fs::exists(options.camera);
  return preset ? camera_file_of_preset(options.camera, "--camera") : read_camera_file(options.camera);
}

/// `colour_from_camera`: from the camera whose pixels are repaired into the photograph's, by which one filter
/// is guided.
sensors::Repaired repaired(const sensors::RepairMethod& method, const sensors::DepthFrame& frame,
                           const Eigen::Isometry3d& colour_from_camera, const RegistrationRig& rig,
                           const Image& photograph) {
  if (!std::holds_alternative<sensors::JointBilateralRepair>(method)) return sensors::repair(frame, method);
  const Image guide = photograph_in_depth_pixels(photograph, frame, colour_from_camera, rig.colour);
  return sensors::repair(frame, method, &guide);
}

/// What the repair made of registered depth takes its place, and what it invented is marked.
void take_repaired(RegisteredFrame& registered, const sensors::Repaired& mended) {
  registered.frame = mended.frame;
  for (std::size_t i = 0; i < mended.marks.size(); ++i) {
    registered.filled[i] = mended.marks[i] == sensors::RepairMark::empty ? 0 : 1;
    if (mended.marks[i] == sensors::RepairMark::invented) registered.invented[i] = 1;
  }
}

RegisteredFrame registered_of(const RegisterOptions& options, const RegistrationRig& rig,
                              const sensors::Repaired& repaired) {
  std::vector<std::uint8_t> invented;
  for (const sensors::RepairMark mark : repaired.marks)
    invented.push_back(mark == sensors::RepairMark::invented ? 1 : 0);
  if (options.by == "points")
    return register_by_points(repaired.frame, rig.colour_from_depth, rig.colour, invented);
  return register_by_mesh(repaired.frame, rig.colour_from_depth, rig.colour, options.mesh, invented);
}

void write_all(const fs::path& folder, const RegistrationRig& rig, const RegisteredFrame& registered,
               const Image& photograph) {
  Image depth(rig.colour.width_px, rig.colour.height_px, 1);
  depth.values = registered.frame.depth_m;
  write_exr(folder / "registered.exr", depth);
  write_png(folder / "filled.png", mask_picture(rig.colour, registered.filled));
  write_png(folder / "extruded.png", mask_picture(rig.colour, registered.extruded));
  write_png(folder / "invented.png", mask_picture(rig.colour, registered.invented));
  write_png(folder / "edges.png", edges_over_photograph(registered, photograph, edge_ratio,
                                                        rig.colour.fx_px / rig.depth_form.camera.fx_px));
  const ByteImage picture = display_image(photograph);
  write_png(folder / "points.png",
            points_picture(registered, picture, rig.depth_form.camera, rig.colour_from_depth));
  const bool in_world = rig.world_from_colour.has_value();
  write_file_atomically(
      folder / "points.ply",
      point_cloud_ply(registered, picture, rig.world_from_colour.value_or(Eigen::Isometry3d::Identity()),
                      in_world ? "world frame" : "colour camera's frame: x right, y down, z forward"));
}

/// `nothing`: values that stand for no depth; none: 65535 of whole numbers of 16 bits.
sensors::DepthFrame read_depth(const RegisterOptions& options, const RegistrationRig& rig,
                               const std::optional<std::vector<double>>& nothing) {
  std::vector<sensors::DepthFrame> frames;
  for (const std::string& path : options.depth) {
    const sensors::RawDepth raw =
        sensors::read_raw_depth(path, {.channel = {}, .packing = rig.depth_form.packing});
    sensors::DepthMeaning meaning;
    if (nothing)
      meaning.nothing = *nothing;
    else if (raw.whole && raw.bits == 16)
      meaning.nothing = {65535};
    sensors::DepthFromValues read = sensors::depth_of_values(raw, path, rig.depth_form, meaning);
    if (read.why.coded > 0)
      fmt::print(stderr, "note: {}: {} {} a value that stands for nothing\n", printable(path),
                 counted(read.why.coded, "pixel"), read.why.coded == 1 ? "holds" : "hold");
    frames.push_back(std::move(read.file.frame));
  }
  return sensors::mean_of_frames(frames, "--depth");
}

/// The truth as the photograph's camera sees it, as `registered.exr` is written: planar, EXR in metres. Whole
/// numbers are read as those of the depth camera.
sensors::DepthFrame read_true_depth(const std::string& path, const RegistrationRig& rig) {
  const bool in_metres = fs::path(path).extension() == ".exr";
  return sensors::read_depth_file(
             path, {.camera = rig.colour,
                    .convention = sensors::DepthConvention::planar,
                    .metres_per_step = in_metres ? std::nullopt : rig.depth_form.metres_per_step,
                    .packing = rig.depth_form.packing,
                    .unusual_distances = rig.depth_form.unusual_distances})
      .frame;
}

/// What is wrong in the registered depth, and why, as a table and a picture.
ErrorClassMap write_errors(const RegisterOptions& options, const RegistrationRig& rig,
                           const sensors::DepthFrame& truth, const sensors::DepthFrame& measured,
                           const RegisteredFrame& registered, const Image& photograph) {
  ErrorClassMap errors = classify_errors(
      registered, truth, measured, rig.colour_from_depth,
      {.tolerance = options.tolerance, .range = {rig.depth_form.nearest_m, rig.depth_form.farthest_m}});
  write_file_atomically(fs::path(options.out) / "errors.csv", csv_text(errors_table(errors)));
  write_png(fs::path(options.out) / "errors.png", errors_over_photograph(errors, photograph));
  return errors;
}

void print_count(const char* what, std::int64_t count, std::size_t of) {
  fmt::print("  {:<34}{:>10}  {:5.1f} %\n", what, count, 100.0 * count / of);
}

void run_register(const RegisterOptions& options) {
  check(options);
  // Of each link of the chain, for the printed text alone: files hold no time.
  renderer::Stopwatch since_last_link;
  const auto lap_s = [&] {
    const double seconds = since_last_link.seconds();
    since_last_link = {};
    return seconds;
  };
  const CameraFile cameras = cameras_of(options);
  const RegistrationRig rig = registration_rig(cameras, options.camera);
  const sensors::DepthFrame measured = read_depth(options, rig, cameras.nothing);
  const Image photograph = read_photograph(options.colour, rig.colour);
  std::optional<sensors::DepthFrame> truth;
  if (!options.true_depth.empty()) truth = read_true_depth(options.true_depth, rig);
  const double read_s = lap_s();
  const sensors::RepairMethod method = sensors::named_repair(options.repair);
  sensors::Repaired mended = options.repair_after
                                 ? sensors::without_repair(measured)
                                 : repaired(method, measured, rig.colour_from_depth, rig, photograph);
  double repair_s = lap_s();
  RegisteredFrame registered = registered_of(options, rig, mended);
  const double register_s = lap_s();
  if (options.repair_after) {
    mended = repaired(method, registered.frame, Eigen::Isometry3d::Identity(), rig, photograph);
    take_repaired(registered, mended);
    repair_s += lap_s();
  }
  std::optional<Section> section;
  if (options.section_row) {
    const sensors::DepthFrame& meshed = options.repair_after ? measured : mended.frame;
    section =
        section_of(meshed, rig.colour_from_depth, rig.colour, options.mesh, registered, *options.section_row);
  }
  prepare_output_folder(options.out);
  write_all(options.out, rig, registered, photograph);
  if (section) draw_section(fs::path(options.out) / "section.svg", *section, *options.section_row);
  std::string errors;
  if (truth) errors = errors_text(write_errors(options, rig, *truth, measured, registered, photograph));
  const double write_s = lap_s();

  const std::int64_t holes =
      std::count_if(measured.depth_m.begin(), measured.depth_m.end(), sensors::DepthFrame::is_hole);
  const std::size_t depth_pixels = measured.depth_m.size(), colour_pixels = registered.filled.size();
  fmt::print("depth camera, {} x {} pixels:\n", rig.depth_form.camera.width_px,
             rig.depth_form.camera.height_px);
  print_count("measured", static_cast<std::int64_t>(depth_pixels) - holes, depth_pixels);
  print_count("holes", holes, depth_pixels);
  const auto print_repair = [&](std::size_t of) {
    print_count("changed by the repair", mended.count(sensors::RepairMark::changed), of);
    print_count("invented by the repair", mended.count(sensors::RepairMark::invented), of);
  };
  if (!options.repair_after) print_repair(depth_pixels);
  fmt::print("colour camera, {} x {} pixels:\n", rig.colour.width_px, rig.colour.height_px);
  const std::int64_t filled = count_of(registered.filled), extruded = count_of(registered.extruded);
  if (options.repair_after) print_repair(colour_pixels);
  print_count("registered", filled - extruded, colour_pixels);
  print_count("from invented depth", count_of(registered.invented), colour_pixels);
  print_count("extruded", extruded, colour_pixels);
  print_count("without depth", static_cast<std::int64_t>(colour_pixels) - filled, colour_pixels);
  fmt::print("{}", errors);
  fmt::print("seconds: read {:.2f}, repair {:.2f}, register {:.2f}, write {:.2f}\n{}\n", read_s, repair_s,
             register_s, write_s, options.out);
}

}  // namespace

void add_register_command(CLI::App& app) {
  const auto options = std::make_shared<RegisterOptions>();
  CLI::App* command = app.add_subcommand("register", "bring a depth map into the photograph's camera");
  command
      ->add_option("--depth", options->depth,
                   "depth map (EXR, 16-bit PNG or PGM, 8-bit PNG red and green); several of a scene where "
                   "nothing moves: their mean, without wild values")
      ->required();
  command->add_option("--colour", options->colour, "photograph (EXR, HDR, PNG, JPEG)")->required();
  command->add_option("--camera", options->camera, "the two cameras: a TOML file, or the name of a preset")
      ->required();
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  command->add_option("--by", options->by, "points or mesh")
      ->check(CLI::IsMember({"points", "mesh"}))
      ->capture_default_str();
  const CLI::Option* jumps =
      add_choice(*command, "--jumps", options->mesh.jumps, std::array{Jumps::stretch, Jumps::cut},
                 "what the mesh does where depth jumps");
  const CLI::Option* ratio = add_number(*command, "--jump-ratio", options->mesh.jump_ratio, {1.0001, 1000},
                                        "of depths between which --jumps cut cuts")
                                 ->capture_default_str();
  const CLI::Option* extrusion =
      add_number(*command, "--extrude", options->mesh.border_extrusion_px, {0, 16384, "px"},
                 "pixels of the depth camera by which its border is extended")
          ->capture_default_str();
  add_number(*command, "--section", options->section_row, {0, 65535, "px"},
             "also draws the mesh cut along this row of the photograph (section.svg; needs gnuplot)");
  command->add_option("--repair", options->repair, "what is done to the depth, before it is registered")
      ->check(CLI::IsMember(option_words<sensors::RepairMethod>()))
      ->capture_default_str();
  command->add_flag("--repair-after", options->repair_after,
                    "repair the registered depth instead, in the photograph's pixels");
  command->add_option("--true-depth", options->true_depth,
                      "planar depth that the photograph's camera truly sees, in its pixels, to compare with: "
                      "adds errors.csv and errors.png");
  const CLI::Option* tolerance =
      add_number(*command, "--error-tolerance", options->tolerance, {1e-6, 10},
                 "share of the true depth from which on registered depth counts as wrong")
          ->capture_default_str();
  command->callback([options, jumps, ratio, extrusion, tolerance, command] {
    require_outputs_in_folder(
        *command, {"registered.exr", "filled.png", "extruded.png", "invented.png", "edges.png", "points.png",
                   "points.ply", "errors.csv", "errors.png"});
    options->tolerance_given = tolerance->count() > 0;
    options->jumps_given = jumps->count() > 0;
    options->ratio_given = ratio->count() > 0;
    options->extrusion_given = extrusion->count() > 0;
    run_register(*options);
  });
}

}  // namespace seamline::registration
