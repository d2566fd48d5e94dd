#include "stimuli/definition/depth_chain.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace seamline::inline stimuli {
namespace {

using sensors::GenericNoise;
using sensors::StructuredLightNoise;
using sensors::TimeOfFlightNoise;

template <class... Cases>
struct Match : Cases... {
  using Cases::operator()...;
};
template <class... Cases>
Match(Cases...) -> Match<Cases...>;

std::string text(const std::array<double, 3>& v) {
  return fmt::format("[{},{},{}]", v[0], v[1], v[2]);
}

std::string text(const sensors::PinholeCamera& camera) {
  std::string out = fmt::format("{} x {} fx {} fy {} cx {} cy {}", camera.width_px, camera.height_px,
                                camera.fx_px, camera.fy_px, camera.cx_px, camera.cy_px);
  if (camera.skew_px != 0) out += fmt::format(" skew {}", camera.skew_px);
  if (const sensors::LensDistortion& lens = camera.distortion; !lens.is_none())
    out += fmt::format(" lens {} {} {} {} {}", lens.k1, lens.k2, lens.p1, lens.p2, lens.k3);
  return out;
}

std::string text(const sensors::SensorRange& range) {
  return fmt::format(" range {} {}", range.nearest_m, range.farthest_m);
}

std::string text(const sensors::Outliers& outliers) {
  return fmt::format(" outliers {} {} {}", outliers.share, outliers.nearest_m, outliers.farthest_m);
}

std::string text(const SensorPose& pose) {
  return fmt::format(" pose {} {}", text(pose.position_m), text(pose.rotation_deg));
}

const char* convention_word(sensors::DepthConvention convention) {
  return convention == sensors::DepthConvention::radial ? "radial" : "planar";
}

std::string text(const SourceNoise& noise) {
  const std::string parameters = std::visit(
      Match{[](const GenericNoise& m) {
              return fmt::format("{} {} {}", m.relative_sigma, m.step_m, m.dropout_share) + text(m.outliers);
            },
            [](const TimeOfFlightNoise& m) {
              return fmt::format("{} {} {} {} {} {} {} {} {}", m.modulation_hz, m.amplitude_at_1m_e,
                                 m.contrast, m.background_e, m.readout_e, m.weakest_amplitude_e,
                                 m.full_well_e, m.wraps, m.mixes) +
                     text(m.outliers);
            },
            [](const StructuredLightNoise& m) {
              return fmt::format("{} {} {} {} {} {} {} {}", m.baseline_m, m.sigma_px, m.step_px,
                                 m.grazing_sigma_m, m.sure_deg, m.lost_deg, m.sure_signal, m.lost_signal) +
                     text(m.outliers);
            }},
      noise.model);
  return fmt::format(" noise {} {} scale {}", stimuli::word(noise.model), parameters, noise.scale);
}

std::string text(const DepthSource& source) {
  return std::visit(
      Match{[](const PanoramaSource& panorama) {
              std::string out = fmt::format("panorama {} {} elevation {} {}", word(panorama.reduction),
                                            panorama.reduction_factor, panorama.lowest_elevation_deg,
                                            panorama.highest_elevation_deg) +
                                text(panorama.range);
              return out + (panorama.noise ? text(*panorama.noise) : "");
            },
            [](const PinholeSource& pinhole) {
              std::string out = "pinhole " + text(pinhole.camera) + " " +
                                convention_word(pinhole.convention) + text(pinhole.range) +
                                text(pinhole.pose);
              if (pinhole.projector_m) out += " projector " + text(*pinhole.projector_m);
              return out + (pinhole.noise ? text(*pinhole.noise) : "");
            },
            [](const FileSource& file) {
              return "file " + file.file + " " + text(file.camera) + " " + convention_word(file.convention) +
                     text(file.range) + text(file.pose) +
                     fmt::format(" step {} {}", file.metres_per_step.value_or(0),
                                 file.packing == sensors::DepthPacking::whole ? "whole" : "red_green");
            }},
      source);
}

std::string text(const sensors::RepairMethod& repair) {
  const std::string name(stimuli::word(repair));
  return name +
         std::visit(Match{[](const sensors::NoRepair&) { return std::string(); },
                          [](const sensors::NearestRepair&) { return std::string(); },
                          [](const sensors::MedianRepair& m) {
                            return fmt::format(" radius {} px, {}", m.radius_px,
                                               m.fills ? "fills holes" : "fills no holes");
                          },
                          [](const sensors::JointBilateralRepair& b) {
                            return fmt::format(" radius {} px, sigma {} px and {}, {}", b.radius_px,
                                               b.sigma_px, b.sigma_colour,
                                               b.fills
                                                   ? fmt::format("fills holes from weight {}", b.least_weight)
                                                   : "fills no holes");
                          },
                          [](const sensors::PlaneRepair& p) {
                            return fmt::format(" most {}, share {}, tolerance {} m and {}, draws {}, seed {}",
                                               p.most_planes, p.least_share, p.tolerance_m,
                                               p.tolerance_relative, p.draws, p.seed);
                          }},
                    repair);
}

std::string text(const OcclusionMethod& occlusion) {
  std::string out(stimuli::word(occlusion));
  if (const auto* buffer = std::get_if<sensors::DepthBuffer>(&occlusion))
    out += fmt::format(" {} {} {}", buffer->bits, buffer->nearest_m, buffer->farthest_m);
  return out;
}

/// The same for people.
std::string described(const OcclusionMethod& occlusion) {
  return std::visit(
      Match{[](const MeshOcclusion&) -> std::string { return "by the mesh"; },
            [](const DepthTestOcclusion&) -> std::string {
              return "depth test a pixel, in metres, linear between pixels";
            },
            [](const sensors::DepthBuffer& buffer) {
              return fmt::format(
                  "depth test a pixel, in a buffer of {} bits between {} and {} m, linear between pixels",
                  buffer.bits, buffer.nearest_m, buffer.farthest_m);
            }},
      occlusion);
}

/// A source for people.
std::string described(const DepthSource& source, int panorama_width_px) {
  if (const auto* panorama = std::get_if<PanoramaSource>(&source)) {
    std::string out = panorama_width_px == 0
                          ? "panorama, whose width is the level"
                          : fmt::format("panorama {} x {} px", panorama_width_px, panorama_width_px / 2);
    if (panorama->reduction == Reduction::boxes)
      out += fmt::format(", planes and boxes fitted to one {} times as wide in place of what they explain",
                         panorama->reduction_factor);
    else if (panorama->reduction != Reduction::sample)
      out += fmt::format(", {} of {} x {} texels each", word(panorama->reduction), panorama->reduction_factor,
                         panorama->reduction_factor);
    return out;
  }
  const sensors::PinholeCamera& camera = *camera_of(source);
  return fmt::format("{} {} x {} px, {:.1f} degrees wide, {:.2f} texels per degree on its axis",
                     kind_of(source), camera.width_px, camera.height_px,
                     sensors::horizontal_field_of_view_deg(camera), camera.fx_px * std::numbers::pi / 180);
}

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
  return std::visit(Match{[](const MeshOcclusion&) { return "mesh"; },
                          [](const DepthTestOcclusion&) { return "depth_test"; },
                          [](const sensors::DepthBuffer&) { return "depth_buffer"; }},
                    occlusion);
}

