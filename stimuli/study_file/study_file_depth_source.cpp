#include "stimuli/study_file/study_file_depth_source.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sensors/rig/presets.h"
#include "stimuli/settings/depth_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/study_file_noise.h"
#include "stimuli/study_file/study_file_words.h"
#include "support/text/suggest.h"

namespace seamline::inline stimuli {
namespace {

constexpr Range side_range{2, 8192, "px"}, distance_range{0, 1e9, "m"};
constexpr std::size_t most_sources = 8;
constexpr int usual_reduction_factor = 4;

// Keys of one source, by what they are for.
constexpr std::array camera_keys = {
    "size_px", "fx", "fy", "cx", "cy", "skew", "distortion", "field_of_view_deg", "texels_per_degree"};
constexpr std::array sensor_keys = {"convention", "pose"};
constexpr std::array panorama_keys = {"reduction", "reduction_factor"};
constexpr std::array file_keys = {"file", "metres_per_step", "packing"};
constexpr std::array noise_keys = {"noise", "projector_m"};
constexpr std::array all_kinds_keys = {"preset", "range_m"};

template <class Keys>
void refuse_keys(const TomlTable& table, const Keys& keys, const std::string& wanted) {
  for (const char* key : keys)
    if (table.has(key)) throw table.complaint(key, wanted, "a setting of its own");
}

sensors::SensorRange read_range_m(const TomlTable& table, const sensors::SensorRange& usual) {
  if (!table.has("range_m")) return usual;
  const std::vector<double> ends = table.numbers("range_m", distance_range);
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    throw table.complaint(
        "range_m", "two distances, the nearest and a larger one",
        fmt::format("{} numbers{}", ends.size(), ends.size() == 2 ? " that do not rise" : ""));
  return {.nearest_m = ends[0], .farthest_m = ends[1]};
}

void read_size(const TomlTable& table, bool known, sensors::PinholeCamera& camera) {
  if (!table.has("size_px")) {
    if (!known) throw table.complaint("size_px", "width and height of the depth map", "nothing");
    return;
  }
  const std::vector<int> size = table.integers("size_px", side_range);
  if (size.size() != 2 || size[0] % 2 != 0)
    throw table.complaint("size_px", "two whole numbers, the first an even one: [width, height]",
                          size.size() == 2 ? fmt::format("[{}, {}]", size[0], size[1])
                                           : fmt::format("an array of {}", size.size()));
  camera = resized(camera, size[0], size[1]);
}

/// One way to say how wide the camera looks; fx = fy but where `fy` says otherwise.
void read_focal_lengths(const TomlTable& table, bool known, sensors::PinholeCamera& camera) {
  constexpr std::array ways = {"field_of_view_deg", "texels_per_degree", "fx"};
  const auto given = std::count_if(ways.begin(), ways.end(), [&](const char* key) { return table.has(key); });
  if (given > 1)
    throw table.complaint("field_of_view_deg", "one of field_of_view_deg, texels_per_degree and fx",
                          "several");
  if (given == 0 && !known)
    throw table.complaint("fx", "fx, field_of_view_deg or texels_per_degree of the pinhole", "none of them");
  constexpr Range focal_range{1e-3, 1e6, "pixels"};
  if (table.has("fx")) camera.fx_px = camera.fy_px = table.number("fx", 0, focal_range);
  if (table.has("field_of_view_deg")) {
    const double deg = table.number("field_of_view_deg", 0, {1, 170, "degrees"});
    camera.fx_px = camera.fy_px =
        sensors::pinhole_of_field_of_view(camera.width_px, camera.height_px, deg).fx_px;
  }
  if (table.has("texels_per_degree"))
    camera.fx_px = camera.fy_px =
        table.number("texels_per_degree", 0, {1e-3, 1e4, "texels per degree"}) * 180 / std::numbers::pi;
  if (table.has("fy")) {
    if (given > 0 && !table.has("fx"))
      throw table.complaint("fy", "fx beside it, or neither", "another way to say how wide the camera looks");
    camera.fy_px = table.number("fy", 0, focal_range);
  }
}

sensors::PinholeCamera read_camera(const TomlTable& table, const sensors::PinholeCamera& usual, bool known) {
  sensors::PinholeCamera camera = usual;
  read_size(table, known, camera);
  read_focal_lengths(table, known, camera);
  if (!known) {
    camera.cx_px = 0.5 * camera.width_px;
    camera.cy_px = 0.5 * camera.height_px;
  }
  read_settings(table, camera);
  if (table.has("distortion")) {
    const std::vector<double> k = table.numbers("distortion", {-1e3, 1e3});
    if (k.size() != 5)
      throw table.complaint("distortion", "five numbers: k1, k2, p1, p2, k3", fmt::format("{}", k.size()));
    camera.distortion = {.k1 = k[0], .k2 = k[1], .p1 = k[2], .p2 = k[3], .k3 = k[4]};
  }
  return camera;
}

SensorPose read_pose(const TomlTable& table, const SensorPose& usual) {
  const auto pose = table.table("pose");
  if (!pose) return usual;
  SensorPose read = usual;
  read_settings(*pose, read);
  pose->finish();
  return read;
}

/// Angles R = Ry(yaw) Rx(pitch) Rz(roll) of a rotation.
std::array<double, 3> angles_deg(const Eigen::Matrix3d& r) {
  constexpr double degrees = 180 / std::numbers::pi;
  return {std::asin(std::clamp(-r(1, 2), -1.0, 1.0)) * degrees, std::atan2(r(0, 2), r(2, 2)) * degrees,
          std::atan2(r(1, 0), r(1, 1)) * degrees};
}

/// A range is the source's own, once; a model's focal length is its camera's.
void take_model(const sensors::NoiseModel& model, sensors::SensorRange& range, SourceNoise& noise) {
  noise = {.model = model, .scale = 1};
  std::visit(
      [&](auto& one) {
        range = one.range;
        one.range = {};
      },
      noise.model);
  if (auto* light = std::get_if<sensors::StructuredLightNoise>(&noise.model))
    light->focal_px = sensors::StructuredLightNoise{}.focal_px;
}

const sensors::SensorPreset& read_preset(const TomlTable& table) {
  const std::string key = table.text("preset");
  std::vector<std::string> keys;
  for (const sensors::SensorPreset& preset : sensors::sensor_presets()) {
    if (preset.key == key) return preset;
    keys.emplace_back(preset.key);
  }
  const std::string nearest = nearest_word(key, keys);
  throw table.complaint(
      "preset", fmt::format("one of {}", fmt::join(keys, ", ")),
      fmt::format("\"{}\"{}", key, nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?"));
}

template <class Sensor>
const Sensor* sensor_of(const TomlTable& table, const char* kind) {
  if (!table.has("preset")) return nullptr;
  const sensors::SensorPreset& preset = read_preset(table);
  const Sensor* sensor = std::get_if<Sensor>(&preset.sensor);
  if (sensor == nullptr)
    throw table.complaint("preset", fmt::format("a sensor that is a {}", kind),
                          fmt::format("\"{}\", which is none", preset.key));
  return sensor;
}

PanoramaSource read_panorama(const TomlTable& table, PanoramaSource source) {
  constexpr const char* none = "nothing: a panorama is the photograph's own camera all round";
  refuse_keys(table, camera_keys, none);
  refuse_keys(table, sensor_keys, none);
  refuse_keys(table, file_keys, "source = \"file\" beside it");
  if (const auto* scanner = sensor_of<sensors::Scanner>(table, "panorama")) {
    source = {};
    take_model(scanner->noise, source.range, source.noise.emplace());
    source.lowest_elevation_deg = scanner->lowest_elevation_deg;
    source.highest_elevation_deg = scanner->highest_elevation_deg;
  }
  source.range = read_range_m(table, source.range);
  source.noise = read_noise(table, source.noise);
  if (source.noise && !std::holds_alternative<sensors::GenericNoise>(source.noise->model))
    throw table.complaint("noise.model", "\"generic\" of a panorama",
                          "\"" + std::string(word(source.noise->model)) + "\"");
  if (source.noise)
    std::get<sensors::GenericNoise>(source.noise->model).convention = sensors::DepthConvention::radial;
  if (table.has("projector_m"))
    throw table.complaint("projector_m", "the model \"structured_light\" of a pinhole", "a panorama");
  read_settings(table, source);
  if (source.reduction == Reduction::sample || is_budgeted(source.reduction)) {
    if (table.has("reduction_factor"))
      throw table.complaint("reduction_factor", "a reduction from a finer map",
                            fmt::format("reduction = \"{}\"", word(source.reduction)));
    source.reduction_factor = 1;
  } else {
    if (source.reduction_factor == 1) source.reduction_factor = usual_reduction_factor;
    read_setting(table, "reduction_factor", source);
  }
  return source;
}

PinholeSource read_pinhole(const TomlTable& table, PinholeSource source, bool known) {
  refuse_keys(table, panorama_keys, "a panorama: a pinhole's pixels are what the sensor measures");
  refuse_keys(table, file_keys, "source = \"file\" beside it");
  if (const auto* rig = sensor_of<sensors::Rig>(table, "pinhole")) {
    source = {};
    known = true;
    source.camera = rig->depth;
    const Eigen::Vector3d& at = rig->colour_from_depth.translation();
    source.pose = {{at.x(), at.y(), at.z()}, angles_deg(rig->colour_from_depth.linear())};
    take_model(rig->noise, source.range, source.noise.emplace());
    if (rig->projector_m)
      source.projector_m = {rig->projector_m->x(), rig->projector_m->y(), rig->projector_m->z()};
  }
  source.camera = read_camera(table, source.camera, known);
  source.range = read_range_m(table, source.range);
  source.pose = read_pose(table, source.pose);
  source.noise = read_noise(table, source.noise);
  const sensors::NoiseModel* model = source.noise ? &source.noise->model : nullptr;
  if (table.has("convention") && model != nullptr && !std::holds_alternative<sensors::GenericNoise>(*model))
    throw table.complaint("convention", fmt::format("nothing: the model \"{}\" has its own", word(*model)),
                          "a setting of its own");
  read_setting(table, "convention", source);
  if (source.noise)
    if (auto* generic = std::get_if<sensors::GenericNoise>(&source.noise->model))
      generic->convention = source.convention;
  if (table.has("projector_m")) {
    if (model == nullptr || !std::holds_alternative<sensors::StructuredLightNoise>(*model))
      throw table.complaint("projector_m", "the noise model \"structured_light\" beside it",
                            "another or none");
    read_setting(table, "projector_m", source);
  }
  return source;
}

FileSource read_file_source(const TomlTable& table, FileSource source, bool known) {
  refuse_keys(table, panorama_keys, "a panorama: a file is taken as it is");
  refuse_keys(table, noise_keys, "nothing: the depths of a file have their noise already");
  if (table.has("preset"))
    throw table.complaint("preset", "size_px and fx of the camera that made the file", "a preset");
  source.file = known ? table.text("file", source.file) : table.text("file");
  source.camera = read_camera(table, source.camera, known);
  if (!known && !table.has("convention"))
    throw table.complaint("convention", "\"radial\" or \"planar\", which a file does not say", "nothing");
  read_setting(table, "convention", source);
  source.range = read_range_m(table, source.range);
  source.pose = read_pose(table, source.pose);
  read_settings(table, source);
  return source;
}

/// `usual` is null where nothing is known of the source before.
DepthSource read_source(const TomlTable& table, const char* kind_key, const DepthSource* usual) {
  DepthSource source = usual != nullptr ? *usual : PanoramaSource{};
  const std::size_t usual_kind = source.index();
  const bool is_named = table.has(kind_key);
  if (is_named) settings::set_place(source, read_word(table, kind_key, words_of<DepthSource>));
  const bool known = usual != nullptr && !is_named && source.index() == usual_kind;
  return std::visit(
      Overloaded{[&](const PanoramaSource& one) -> DepthSource { return read_panorama(table, one); },
                 [&](const PinholeSource& one) -> DepthSource { return read_pinhole(table, one, known); },
                 [&](const FileSource& one) -> DepthSource { return read_file_source(table, one, known); }},
      source);
}

template <class Keys>
bool has_any(const TomlTable& table, const Keys& keys) {
  return std::any_of(keys.begin(), keys.end(), [&](const char* key) { return table.has(key); });
}

}  // namespace

std::vector<DepthSource> read_sources(const TomlTable& table, const std::vector<DepthSource>& usual) {
  if (!table.has("source") || table.is_text("source")) {
    if (table.has("source") || usual.size() == 1) return {read_source(table, "source", &usual.front())};
    if (has_any(table, camera_keys) || has_any(table, sensor_keys) || has_any(table, panorama_keys) ||
        has_any(table, file_keys) || has_any(table, noise_keys) || has_any(table, all_kinds_keys))
      throw table.complaint("source", "the sources whose keys these are: the study has several", "nothing");
    return usual;
  }
  constexpr const char* in_list = "such keys in each of the list's tables";
  refuse_keys(table, camera_keys, in_list);
  refuse_keys(table, sensor_keys, in_list);
  refuse_keys(table, panorama_keys, in_list);
  refuse_keys(table, file_keys, in_list);
  refuse_keys(table, noise_keys, in_list);
  refuse_keys(table, all_kinds_keys, in_list);
  std::vector<DepthSource> sources;
  for (const TomlTable& one : table.tables("source")) {
    if (!one.has("kind")) throw one.complaint("kind", "\"pinhole\" or \"file\"", "nothing");
    sources.push_back(read_source(one, "kind", nullptr));
    if (std::holds_alternative<PanoramaSource>(sources.back()))
      throw one.complaint("kind",
                          "\"pinhole\" or \"file\": a panorama sees everything and is the only source",
                          "\"panorama\"");
    one.finish();
  }
  if (sources.size() > most_sources)
    throw table.complaint("source", fmt::format("at most {} sources", most_sources),
                          fmt::format("{}", sources.size()));
  return sources;
}

}  // namespace seamline::inline stimuli
