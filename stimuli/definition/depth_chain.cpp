#include "stimuli/definition/depth_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support/running/overloaded.h"

namespace seamline::inline stimuli {
namespace {

using sensors::GenericNoise;
using sensors::StructuredLightNoise;
using sensors::TimeOfFlightNoise;

void simplify(DepthSource& source) {
  // The generic model is errors and nothing else; the others are instruments, which stay.
  const auto drop_noise = [](std::optional<SourceNoise>& noise) {
    if (noise && noise->scale == 0 && std::holds_alternative<GenericNoise>(noise->model)) noise.reset();
  };
  if (auto* panorama = std::get_if<PanoramaSource>(&source)) {
    drop_noise(panorama->noise);
    if (panorama->reduction_factor == 1) panorama->reduction = Reduction::sample;
    if (panorama->reduction == Reduction::sample) panorama->reduction_factor = 1;
  }
  if (auto* pinhole = std::get_if<PinholeSource>(&source)) {
    if (pinhole->noise) pinhole->convention = sensors::convention_of(pinhole->noise->model);
    drop_noise(pinhole->noise);
    if (!pinhole->noise || !std::holds_alternative<StructuredLightNoise>(pinhole->noise->model))
      pinhole->projector_m.reset();
  }
}

int even(double value) {
  return 2 * static_cast<int>(std::lround(value / 2));
}

bool is_still(const DepthChain& chain) {
  return chain.delay_ms == 0 || chain.velocity_m_s == std::array<double, 3>{0, 0, 0};
}

}  // namespace

std::string_view word(Reduction reduction) {
  switch (reduction) {
    case Reduction::sample:
      return "sample";
    case Reduction::minimum:
      return "minimum";
    case Reduction::maximum:
      return "maximum";
    case Reduction::median:
      return "median";
    case Reduction::edge_aware:
      return "edge_aware";
    case Reduction::boxes:
      return "boxes";
  }
  return {};
}

std::string_view word(RepairGuide guide) {
  switch (guide) {
    case RepairGuide::own_light:
      return "own_light";
    case RepairGuide::photograph:
      return "photograph";
  }
  return {};
}

std::string_view word(Registration registration) {
  switch (registration) {
    case Registration::none:
      return "none";
    case Registration::points:
      return "points";
    case Registration::mesh:
      return "mesh";
  }
  return {};
}

std::string_view word(Jumps jumps) {
  switch (jumps) {
    case Jumps::stretch:
      return "stretch";
    case Jumps::cut:
      return "cut";
    case Jumps::layer:
      return "layer";
  }
  return {};
}

std::string_view word(const OcclusionMethod& occlusion) {
  return std::visit(Overloaded{[](const MeshOcclusion&) { return "mesh"; },
                               [](const DepthTestOcclusion&) { return "depth_test"; },
                               [](const sensors::DepthBuffer&) { return "depth_buffer"; }},
                    occlusion);
}

bool tests_pixels(const OcclusionMethod& occlusion) {
  return !std::holds_alternative<MeshOcclusion>(occlusion);
}

std::string_view kind_of(const DepthSource& source) {
  return std::visit(
      Overloaded{[](const PanoramaSource&) { return "panorama"; },
                 [](const PinholeSource&) { return "pinhole"; }, [](const FileSource&) { return "file"; }},
      source);
}

std::string_view word(const sensors::RepairMethod& repair) {
  return std::visit(Overloaded{[](const sensors::NoRepair&) { return "none"; },
                               [](const sensors::NearestRepair&) { return "nearest"; },
                               [](const sensors::MedianRepair&) { return "median"; },
                               [](const sensors::JointBilateralRepair&) { return "joint_bilateral"; },
                               [](const sensors::PlaneRepair&) { return "planes"; }},
                    repair);
}

std::string_view word(const sensors::NoiseModel& model) {
  return std::visit(Overloaded{[](const GenericNoise&) { return "generic"; },
                               [](const TimeOfFlightNoise&) { return "time_of_flight"; },
                               [](const StructuredLightNoise&) { return "structured_light"; }},
                    model);
}

bool is_panorama(const DepthChain& chain) {
  return std::holds_alternative<PanoramaSource>(chain.sources.front());
}

bool is_in_photographs_place(const DepthChain& chain) {
  if (is_panorama(chain) || chain.registration != Registration::none) return true;
  if (chain.calibration_error_m != 0 || chain.delay_ms != 0) return false;
  const auto pose_of = [](const DepthSource& source) -> const SensorPose& {
    const auto* file = std::get_if<FileSource>(&source);
    return file != nullptr ? file->pose : std::get<PinholeSource>(source).pose;
  };
  return std::all_of(chain.sources.begin(), chain.sources.end(), [&](const DepthSource& source) {
    return pose_of(source).position_m == std::array<double, 3>{0, 0, 0};
  });
}

const sensors::PinholeCamera* camera_of(const DepthSource& source) {
  using Found = const sensors::PinholeCamera*;
  return std::visit(Overloaded{[](const PanoramaSource&) -> Found { return nullptr; },
                               [](const PinholeSource& pinhole) -> Found { return &pinhole.camera; },
                               [](const FileSource& file) -> Found { return &file.camera; }},
                    source);
}

const SourceNoise* noise_of(const DepthSource& source) {
  using Found = const SourceNoise*;
  const auto of = [](const std::optional<SourceNoise>& noise) -> Found { return noise ? &*noise : nullptr; };
  return std::visit(Overloaded{[&](const PanoramaSource& panorama) { return of(panorama.noise); },
                               [&](const PinholeSource& pinhole) { return of(pinhole.noise); },
                               [](const FileSource&) -> Found { return nullptr; }},
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

std::optional<DepthChain> meaningful(DepthChain chain) {
  const DepthChain usual;
  for (DepthSource& source : chain.sources) simplify(source);
  const bool exact_pose = chain.calibration_error_deg == 0 && chain.calibration_error_m == 0;
  if (!std::holds_alternative<sensors::JointBilateralRepair>(chain.repair)) chain.guide = usual.guide;
  if (std::holds_alternative<sensors::NoRepair>(chain.repair) || chain.registration == Registration::none)
    chain.repair_after = usual.repair_after;
  if (!has_noise(chain)) chain.noise_sigmas = usual.noise_sigmas;
  if (!has_noise(chain) && exact_pose) chain.seed = usual.seed;
  if (chain.registration != Registration::mesh) chain.border_extrusion_px = usual.border_extrusion_px;
  if (chain.jumps == Jumps::stretch) chain.jump_ratio = usual.jump_ratio;
  if (chain.jumps != Jumps::layer) chain.layer_px = usual.layer_px;
  if (is_still(chain)) {
    chain.delay_ms = 0;
    chain.velocity_m_s = {0, 0, 0};
  }
  if (chain == usual) return std::nullopt;
  return chain;
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
