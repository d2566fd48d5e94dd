#include "stimuli/pictures/mask_image.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <map>
#include <utility>
#include <vector>

#include "support/arithmetic/grid_index.h"
#include "support/arithmetic/random.h"

namespace seamline::inline stimuli {
namespace {

constexpr int noise_square_px = 4, scrambled_square_px = 16;
constexpr std::uint64_t mask_salt = 0x6d61736b;  // "mask"

struct Square {
  int x_px = 0, y_px = 0, width_px = 0, height_px = 0;
};

/// In rows from the top.
std::vector<Square> squares_of(const ByteImage& image, int side_px) {
  std::vector<Square> squares;
  for (int y = 0; y < image.height_px; y += side_px)
    for (int x = 0; x < image.width_px; x += side_px)
      squares.push_back(
          {x, y, std::min(side_px, image.width_px - x), std::min(side_px, image.height_px - y)});
  return squares;
}

std::size_t place(const ByteImage& image, int x_px, int y_px) {
  return 3 * grid_index(y_px, x_px, image.width_px);
}

ByteImage noise(ByteImage image, Random& random) {
  for (const Square& square : squares_of(image, noise_square_px)) {
    const auto grey = static_cast<std::uint8_t>(random.below(256));
    for (int y = 0; y < square.height_px; ++y)
      std::fill_n(
          image.values.begin() + static_cast<std::ptrdiff_t>(place(image, square.x_px, square.y_px + y)),
          3 * square.width_px, grey);
  }
  return image;
}

void copy_square(const ByteImage& from, const Square& source, ByteImage& into, const Square& target) {
  for (int y = 0; y < target.height_px; ++y)
    std::copy_n(from.values.begin() + static_cast<std::ptrdiff_t>(place(from, source.x_px, source.y_px + y)),
                3 * target.width_px,
                into.values.begin() + static_cast<std::ptrdiff_t>(place(into, target.x_px, target.y_px + y)));
}

ByteImage scrambled(const ByteImage& reference, Random& random) {
  ByteImage image = reference;
  std::map<std::array<int, 2>, std::vector<Square>> by_size;
  for (const Square& square : squares_of(reference, scrambled_square_px))
    by_size[{square.width_px, square.height_px}].push_back(square);
  for (const auto& [size, squares] : by_size) {
    std::vector<Square> sources = squares;
    shuffle(std::span<Square>(sources), random);
    for (std::size_t i = 0; i < squares.size(); ++i) copy_square(reference, sources[i], image, squares[i]);
  }
  return image;
}

}  // namespace

ByteImage mask_image(const ByteImage& reference, TaskMask mask, std::uint64_t seed, std::uint64_t stream) {
  assert(reference.channels == 3 && mask != TaskMask::none);
  Random random(mix_bits(seed ^ mask_salt), stream);
  return mask == TaskMask::noise ? noise(reference, random) : scrambled(reference, random);
}

}  // namespace seamline::inline stimuli
