#include "registration/files/text_cameras.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "registration/files/lens_fit.h"
#include "support/text/error.h"
#include "support/text/limits.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::registration {
namespace {

InputError wrong_camera(const std::string& file, const std::string& field, const std::string& wanted,
                        const std::string& found) {
  return input_error({.file = file, .field = field, .wanted = wanted, .found = found});
}

/// Numbers of a text in which commas, brackets and semicolons stand between them; none: it has other words.
std::optional<std::vector<double>> all_numbers(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t from = text.find_first_not_of(" \t\r\n,;[]()", at);
    if (from == std::string::npos) break;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n,;[]()", from), text.size());
    const auto number = decimal_number(std::string_view(text).substr(from, end - from));
    constexpr std::size_t most = 64;
    if (!number || numbers.size() > most) return std::nullopt;
    numbers.push_back(*number);
    at = end;
  }
  return numbers;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    if (!line.empty() && line.back() == '\r') line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

std::optional<StatedCamera> matrix_alone(const std::string& text, const std::string& file) {
  const auto numbers = all_numbers(text);
  if (!numbers) return std::nullopt;
  StatedCamera stated{.format = "a matrix K alone"};
  std::vector<double> k = *numbers;
  if (k.size() == 16 || k.size() == 12) k = {k[0], k[1], k[2], k[4], k[5], k[6], k[8], k[9], k[10]};
  if (k.size() != 9)
    throw wrong_camera(file, "", "a matrix of 3 x 3, 3 x 4 or 4 x 4 numbers",
                       fmt::format("{} numbers", numbers->size()));
  take_matrix(k, file, stated);
  stated.notes.emplace_back(
      "a matrix alone: no lens, its principal point counted from the first pixel's centre");
  return stated;
}

/// COLMAP's models: which of its parameters are what. Focal lengths and principal point come first.
struct ColmapModel {
  const char* name;
  bool one_focal, fisheye;
  std::size_t lens_terms;
};
constexpr std::array<ColmapModel, 9> colmap_models = {{{"SIMPLE_PINHOLE", true, false, 0},
                                                       {"PINHOLE", false, false, 0},
                                                       {"SIMPLE_RADIAL", true, false, 1},
                                                       {"RADIAL", true, false, 2},
                                                       {"OPENCV", false, false, 4},
                                                       {"FULL_OPENCV", false, false, 8},
                                                       {"OPENCV_FISHEYE", false, true, 4},
                                                       {"SIMPLE_RADIAL_FISHEYE", true, true, 1},
                                                       {"RADIAL_FISHEYE", true, true, 2}}};

struct ColmapLine {
  int id = 0, width_px = 0, height_px = 0;
  std::string model;
  std::vector<double> parameters;
};

std::optional<ColmapLine> colmap_line(const std::string& line) {
  std::istringstream in(line);
  ColmapLine out;
  if (!(in >> out.id >> out.model >> out.width_px >> out.height_px)) return std::nullopt;
  const auto is_letter = [](char letter) { return (letter >= 'A' && letter <= 'Z') || letter == '_'; };
  if (out.model.size() < 3 || !std::all_of(out.model.begin(), out.model.end(), is_letter))
    return std::nullopt;
  for (std::string word; in >> word;) {
    const auto number = decimal_number(word);
    if (!number) return std::nullopt;
    out.parameters.push_back(*number);
  }
  return out;
}

std::optional<StatedCamera> colmap_camera(const std::string& text, const std::string& file) {
  std::vector<ColmapLine> cameras;
  for (const std::string& line : lines_of(text)) {
    if (line.empty() || line.front() == '#') continue;
    const auto camera = colmap_line(line);
    if (!camera) return std::nullopt;
    cameras.push_back(*camera);
  }
  if (cameras.empty()) return std::nullopt;
  if (cameras.size() > 1)
    throw wrong_camera(file, "", "one camera: leave its line alone in a copy of COLMAP's cameras.txt",
                       fmt::format("{} cameras", cameras.size()));
  const ColmapLine& camera = cameras.front();
  for (const ColmapModel& model : colmap_models) {
    if (camera.model != model.name) continue;
    const std::vector<double>& p = camera.parameters;
    const std::size_t before = model.one_focal ? 3 : 4;
    if (p.size() != before + model.lens_terms)
      throw wrong_camera(file, "COLMAP " + camera.model,
                         fmt::format("{} parameters", before + model.lens_terms),
                         fmt::format("{}", p.size()));
    StatedCamera stated{.format = "COLMAP " + camera.model};
    stated.width_px = camera.width_px;
    stated.height_px = camera.height_px;
    stated.fx_px = p[0];
    stated.fy_px = model.one_focal ? p[0] : p[1];
    stated.cx_px = p[before - 2];
    stated.cy_px = p[before - 1];
    stated.from_first_centre = false;
    stated.fisheye = model.fisheye;
    stated.lens.assign(p.begin() + static_cast<std::ptrdiff_t>(before), p.end());
    return stated;
  }
  throw wrong_camera(
      file, "COLMAP",
      "one of SIMPLE_PINHOLE, PINHOLE, SIMPLE_RADIAL, RADIAL, OPENCV, FULL_OPENCV, OPENCV_FISHEYE, "
      "SIMPLE_RADIAL_FISHEYE and RADIAL_FISHEYE",
      printable(camera.model));
}

/// The numbers after "KEY" and a colon, of the first line that has one of the keys.
std::optional<std::vector<double>> kitti_numbers(const std::string& text,
                                                 std::initializer_list<std::string_view> keys) {
  for (const std::string_view key : keys)
    for (const std::string& line : lines_of(text))
      if (line.starts_with(key) && line.size() > key.size() && line[key.size()] == ':')
        return all_numbers(line.substr(key.size() + 1));
  return std::nullopt;
}

std::optional<StatedCamera> kitti_camera(const std::string& text, const std::string& file) {
  const auto p = kitti_numbers(text, {"P_rect_02", "P2"});
  if (!p || p->size() != 12) return std::nullopt;
  StatedCamera stated{.format = "KITTI"};
  take_matrix({(*p)[0], (*p)[1], (*p)[2], (*p)[4], (*p)[5], (*p)[6], (*p)[8], (*p)[9], (*p)[10]}, file,
              stated);
  if (const auto size = kitti_numbers(text, {"S_rect_02"}); size && size->size() == 2) {
    stated.width_px = static_cast<int>(std::clamp((*size)[0], 0.0, 1e6));
    stated.height_px = static_cast<int>(std::clamp((*size)[1], 0.0, 1e6));
  }
  stated.notes.emplace_back("KITTI's left colour camera, rectified (P2)");
  return stated;
}

std::optional<StatedCamera> middlebury_camera(const std::string& text, const std::string& file) {
  if (!text.starts_with("cam0=")) return std::nullopt;
  StatedCamera stated{.format = "Middlebury"};
  for (const std::string& line : lines_of(text)) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) continue;
    const std::string key = line.substr(0, equals);
    const auto numbers = all_numbers(line.substr(equals + 1));
    if (!numbers) continue;
    if (key == "cam0" && numbers->size() == 9) take_matrix(*numbers, file, stated);
    if (key == "width" && numbers->size() == 1)
      stated.width_px = static_cast<int>(std::clamp((*numbers)[0], 0.0, 1e6));
    if (key == "height" && numbers->size() == 1)
      stated.height_px = static_cast<int>(std::clamp((*numbers)[0], 0.0, 1e6));
  }
  stated.notes.emplace_back("Middlebury's left camera; of its disparities, " + request_name("depth_value") +
                            " inverse with " + request_name("depth_scale") + " 1000 / (baseline f) and " +
                            request_name("depth_shift") + " 1000 doffs / (baseline f)");
  return stated;
}

