#include "registration/files/camera_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "registration/files/other_cameras.h"
#include "registration/files/pose_table.h"
#include "sensors/files/depth_units.h"
#include "sensors/files/depth_words.h"
#include "sensors/noise/measurement.h"
#include "sensors/rig/presets.h"
#include "support/files/atomic_file.h"
#include "support/files/toml_table.h"
#include "support/text/limits.h"

namespace seamline::registration {
namespace {

using sensors::DepthConvention;
using sensors::DepthPacking;
using sensors::PinholeCamera;

constexpr const char* format_text = "seamline camera 1";
constexpr NumberRange any_size_px{2, limits::largest_picture_side_px, "px"};
constexpr NumberRange any_focal_px{1e-3, 1e9, "px"};
constexpr NumberRange any_position_px{-1e9, 1e9, "px"};
constexpr NumberRange lens_term{-1e6, 1e6};
constexpr NumberRange any_distance_m{0, 1e9, "m"};
constexpr NumberRange any_step_m{1e-12, 1e9, "m"};
constexpr NumberRange any_value{-1e30, 1e30};

/// The one of some words that a key holds.
template <class Value>
Value word(const TomlTable& table, const std::string& key,
           std::initializer_list<std::pair<const char*, Value>> words) {
  const std::string found = table.text(key);
  std::string known;
  for (const auto& [name, value] : words) {
    if (found == name) return value;
    known += (known.empty() ? "\"" : " or \"") + std::string(name) + "\"";
  }
  throw table.complaint(key, known, "\"" + found + "\"");
}

/// The same of an enumeration, whose words stand in its order.
template <class Value, std::size_t count>
Value word(const TomlTable& table, const std::string& key, const std::array<std::string_view, count>& words) {
  const std::string text = table.text(key);
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end())
    throw table.complaint(key, fmt::format("\"{}\"", fmt::join(words, "\" or \"")), "\"" + text + "\"");
  return static_cast<Value>(found - words.begin());
}

double required(const TomlTable& table, const std::string& key, const std::optional<double>& known,
                NumberRange range) {
  if (!table.has(key) && !known) throw table.complaint(key, range_text("a number", range), "nothing");
  return table.number(key, known.value_or(0), range);
}

/// `known`: of a preset, whose values stay where the table has none.
PinholeCamera read_camera(const TomlTable& table, const std::optional<PinholeCamera>& known,
                          double to_half_integers_px) {
  PinholeCamera camera = known.value_or(PinholeCamera{});
  const auto given = [&](auto value) {
    return known ? std::optional<double>(static_cast<double>(value)) : std::nullopt;
  };
  for (const auto& [key, size] :
       {std::pair{"width_px", &camera.width_px}, std::pair{"height_px", &camera.height_px}}) {
    if (!table.has(key) && !known)
      throw table.complaint(key, range_text("a whole number", any_size_px), "nothing");
    *size = table.integer(key, *size, any_size_px);
  }
  camera.fx_px = required(table, "fx_px", given(camera.fx_px), any_focal_px);
  camera.fy_px = required(table, "fy_px", given(camera.fy_px), any_focal_px);
  for (const auto& [key, place] : {std::pair{"cx_px", &camera.cx_px}, std::pair{"cy_px", &camera.cy_px}}) {
    const double shift_px = table.has(key) ? to_half_integers_px : 0;
    *place = required(table, key, given(*place), any_position_px) + shift_px;
  }
  camera.skew_px = table.number("skew_px", camera.skew_px, any_position_px);
  if (table.has("lens") && table.text("lens") != "brown")
    throw table.complaint("lens", "\"brown\", or \"fisheye\" of the photograph's camera",
                          "\"" + table.text("lens") + "\"");
  sensors::LensDistortion& lens = camera.distortion;
  for (const auto& [key, term] :
       {std::pair{"k1", &lens.k1}, std::pair{"k2", &lens.k2}, std::pair{"p1", &lens.p1},
        std::pair{"p2", &lens.p2}, std::pair{"k3", &lens.k3}})
    *term = table.number(key, *term, lens_term);
  table.finish();
  return camera;
}

/// A lens by Kannala and Brandt: four terms, and nothing of a preset.
sensors::FisheyeCamera read_fisheye(const TomlTable& table, double to_half_integers_px) {
  sensors::FisheyeCamera camera;
  for (const auto& [key, size] :
       {std::pair{"width_px", &camera.width_px}, std::pair{"height_px", &camera.height_px}}) {
    if (!table.has(key)) throw table.complaint(key, range_text("a whole number", any_size_px), "nothing");
    *size = table.integer(key, *size, any_size_px);
  }
  camera.fx_px = required(table, "fx_px", {}, any_focal_px);
  camera.fy_px = required(table, "fy_px", {}, any_focal_px);
  camera.cx_px = required(table, "cx_px", {}, any_position_px) + to_half_integers_px;
  camera.cy_px = required(table, "cy_px", {}, any_position_px) + to_half_integers_px;
  camera.skew_px = table.number("skew_px", 0, any_position_px);
  for (const auto& [key, term] : {std::pair{"k1", &camera.k1}, std::pair{"k2", &camera.k2},
                                  std::pair{"k3", &camera.k3}, std::pair{"k4", &camera.k4}})
    *term = table.number(key, 0, lens_term);
  table.finish();
  return camera;
}

std::string fisheye_text(const sensors::FisheyeCamera& camera) {
  return fmt::format(
      "\n[colour]\nlens = \"fisheye\"\nwidth_px = {}\nheight_px = {}\nfx_px = {}\nfy_px = {}\ncx_px = {}\ncy_px = "
      "{}\nskew_px = {}\nk1 = {}\nk2 = {}\nk3 = {}\nk4 = {}\n",
      camera.width_px, camera.height_px, camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px,
      camera.skew_px, camera.k1, camera.k2, camera.k3, camera.k4);
}

std::string camera_text(const char* name, const PinholeCamera& camera) {
  const sensors::LensDistortion& lens = camera.distortion;
  return fmt::format(
      "\n[{}]\nwidth_px = {}\nheight_px = {}\nfx_px = {}\nfy_px = {}\ncx_px = {}\ncy_px = {}\nskew_px = {}\n"
      "k1 = {}\nk2 = {}\np1 = {}\np2 = {}\nk3 = {}\n",
      name, camera.width_px, camera.height_px, camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px,
      camera.skew_px, lens.k1, lens.k2, lens.p1, lens.p2, lens.k3);
}

/// The unit of depth files by the name of a camera or data set.
void take_unit(const TomlTable& table, CameraFile& cameras) {
  if (table.has("metres_per_step"))
    throw table.complaint("depth_unit", "depth_unit or metres_per_step, not both", "both");
  const sensors::DepthUnit& unit = sensors::depth_unit(table.text("depth_unit"), table.field("depth_unit"));
  cameras.metres_per_step = unit.metres_per_step;
  cameras.nothing = unit.nothing;
}

CameraFile camera_file_of(const TomlTable& table, const std::string& file) {
  const std::string format = table.text("format");
  if (format != format_text)
    throw table.complaint("format", fmt::format("\"{}\"", format_text), "\"" + format + "\"");
  CameraFile cameras;
  if (table.has("preset")) {
    cameras = camera_file_of_preset(table.text("preset"), file + ": preset");
  }
  const double shift_px =
      table.has("pixel_centres") ? word<double>(table, "pixel_centres", {{"half", 0}, {"integer", 0.5}}) : 0;
  if (table.has("convention"))
    cameras.convention = word<DepthConvention>(table, "convention", sensors::words_of_conventions);
  if (table.has("packing"))
    cameras.packing = word<DepthPacking>(table, "packing", sensors::words_of_packings);
  if (table.has("metres_per_step")) cameras.metres_per_step = table.number("metres_per_step", 0, any_step_m);
  if (table.has("nearest_m")) cameras.nearest_m = table.number("nearest_m", 0, any_distance_m);
  if (table.has("farthest_m")) cameras.farthest_m = table.number("farthest_m", 0, any_distance_m);
  if (cameras.nearest_m && cameras.farthest_m && !(*cameras.nearest_m < *cameras.farthest_m))
    throw table.complaint("farthest_m", "more than nearest_m", fmt::format("{}", *cameras.farthest_m));
  cameras.unusual_distances = table.boolean("unusual_distances", false);
  if (table.has("depth_unit")) take_unit(table, cameras);
  if (table.has("nothing")) cameras.nothing = table.numbers("nothing", any_value);
  if (table.has("up")) {
    const std::array<double, 3> up = table.triple("up", {0, 1, 0}, {-1, 1});
    cameras.up = Eigen::Vector3d(up[0], up[1], up[2]);
    if (!(cameras.up->norm() > 1e-6)) throw table.complaint("up", "a direction", "[0, 0, 0]");
  }
  if (const auto depth = table.table("depth")) cameras.depth = read_camera(*depth, cameras.depth, shift_px);
  if (const auto colour = table.table("colour")) {
    if (colour->has("lens") && word<bool>(*colour, "lens", {{"fisheye", true}, {"brown", false}}))
      cameras.fisheye = read_fisheye(*colour, shift_px);
    else
      cameras.colour = read_camera(*colour, cameras.colour, shift_px);
  }
  if (cameras.fisheye) cameras.colour.reset();
  for (const auto& [key, pose] : {std::pair{"colour_from_depth", &cameras.colour_from_depth},
                                  std::pair{"world_from_colour", &cameras.world_from_colour}})
    if (const auto found = table.table(key)) *pose = read_pose(*found);
  table.finish();
  return cameras;
}

}  // namespace

