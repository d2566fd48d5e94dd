#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <variant>
#include <vector>

#include "raytracer/material/direction_map.h"
#include "support/files/image.h"

namespace seamline::renderer {

// A mask is a given answer from 0 to 1 for every place of a picture, whoever made it: somebody who painted a
// file, or a study from its truth. Of an occlusion mask 1 means that something real is in front, of a shadow
// matte that the sun does not reach the surface that is seen there. Its resolution is its own.

/// A mask by direction, equirectangular as depth maps are.
using DirectionMask = DirectionMap<float>;
/// A mask over the photograph, edge to edge; one channel.
struct PhotographMask {
  Image values;
};
using Mask = std::variant<DirectionMask, PhotographMask>;

/// Whether an occlusion mask hides in a direction: a half, linear between texels, so that a silhouette is
/// finer than they are.
[[nodiscard]] inline bool masks(const DirectionMask& mask, const Eigen::Vector3f& direction) {
  return mask.at(direction) >= 0.5F;
}

/// A mask of so many texels around, even, all of one value.
[[nodiscard]] DirectionMask even_mask(int width_px, float value);

/// Where a sample lies: its direction in the world, and its place in the photograph, 0 to 1 across and down.
struct MaskPlace {
  Eigen::Vector3f direction;
  Eigen::Array2f in_photograph = Eigen::Array2f::Zero();
};

/// The mask there, bilinear between the centres of its pixels.
[[nodiscard]] float mask_at(const Mask& mask, const MaskPlace& place);

/// What suns do not reach of the real surfaces that a photograph shows, in place of any geometry's answer:
/// one matte a sun, in the light's order, or one for all of them.
struct ShadowMatte {
  std::vector<DirectionMask> of_suns = {};
  const Mask* of_all_suns = nullptr;  ///< in place of those; outlives this
};
/// The share of a sun's light that arrives there.
[[nodiscard]] inline float arriving_share(const ShadowMatte& matte, std::size_t sun, const MaskPlace& place) {
  return 1.0F - (matte.of_all_suns != nullptr ? mask_at(*matte.of_all_suns, place)
                                              : matte.of_suns[sun].at(place.direction));
}

/// Reads a mask: PNG (whole numbers as shares of the largest, no display curve) or EXR, of which the first
/// channel counts. Throws InputError naming the file at values outside 0 to 1 and at a shape that is neither
/// 2:1 nor that of the photograph; one that could be either is the photograph's.
[[nodiscard]] Mask read_mask(const std::filesystem::path& path, int photograph_width_px,
                             int photograph_height_px, bool photograph_is_panorama);

}  // namespace seamline::renderer