sensors::PinholeCamera pinhole_of_stated(const StatedCamera& stated) {
  const double shift_px = stated.from_first_centre ? 0.5 : 0;
  sensors::PinholeCamera camera;
  camera.width_px = stated.width_px;
  camera.height_px = stated.height_px;
  camera.fx_px = stated.fx_px;
  camera.fy_px = stated.fy_px;
  camera.cx_px = stated.cx_px + shift_px;
  camera.cy_px = stated.cy_px + shift_px;
  camera.skew_px = stated.skew_px;
  return camera;
}

/// OpenCV's rational model: Brown's, divided by 1 + k4 r^2 + k5 r^4 + k6 r^6.
Eigen::Vector2d rational_place(const std::vector<double>& k, const Eigen::Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y(), r2 = x * x + y * y;
  const double radial =
      (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[4]))) / (1 + r2 * (k[5] + r2 * (k[6] + r2 * k[7])));
  return {x * radial + 2 * k[2] * x * y + k[3] * (r2 + 2 * x * x),
          y * radial + k[2] * (r2 + 2 * y * y) + 2 * k[3] * x * y};
}

void take_lens(const StatedCamera& stated, const std::string& file, sensors::PinholeCamera& camera,
               std::vector<std::string>& notes) {
  std::vector<double> k = stated.lens;
  constexpr std::size_t rational_terms = 8;
  for (std::size_t i = rational_terms; i < k.size(); ++i)
    if (k[i] != 0)
      throw wrong_camera(file, stated.format,
                         "a lens of at most OpenCV's eight terms k1 k2 p1 p2 k3 k4 k5 k6",
                         "one with thin prism or tilt");
  k.resize(rational_terms, 0.0);
  if (!std::all_of(k.begin(), k.end(), [](double term) { return std::isfinite(term); }))
    throw wrong_camera(file, stated.format, "a lens whose terms are numbers", "one that is none");
  camera.distortion = {.k1 = k[0], .k2 = k[1], .p1 = k[2], .p2 = k[3], .k3 = k[4]};
  if (k[5] == 0 && k[6] == 0 && k[7] == 0) return;
  const LensFit fit =
      fit_brown([&](const Eigen::Vector2d& ideal) { return rational_place(k, ideal); }, camera);
  constexpr double worst_share = 0.002;
  if (!(fit.worst_px <= worst_share * camera.width_px))
    throw wrong_camera(file, stated.format,
                       "a lens that Brown's five terms can express within 0.2 % of the width",
                       fmt::format("a rational one, {:.2g} pixels off", fit.worst_px));
  camera.distortion = fit.lens;
  notes.push_back(fmt::format(
      "its rational lens is taken as the nearest by Brown's five terms, at most {:.2g} pixels off",
      fit.worst_px));
}

}  // namespace

