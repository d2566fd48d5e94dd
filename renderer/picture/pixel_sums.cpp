#include "renderer/picture/pixel_sums.h"

namespace seamline::renderer {
namespace {

template <class Radiance>
Image image_of(const TruthSums& truth, int channels, const Radiance& radiance) {
  Image image(truth.width_px, truth.height_px, channels);
  const float scale = 1.0F / static_cast<float>(truth.spp);
  for (int y = 0; y < truth.height_px; ++y)
    for (int x = 0; x < truth.width_px; ++x) {
      const std::size_t i = truth.index(x, y);
      const Rgb value = (radiance(truth.halves[0][i]) + radiance(truth.halves[1][i])) * scale;
      for (int c = 0; c < channels; ++c) image.at(x, y, c) = value[c];
    }
  return image;
}

}  // namespace

Image background_image(const TruthSums& truth) {
  return image_of(truth, 3, [](const TruthPixel& sums) -> Rgb {
    return sums.sky + sums.without_object.total() + sums.behind;
  });
}

Image reference_image(const TruthSums& truth) {
  return image_of(truth, 3, [](const TruthPixel& sums) -> Rgb {
    return sums.sky + sums.with_object.total() + sums.object.total();
  });
}

Image half_reference_image(const TruthSums& truth, std::size_t half) {
  Image image(truth.width_px, truth.height_px, 3);
  const float scale = 1.0F / static_cast<float>((truth.spp + 1 - static_cast<int>(half)) / 2);
  for (int y = 0; y < truth.height_px; ++y)
    for (int x = 0; x < truth.width_px; ++x) {
      const TruthPixel& sums = truth.halves[half][truth.index(x, y)];
      image.set_rgb(x, y, (sums.sky + sums.with_object.total() + sums.object.total()) * scale);
    }
  return image;
}

Image matte_image(const TruthSums& truth) {
  return image_of(truth, 1, [](const TruthPixel& sums) -> Rgb { return Rgb::Constant(sums.covered); });
}

StimulusPixel& StimulusPixel::operator+=(const StimulusPixel& other) {
  sky += other.sky;
  background += other.background;
  without_object += other.without_object;
  with_object += other.with_object;
  object += other.object;
  from_reference += other.from_reference;
  uncovered_surfaces += other.uncovered_surfaces;
  return *this;
}

}  // namespace seamline::renderer
