#include "commands/depth_cameras/depth_camera_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "commands/options/output_files.h"
#include "registration/calibration/calibrate.h"
#include "registration/calibration/opencv.h"
#include "registration/files/camera_file.h"
#include "registration/files/pairs_file.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/running/interrupt.h"
#include "support/text/counted.h"
#include "support/text/csv.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::registration {
namespace {

struct CalibrateOptions {
  std::vector<std::string> depth_pictures, colour_pictures;
  std::string pairs, camera, out, board_text = "9x6";
  double square_m = 0.03, least_confidence = 0;
  bool board_given = false, square_given = false, confidence_given = false;
};

/// A parameter of the result: what it is called, and which of the covariance it is.
struct FittedParameter {
  std::string name, unit;
  double value = 0;
  int index = 0;
};

/// What was found, ready to be written and printed.
struct Result {
  CameraFile cameras;
  std::vector<FittedParameter> parameters;
  Refined refined;
  std::string said;  ///< which pictures or pairs were used
};

Board board_of(const std::string& text, double square_m) {
  const auto corners = whole_pair(text, 'x');
  if (!corners || corners->first < 3 || corners->second < 3 || corners->first > 100 || corners->second > 100)
    throw input_error({.field = "--board",
                       .wanted = "a board's inner corners, from 3x3 to 100x100, e.g. 9x6",
                       .found = text});
  return {.columns = corners->first, .rows = corners->second, .square_m = square_m};
}

/// The picture's brightest value as white, in grey codes: corners do not care how it was exposed.
ByteImage grey_of(const std::string& file) {
  Image picture = read_image(file);
  require_numbers(picture, file);
  const int channels = picture.channels >= 3 ? 3 : 1;  // an alpha is left out
  Image grey(picture.width_px, picture.height_px, 1);
  float brightest = 0;
  for (int row = 0; row < picture.height_px; ++row)
    for (int column = 0; column < picture.width_px; ++column) {
      float sum = 0;
      for (int channel = 0; channel < channels; ++channel) sum += picture.at(column, row, channel);
      grey.at(column, row) = sum;
      brightest = std::max(brightest, sum);
    }
  if (brightest > 0)
    for (float& value : grey.values) value /= brightest;
  return display_image(grey);
}

/// Corners of every picture; of two cameras only where both see the board.
struct FoundBoards {
  BoardPictures pictures;
  std::vector<bool> found;
};

FoundBoards boards_in(const std::vector<std::string>& files, const Board& board) {
  FoundBoards boards;
  for (const std::string& file : files) {
    stop_if_interrupted();
    const ByteImage grey = grey_of(file);
    if (boards.found.empty()) {
      boards.pictures.width_px = grey.width_px;
      boards.pictures.height_px = grey.height_px;
    } else if (grey.width_px != boards.pictures.width_px || grey.height_px != boards.pictures.height_px) {
      throw input_error({.file = file,
                         .field = "size",
                         .wanted = fmt::format("{} x {} pixels, as the first picture has",
                                               boards.pictures.width_px, boards.pictures.height_px),
                         .found = fmt::format("{} x {}", grey.width_px, grey.height_px)});
    }
    const std::optional<Corners> corners = find_corners(grey, board);
    boards.found.push_back(corners.has_value());
    boards.pictures.boards.push_back(corners.value_or(Corners{}));
  }
  return boards;
}

BoardPictures kept(const FoundBoards& boards, const std::vector<bool>& keep) {
  BoardPictures pictures{boards.pictures.width_px, boards.pictures.height_px, {}};
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (keep[i]) pictures.boards.push_back(boards.pictures.boards[i]);
  return pictures;
}

std::string said_of_boards(const std::vector<std::string>& files, const std::vector<bool>& keep,
                           const char* what) {
  std::string without;
  for (std::size_t i = 0; i < keep.size(); ++i)
    if (!keep[i]) without += (without.empty() ? "" : ", ") + printable(files[i]);
  return fmt::format("the board was found in {} of {} {}{}\n", std::count(keep.begin(), keep.end(), true),
                     keep.size(), what, without.empty() ? "" : "; not in " + without);
}

void add_camera(std::vector<FittedParameter>& parameters, const char* name,
                const sensors::PinholeCamera& camera, int first) {
  const sensors::LensDistortion& lens = camera.distortion;
  const std::array<std::tuple<const char*, const char*, double>, camera_parameters> all = {
      {{"fx_px", "px", camera.fx_px},
       {"fy_px", "px", camera.fy_px},
       {"cx_px", "px", camera.cx_px},
       {"cy_px", "px", camera.cy_px},
       {"k1", "", lens.k1},
       {"k2", "", lens.k2},
       {"p1", "", lens.p1},
       {"p2", "", lens.p2},
       {"k3", "", lens.k3}}};
  for (const auto& [key, unit, value] : all)
    parameters.push_back({fmt::format("{}.{}", name, key), unit, value, first++});
}

/// A turn is told as the rotation vector; its covariance is that of a small turn beside it.
void add_pose(std::vector<FittedParameter>& parameters, const Eigen::Isometry3d& pose, int first) {
  const Eigen::AngleAxisd turn(Eigen::Matrix3d(pose.linear()));
  const Eigen::Vector3d vector = turn.angle() * turn.axis();
  const char* axes = "xyz";
  for (int axis = 0; axis < 3; ++axis)
    parameters.push_back(
        {fmt::format("colour_from_depth.turn_{}", axes[axis]), "rad", vector[axis], first++});
  for (int axis = 0; axis < 3; ++axis)
    parameters.push_back({fmt::format("colour_from_depth.translation_{}", axes[axis]), "m",
                          pose.translation()[axis], first++});
}

Result result_of_one(const CalibrateOptions& options, const CameraFile& known) {
  const Board board = board_of(options.board_text, options.square_m);
  const bool is_depth = !options.depth_pictures.empty();
  const std::vector<std::string>& files = is_depth ? options.depth_pictures : options.colour_pictures;
  const char* name = is_depth ? "depth" : "colour";
  const FoundBoards boards = boards_in(files, board);
  Result result{.cameras = known, .parameters = {}, .refined = {}, .said = {}};
  result.refined = calibrate_camera(board, kept(boards, boards.found),
                                    is_depth ? "--depth-pictures" : "--colour-pictures");
  const sensors::PinholeCamera& camera = result.refined.estimate.cameras.front();
  (is_depth ? result.cameras.depth : result.cameras.colour) = camera;
  add_camera(result.parameters, name, camera, 0);
  result.said = said_of_boards(files, boards.found, "pictures");
  return result;
}

Result result_of_two(const CalibrateOptions& options, const CameraFile& known) {
  const Board board = board_of(options.board_text, options.square_m);
  if (options.depth_pictures.size() != options.colour_pictures.size())
    throw input_error(
        {.field = "--depth-pictures",
         .wanted = "as many as --colour-pictures, in the same order",
         .found = fmt::format("{} and {}", options.depth_pictures.size(), options.colour_pictures.size())});
  const FoundBoards depth = boards_in(options.depth_pictures, board),
                    colour = boards_in(options.colour_pictures, board);
  std::vector<bool> both(depth.found.size());
  for (std::size_t i = 0; i < both.size(); ++i) both[i] = depth.found[i] && colour.found[i];
  Result result{.cameras = known, .parameters = {}, .refined = {}, .said = {}};
  result.refined = calibrate_two_cameras(board, kept(depth, both), kept(colour, both), "pairs of pictures");
  const Estimate& found = result.refined.estimate;
  result.cameras.depth = found.cameras[0];
  result.cameras.colour = found.cameras[1];
  result.cameras.colour_from_depth = found.second_from_first;
  add_camera(result.parameters, "depth", found.cameras[0], 0);
  add_camera(result.parameters, "colour", found.cameras[1], camera_parameters);
  add_pose(result.parameters, found.second_from_first, result.refined.first_of_second());
  result.said = said_of_boards(options.depth_pictures, both, "pairs of pictures");
  return result;
}

Result result_of_pairs(const CalibrateOptions& options, const CameraFile& known) {
  if (!known.colour)
    throw input_error({.field = "--pairs",
                       .wanted = "a --camera file with a table [colour], the photograph's camera",
                       .found = options.camera.empty() ? "none" : options.camera + " without"});
  const PairsFile file = read_pairs(options.pairs, options.least_confidence);
  Result result{.cameras = known, .parameters = {}, .refined = {}, .said = {}};
  result.refined = pose_of_pairs(*known.colour, file.pairs, options.pairs);
  result.cameras.colour_from_depth = result.refined.estimate.first_from_view.front();
  add_pose(result.parameters, *result.cameras.colour_from_depth, result.refined.first_of_view(0));
  result.said = fmt::format("{} used, {} left out for a confidence below {:g}\n",
                            counted(file.pairs.size(), "pair"), file.left_out, options.least_confidence);
  return result;
}

/// What was asked for, and nothing that would be ignored.
Result result_of(const CalibrateOptions& options) {
  const auto refuse = [](const char* option, const char* wanted, const char* found) {
    throw input_error({.field = option, .wanted = wanted, .found = found});
  };
  const bool depth = !options.depth_pictures.empty(), colour = !options.colour_pictures.empty(),
             pairs = !options.pairs.empty();
  if (!depth && !colour && !pairs)
    refuse("calibrate", "--depth-pictures, --colour-pictures, both, or --pairs", "none of them");
  if (pairs && (depth || colour)) refuse("--pairs", "pairs or pictures", "both");
  if (pairs && options.board_given) refuse("--board", "pictures of a board", "--pairs");
  if (pairs && options.square_given) refuse("--square", "pictures of a board", "--pairs");
  if (!pairs && options.confidence_given) refuse("--least-confidence", "--pairs beside it", "pictures");
  const CameraFile known = options.camera.empty() ? CameraFile{} : read_camera_file(options.camera);
  if (pairs) return result_of_pairs(options, known);
  return depth && colour ? result_of_two(options, known) : result_of_one(options, known);
}

double deviation(const Result& result, const FittedParameter& parameter) {
  return std::sqrt(result.refined.covariance(parameter.index, parameter.index));
}

CsvTable parameter_table(const Result& result) {
  CsvTable table{
      "parameters",
      {{"parameter", "", "key of camera.toml; turn: the rotation vector of colour_from_depth"},
       {"value", "", "as found"},
       {"standard_deviation", "", "from residuals and Jacobian; of a turn: of a small turn beside it"},
       {"unit", "", "of both"}},
      {}};
  for (const FittedParameter& parameter : result.parameters)
    table.rows.push_back({parameter.name, parameter.value, deviation(result, parameter), parameter.unit});
  return table;
}

CsvTable covariance_table(const Result& result) {
  CsvTable table{"covariance",
                 {{"parameter", "", "of parameters.csv"},
                  {"other", "", "of parameters.csv"},
                  {"covariance", "", "in the units of both"}},
                 {}};
  for (const FittedParameter& one : result.parameters)
    for (const FittedParameter& other : result.parameters)
      table.rows.push_back({one.name, other.name, result.refined.covariance(one.index, other.index)});
  return table;
}

void run_calibrate(const CalibrateOptions& options) {
  require_opencv();
  const Result result = result_of(options);
  const std::filesystem::path out = options.out;
  prepare_output_folder(out);
  const std::string error = fmt::format(
      "reprojection error {:.4g} px (root mean square of {} points), "
      "noise {:.4g} px a coordinate",
      result.refined.rms_px, result.refined.points, result.refined.sigma_px);
  write_file_atomically(out / "camera.toml",
                        camera_file_text(result.cameras, "written by seamline calibrate\n" + error));
  for (const CsvTable& table : {parameter_table(result), covariance_table(result)})
    write_file_atomically(out / (table.name + ".csv"), csv_text(table));
  fmt::print("{}{}\n", result.said, error);
  for (const FittedParameter& parameter : result.parameters)
    fmt::print("  {:<34}{:>14.7g} +- {:<10.3g} {}\n", parameter.name, parameter.value,
               deviation(result, parameter), parameter.unit);
  fmt::print("(+-: one standard deviation)\n{}\n", (out / "camera.toml").string());
}

}  // namespace

