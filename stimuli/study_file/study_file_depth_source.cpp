#include "stimuli/study_file/study_file_depth_source.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "sensors/rig/presets.h"
#include "stimuli/definition/methods/depth_file_names.h"
#include "stimuli/settings/depth_settings.h"
#include "stimuli/settings/noise_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/parts/study_file_camera.h"
#include "stimuli/study_file/parts/study_file_estimate.h"
#include "support/running/overloaded.h"
#include "support/text/suggest.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::size_t most_sources = 8;
constexpr int usual_reduction_factor = 4;

// Keys of one source, by what they are for.
constexpr std::array all_kinds_keys = {"preset", "range_m"};

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

/// `noise` of a source: "none", or a table over the source's usual noise; another `model` begins anew.
/// Throws InputError for parameters without a model, and those that it does not have.
std::optional<SourceNoise> read_noise(const TomlTable& source, const std::optional<SourceNoise>& usual) {
  if (!source.has("noise")) return usual;
  if (source.is_text("noise")) {
    if (source.text("noise") != "none")
      throw source.complaint("noise", "\"none\", or a table with a model",
                             "\"" + source.text("noise") + "\"");
    return std::nullopt;
  }
  const TomlTable table = *source.table("noise");
  SourceNoise noise = usual.value_or(SourceNoise{});
  if (!usual && !table.has("model")) throw table.missing("model", words_text(words_of<sensors::NoiseModel>));
  read_settings(table, noise);
  std::visit(
      [&](auto& model) {
        read_settings(table, model);
        read_settings(table, model.outliers);
      },
      noise.model);
  table.finish();
  return noise;
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
  refuse_keys(table, camera_keys, no_key_of_panorama);
  refuse_keys(table, sensor_keys, no_key_of_panorama);
  refuse_file(table);
  refuse_stereo(table);
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
  refuse_file(table);
  refuse_stereo(table);
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

FileSource read_file_source(const TomlTable& table, FileSource source, bool known, bool share_is_level) {
  refuse_keys(table, panorama_keys, "a panorama: a file is taken as it is");
  refuse_keys(table, noise_keys, "nothing: the depths of a file have their noise already");
  refuse_stereo(table);
  if (table.has("preset"))
    throw table.complaint("preset", "size_px and fx of the camera that made the file", "a preset");
  source.file = known ? table.text("file", source.file) : table.text("file");
  source.camera = read_camera(table, source.camera, known);
  if (!known && !table.has("convention"))
    throw table.missing("convention", "\"radial\" or \"planar\", which a file does not say");
  read_setting(table, "convention", source);
  source.range = read_range_m(table, source.range);
  source.pose = read_pose(table, source.pose);
  read_settings(table, source);
  if (source.estimate || share_is_level || is_named_by_stimulus(source.file) || names_estimate(table))
    source.estimate =
        read_estimate(table, source.estimate.value_or(FileEstimate{}), source.metres_per_step.has_value());
  return source;
}

/// `usual` is null where nothing is known of the source before.
DepthSource read_source(const TomlTable& table, const char* kind_key, const DepthSource* usual,
                        Quantity level) {
  DepthSource source = usual != nullptr ? *usual : PanoramaSource{};
  const std::size_t usual_kind = source.index();
  const bool is_named = table.has(kind_key);
  if (is_named) settings::set_place(source, read_word(table, kind_key, words_of<DepthSource>));
  if (is_panorama_file(table, source)) {
    const auto* before = std::get_if<PanoramaSource>(&source);
    return read_panorama_file(table, before != nullptr ? *before : PanoramaSource{});
  }
  const bool known = usual != nullptr && !is_named && source.index() == usual_kind;
  return std::visit(
      Overloaded{[&](const PanoramaSource& one) -> DepthSource { return read_panorama(table, one); },
                 [&](const PinholeSource& one) -> DepthSource { return read_pinhole(table, one, known); },
                 [&](const FileSource& one) -> DepthSource {
                   return read_file_source(table, one, known, level == Quantity::estimate_share);
                 },
                 [&](const StereoSource& one) -> DepthSource { return read_stereo(table, one, known); }},
      source);
}

}  // namespace

std::vector<DepthSource> read_sources(const TomlTable& table, const std::vector<DepthSource>& usual,
                                      Quantity level) {
  if (!table.has("source") || table.is_text("source")) {
    if (table.has("source") || usual.size() == 1)
      return {read_source(table, "source", &usual.front(), level)};
    if (has_any(table, camera_keys) || has_any(table, sensor_keys) || has_any(table, panorama_keys) ||
        has_any(table, file_keys) || has_any(table, noise_keys) || has_any(table, all_kinds_keys) ||
        names_estimate(table) || names_stereo(table))
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
  if (names_estimate(table) || names_stereo(table))
    throw table.complaint("source", in_list, "an estimate's key");
  std::vector<DepthSource> sources;
  for (const TomlTable& one : table.tables("source")) {
    if (!one.has("kind")) throw one.missing("kind", "\"pinhole\", \"file\" or \"stereo\"");
    sources.push_back(read_source(one, "kind", nullptr, level));
    if (std::holds_alternative<PanoramaSource>(sources.back()))
      throw one.complaint(
          "kind", "\"pinhole\", \"file\" or \"stereo\": a panorama sees everything and is the only source",
          "\"panorama\"");
    one.finish();
  }
  if (sources.size() > most_sources)
    throw table.complaint("source", fmt::format("at most {} sources", most_sources),
                          fmt::format("{}", sources.size()));
  return sources;
}

}  // namespace seamline::inline stimuli
