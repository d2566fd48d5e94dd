#include "stimuli/pictures/attention_image.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace {

/// Two stops brighter, then three quarters of the way to this colour. Brightness alone is not enough, because
/// a surface near white has none to gain; magenta is rare in pictures of places, and with green gone it is
/// darker than white and brighter than a shadow for every kind of colour vision. The rest of the surface's
/// own light leaves its shape and shading: it must still look like the object, put in wrongly.
constexpr float brighter = 4;
constexpr float tint_share = 0.75F;
constexpr std::array<float, 3> tint_linear = {1.0F, 0.05F, 0.8F};

std::uint8_t changed(std::uint8_t code, float tint) {
  const float linear = linear_from_srgb(static_cast<float>(code) / 255.0F);
  const float lifted = std::min(1.0F, brighter * linear);
  return code_from_display(srgb_from_linear((1 - tint_share) * lifted + tint_share * tint));
}

std::string size_text(const ByteImage& image) {
  return fmt::format("{} x {} with {} channels", image.width_px, image.height_px, image.channels);
}

}  // namespace

ByteImage attention_image(const ByteImage& reference, const ByteImage& object_ids, int object_index) {
  if (reference.channels != 3 || object_ids.channels != 1 || reference.width_px != object_ids.width_px ||
      reference.height_px != object_ids.height_px)
    throw input_error(
        {.field = "attention image",
         .wanted = "a reference of 3 channels and a map of object ids of 1 channel, of the same size",
         .found = size_text(reference) + " and " + size_text(object_ids)});
  ByteImage image = reference;
  std::size_t pixels = 0;
  for (std::size_t pixel = 0; pixel < object_ids.values.size(); ++pixel) {
    if (object_ids.values[pixel] != object_index) continue;
    ++pixels;
    for (std::size_t channel = 0; channel < 3; ++channel) {
      std::uint8_t& code = image.values[3 * pixel + channel];
      code = changed(code, tint_linear[channel]);
    }
  }
  if (pixels == 0)
    throw input_error({.field = "attention image",
                       .wanted = fmt::format("pixels of object {} in the map of object ids", object_index),
                       .found = "none"});
  return image;
}

}  // namespace seamline::inline stimuli
