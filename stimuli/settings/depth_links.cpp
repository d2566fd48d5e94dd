#include <fmt/core.h>

#include <numbers>

#include "stimuli/settings/depth_settings.h"

// Depth chains as words for people.
namespace seamline::inline stimuli {
namespace {

/// Who is in front, for people.
std::string described_occlusion(const DepthChain& chain) {
  if (chain.occlusion == Occlusion::depth_test) return "depth test a pixel, in metres, linear between pixels";
  if (chain.occlusion != Occlusion::depth_buffer) return "by the mesh";
  return fmt::format("depth test a pixel, in a buffer of {} bits between {} and {} m, linear between pixels",
                     chain.buffer.bits, chain.buffer.nearest_m, chain.buffer.farthest_m);
}

/// How an estimate becomes distances, for people.
std::string described(const FileEstimate& estimate) {
  std::string out = fmt::format(", {} values", word_of(estimate.value));
  if (estimate.value == sensors::DepthValue::metres) out = ", metres";
  if (estimate.align == EstimateAlignment::least_squares) out += " aligned to the truth by least squares";
  if (estimate.scale) out += fmt::format(", scale {} shift {}", *estimate.scale, estimate.shift);
  if (estimate.share != 1) out += fmt::format(", a share of {} beside the truth", estimate.share);
  return out;
}

/// A source for people.
std::string described(const DepthSource& source, int panorama_width_px) {
  if (const auto* panorama = std::get_if<PanoramaSource>(&source)) {
    if (is_budgeted(panorama->reduction))
      return fmt::format("panorama{} depth samples, spent where {}",
                         panorama_width_px == 0
                             ? ", the level says of how many"
                             : fmt::format(" of {}", panorama_width_px * (panorama_width_px / 2)),
                         panorama->reduction == Reduction::jumps ? "depth jumps" : "wrong depth would show");
    std::string out = panorama_width_px == 0
                          ? "panorama, whose width is the level"
                          : fmt::format("panorama {} x {} px", panorama_width_px, panorama_width_px / 2);
    if (panorama->file) return out + " in " + panorama->file->file + described(panorama->file->estimate);
    if (panorama->reduction == Reduction::boxes)
      out += fmt::format(", planes and boxes fitted to one {} times as wide in place of what they explain",
                         panorama->reduction_factor);
    else if (panorama->reduction != Reduction::sample)
      out += fmt::format(", {} of {} x {} texels each", word(panorama->reduction), panorama->reduction_factor,
                         panorama->reduction_factor);
    return out;
  }
  const sensors::PinholeCamera& camera = *camera_of(source);
  std::string out =
      fmt::format("{} {} x {} px, {:.1f} degrees wide, {:.2f} texels per degree on its axis", kind_of(source),
                  camera.width_px, camera.height_px, sensors::horizontal_field_of_view_deg(camera),
                  camera.fx_px * std::numbers::pi / 180);
  if (const auto* file = std::get_if<FileSource>(&source); file != nullptr && file->estimate)
    out += ", " + file->file + described(*file->estimate);
  if (const auto* stereo = std::get_if<StereoSource>(&source))
    out += fmt::format(
        ", baseline {} m, {} disparities, blocks of {} px, {} samples a pixel{}", stereo->baseline_m,
        stereo->disparities_px, stereo->block_px, stereo->samples_per_pixel,
        stereo->share == 1 ? std::string() : fmt::format(", a share of {} beside the truth", stereo->share));
  return out;
}

}  // namespace

DepthLinks depth_links(const std::optional<DepthChain>& given, int panorama_width_px) {
  const DepthChain chain = given.value_or(DepthChain{});
  DepthLinks links;
  for (const DepthSource& source : chain.sources) {
    links.emplace_back("source", described(source, panorama_width_px));
    const SourceNoise* noise = noise_of(source);
    links.emplace_back(
        "noise", noise == nullptr ? "none" : fmt::format("{}, scale {}", word(noise->model), noise->scale));
  }
  links.emplace_back("repair", value_text(setting<DepthChain>("repair"), chain));
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
  links.emplace_back("occlusion", described_occlusion(chain));
  const bool exact = chain.calibration_error_deg == 0 && chain.calibration_error_m == 0;
  links.emplace_back("calibration error", exact ? "none"
                                                : fmt::format("{} degrees, {} m", chain.calibration_error_deg,
                                                              chain.calibration_error_m));
  links.emplace_back("delay", chain.delay_ms == 0 ? "none"
                                                  : fmt::format("{} ms at {} m/s", chain.delay_ms,
                                                                three_text(chain.velocity_m_s)));
  return links;
}

}  // namespace seamline::inline stimuli
