#pragma once
#include <Eigen/Core>
#include <vector>

#include "renderer/material/direction_map.h"

namespace seamline::renderer {

/// A share of 0 to 1 by direction, in the panorama's domain (renderer/material/direction_map.h): of an
/// occlusion mask how much of a texel the real world hides the virtual object in, of a shadow matte how much
/// of the sun arrives at the real surface there. (Masks of files, which people paint, are
/// renderer/common/mask.h's.)
using DirectionMask = DirectionMap<float>;

/// Whether a mask hides in a direction: a half, linear between texels, so that a silhouette is finer than
/// they are.
[[nodiscard]] inline bool masks(const DirectionMask& mask, const Eigen::Vector3f& direction) {
  return mask.at(direction) >= 0.5F;
}

/// How much of each sun arrives at the real surfaces that a photograph shows, in place of any geometry's
/// answer. One mask a sun, in the light's order.
struct ShadowMatte {
  std::vector<DirectionMask> of_suns;
};

/// An empty mask of so many texels around, even.
[[nodiscard]] DirectionMask empty_mask(int width_px, float elsewhere);

}  // namespace seamline::renderer
