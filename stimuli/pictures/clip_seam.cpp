#include "stimuli/pictures/clip_seam.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace seamline::inline stimuli {

void ClipSeamMeter::add(const ByteImage& stimulus, const ByteImage& reference) {
  SignedDifference difference = signed_difference(stimulus, reference);
  const NoiseTiles noise = noise_tiles(difference);
  PixelSet seam;
  for (std::size_t i = 0; i < seam_steps.size(); ++i) {
    PixelSet set = seam_pixels(difference, noise, seam_steps[i]);
    const auto area_px = static_cast<double>(std::count(set.values.begin(), set.values.end(), 1));
    const double band_px = widest_band_px(set);
    ClipSeamExtent& sum = sum_.beyond[i];
    sum.mean_area_px += area_px;
    sum.mean_band_px += band_px;
    sum.largest_area_px = std::max(sum.largest_area_px, area_px);
    sum.largest_band_px = std::max(sum.largest_band_px, band_px);
    if (i == 0) seam = std::move(set);
  }
  if (frames_ > 0) {
    assert(last_.steps.size() == difference.steps.size());
    const auto channels = static_cast<std::size_t>(difference.channels);
    for (std::size_t i = 0; i < difference.steps.size(); ++i) {
      const std::size_t pixel = i / channels;
      if (seam.values[pixel] == 0 && last_seam_.values[pixel] == 0) continue;
      const double now = difference.steps[i], before = last_.steps[i];
      change_ += (now - before) * (now - before);
      size_ += (now * now + before * before) / 2;
      ++values_;
    }
  }
  last_ = std::move(difference);
  last_seam_ = std::move(seam);
  ++frames_;
}

ClipSeam ClipSeamMeter::result() const {
  assert(frames_ > 0);
  ClipSeam seam = sum_;
  for (ClipSeamExtent& extent : seam.beyond) {
    extent.mean_area_px /= frames_;
    extent.mean_band_px /= frames_;
  }
  if (size_ > 0) seam.flicker = std::sqrt(change_ / size_);
  if (values_ > 0) seam.change_steps = std::sqrt(change_ / static_cast<double>(values_));
  return seam;
}

}  // namespace seamline::inline stimuli
