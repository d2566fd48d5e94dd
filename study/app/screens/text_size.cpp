#include "study/app/screens/text_size.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "study/app/pictures/picture_place.h"

namespace seamline::study::app {
namespace {

struct SizeOption {
  double scale;
  const char* text;
};

constexpr std::array<SizeOption, 4> sizes = {{{1, "100 %"}, {1.25, "125 %"}, {1.5, "150 %"}, {2, "200 %"}}};

}  // namespace

double body_size_px(const DisplayInfo& display, double text_scale) {
  constexpr double design_px = 22, design_height_px = 1080;
  const double screen =
      std::max({1.0, display.content_scale, display.framebuffer_height_px / design_height_px});
  return std::round(design_px * screen * text_scale);
}

void choose_text_size(Stage& stage) {
  const Size picture_px{static_cast<double>(stage.set.manifest.width_px),
                        static_cast<double>(stage.set.manifest.height_px)};
  std::vector<std::string> options;  // those with which the questions still fit below the pictures
  int chosen = -1;
  for (const SizeOption& size : sizes) {
    const double em_px = body_size_px(stage.display, stage.set.study.session.text_scale * size.scale);
    if (size.scale > 1 && !stage.scaling_allowed && !fits(stage.screen_px, picture_px, em_px)) break;
    if (std::abs(size.scale - stage.text_scale) < 1e-6) chosen = static_cast<int>(options.size());
    options.emplace_back(size.text);
  }
  if (options.size() < 2) return;
  stage.ui.note(stage.phrase(Phrase::text_size));
  const int now = stage.ui.choice("text_size", options, chosen, Font::small);
  if (now >= 0 && now != chosen) stage.text_scale = sizes.at(now).scale;
}

}  // namespace seamline::study::app
