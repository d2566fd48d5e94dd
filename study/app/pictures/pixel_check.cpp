#include "study/app/pictures/pixel_check.h"

#include <algorithm>

#include "support/arithmetic/random.h"
#include "window/look.h"

namespace seamline::study::app {

ByteImage test_picture(int width_px, int height_px) {
  ByteImage picture{width_px, height_px, 3, {}};
  const auto count = static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px) * 3;
  picture.values.resize(count);
  Random random(1, 0);
  for (std::size_t i = 0; i < count;
       ++i)  // ramps of each channel first, then noise without likeness of neighbours
    picture.values[i] = static_cast<std::uint8_t>(i < 3UL * 256 ? i / 3 : random.below(256));
  return picture;
}

PixelCheck check_pixels(Window& window, Canvas& canvas, Size picture_px, double em_px,
                        const std::optional<Point>& corner_px) {
  const ByteImage picture =
      test_picture(static_cast<int>(picture_px.width_px), static_cast<int>(picture_px.height_px));
  WindowTexture texture;
  texture.upload(picture);
  const TrialPlace place = place_trial(window.framebuffer_px(), picture_px, em_px, corner_px);
  canvas.begin(window.framebuffer_px());
  canvas.picture(texture, place.picture);
  window.clear(look::background);
  canvas.end();
  const ByteImage seen =
      window.read_back(static_cast<int>(place.picture.x_px), static_cast<int>(place.picture.y_px),
                       picture.width_px, picture.height_px);
  PixelCheck check{.bytes = static_cast<std::int64_t>(picture.values.size())};
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    if (picture.values[i] != seen.values[i]) ++check.different;
  return check;
}

}  // namespace seamline::study::app
