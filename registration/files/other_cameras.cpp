#include "registration/files/other_cameras.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "registration/files/text_cameras.h"
#include "registration/files/yaml_tree.h"
#include "support/text/error.h"
#include "support/text/pattern.h"
#include "support/text/printable.h"

namespace seamline::registration {
namespace {

using nlohmann::json;

/// A tree of a file, and the words of complaints about it.
struct CameraTree {
  const json& tree;
  std::string file, format;

  [[nodiscard]] InputError wrong(const std::string& key, const std::string& wanted,
                                 const std::string& found) const {
    return input_error(
        {.file = file, .field = format + (key.empty() ? "" : ": " + key), .wanted = wanted, .found = found});
  }
};

const json* member(const json& tree, std::initializer_list<const char*> names) {
  if (!tree.is_object()) return nullptr;
  for (const char* name : names)
    if (const auto found = tree.find(name); found != tree.end() && !found->is_null()) return &*found;
  return nullptr;
}

/// Numbers of a list, of lists in it, or of an OpenCV matrix; none: something else.
std::optional<std::vector<double>> numbers_of_node(const json* node, int depth = 0) {
  constexpr int deepest_list = 4;
  constexpr std::size_t most_numbers = 64;
  if (node && node->is_object()) node = member(*node, {"data"});
  if (!node || !node->is_array() || depth > deepest_list) return std::nullopt;
  std::vector<double> numbers;
  for (const json& entry : *node) {
    if (entry.is_number()) {
      numbers.push_back(entry.get<double>());
    } else if (const auto inner = numbers_of_node(&entry, depth + 1)) {
      numbers.insert(numbers.end(), inner->begin(), inner->end());
    } else {
      return std::nullopt;
    }
    if (numbers.size() > most_numbers) return std::nullopt;
  }
  return numbers;
}

double number_of_member(const CameraTree& in, const json& tree, std::initializer_list<const char*> names) {
  const json* node = member(tree, names);
  if (!node || !node->is_number())
    throw in.wrong(*names.begin(), "a number", node ? "something else" : "nothing");
  return node->get<double>();
}

int whole_pixels(double side) {
  return static_cast<int>(std::clamp(side, 0.0, 1e6));
}

void take_size(const json& tree, StatedCamera& stated) {
  const json* width = member(tree, {"image_width", "width", "w", "img_width", "imageWidth"});
  const json* height = member(tree, {"image_height", "height", "h", "img_height", "imageHeight"});
  if (width && height && width->is_number() && height->is_number()) {
    stated.width_px = whole_pixels(width->get<double>());
    stated.height_px = whole_pixels(height->get<double>());
    return;
  }
  const auto size =
      numbers_of_node(member(tree, {"resolution", "image_size", "imageSize", "img_size", "size"}));
  if (!size || size->size() != 2) return;
  stated.width_px = whole_pixels((*size)[0]);
  stated.height_px = whole_pixels((*size)[1]);
}

/// What a file calls its lens.
void take_lens_name(const CameraTree& in, const std::string& name, StatedCamera& stated) {
  const auto is = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  if (is({"", "none", "None", "plumb_bob", "radtan", "brown_conrady", "rational_polynomial", "opencv",
          "pinhole", "OPENCV"}))
    return;
  if (is({"equidistant", "equidist", "fisheye", "kannala_brandt", "kannala_brandt4", "OPENCV_FISHEYE"})) {
    stated.fisheye = true;
    return;
  }
  throw in.wrong("distortion_model", "plumb_bob, radtan, rational_polynomial, equidistant or none", name);
}

std::string text_of_node(const json* node) {
  return node && node->is_string() ? node->get<std::string>() : std::string();
}

StatedCamera opencv_camera(CameraTree in) {
  const json& tree = in.tree;
  const json* model = member(tree, {"distortion_model"});
  in.format = model ? "ROS camera_info" : "OpenCV";
  StatedCamera stated{.format = in.format};
  const auto k =
      numbers_of_node(member(tree, {"camera_matrix", "Camera_Matrix", "cameraMatrix", "CameraMatrix",
                                    "intrinsic_matrix", "K", "k", "M1", "K1", "mtx"}));
  if (!k) throw in.wrong("camera_matrix", "nine numbers", "something else");
  take_matrix(*k, in.file, stated);
  take_size(tree, stated);
  take_lens_name(in, text_of_node(model), stated);
  if (const json* flag = member(tree, {"fisheye_model", "fisheye"}))
    stated.fisheye =
        (flag->is_number() && flag->get<double>() != 0) || (flag->is_boolean() && flag->get<bool>());
  const json* lens = member(tree, {"distortion_coefficients", "Distortion_Coefficients", "dist_coeffs",
                                   "distCoeffs", "distortion", "dist_coeff", "dist", "D", "d", "D1"});
  if (lens) {
    const auto terms = numbers_of_node(lens);
    if (!terms) throw in.wrong("distortion_coefficients", "numbers", "something else");
    stated.lens = *terms;
    const std::size_t count = terms->size();
    if (stated.fisheye ? count != 4
                       : count != 0 && count != 4 && count != 5 && count != 8 && count != 12 && count != 14)
      throw in.wrong("distortion_coefficients",
                     stated.fisheye ? "the four terms of a fisheye" : "0, 4, 5, 8, 12 or 14 numbers",
                     fmt::format("{}", count));
  } else {
    stated.notes.emplace_back("it states no lens");
  }
  return stated;
}

const json* kalibr_camera(const json& tree, std::string& name) {
  if (!tree.is_object()) return nullptr;
  for (const auto& [key, value] : tree.items())
    if (key.starts_with("cam") && value.is_object() && value.contains("intrinsics")) {
      name = key;
      return &value;
    }
  return tree.contains("intrinsics") && tree.contains("camera_model") ? &tree : nullptr;
}

StatedCamera camera_of_kalibr(CameraTree in, const json& camera, const std::string& name) {
  in.format = "Kalibr";
  StatedCamera stated{.format = in.format};
  if (const std::string model = text_of_node(member(camera, {"camera_model"})); model != "pinhole")
    throw in.wrong("camera_model", "pinhole (with radtan, equidistant or no distortion)", printable(model));
  const auto k = numbers_of_node(member(camera, {"intrinsics"}));
  if (!k || k->size() != 4) throw in.wrong("intrinsics", "four numbers: fx, fy, cx, cy", "something else");
  stated.fx_px = (*k)[0], stated.fy_px = (*k)[1], stated.cx_px = (*k)[2], stated.cy_px = (*k)[3];
  take_size(camera, stated);
  take_lens_name(in, text_of_node(member(camera, {"distortion_model"})), stated);
  if (const auto terms = numbers_of_node(member(camera, {"distortion_coeffs"}))) stated.lens = *terms;
  if (in.tree.size() > 1 && !name.empty())
    stated.notes.push_back(fmt::format("of its cameras it is {}", printable(name)));
  return stated;
}

StatedCamera open3d_camera(CameraTree in) {
  in.format = "Open3D";
  StatedCamera stated{.format = in.format};
  const json* inner = member(in.tree, {"intrinsic"});
  const json& intrinsic = inner ? *inner : in.tree;
  const auto k = numbers_of_node(member(intrinsic, {"intrinsic_matrix"}));
  if (!k) throw in.wrong("intrinsic_matrix", "nine numbers", "something else");
  take_matrix(*k, in.file, stated);
  take_size(intrinsic, stated);
  const auto pose = numbers_of_node(member(in.tree, {"extrinsic"}));
  if (!pose) return stated;
  if (pose->size() != 16) throw in.wrong("extrinsic", "16 numbers", fmt::format("{}", pose->size()));
  Eigen::Isometry3d camera_from_world;
  camera_from_world.matrix() = Eigen::Map<const Eigen::Matrix4d>(pose->data());  // column by column
  sensors::require_rigid(camera_from_world, in.file + ": Open3D: extrinsic");
  stated.world_from_camera = camera_from_world.inverse();
  return stated;
}

/// As VINS and camodocal write them.
StatedCamera camodocal_camera(CameraTree in, const json& projection) {
  in.format = "camodocal";
  StatedCamera stated{.format = in.format};
  const std::string model = text_of_node(member(in.tree, {"model_type"}));
  if (model != "PINHOLE" && model != "KANNALA_BRANDT")
    throw in.wrong("model_type", "PINHOLE or KANNALA_BRANDT", printable(model));
  stated.fisheye = model == "KANNALA_BRANDT";
  stated.fx_px = number_of_member(in, projection, {"fx", "mu"});
  stated.fy_px = number_of_member(in, projection, {"fy", "mv"});
  stated.cx_px = number_of_member(in, projection, {"cx", "u0"});
  stated.cy_px = number_of_member(in, projection, {"cy", "v0"});
  take_size(in.tree, stated);
  const json* lens = stated.fisheye ? &projection : member(in.tree, {"distortion_parameters"});
  if (!lens) return stated;
  const std::initializer_list<const char*> brown = {"k1", "k2", "p1", "p2"}, bend = {"k2", "k3", "k4", "k5"};
  for (const char* name : stated.fisheye ? bend : brown)
    stated.lens.push_back(number_of_member(in, *lens, {name}));
  return stated;
}

/// All objects of a tree that state a focal length, with their keys' path.
void collect_focal(const json& tree, const std::string& path, int depth,
                   std::vector<std::pair<std::string, const json*>>& found) {
  constexpr int deepest = 8;
  if (depth > deepest || (!tree.is_object() && !tree.is_array())) return;
  if (tree.is_object() && tree.contains("fx") && tree.contains("fy")) {
    found.emplace_back(path, &tree);
    return;
  }
  for (const auto& [key, value] : tree.items()) collect_focal(value, path + "/" + key, depth + 1, found);
}

StatedCamera camera_of_focal(CameraTree in, const std::vector<std::pair<std::string, const json*>>& found) {
  const Pattern colour("colou?r|rgb", Pattern::Case::any);
  const auto* chosen = &found.front();
  for (const auto& one : found)
    if (colour.is_in(one.first)) chosen = &one;
  if (found.size() > 1 && !colour.is_in(chosen->first))
    throw in.wrong("", "one camera, or one called color", fmt::format("{} cameras", found.size()));
  const json& camera = *chosen->second;
  in.format = camera.contains("ppx") ? "RealSense" : "fx, fy, cx, cy";
  StatedCamera stated{.format = in.format};
  stated.fx_px = number_of_member(in, camera, {"fx"});
  stated.fy_px = number_of_member(in, camera, {"fy"});
  stated.cx_px = number_of_member(in, camera, {"ppx", "cx"});
  stated.cy_px = number_of_member(in, camera, {"ppy", "cy"});
  take_size(camera, stated);
  if (found.size() > 1) stated.notes.push_back("of its cameras it is " + printable(chosen->first));
  const auto terms = numbers_of_node(member(camera, {"coeffs", "distortion_coefficients", "dist", "D"}));
  if (!terms || std::all_of(terms->begin(), terms->end(), [](double term) { return term == 0; }))
    return stated;
  std::string model = text_of_node(member(camera, {"model", "distortion_model"}));
  std::transform(model.begin(), model.end(), model.begin(), [](char letter) {
    return letter == ' '                    ? '_'
           : letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a')
                                            : letter;
  });
  if (const std::size_t dot = model.rfind('.'); dot != std::string::npos) model = model.substr(dot + 1);
  if (model == "inverse_brown_conrady" || model == "modified_brown_conrady" || model == "ftheta")
    throw in.wrong("model", "a lens without terms, brown_conrady or kannala_brandt4", model);
  take_lens_name(in, model, stated);
  stated.lens = *terms;
  if (stated.fisheye) stated.lens.resize(4, 0.0);
  return stated;
}

/// Azure Kinect's raw calibration: numbers of a picture of side 1, counted from its corner, of the whole
/// sensor; a mode is a cut of it (Microsoft's Sensor SDK, mode_specific_calibration.c).
StatedCamera kinect_camera(CameraTree in, const json& information,
                           const std::optional<std::pair<int, int>>& size_px) {
  in.format = "Azure Kinect";
  StatedCamera stated{.format = in.format};
  if (!size_px)
    throw in.wrong("", "the photograph beside it, whose size is the camera's mode; or a file of one mode",
                   "none");
  const json* cameras = member(information, {"Cameras"});
  const json* colour = nullptr;
  if (cameras && cameras->is_array())
    for (const json& camera : *cameras)
      if (text_of_node(member(camera, {"Purpose"})) == "CALIBRATION_CameraPurposePhotoVideo" ||
          text_of_node(member(camera, {"Location"})) == "CALIBRATION_CameraLocationPV0")
        colour = &camera;
  const json* intrinsics = colour ? member(*colour, {"Intrinsics"}) : nullptr;
  const auto p = intrinsics ? numbers_of_node(member(*intrinsics, {"ModelParameters"})) : std::nullopt;
  if (!p || p->size() < 14)
    throw in.wrong("ModelParameters", "14 numbers of its colour camera",
                   colour ? "something else" : "no such camera");
  const double width = size_px->first, height = size_px->second;
  const double whole_height = width * 3 / 4;
  const bool has_mode = height == whole_height || height * 16 == width * 9;
  if (!has_mode)
    throw in.wrong("", "a photograph of 4:3 or 16:9, a mode of its colour camera",
                   fmt::format("{} x {}", size_px->first, size_px->second));
  stated.width_px = size_px->first;
  stated.height_px = size_px->second;
  stated.from_first_centre = false;
  stated.cx_px = (*p)[0] * width;
  stated.cy_px = (*p)[1] * whole_height - (whole_height - height) / 2;
  stated.fx_px = (*p)[2] * width;
  stated.fy_px = (*p)[3] * whole_height;
  if ((*p)[10] != 0 || (*p)[11] != 0)
    throw in.wrong("ModelParameters", "a lens centred on its axis", "another");
  stated.lens = {(*p)[4], (*p)[5], (*p)[13], (*p)[12], (*p)[6], (*p)[7], (*p)[8], (*p)[9]};
  return stated;
}

StatedCamera tree_camera(const json& tree, const std::string& file,
                         const std::optional<std::pair<int, int>>& size_px) {
  const CameraTree in{tree, file, "a camera"};
  if (!tree.is_object()) throw in.wrong("", "keys and values", "something else");
  if (const json* information = member(tree, {"CalibrationInformation"}))
    return kinect_camera(in, *information, size_px);
  if (member(tree, {"intrinsic"}) || (member(tree, {"intrinsic_matrix"}) && !member(tree, {"camera_matrix"})))
    return open3d_camera(in);
  std::string name;
  if (const json* camera = kalibr_camera(tree, name)) return camera_of_kalibr(in, *camera, name);
  if (member(tree,
             {"camera_matrix", "Camera_Matrix", "cameraMatrix", "CameraMatrix", "K", "k", "M1", "K1", "mtx"}))
    return opencv_camera(in);
  if (const json* projection = member(tree, {"projection_parameters"}))
    return camodocal_camera(in, *projection);
  std::vector<std::pair<std::string, const json*>> found;
  collect_focal(tree, "", 0, found);
  if (!found.empty()) return camera_of_focal(in, found);
  throw in.wrong(
      "",
      "a camera of OpenCV (camera_matrix), ROS (camera_matrix, distortion_model), Kalibr (cam0), Open3D "
      "(intrinsic_matrix), Azure Kinect (CalibrationInformation) or RealSense (fx, fy, ppx, ppy)",
      "none of their keys");
}

std::string without_blank_start(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  return from == std::string::npos ? std::string() : text.substr(from);
}

bool is_json(const std::string& start) {
  return start.starts_with("{");
}

/// A key with a colon before any key with an equals sign.
bool looks_like_yaml(const std::string& start) {
  if (start.starts_with("%YAML") || start.starts_with("---")) return true;
  std::size_t at = 0;
  while (at < start.size()) {
    const std::size_t end = std::min(start.find('\n', at), start.size());
    const std::string_view line = std::string_view(start).substr(at, end - at);
    at = end + 1;
    const std::size_t from = line.find_first_not_of(" \t\r");
    if (from == std::string_view::npos || line[from] == '#') continue;
    const std::size_t sign = line.find_first_of(":=", from);
    return sign != std::string_view::npos && line[sign] == ':';
  }
  return false;
}

bool is_lines_of_numbers(const std::string& start) {
  try {
    return text_camera(start, "").has_value();
  } catch (const InputError&) {
    return true;  // of a known format, with something missing
  }
}

}  // namespace

bool is_other_camera(const std::string& text) {
  const std::string start = without_blank_start(text);
  if (start.empty()) return false;
  return is_json(start) || start.starts_with("<") || looks_like_yaml(start) || is_lines_of_numbers(start);
}

CameraFile parse_other_camera(const std::string& text, const std::string& file,
                              const std::optional<std::pair<int, int>>& size_px) {
  const std::string start = without_blank_start(text);
  if (start.starts_with("<"))
    throw input_error({.file = file,
                       .wanted = "a camera as TOML, YAML, JSON or lines of numbers (OpenCV writes YAML too)",
                       .found = "XML"});
  if (is_json(start)) {
    const json tree = json::parse(start, nullptr, false, true);
    if (tree.is_discarded())
      throw input_error({.file = file, .wanted = "a camera as JSON", .found = "damaged JSON"});
    return camera_of_stated(tree_camera(tree, file, size_px), file, size_px);
  }
  if (const auto stated = text_camera(start, file)) return camera_of_stated(*stated, file, size_px);
  return camera_of_stated(tree_camera(yaml_tree(start, file), file, size_px), file, size_px);
}

}  // namespace seamline::registration
