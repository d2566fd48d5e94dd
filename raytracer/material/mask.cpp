#include "raytracer/material/mask.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "support/arithmetic/bilinear.h"
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

/// Between the centres of an image's pixels, borders repeated; `place` is 0 to 1 across and down.
float mask_value(const Image& image, const Eigen::Array2f& place) {
  const Eigen::Array2f size(static_cast<float>(image.width_px), static_cast<float>(image.height_px));
  const Eigen::Array2f at = place * size - 0.5F;
  return bilinear(between_cells(at[0], at[1]), [&](int column, int row) {
    return image.at(std::clamp(column, 0, image.width_px - 1), std::clamp(row, 0, image.height_px - 1));
  });
}

}  // namespace

DirectionMask even_mask(int width_px, float value) {
  DirectionMask mask{
      .width_px = width_px, .height_px = width_px / 2, .texels = {}, .known = {}, .elsewhere = value};
  mask.texels.assign(static_cast<std::size_t>(mask.width_px) * static_cast<std::size_t>(mask.height_px),
                     value);
  return mask;
}

float mask_at(const Mask& mask, const MaskPlace& place) {
  if (const auto* by_direction = std::get_if<DirectionMask>(&mask)) return by_direction->at(place.direction);
  return mask_value(std::get<PhotographMask>(mask).values, place.in_photograph);
}

Mask read_mask(const std::filesystem::path& path, int photograph_width_px, int photograph_height_px,
               bool photograph_is_panorama) {
  Image values = first_channel(path);
  const int width = values.width_px, height = values.height_px;
  const bool by_direction =
      photograph_is_panorama || !has_shape(width, height, photograph_width_px, photograph_height_px);
  if (by_direction && width != 2 * height)
    throw input_error({.file = path.string(),
                       .wanted = photograph_is_panorama
                                     ? std::string("a mask twice as wide as high, as the panorama is")
                                     : fmt::format("a mask twice as wide as high (by direction), or of the "
                                                   "shape of the photograph, {} x {}",
                                                   photograph_width_px, photograph_height_px),
                       .found = fmt::format("{} x {}", width, height)});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      if (const float value = values.at(x, y); !(value >= 0 && value <= 1))
        throw input_error({.file = path.string(),
                           .wanted = "a mask of values from 0 to 1",
                           .found = fmt::format("{:g} in pixel ({}, {})", value, x, y)});
  if (!by_direction) return PhotographMask{std::move(values)};
  return DirectionMask{.width_px = width,
                       .height_px = height,
                       .texels = std::move(values.values),
                       .known = {},
                       .elsewhere = 0};
}

}  // namespace seamline::renderer
