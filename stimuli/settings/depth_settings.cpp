#include "stimuli/settings/depth_settings.h"

#include "stimuli/definition/at_level.h"

namespace seamline::inline stimuli {
namespace {

DepthSource exact_pinhole(const sensors::PinholeCamera& camera, sensors::DepthConvention convention,
                          const sensors::SensorRange& range, const SensorPose& pose) {
  PinholeSource pinhole;
  pinhole.camera = camera;
  pinhole.convention = convention;
  pinhole.range = range;
  pinhole.pose = pose;
  return pinhole;
}

/// Nothing of an estimate is the exact source.
void drop_unused_estimate(DepthSource& source) {
  if (auto* panorama = std::get_if<PanoramaSource>(&source))
    if (panorama->file && panorama->file->estimate.share == 0) panorama->file.reset();
  if (const auto* stereo = std::get_if<StereoSource>(&source); stereo != nullptr && stereo->share == 0)
    source = exact_pinhole(stereo->camera, sensors::DepthConvention::planar, stereo->range, stereo->pose);
  else if (const auto* file = std::get_if<FileSource>(&source);
           file != nullptr && file->estimate && file->estimate->share == 0)
    source = exact_pinhole(file->camera, file->convention, file->range, file->pose);
}

void simplify_source(DepthSource& source) {
  drop_unused_estimate(source);
  // The generic model is errors and nothing else; the others are instruments, which stay.
  const auto drop_noise = [](std::optional<SourceNoise>& noise) {
    if (noise && noise->scale == 0 && std::holds_alternative<sensors::GenericNoise>(noise->model))
      noise.reset();
  };
  if (auto* panorama = std::get_if<PanoramaSource>(&source)) {
    drop_noise(panorama->noise);
    if (is_budgeted(panorama->reduction))
      panorama->reduction_factor = 1;
    else if (panorama->reduction_factor == 1)
      panorama->reduction = Reduction::sample;
    if (panorama->reduction == Reduction::sample) panorama->reduction_factor = 1;
  }
  if (auto* pinhole = std::get_if<PinholeSource>(&source)) {
    if (pinhole->noise) pinhole->convention = sensors::convention_of(pinhole->noise->model);
    drop_noise(pinhole->noise);
    if (!pinhole->noise || !std::holds_alternative<sensors::StructuredLightNoise>(pinhole->noise->model))
      pinhole->projector_m.reset();
  }
}

FileEstimate* estimate_in(DepthSource& source) {
  if (auto* panorama = std::get_if<PanoramaSource>(&source); panorama != nullptr && panorama->file)
    return &panorama->file->estimate;
  auto* file = std::get_if<FileSource>(&source);
  return file != nullptr && file->estimate ? &*file->estimate : nullptr;
}

bool is_still(const DepthChain& chain) {
  return chain.delay_ms == 0 || chain.velocity_m_s == std::array<double, 3>{0, 0, 0};
}

}  // namespace

std::string fault_of_farthest(const sensors::Outliers& outliers) {
  return outliers.nearest_m <= outliers.farthest_m ? ""
                                                   : range_text("a number", {outliers.nearest_m, 1e9, "m"});
}

std::string fault_of_lost_angle(const sensors::StructuredLightNoise& noise) {
  return noise.sure_deg <= noise.lost_deg
             ? ""
             : fmt::format("a number from {} to 90 degrees (not before sure_deg)", noise.sure_deg);
}

std::string fault_of_lost_signal(const sensors::StructuredLightNoise& noise) {
  return noise.lost_signal <= noise.sure_signal
             ? ""
             : fmt::format("a number from 0 to {} (not above sure_signal)", noise.sure_signal);
}

std::string fault_of_far_plane(const sensors::DepthBuffer& buffer) {
  return buffer.nearest_m < buffer.farthest_m
             ? ""
             : fmt::format("a plane beyond buffer_near_m = {}", buffer.nearest_m);
}

std::string fault_of_jump_ratio(const DepthChain& chain) {
  return chain.jump_ratio > 1 ? "" : "a ratio above 1";
}

std::string fault_of_disparities(const StereoSource& stereo) {
  return stereo.disparities_px % 16 == 0 ? "" : "a multiple of 16";
}

std::string fault_of_block(const StereoSource& stereo) {
  return stereo.block_px % 2 == 1 ? "" : "an odd number";
}

void choose_occlusion(DepthChain& chain, std::size_t place) {
  const auto chosen = static_cast<Occlusion>(place);
  if (chosen != chain.occlusion) chain.buffer = {};
  chain.occlusion = chosen;
}

std::string buffer_text(const DepthChain& chain) {
  return chain.occlusion == Occlusion::depth_buffer ? settings_text(chain.buffer) : std::string();
}

std::string_view word(Reduction reduction) {
  return word_of(reduction);
}
std::string_view word(RepairGuide guide) {
  return word_of(guide);
}
std::string_view word(Registration registration) {
  return word_of(registration);
}
std::string_view word(Jumps jumps) {
  return word_of(jumps);
}
std::string_view word(const sensors::RepairMethod& repair) {
  return word_of(repair);
}
std::string_view word(const sensors::NoiseModel& model) {
  return word_of(model);
}
std::string_view kind_of(const DepthSource& source) {
  return word_of(source);
}

std::optional<DepthChain> meaningful(DepthChain chain) {
  const DepthChain usual;
  for (DepthSource& source : chain.sources) simplify_source(source);
  const bool exact_pose = chain.calibration_error_deg == 0 && chain.calibration_error_m == 0;
  drop_idle(chain);
  if (std::holds_alternative<sensors::NoRepair>(chain.repair) || chain.registration == Registration::none)
    chain.repair_after = usual.repair_after;
  if (!has_noise(chain)) chain.noise_sigmas = usual.noise_sigmas;
  if (!has_noise(chain) && exact_pose && !has_stereo(chain)) chain.seed = usual.seed;
  if (is_still(chain)) {
    chain.delay_ms = 0;
    chain.velocity_m_s = {0, 0, 0};
  }
  if (chain == usual) return std::nullopt;
  return chain;
}

void set_level(DepthChain& chain, Quantity quantity, double level) {
  for (DepthSource& source : chain.sources) {
    if (auto* noise = const_cast<SourceNoise*>(noise_of(source))) {
      set_level_of(*noise, quantity, level);
      std::visit([&](auto& model) { set_level_of(model.outliers, quantity, level); }, noise->model);
    }
    if (FileEstimate* estimate = estimate_in(source)) set_level_of(*estimate, quantity, level);
    if (auto* stereo = std::get_if<StereoSource>(&source)) set_level_of(*stereo, quantity, level);
  }
  set_level_of(chain, quantity, level);
}

std::string canonical_text(const std::optional<DepthChain>& chain) {
  if (!chain) return {};
  std::string text;
  for (const DepthSource& source : chain->sources)
    text += "source " + std::visit([](const auto& one) { return settings_text(one); }, source) + "; ";
  return text + settings_text(*chain);
}

}  // namespace seamline::inline stimuli
