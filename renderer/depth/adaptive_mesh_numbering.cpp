#include "renderer/depth/adaptive_mesh_numbering.h"

#include <atomic>
#include <bit>

#include "support/running/parallel.h"

namespace seamline::renderer {

VertexNumbering::VertexNumbering(int width, int height)
    : tiles_across_((width + 7) / 8),
      tiles_down_((height + 7) / 8),
      marked_(static_cast<std::size_t>(tiles_across_) * static_cast<std::size_t>(tiles_down_)),
      marked_before_(marked_.size()) {}

void VertexNumbering::mark(int row, int column) {
  std::atomic_ref<std::uint64_t> bits(marked_[tile(row, column)]);
  if ((bits.load(std::memory_order_relaxed) & bit(row, column)) == 0)
    bits.fetch_or(bit(row, column), std::memory_order_relaxed);
}

std::uint32_t VertexNumbering::number_marked() {
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < marked_.size(); ++i) {
    marked_before_[i] = count;
    count += static_cast<std::uint32_t>(std::popcount(marked_[i]));
  }
  return count;
}

std::uint32_t VertexNumbering::number(int row, int column) const {
  const std::size_t i = tile(row, column);
  return marked_before_[i] + static_cast<std::uint32_t>(std::popcount(marked_[i] & (bit(row, column) - 1)));
}

void VertexNumbering::write_positions(const DenseSphere& sphere, Eigen::Vector3f* positions_m,
                                      int threads) const {
  run_parallel(tiles_down_, threads, [&](int tile_row) {
    for (int tile_column = 0; tile_column < tiles_across_; ++tile_column) {
      const std::size_t i = tile(tile_row * 8, tile_column * 8);
      Eigen::Vector3f* out = positions_m + marked_before_[i];
      for (std::uint64_t bits = marked_[i]; bits != 0; bits &= bits - 1) {
        const int place = std::countr_zero(bits);
        *out++ = sphere.position_m(tile_row * 8 + place / 8, tile_column * 8 + place % 8);
      }
    }
  });
}

}  // namespace seamline::renderer