void take_matrix(const std::vector<double>& k, const std::string& file, StatedCamera& stated) {
  const bool by_rows = k.size() == 9 && k[3] == 0 && k[6] == 0 && k[7] == 0;
  const bool by_columns = k.size() == 9 && k[1] == 0 && k[2] == 0 && k[5] == 0;
  if ((!by_rows && !by_columns) || k[8] == 0)
    throw wrong_camera(file, stated.format, "a camera matrix, fx skew cx, 0 fy cy, 0 0 1", "other numbers");
  stated.fx_px = k[0] / k[8];
  stated.fy_px = k[4] / k[8];
  stated.skew_px = (by_rows ? k[1] : k[3]) / k[8];
  stated.cx_px = (by_rows ? k[2] : k[6]) / k[8];
  stated.cy_px = (by_rows ? k[5] : k[7]) / k[8];
}

std::optional<StatedCamera> text_camera(const std::string& text, const std::string& file) {
  if (auto stated = matrix_alone(text, file)) return stated;
  if (auto stated = middlebury_camera(text, file)) return stated;
  if (auto stated = kitti_camera(text, file)) return stated;
  return colmap_camera(text, file);
}

CameraFile camera_of_stated(StatedCamera stated, const std::string& file,
                            const std::optional<std::pair<int, int>>& size_px) {
  CameraFile cameras;
  if (stated.width_px == 0 || stated.height_px == 0) {
    if (!size_px)
      throw wrong_camera(file, stated.format,
                         "the size of its pictures in pixels, which another format states", "none");
    std::tie(stated.width_px, stated.height_px) = *size_px;
    stated.notes.push_back(fmt::format("{} states no size: it is taken as that of the photograph, {} x {}",
                                       stated.format, stated.width_px, stated.height_px));
  }
  if (std::max(stated.width_px, stated.height_px) > limits::largest_picture_side_px)
    throw wrong_camera(file, stated.format,
                       fmt::format("at most {0} x {0} pixels", limits::largest_picture_side_px),
                       fmt::format("{} x {}", stated.width_px, stated.height_px));
  cameras.notes = std::move(stated.notes);
  cameras.notes.insert(cameras.notes.begin(), "a camera of " + stated.format);
  cameras.world_from_colour = stated.world_from_camera;
  sensors::PinholeCamera camera = pinhole_of_stated(stated);
  sensors::require_valid(camera, fmt::format("{}: {}: ", file, stated.format));
  if (stated.fisheye) {
    stated.lens.resize(4, 0.0);
    cameras.fisheye = sensors::FisheyeCamera{.width_px = camera.width_px,
                                             .height_px = camera.height_px,
                                             .fx_px = camera.fx_px,
                                             .fy_px = camera.fy_px,
                                             .cx_px = camera.cx_px,
                                             .cy_px = camera.cy_px,
                                             .skew_px = camera.skew_px,
                                             .k1 = stated.lens[0],
                                             .k2 = stated.lens[1],
                                             .k3 = stated.lens[2],
                                             .k4 = stated.lens[3]};
    sensors::require_valid(*cameras.fisheye, fmt::format("{}: {}: ", file, stated.format));
    return cameras;
  }
  take_lens(stated, file, camera, cameras.notes);
  cameras.colour = camera;
  return cameras;
}

}  // namespace seamline::registration
