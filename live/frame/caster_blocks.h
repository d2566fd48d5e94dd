#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "renderer/realtime/shadow_map.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::live {

/// Where a shadow map has anything at all, in blocks of 16 x 16 texels: most of the pixels that a light sees
/// behind an object's box need no further question.
class CasterBlocks {
 public:
  explicit CasterBlocks(const renderer::ShadowMap& map);

  /// Whether anything that throws a shadow lies at a place of the light's picture plane, or less than 16
  /// texels beside it. Outside the picture: false but within 16 texels of it.
  [[nodiscard]] bool near(float u, float v) const {
    const int x = static_cast<int>((u - left_) * blocks_per_unit_[0]) + 1;
    const int y = static_cast<int>((v - top_) * blocks_per_unit_[1]) + 1;
    return x >= 0 && y >= 0 && x < width_ && y < height_ && has_[grid_index(y, x, width_)] != 0;
  }

 private:
  float left_ = 0, top_ = 0;
  Eigen::Array2f blocks_per_unit_;
  int width_ = 0, height_ = 0;  ///< with one more block on each side
  std::vector<std::uint8_t> has_;
};

}  // namespace seamline::live