bool is_preset(const std::string& key) {
  for (const sensors::SensorPreset& preset : sensors::sensor_presets())
    if (preset.key == key) return true;
  return false;
}

CameraFile camera_file_of_preset(const std::string& key, const std::string& field) {
  const sensors::SensorPreset& preset = sensors::sensor_preset(key, field);
  const auto* rig = std::get_if<sensors::Rig>(&preset.sensor);
  if (rig == nullptr)
    throw input_error({.field = field,
                       .wanted = "a preset with a depth and a colour camera",
                       .found = key + ", a scanner"});
  CameraFile cameras;
  cameras.depth = rig->depth;
  cameras.colour = rig->colour;
  cameras.colour_from_depth = rig->colour_from_depth;
  cameras.convention = sensors::convention_of(rig->noise);
  const sensors::SensorRange range = std::visit([](const auto& model) { return model.range; }, rig->noise);
  cameras.nearest_m = range.nearest_m;
  cameras.farthest_m = range.farthest_m;
  return cameras;
}

CameraFile parse_camera_file(const std::string& text, const std::filesystem::path& path) {
  CameraFile cameras = camera_file_of(TomlTable::parse(text, path), path.string());
  const std::string where = path.string() + ": ";
  if (cameras.depth) sensors::require_valid(*cameras.depth, where + "depth.");
  if (cameras.colour) sensors::require_valid(*cameras.colour, where + "colour.");
  if (cameras.fisheye) sensors::require_valid(*cameras.fisheye, where + "colour.");
  if (cameras.colour_from_depth)
    sensors::require_rigid(*cameras.colour_from_depth, where + "colour_from_depth.rotation");
  if (cameras.world_from_colour)
    sensors::require_rigid(*cameras.world_from_colour, where + "world_from_colour.rotation");
  return cameras;
}

