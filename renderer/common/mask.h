#pragma once
#include <Eigen/Core>
#include <filesystem>

#include "support/files/image.h"

namespace seamline::renderer {

/// What a mask's rows and columns are. Its resolution is its own.
enum class MaskDomain {
  panorama,   ///< directions, equirectangular, as depth maps are
  photograph  ///< the photograph, edge to edge
};

/// A given answer, from 0 to 1, for every place of a picture: an occlusion mask (1: something real is in
/// front) or a shadow matte (1: the sun does not reach the surface that is seen there).
struct Mask {
  Image values;  ///< one channel
  MaskDomain domain = MaskDomain::photograph;
};

/// Where a sample lies: its direction in the world, and its place in the photograph, 0 to 1 across and down.
struct MaskPlace {
  Eigen::Vector3f direction;
  Eigen::Array2f in_photograph;
};

/// The mask there, bilinear between the centres of its pixels.
[[nodiscard]] float mask_at(const Mask& mask, const MaskPlace& place);

/// Reads a mask: PNG (whole numbers as shares of the largest, no display curve) or EXR, of which the first
/// channel counts. Throws InputError naming the file at values outside 0 to 1 and at a shape that is neither
/// 2:1 nor that of the photograph; one that could be either is the photograph's.
[[nodiscard]] Mask read_mask(const std::filesystem::path& path, int photograph_width_px,
                             int photograph_height_px, bool photograph_is_panorama);

}  // namespace seamline::renderer
