#include <fmt/core.h>

#include <numbers>

#include "stimuli/definition/depth_chain.h"
#include "support/running/overloaded.h"

// Depth chains as words: for the hash of a study, and for people.
namespace seamline::inline stimuli {
namespace {

using sensors::GenericNoise;
using sensors::StructuredLightNoise;
using sensors::TimeOfFlightNoise;

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
  const std::string parameters =
      std::visit(Overloaded{[](const GenericNoise& m) {
                              return fmt::format("{} {} {}", m.relative_sigma, m.step_m, m.dropout_share) +
                                     text(m.outliers);
                            },
                            [](const TimeOfFlightNoise& m) {
                              return fmt::format("{} {} {} {} {} {} {} {} {}", m.modulation_hz,
                                                 m.amplitude_at_1m_e, m.contrast, m.background_e, m.readout_e,
                                                 m.weakest_amplitude_e, m.full_well_e, m.wraps, m.mixes) +
                                     text(m.outliers);
                            },
                            [](const StructuredLightNoise& m) {
                              return fmt::format("{} {} {} {} {} {} {} {}", m.baseline_m, m.sigma_px,
                                                 m.step_px, m.grazing_sigma_m, m.sure_deg, m.lost_deg,
                                                 m.sure_signal, m.lost_signal) +
                                     text(m.outliers);
                            }},
                 noise.model);
  return fmt::format(" noise {} {} scale {}", stimuli::word(noise.model), parameters, noise.scale);
}

std::string text(const DepthSource& source) {
  return std::visit(
      Overloaded{[](const PanoramaSource& panorama) {
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
                   return "file " + file.file + " " + text(file.camera) + " " +
                          convention_word(file.convention) + text(file.range) + text(file.pose) +
                          fmt::format(" step {} {}", file.metres_per_step.value_or(0),
                                      file.packing == sensors::DepthPacking::whole ? "whole" : "red_green");
                 }},
      source);
}

std::string text(const sensors::RepairMethod& repair) {
  const std::string name(stimuli::word(repair));
  return name + std::visit(Overloaded{[](const sensors::NoRepair&) { return std::string(); },
                                      [](const sensors::NearestRepair&) { return std::string(); },
                                      [](const sensors::MedianRepair& m) {
                                        return fmt::format(" radius {} px, {}", m.radius_px,
                                                           m.fills ? "fills holes" : "fills no holes");
                                      },
                                      [](const sensors::JointBilateralRepair& b) {
                                        return fmt::format(" radius {} px, sigma {} px and {}, {}",
                                                           b.radius_px, b.sigma_px, b.sigma_colour,
                                                           b.fills ? fmt::format("fills holes from weight {}",
                                                                                 b.least_weight)
                                                                   : "fills no holes");
                                      },
                                      [](const sensors::PlaneRepair& p) {
                                        return fmt::format(
                                            " most {}, share {}, tolerance {} m and {}, draws {}, seed {}",
                                            p.most_planes, p.least_share, p.tolerance_m, p.tolerance_relative,
                                            p.draws, p.seed);
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
      Overloaded{
          [](const MeshOcclusion&) -> std::string { return "by the mesh"; },
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

}  // namespace

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

}  // namespace seamline::inline stimuli
