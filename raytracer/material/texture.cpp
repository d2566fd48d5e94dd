#include "raytracer/material/texture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "support/arithmetic/bilinear.h"
#include "support/arithmetic/colour.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

constexpr int codes = 256;
using DecodingTable = std::array<float, codes>;

const DecodingTable& decoding_table(Encoding encoding) {
  static const std::array<DecodingTable, 2> tables = [] {
    std::array<DecodingTable, 2> made{};
    for (std::size_t code = 0; code < codes; ++code) {
      const float display = static_cast<float>(code) / (codes - 1);
      made[0][code] = linear_from_srgb(display);
      made[1][code] = display;
    }
    return made;
  }();
  return tables[encoding == Encoding::srgb ? 0 : 1];
}

/// Index of a texel that may lie outside the picture.
int wrapped(std::int64_t index, int size, Wrap wrap) {
  const std::int64_t count = size;
  switch (wrap) {
    case Wrap::repeat:
      return static_cast<int>(((index % count) + count) % count);
    case Wrap::mirrored: {
      const std::int64_t twice = ((index % (2 * count)) + 2 * count) % (2 * count);
      return static_cast<int>(twice < count ? twice : 2 * count - 1 - twice);
    }
    case Wrap::clamp:
      return static_cast<int>(std::clamp<std::int64_t>(index, 0, count - 1));
  }
  return 0;
}

/// A coordinate in texels, not so far out that a whole number could not hold it; what is no number is 0.
float in_texels(float coordinate, int size) {
  constexpr float farthest = 1e9F;
  const float at = coordinate * static_cast<float>(size);
  return at > -farthest && at < farthest ? at : 0.0F;
}

Eigen::Array4f texel(const Texture& texture, int x, int y) {
  const ByteImage& picture = *texture.picture;
  const auto channels = static_cast<std::size_t>(picture.channels);
  const std::uint8_t* at = picture.values.data() + grid_index(y, x, picture.width_px) * channels;
  const DecodingTable& colour = decoding_table(texture.encoding);
  const DecodingTable& linear = decoding_table(Encoding::linear);
  if (channels <= 2)
    return {colour[at[0]], colour[at[0]], colour[at[0]], channels == 2 ? linear[at[1]] : 1.0F};
  return {colour[at[0]], colour[at[1]], colour[at[2]], channels == 4 ? linear[at[3]] : 1.0F};
}

}  // namespace

Eigen::Array4f look_up(const Texture& texture, const Eigen::Vector2f& uv) {
  const Eigen::Vector2f at = texture.transform * Eigen::Vector3f(uv.x(), uv.y(), 1.0F);
  const int width_px = texture.picture->width_px, height_px = texture.picture->height_px;
  const auto column = [&](std::int64_t x) { return wrapped(x, width_px, texture.wrap_u); };
  const auto row = [&](std::int64_t y) { return wrapped(y, height_px, texture.wrap_v); };
  const float x = in_texels(at.x(), width_px), y = in_texels(at.y(), height_px);
  if (texture.nearest)
    return texel(texture, column(static_cast<std::int64_t>(std::floor(x))),
                 row(static_cast<std::int64_t>(std::floor(y))));
  return bilinear(between_cells<std::int64_t>(x - 0.5F, y - 0.5F), [&](std::int64_t left, std::int64_t top) {
    return texel(texture, column(left), row(top));
  });
}

Eigen::Matrix<float, 2, 3> texture_transform(const Eigen::Vector2f& offset, float rotation_rad,
                                             const Eigen::Vector2f& scale) {
  const float cosine = std::cos(rotation_rad), sine = std::sin(rotation_rad);
  Eigen::Matrix<float, 2, 3> transform;
  transform << cosine * scale.x(), sine * scale.y(), offset.x(),  //
      -sine * scale.x(), cosine * scale.y(), offset.y();
  return transform;
}

}  // namespace seamline::renderer
