#include "stimuli/definition/depth_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/running/overloaded.h"

namespace seamline::inline stimuli {
namespace {

int even(double value) {
  return 2 * static_cast<int>(std::lround(value / 2));
}

}  // namespace

bool is_panorama(const DepthChain& chain) {
  return std::holds_alternative<PanoramaSource>(chain.sources.front());
}

bool is_in_photographs_place(const DepthChain& chain) {
  if (is_panorama(chain) || chain.registration != Registration::none) return true;
  if (chain.calibration_error_m != 0 || chain.delay_ms != 0) return false;
  return std::all_of(chain.sources.begin(), chain.sources.end(), [&](const DepthSource& source) {
    return pose_of(source).position_m == std::array<double, 3>{0, 0, 0};
  });
}

bool is_estimated(const DepthSource& source) {
  return std::visit(Overloaded{[](const PanoramaSource& panorama) { return panorama.file.has_value(); },
                               [](const PinholeSource&) { return false; },
                               [](const FileSource& file) { return file.estimate.has_value(); },
                               [](const StereoSource&) { return true; }},
                    source);
}

bool is_estimated(const DepthChain& chain) {
  return std::any_of(chain.sources.begin(), chain.sources.end(),
                     [](const DepthSource& source) { return is_estimated(source); });
}

bool has_stereo(const DepthChain& chain) {
  return std::any_of(chain.sources.begin(), chain.sources.end(),
                     [](const DepthSource& source) { return std::holds_alternative<StereoSource>(source); });
}

SensorPose pose_of(const DepthSource& source) {
  return std::visit(Overloaded{[](const PanoramaSource&) { return SensorPose{}; },
                               [](const auto& sensor) { return sensor.pose; }},
                    source);
}

const sensors::PinholeCamera* camera_of(const DepthSource& source) {
  using Found = const sensors::PinholeCamera*;
  return std::visit(Overloaded{[](const PanoramaSource&) -> Found { return nullptr; },
                               [](const PinholeSource& pinhole) -> Found { return &pinhole.camera; },
                               [](const FileSource& file) -> Found { return &file.camera; },
                               [](const StereoSource& stereo) -> Found { return &stereo.camera; }},
                    source);
}

const SourceNoise* noise_of(const DepthSource& source) {
  using Found = const SourceNoise*;
  const auto of = [](const std::optional<SourceNoise>& noise) -> Found { return noise ? &*noise : nullptr; };
  return std::visit(Overloaded{[&](const PanoramaSource& panorama) { return of(panorama.noise); },
                               [&](const PinholeSource& pinhole) { return of(pinhole.noise); },
                               [](const FileSource&) -> Found { return nullptr; },
                               [](const StereoSource&) -> Found { return nullptr; }},
                    source);
}

bool has_noise(const DepthChain& chain) {
  for (const DepthSource& source : chain.sources)
    if (const SourceNoise* noise = noise_of(source); noise != nullptr && noise->scale > 0) return true;
  return false;
}

bool guided_by_photograph(const DepthChain& chain) {
  return chain.guide == RepairGuide::photograph &&
         std::holds_alternative<sensors::JointBilateralRepair>(chain.repair);
}

bool has_boxes(const DepthChain& chain) {
  const auto* panorama = std::get_if<PanoramaSource>(&chain.sources.front());
  return panorama != nullptr && panorama->reduction == Reduction::boxes;
}

bool is_budgeted(Reduction reduction) {
  return reduction == Reduction::jumps || reduction == Reduction::budgeted;
}

bool is_budgeted(const DepthChain& chain) {
  const auto* panorama = std::get_if<PanoramaSource>(&chain.sources.front());
  return panorama != nullptr && is_budgeted(panorama->reduction);
}

sensors::PinholeCamera with_field_of_view(const sensors::PinholeCamera& camera,
                                          double horizontal_field_of_view_deg) {
  const double half_rad = horizontal_field_of_view_deg * std::numbers::pi / 360;
  const double across_px = 2 * camera.fx_px * std::tan(half_rad);
  sensors::PinholeCamera wider = camera;
  wider.width_px = even(across_px);
  wider.height_px = even(across_px * camera.height_px / camera.width_px);
  wider.cx_px += 0.5 * (wider.width_px - camera.width_px);
  wider.cy_px += 0.5 * (wider.height_px - camera.height_px);
  return wider;
}

sensors::PinholeCamera resized(sensors::PinholeCamera camera, int width_px, int height_px) {
  const double across = static_cast<double>(width_px) / camera.width_px,
               down = static_cast<double>(height_px) / camera.height_px;
  camera.fx_px *= across, camera.cx_px *= across, camera.skew_px *= across;
  camera.fy_px *= down, camera.cy_px *= down;
  camera.width_px = width_px, camera.height_px = height_px;
  return camera;
}

sensors::PinholeCamera with_texels_per_degree(const sensors::PinholeCamera& camera,
                                              double texels_per_degree) {
  const double share = texels_per_degree * 180 / std::numbers::pi / camera.fx_px;
  return resized(camera, even(camera.width_px * share),
                 static_cast<int>(std::lround(camera.height_px * share)));
}

}  // namespace seamline::inline stimuli
