#pragma once
#include <vector>

#include "raytracer/common/tiles.h"
#include "renderer/picture/pixel_sums.h"

namespace seamline::renderer {

/// Light a sample without and with the object, of one pixel.
struct FilteredLight {
  Rgb without_object = Rgb::Zero();
  Rgb with_object = Rgb::Zero();
};

/// The light of the pixels in `pockets`, filtered among themselves by two a-trous levels (Dammertz et al.,
/// HPG 2010) whose weights fall with the difference in normal and in depth, never with colour. Sums are
/// filtered, not ratios. Row by row; pixels outside the pockets keep zeros. `grid`: the picture's size, and
/// whether its last column stands beside its first.
[[nodiscard]] std::vector<FilteredLight> filter_pockets(const std::vector<StimulusPixel>& sums,
                                                        const std::vector<bool>& pockets,
                                                        const std::vector<Guide>& guides,
                                                        const TileGrid& grid, int threads);
/// The same of `light` alone, a sample.
[[nodiscard]] std::vector<float> filter_pockets(const std::vector<float>& light,
                                                const std::vector<StimulusPixel>& sums,
                                                const std::vector<bool>& pockets,
                                                const std::vector<Guide>& guides, const TileGrid& grid,
                                                int threads);

}  // namespace seamline::renderer