bool tests_pixels(const OcclusionMethod& occlusion) {
  return !std::holds_alternative<MeshOcclusion>(occlusion);
}

std::string_view kind_of(const DepthSource& source) {
  return std::visit(
      Match{[](const PanoramaSource&) { return "panorama"; }, [](const PinholeSource&) { return "pinhole"; },
            [](const FileSource&) { return "file"; }},
      source);
}

std::string_view word(const sensors::RepairMethod& repair) {
  return std::visit(Match{[](const sensors::NoRepair&) { return "none"; },
                          [](const sensors::NearestRepair&) { return "nearest"; },
                          [](const sensors::MedianRepair&) { return "median"; },
                          [](const sensors::JointBilateralRepair&) { return "joint_bilateral"; },
                          [](const sensors::PlaneRepair&) { return "planes"; }},
                    repair);
}

std::string_view word(const sensors::NoiseModel& model) {
  return std::visit(Match{[](const GenericNoise&) { return "generic"; },
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
  return std::visit(Match{[](const PanoramaSource&) -> Found { return nullptr; },
                          [](const PinholeSource& pinhole) -> Found { return &pinhole.camera; },
                          [](const FileSource& file) -> Found { return &file.camera; }},
                    source);
}

const SourceNoise* noise_of(const DepthSource& source) {
  using Found = const SourceNoise*;
  const auto of = [](const std::optional<SourceNoise>& noise) -> Found { return noise ? &*noise : nullptr; };
  return std::visit(Match{[&](const PanoramaSource& panorama) { return of(panorama.noise); },
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

std::string canonical_text(const std::optional<DepthChain>& chain) {
  if (!chain) return {};
  std::string out;
  for (const DepthSource& source : chain->sources) out += "source " + text(source) + "; ";
  out += fmt::format("repair {}; registration {} {}; jumps {} {} {}", text(chain->repair),
                     word(chain->registration), chain->border_extrusion_px, word(chain->jumps),
                     chain->jump_ratio, chain->layer_px);
  out += fmt::format("; calibration error {} {}; delay {} {}; sigmas {} seed {}",
                     chain->calibration_error_deg, chain->calibration_error_m, chain->delay_ms,
                     text(chain->velocity_m_s), chain->noise_sigmas, chain->seed);
  if (guided_by_photograph(*chain)) out += "; guide photograph";
  if (chain->repair_after) out += "; repair after registration";
  if (tests_pixels(chain->occlusion)) out += "; occlusion " + text(chain->occlusion);
  return out;
}

DepthLinks depth_links(const std::optional<DepthChain>& given, int panorama_width_px) {
  const DepthChain chain = given.value_or(DepthChain{});
  DepthLinks links;
  for (const DepthSource& source : chain.sources) {
    links.emplace_back("source", described(source, panorama_width_px));
    const SourceNoise* noise = noise_of(source);
    links.emplace_back(
        "noise", noise == nullptr ? "none" : fmt::format("{}, scale {}", word(noise->model), noise->scale));
  }
  links.emplace_back("repair", text(chain.repair));
  if (guided_by_photograph(chain)) links.back().second += ", guided by the photograph";
  if (chain.repair_after) links.back().second += ", after the registration";
  links.emplace_back("registration", chain.registration == Registration::none
                                         ? "none"
                                         : "by " + std::string(word(chain.registration)));
  if (chain.border_extrusion_px > 0)
    links.back().second += fmt::format(", borders extruded by {} px", chain.border_extrusion_px);
  switch (chain.jumps) {
    case Jumps::stretch:
      links.emplace_back("jumps", "sheets");
      break;
    case Jumps::cut:
      links.emplace_back("jumps", fmt::format("cut from a ratio of {}", chain.jump_ratio));
      break;
    case Jumps::layer:
      links.emplace_back("jumps",
                         fmt::format("cut from a ratio of {}, with a second layer of {} px behind them",
                                     chain.jump_ratio, chain.layer_px));
      break;
  }
  links.emplace_back("occlusion", described(chain.occlusion));
  const bool exact = chain.calibration_error_deg == 0 && chain.calibration_error_m == 0;
  links.emplace_back("calibration error", exact ? "none"
                                                : fmt::format("{} degrees, {} m", chain.calibration_error_deg,
                                                              chain.calibration_error_m));
  links.emplace_back("delay", chain.delay_ms == 0
                                  ? "none"
                                  : fmt::format("{} ms at {} m/s", chain.delay_ms, text(chain.velocity_m_s)));
  return links;
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