void add_calibrate_command(CLI::App& app) {
  const auto options = std::make_shared<CalibrateOptions>();
  CLI::App* command =
      app.add_subcommand("calibrate", "cameras from pictures of a chessboard, a pose from pairs of points");
  command->add_option("--depth-pictures", options->depth_pictures,
                      "the board as the depth camera sees it (infrared or amplitude)");
  command->add_option("--colour-pictures", options->colour_pictures,
                      "the board as the photograph's camera sees it; of both, the same moments in one order");
  const CLI::Option* board = add_formed_text(*command, "--board", options->board_text, "WxH",
                                             "inner corners of the board (default: 9x6)",
                                             [](const std::string& text) { (void)board_of(text, 1); });
  const CLI::Option* square =
      add_number(*command, "--square", options->square_m, {1e-6, 1000, "m"}, "side of a square")
          ->capture_default_str();
  command->add_option("--pairs", options->pairs, "CSV of pairs: u, v, x, y, z, confidence");
  const CLI::Option* confidence = add_number(*command, "--least-confidence", options->least_confidence,
                                             {-1e9, 1e9}, "pairs below it are left out")
                                      ->capture_default_str();
  command->add_option("--camera", options->camera, "TOML file with what is known already, and stays");
  command->add_option("--out", options->out, "folder to write; made when missing")->required();
  command->callback([options, board, square, confidence, command] {
    require_outputs_in_folder(*command, {"camera.toml", "parameters.csv", "covariance.csv"});
    options->board_given = board->count() > 0;
    options->square_given = square->count() > 0;
    options->confidence_given = confidence->count() > 0;
    run_calibrate(*options);
  });
}

}  // namespace seamline::registration
