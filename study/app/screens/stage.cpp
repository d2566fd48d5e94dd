#include "study/app/screens/stage.h"

#include <unistd.h>

#include <algorithm>
#include <array>

#include "study/app/pictures/picture_place.h"
#include "study/trials/trial_picture.h"

namespace seamline::study::app {

std::string Stage::phrase(Phrase which,
                          const std::vector<std::pair<std::string, std::string>>& values) const {
  return fill_in(phrase_text(set.study.texts, which), values);
}

Size shown_picture_size(const RenderedSet& set) {
  const auto [width_px, height_px] = shown_size_px(set);
  Size size{static_cast<double>(width_px), static_cast<double>(height_px)};
  if (!is_panorama(set.study)) return size;
  size = {};
  for (const ConditionDefinition& condition : list_conditions(set.study)) {
    const std::array<int, 2>& view_px = look_of(set.study, condition)->view_px;
    size = {std::max(size.width_px, double{1} * view_px[0]),
            std::max(size.height_px, double{1} * view_px[1])};
  }
  return size;
}

DisplayFacts display_facts(const Stage& stage, const DisplayProfile& profile) {
  std::array<char, 256> machine{};
  if (::gethostname(machine.data(), machine.size() - 1) != 0) machine[0] = '\0';
  const double scale = place_trial(stage.screen_px, shown_picture_size(stage.set), stage.ui.em(),
                                   picture_corner(stage.set.study))
                           .scale;
  return {.machine = machine.data(),
          .monitor = stage.display.monitor,
          .renderer = stage.display.graphics,
          .mode_width_px = stage.display.mode_width,
          .mode_height_px = stage.display.mode_height,
          .refresh_hz = static_cast<double>(stage.display.refresh_hz),
          .content_scale = stage.display.content_scale,
          .framebuffer_width_px = stage.display.framebuffer_width_px,
          .framebuffer_height_px = stage.display.framebuffer_height_px,
          .mm_per_px = profile.mm_per_px,
          .viewing_distance_mm = profile.viewing_distance_mm,
          .pixels_per_degree = pixels_per_degree_of(profile.mm_per_px, profile.viewing_distance_mm),
          .gamma_confirmed = profile.gamma_confirmed,
          .read_back_bytes = stage.pixel_check.bytes,
          .read_back_different = stage.pixel_check.different,
          .scaling_allowed = stage.scaling_allowed,
          .image_scale = scale};
}

}  // namespace seamline::study::app
