#include "live/frame/caster_blocks.h"
#include "support/arithmetic/grid_index.h"

#include <algorithm>
#include <limits>

namespace seamline::live {
namespace {

constexpr int block_px = 16;

int blocks_of(int size_px) {
  return (size_px + block_px - 1) / block_px + 2;
}

}  // namespace

CasterBlocks::CasterBlocks(const renderer::ShadowMap& map)
    : left_(map.view.corner[0]),
      top_(map.view.corner[1]),
      width_(blocks_of(map.depth.width_px)),
      height_(blocks_of(map.depth.height_px)) {
  const Eigen::Array2f size_px(static_cast<float>(map.depth.width_px),
                               static_cast<float>(map.depth.height_px));
  blocks_per_unit_ = size_px / (map.view.size * static_cast<float>(block_px));
  std::vector<std::uint8_t> filled(width_ * static_cast<std::size_t>(height_), 0);
  for (int y = 0; y < map.depth.height_px; ++y) {
    const float* row = &map.depth.depth_m[grid_index(y, 0, map.depth.width_px)];
    for (int x = 0; x < map.depth.width_px; x += block_px) {
      const int end = std::min(x + block_px, map.depth.width_px);
      const bool any = std::any_of(
          row + x, row + end, [](float depth_m) { return depth_m < std::numeric_limits<float>::infinity(); });
      if (any) filled[grid_index(y / block_px + 1, x / block_px + 1, width_)] = 1;
    }
  }
  has_.assign(filled.size(), 0);
  for (int y = 0; y < height_; ++y)
    for (int x = 0; x < width_; ++x) {
      if (filled[grid_index(y, x, width_)] == 0) continue;
      for (int beside_y = std::max(y - 1, 0); beside_y <= std::min(y + 1, height_ - 1); ++beside_y)
        for (int beside_x = std::max(x - 1, 0); beside_x <= std::min(x + 1, width_ - 1); ++beside_x)
          has_[grid_index(beside_y, beside_x, width_)] = 1;
    }
}

}  // namespace seamline::live