CameraFile read_camera_file(const std::filesystem::path& path,
                            const std::optional<std::pair<int, int>>& size_px) {
  const std::string text = read_file(path, limits::largest_study_file_bytes);
  if (is_other_camera(text)) return parse_other_camera(text, path.string(), size_px);
  return parse_camera_file(text, path);
}

std::string camera_file_text(const CameraFile& cameras, const std::string& remark) {
  std::string text;
  for (std::size_t at = 0; at < remark.size();) {
    const std::size_t end = std::min(remark.find('\n', at), remark.size());
    text += "# " + remark.substr(at, end - at) + "\n";
    at = end + 1;
  }
  text += fmt::format("format = \"{}\"\n", format_text);
  if (cameras.convention) text += fmt::format("convention = \"{}\"\n", sensors::word(*cameras.convention));
  if (cameras.packing) text += fmt::format("packing = \"{}\"\n", sensors::word(*cameras.packing));
  for (const auto& [key, value] :
       {std::pair{"metres_per_step", cameras.metres_per_step}, std::pair{"nearest_m", cameras.nearest_m},
        std::pair{"farthest_m", cameras.farthest_m}})
    if (value) text += fmt::format("{} = {}\n", key, *value);
  if (cameras.unusual_distances) text += "unusual_distances = true\n";
  if (cameras.nothing) text += fmt::format("nothing = [{}]\n", fmt::join(*cameras.nothing, ", "));
  if (cameras.up)
    text += fmt::format("up = [{}, {}, {}]\n", cameras.up->x(), cameras.up->y(), cameras.up->z());
  if (cameras.depth) text += camera_text("depth", *cameras.depth);
  if (cameras.colour) text += camera_text("colour", *cameras.colour);
  if (cameras.fisheye) text += fisheye_text(*cameras.fisheye);
  if (cameras.colour_from_depth) text += pose_text("colour_from_depth", *cameras.colour_from_depth);
  if (cameras.world_from_colour) text += pose_text("world_from_colour", *cameras.world_from_colour);
  return text;
}

RegistrationRig registration_rig(const CameraFile& cameras, const std::string& file) {
  const auto require = [&](bool known, const char* field, const char* wanted) {
    if (!known) throw input_error({.file = file, .field = field, .wanted = wanted, .found = "nothing"});
  };
  if (cameras.fisheye)
    throw input_error({.file = file,
                       .field = "colour",
                       .wanted = "a camera whose lens is Brown's",
                       .found = "a fisheye, which composite and place take and registration does not"});
  require(cameras.depth.has_value(), "depth", "a table [depth], the depth camera, or a preset");
  require(cameras.colour.has_value(), "colour", "a table [colour], the photograph's camera, or a preset");
  require(cameras.colour_from_depth.has_value(), "colour_from_depth",
          "a table [colour_from_depth]; where depth is registered already, translation_m = [0, 0, 0]");
  require(cameras.convention.has_value(), "convention", "\"radial\" or \"planar\"");
  RegistrationRig rig;
  rig.depth_form = {.camera = *cameras.depth,
                    .convention = *cameras.convention,
                    .metres_per_step = cameras.metres_per_step,
                    .packing = cameras.packing.value_or(DepthPacking::whole),
                    .nearest_m = cameras.nearest_m.value_or(0),
                    .farthest_m = cameras.farthest_m.value_or(1e9),
                    .unusual_distances = cameras.unusual_distances};
  rig.colour = *cameras.colour;
  rig.colour_from_depth = *cameras.colour_from_depth;
  rig.world_from_colour = cameras.world_from_colour;
  return rig;
}

}  // namespace seamline::registration
