#pragma once
#include <vector>

#include "renderer/picture/pixel_sums.h"

namespace seamline::renderer {

/// Light a sample without and with the object, of one pixel.
struct FilteredLight {
  Rgb without_object = Rgb::Zero();
  Rgb with_object = Rgb::Zero();
};

/// Pixels that less than `poorly_lit` a sample lights. `light`: of each pixel, summed over its samples.
[[nodiscard]] std::vector<bool> find_pockets(const std::vector<float>& light,
                                             const std::vector<StimulusPixel>& sums, float poorly_lit);

/// Adds the pixels beside pockets that only chance has lit: whose neighbours of like normal and depth have
/// less light than `poorly_lit`, themselves left out. In a well that one path in hundreds finds, the pixel
/// that it fell on is bright, and its neighbours would be filtered without the only light that was found.
void add_lit_by_chance(const std::vector<float>& light, const std::vector<StimulusPixel>& sums,
                       const std::vector<Guide>& guides, int width_px, int height_px, float poorly_lit,
                       int threads, std::vector<bool>& pockets);

/// The light of the pixels in `pockets`, filtered among themselves by two a-trous levels (Dammertz et al.,
/// HPG 2010) whose weights fall with the difference in normal and in depth, never with colour. Sums are
/// filtered, not ratios. Row by row; pixels outside the pockets keep zeros.
[[nodiscard]] std::vector<FilteredLight> filter_pockets(const std::vector<StimulusPixel>& sums,
                                                        const std::vector<bool>& pockets,
                                                        const std::vector<Guide>& guides, int width_px,
                                                        int height_px, int threads);
/// The same of `light` alone, a sample.
[[nodiscard]] std::vector<float> filter_pockets(const std::vector<float>& light,
                                                const std::vector<StimulusPixel>& sums,
                                                const std::vector<bool>& pockets,
                                                const std::vector<Guide>& guides, int width_px, int height_px,
                                                int threads);

}  // namespace seamline::renderer
