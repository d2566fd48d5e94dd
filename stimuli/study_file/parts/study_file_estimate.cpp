#include "stimuli/study_file/parts/study_file_estimate.h"

#include <fmt/core.h>

#include "stimuli/settings/depth_settings.h"
#include "stimuli/settings/read_settings.h"
#include "stimuli/study_file/parts/study_file_camera.h"

namespace seamline::inline stimuli {
namespace {

constexpr std::array estimate_keys = {"value", "align", "scale", "shift", "estimate_share", "projection"};
constexpr std::array stereo_keys = {"baseline_m", "disparities_px", "block_px", "stereo_samples"};

constexpr const char* file_beside_it = "source = \"file\" beside it";

}  // namespace

bool names_estimate(const TomlTable& table) {
  return has_any(table, estimate_keys);
}

bool names_stereo(const TomlTable& table) {
  return has_any(table, stereo_keys);
}

void refuse_file(const TomlTable& table) {
  refuse_keys(table, file_keys, file_beside_it);
  refuse_keys(table, estimate_keys, file_beside_it);
}

void refuse_stereo(const TomlTable& table) {
  refuse_keys(table, stereo_keys, "source = \"stereo\" beside it");
}

FileEstimate read_estimate(const TomlTable& table, FileEstimate estimate, bool has_metres_a_step) {
  read_settings(table, estimate);
  drop_idle(estimate);
  if (estimate.value == sensors::DepthValue::metres) {
    for (const char* key : {"scale", "shift"})
      if (table.has(key))
        throw table.complaint(key, "value = \"inverse\" or \"relative\" beside it", "distances in metres");
    estimate.scale.reset();
    estimate.shift = 0;
    return estimate;
  }
  if (has_metres_a_step)
    throw table.complaint("metres_per_step", "value = \"metres\" beside it", "an estimate's values");
  if (estimate.align == EstimateAlignment::stated && !estimate.scale)
    throw table.complaint("align",
                          "\"least_squares\", or scale (and shift) beside it: without a scale an estimate is "
                          "no distance",
                          "nothing");
  return estimate;
}

bool is_panorama_file(const TomlTable& table, const DepthSource& source) {
  const auto* panorama = std::get_if<PanoramaSource>(&source);
  const bool was_one = panorama != nullptr && panorama->file.has_value();
  if (!was_one && !std::holds_alternative<FileSource>(source)) return false;
  constexpr std::array<std::string_view, 2> projections = {"pinhole", "panorama"};
  if (!table.has("projection")) return was_one;
  const bool is_one = read_word(table, "projection", projections) == 1;
  if (was_one && !is_one)
    throw table.complaint("projection", "source = \"file\" beside it: a sensor's file begins anew",
                          "\"pinhole\" alone");
  return is_one;
}

PanoramaSource read_panorama_file(const TomlTable& table, const PanoramaSource& usual) {
  refuse_keys(table, camera_keys, no_key_of_panorama);
  refuse_keys(table, sensor_keys, no_key_of_panorama);
  refuse_keys(table, panorama_keys, "a panorama that is captured: a file is taken as it is");
  refuse_keys(table, noise_keys, "nothing: the depths of a file have their noise already");
  refuse_stereo(table);
  if (table.has("preset")) throw table.complaint("preset", "nothing: a file is nobody's sensor", "a preset");
  PanoramaFile file = usual.file.value_or(PanoramaFile{});
  file.file = usual.file ? table.text("file", file.file) : table.text("file");
  read_settings(table, file);
  file.estimate = read_estimate(table, file.estimate, file.metres_per_step.has_value());
  return {.range = read_range_m(table, usual.range), .noise = {}, .file = std::move(file)};
}

StereoSource read_stereo(const TomlTable& table, StereoSource source, bool known) {
  refuse_keys(table, panorama_keys, "a panorama: stereo has the pixels of its left camera");
  refuse_keys(table, file_keys, file_beside_it);
  refuse_keys(table, noise_keys, "nothing: stereo has the noise of its pictures");
  for (const char* key : {"value", "align", "scale", "shift", "projection"})
    if (table.has(key)) throw table.complaint(key, file_beside_it, "source = \"stereo\"");
  for (const char* key : {"preset", "convention"})
    if (table.has(key))
      throw table.complaint(key, "nothing: stereo is two pinholes, and its depth is planar",
                            "a setting of its own");
  source.camera = read_camera(table, source.camera, known);
  const sensors::PinholeCamera& camera = source.camera;
  if (camera.distortion != sensors::LensDistortion{} || camera.skew_px != 0 || camera.fx_px != camera.fy_px)
    throw table.complaint("source", "cameras without lens and skew, of square pixels, as matching wants them",
                          "\"stereo\" beside distortion, skew or another fy");
  source.range = read_range_m(table, source.range);
  source.pose = read_pose(table, source.pose);
  if (!known && !table.has("baseline_m"))
    throw table.missing("baseline_m", "the distance of the two cameras in metres");
  if (table.has("baseline_m")) read_setting(table, "baseline_m", source);
  read_settings(table, source);
  if (source.disparities_px >= camera.width_px)
    throw table.complaint("disparities_px", fmt::format("fewer than the {} pixels of a row", camera.width_px),
                          fmt::format("{}", source.disparities_px));
  return source;
}

}  // namespace seamline::inline stimuli
