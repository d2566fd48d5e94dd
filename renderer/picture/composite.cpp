#include "renderer/picture/composite.h"

#include <algorithm>

#include "raytracer/common/parallel.h"
#include "renderer/picture/pocket_filter.h"
#include "stimuli/pictures/difference.h"

namespace seamline::renderer {
namespace {

constexpr float floor_share = 1e-6F;  // of the frame's median: below it the ratio is 1
constexpr float sealed_share = 0.1F;  // of the usual S_no for what the photograph shows
constexpr float largest_ratio = 4.0F;

TileGrid picture_of(const StimulusSums& sums) {
  return {sums.width_px, sums.height_px, sums.wraps};
}

std::vector<StimulusPixel> sum_halves(const StimulusSums& sums) {
  std::vector<StimulusPixel> pixels = sums.halves[0];
  for (std::size_t i = 0; i < pixels.size(); ++i) pixels[i] += sums.halves[1][i];
  return pixels;
}

/// Pixels that a median is taken over at least, where there are as many: it only scales thresholds.
constexpr std::size_t median_pixels = 1 << 15;

/// Median of a value over the pixels that have a ratio (of large pictures, every few pixels); 0 when none
/// has.
template <class Value>
float median_of(const std::vector<StimulusPixel>& pixels, const Value& value) {
  std::vector<float> values;
  // An odd step, so that it meets every column of a picture.
  const std::size_t step = (pixels.size() / median_pixels) | 1U;
  for (std::size_t i = 0; i < pixels.size(); i += step)
    if (pixels[i].uncovered_surfaces > 0) values.push_back(value(pixels[i]));
  if (values.empty()) return 0.0F;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// Of S_no a sample, channels averaged.
float median_denominator(const std::vector<StimulusPixel>& pixels) {
  return median_of(pixels, [](const StimulusPixel& pixel) {
    return pixel.without_object.mean() / pixel.uncovered_surfaces;
  });
}

struct RatioOutcome {
  Rgb ratio = Rgb::Ones();
  bool floored = false;
  bool clamped = false;
  bool sealed = false;
};

/// Pixels whose S_no rests on too few paths for a ratio of their own.
std::vector<bool> find_pockets(const std::vector<StimulusPixel>& pixels, float median, int samples) {
  const float poorly_lit_share = std::clamp(4.0F / static_cast<float>(samples), 0.02F, 0.25F);
  std::vector<bool> pockets(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    pockets[i] = pixels[i].uncovered_surfaces > 0 &&
                 pixels[i].without_object.mean() < poorly_lit_share * median * pixels[i].uncovered_surfaces;
  return pockets;
}

/// How much of a pixel's ratio is believed: all of it, less where the depth mesh is more than ten times
/// darker than the photograph there (both against what is usual in this picture): depth sheets have sealed
/// the surface in a well that only the camera sees into, and whatever stands before the well takes all its
/// light.
float belief(float without_object, const Rgb& photograph, float usual_darkness) {
  const float sealed = sealed_share * usual_darkness * photograph.mean();
  return sealed > 0.0F ? std::min(1.0F, without_object / sealed) : 1.0F;
}

/// Median of S_no over the photograph.
float usual_darkness(const std::vector<StimulusPixel>& pixels) {
  return median_of(pixels, [](const StimulusPixel& pixel) {
    return pixel.without_object.mean() / std::max(pixel.background.mean(), 1e-30F);
  });
}

/// The ratio of light a sample with and without the object.
RatioOutcome ratio_of(const FilteredLight& light, float median, float believed) {
  RatioOutcome outcome;
  const Rgb change = light.with_object - light.without_object;
  for (int c = 0; c < 3; ++c) {
    if (change[c] == 0.0F) continue;  // exactly 1: nothing changed
    if (!(light.without_object[c] > floor_share * median)) {
      outcome.floored = true;
      continue;
    }
    const float ratio = 1.0F + change[c] / light.without_object[c];
    const float clamped = std::clamp(ratio, 0.0F, largest_ratio);
    outcome.ratio[c] = believed < 1.0F ? 1.0F + believed * (clamped - 1.0F) : clamped;
    // A fully blocked light ends a rounding error below 0: that is no clamped pixel.
    outcome.clamped = outcome.clamped || ratio < -1e-4F || ratio > largest_ratio;
    outcome.sealed = outcome.sealed || believed < 1.0F;
  }
  return outcome;
}

/// What all pixels of a picture have in common, and its poorly lit ones.
struct PictureLight {
  float median = 0, darkness = 0;
  std::vector<bool> pockets;            ///< empty: none is looked for
  std::vector<FilteredLight> filtered;  ///< of the pockets
  std::vector<float> for_belief;        ///< light a sample before a filter; empty: what the ratio is of
};

/// Light before a filter, a sample, of the pixels that may be a well: by the filtered light up to three times
/// as bright as one. Filtered among these by what is near. Others keep `no_well`.
constexpr float may_be_well = 3, no_well = 1e30F;
std::vector<float> light_in_wells(const std::vector<StimulusPixel>& pixels,
                                  const std::vector<float>& as_sampled, const StimulusSums& sums,
                                  float darkness, int threads) {
  std::vector<bool> wells(pixels.size());
  for (std::size_t i = 0; i < pixels.size(); ++i)
    wells[i] =
        pixels[i].uncovered_surfaces > 0 &&
        pixels[i].without_object.mean() < may_be_well * sealed_share * darkness * pixels[i].background.mean();
  std::vector<float> light =
      filter_pockets(as_sampled, pixels, wells, sums.guides, picture_of(sums), threads);
  for (std::size_t i = 0; i < light.size(); ++i)
    if (!wells[i]) light[i] = no_well;
  return light;
}

PictureLight picture_light(const std::vector<StimulusPixel>& pixels, const std::vector<float>& as_sampled,
                           const StimulusSums& sums, int samples, int threads) {
  PictureLight light;
  light.median = median_denominator(pixels);
  if (!sums.depth_lights_uncovered) return light;
  light.darkness = usual_darkness(pixels);
  light.pockets = find_pockets(pixels, light.median, samples);
  light.filtered = filter_pockets(pixels, light.pockets, sums.guides, picture_of(sums), threads);
  if (!as_sampled.empty())
    light.for_belief = light_in_wells(pixels, as_sampled, sums, light.darkness, threads);
  return light;
}

/// One pixel's light off the object, in sums of samples.
Rgb rest_of_pixel(const StimulusPixel& pixel, std::size_t i, const PictureLight& picture,
                  Compositing compositing, Rgb& ratio, TinyDenominators& tiny) {
  if (pixel.uncovered_surfaces <= 0) return pixel.background;
  const float per_sample = 1.0F / pixel.uncovered_surfaces;
  const bool pocket = !picture.pockets.empty() && picture.pockets[i];
  const FilteredLight light =
      pocket ? picture.filtered[i]
             : FilteredLight{pixel.without_object * per_sample, pixel.with_object * per_sample};
  const float lit = picture.for_belief.empty() ? light.without_object.mean() : picture.for_belief[i];
  const float believed =
      picture.pockets.empty() ? 1.0F : belief(lit, pixel.background * per_sample, picture.darkness);
  const RatioOutcome outcome = ratio_of(light, picture.median, believed);
  ratio = outcome.ratio;
  if (compositing == Compositing::additive)
    return pixel.background + pixel.with_object - pixel.without_object;
  tiny.floored_pixels += outcome.floored ? 1 : 0;
  tiny.clamped_pixels += outcome.clamped ? 1 : 0;
  tiny.sealed_pixels += outcome.sealed ? 1 : 0;
  return pixel.background * outcome.ratio;
}

Composite compose_pixels(const std::vector<StimulusPixel>& pixels, const std::vector<float>& as_sampled,
                         const StimulusSums& sums, int samples, Compositing compositing, int threads) {
  Composite out{Image(sums.width_px, sums.height_px, 3), Image(sums.width_px, sums.height_px, 3, 1.0F), {}};
  const PictureLight light = picture_light(pixels, as_sampled, sums, samples, threads);
  std::vector<TinyDenominators> tiny(static_cast<std::size_t>(sums.height_px));
  parallel_for(sums.height_px, threads, [&](int y) {
    TinyDenominators& row = tiny[y];
    for (int x = 0; x < sums.width_px; ++x) {
      const std::size_t i = out.picture.index(x, y) / 3;
      const StimulusPixel& pixel = pixels[i];
      Rgb ratio = Rgb::Ones();
      const Rgb uncovered_surfaces = rest_of_pixel(pixel, i, light, compositing, ratio, row);
      out.ratio.set_rgb(x, y, ratio);
      out.picture.set_rgb(x, y,
                          (pixel.sky + uncovered_surfaces + pixel.object + pixel.from_reference) /
                              static_cast<float>(samples));
      row.not_finite_pixels += out.picture.rgb(x, y).allFinite() ? 0 : 1;
    }
  });
  for (const TinyDenominators& row : tiny) {
    out.tiny_denominators.floored_pixels += row.floored_pixels;
    out.tiny_denominators.clamped_pixels += row.clamped_pixels;
    out.tiny_denominators.sealed_pixels += row.sealed_pixels;
    out.tiny_denominators.not_finite_pixels += row.not_finite_pixels;
  }
  return out;
}

}  // namespace

Composite compose(const StimulusSums& sums, Compositing compositing, int threads) {
  std::vector<float> as_sampled = sums.light_as_sampled[0];
  for (std::size_t i = 0; i < as_sampled.size(); ++i) as_sampled[i] += sums.light_as_sampled[1][i];
  return compose_pixels(sum_halves(sums), as_sampled, sums, sums.spp, compositing, threads);
}

Composite compose_half(const StimulusSums& sums, std::size_t half, int threads) {
  const int samples = (sums.spp + 1 - static_cast<int>(half)) / 2;
  return compose_pixels(sums.halves[half], sums.light_as_sampled[half], sums, samples, sums.compositing,
                        threads);
}

std::optional<double> estimated_noise(const StimulusSums& sums, double exposure_ev) {
  if (sums.spp < 2) return std::nullopt;
  return 0.5 * display_rmse(compose_half(sums, 0).picture, compose_half(sums, 1).picture, exposure_ev);
}

LayerImages layer_images(const StimulusSums& sums) {
  LayerImages images{Image(sums.width_px, sums.height_px, 3), Image(sums.width_px, sums.height_px, 3),
                     Image(sums.width_px, sums.height_px, 3)};
  const std::vector<StimulusPixel> pixels = sum_halves(sums);
  const float scale = 1.0F / static_cast<float>(sums.spp);
  for (int y = 0; y < sums.height_px; ++y)
    for (int x = 0; x < sums.width_px; ++x) {
      const StimulusPixel& pixel = pixels[images.with_object.index(x, y) / 3];
      images.with_object.set_rgb(x, y, (pixel.with_object + pixel.object) * scale);
      images.without_object.set_rgb(x, y, pixel.without_object * scale);
      images.object.set_rgb(x, y, pixel.object * scale);
    }
  return images;
}

}  // namespace seamline::renderer
