#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <memory>

#include "support/files/image.h"

namespace seamline::renderer {

/// What a texture shows outside 0 to 1.
enum class Wrap { repeat, mirrored, clamp };

/// How a texture's codes are numbers: colours are sRGB, everything else, and alpha always, is linear.
enum class Encoding { srgb, linear };

/// A picture on a surface. Texture coordinates are glTF's: (0, 0) is the picture's upper left corner, (1, 1)
/// its lower right one. The picture keeps its 8-bit codes.
struct Texture {
  std::shared_ptr<const ByteImage> picture;  ///< 1 to 4 channels
  Encoding encoding = Encoding::linear;
  Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
  bool nearest = false;  ///< not mixed from four texels
  int uv_set = 0;        ///< which of a mesh's texture coordinates
  /// Of KHR_texture_transform: uv becomes this times (u, v, 1).
  Eigen::Matrix<float, 2, 3> transform = Eigen::Matrix<float, 2, 3>::Identity();

  [[nodiscard]] bool has_alpha() const { return picture->channels == 2 || picture->channels == 4; }
};

/// Linear red, green, blue and alpha at a point of a surface, mixed from four texels after they are decoded.
/// A grey picture is grey in all three; without alpha it is 1.
[[nodiscard]] Eigen::Array4f look_up(const Texture& texture, const Eigen::Vector2f& uv);

/// The transform of KHR_texture_transform: scaled, turned counter-clockwise as the picture is seen, and
/// moved.
[[nodiscard]] Eigen::Matrix<float, 2, 3> texture_transform(const Eigen::Vector2f& offset, float rotation_rad,
                                                           const Eigen::Vector2f& scale);

}  // namespace seamline::renderer
