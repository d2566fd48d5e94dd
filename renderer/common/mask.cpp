#include "renderer/common/mask.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "support/files/word_image.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

bool has_shape(int width, int height, int other_width, int other_height) {
  const double ratio = static_cast<double>(width) / height,
               other = static_cast<double>(other_width) / other_height;
  return std::abs(ratio / other - 1) < 0.01;
}

Image first_channel(const std::filesystem::path& path) {
  const std::string ending = lower_case_ending(path);
  if (ending == ".png") {
    const WordImage words = read_word_image(path);
    Image values(words.width_px, words.height_px, 1);
    const float largest = words.bits == 16 ? 65535.0F : 255.0F;
    for (std::size_t i = 0; i < values.values.size(); ++i)
      values.values[i] =
          static_cast<float>(words.values[i * static_cast<std::size_t>(words.channels)]) / largest;
    return values;
  }
  const Image image = read_image(path, [&](const ImageHeader& header) {
    if (!header.floating_point)
      throw input_error({.file = path.string(),
                         .wanted = "a mask as a PNG or EXR file",
                         .found = "a picture whose compression would change it"});
  });
  Image values(image.width_px, image.height_px, 1);
  for (int y = 0; y < image.height_px; ++y)
    for (int x = 0; x < image.width_px; ++x) values.at(x, y) = image.at(x, y);
  return values;
}

}  // namespace

float mask_at(const Mask& mask, const MaskPlace& place) {
  const bool wraps = mask.domain == MaskDomain::panorama;
  const int width = mask.values.width_px, height = mask.values.height_px;
  Eigen::Array2f share = place.in_photograph;
  if (wraps) {
    constexpr float pi = std::numbers::pi_v<float>;
    share = {std::atan2(place.direction.x(), -place.direction.z()) / (2 * pi) + 0.5F,
             0.5F - std::asin(std::clamp(place.direction.y(), -1.0F, 1.0F)) / pi};
  }
  const Eigen::Array2f at =
      share * Eigen::Array2f(static_cast<float>(width), static_cast<float>(height)) - 0.5F;
  const Eigen::Array2f corner = at.floor(), part = at - corner;
  const auto column = [&](int x) {
    return wraps ? (x % width + width) % width : std::clamp(x, 0, width - 1);
  };
  const auto row = [&](int y) { return std::clamp(y, 0, height - 1); };
  const int left = static_cast<int>(corner[0]), top = static_cast<int>(corner[1]);
  const auto along = [&](int y) {
    return (1 - part[0]) * mask.values.at(column(left), row(y)) +
           part[0] * mask.values.at(column(left + 1), row(y));
  };
  return (1 - part[1]) * along(top) + part[1] * along(top + 1);
}

Mask read_mask(const std::filesystem::path& path, int photograph_width_px, int photograph_height_px,
               bool photograph_is_panorama) {
  Mask mask{.values = first_channel(path), .domain = MaskDomain::photograph};
  const int width = mask.values.width_px, height = mask.values.height_px;
  if (photograph_is_panorama || !has_shape(width, height, photograph_width_px, photograph_height_px)) {
    if (width != 2 * height)
      throw input_error({.file = path.string(),
                         .wanted = photograph_is_panorama
                                       ? std::string("a mask twice as wide as high, as the panorama is")
                                       : fmt::format("a mask twice as wide as high (by direction), or of the "
                                                     "shape of the photograph, {} x {}",
                                                     photograph_width_px, photograph_height_px),
                         .found = fmt::format("{} x {}", width, height)});
    mask.domain = MaskDomain::panorama;
  }
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (const float value = mask.values.at(x, y); !(value >= 0 && value <= 1))
        throw input_error({.file = path.string(),
                           .wanted = "a mask of values from 0 to 1",
                           .found = fmt::format("{:g} in pixel ({}, {})", value, x, y)});
  return mask;
}

}  // namespace seamline::renderer
