#include "stimuli/pictures/mask_image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "support/arithmetic/random.h"

namespace seamline {
namespace {

/// Every pixel another one, in a size that no whole squares fill.
ByteImage different_pixels() {
  ByteImage image{.width_px = 166, .height_px = 90, .channels = 3, .values = {}};
  for (int i = 0; i < image.width_px * image.height_px; ++i)
    for (const int shift : {0, 8, 16}) image.values.push_back(static_cast<std::uint8_t>((i >> shift) & 255));
  return image;
}

std::vector<std::array<std::uint8_t, 3>> sorted_pixels(const ByteImage& image) {
  std::vector<std::array<std::uint8_t, 3>> pixels;
  for (std::size_t i = 0; i < image.values.size(); i += 3)
    pixels.push_back({image.values[i], image.values[i + 1], image.values[i + 2]});
  std::sort(pixels.begin(), pixels.end());
  return pixels;
}

TEST(MaskImage, TheSameSeedAndStreamGiveTheSameBytesAndOthersDoNot) {
  const ByteImage reference = different_pixels();
  for (const TaskMask mask : {TaskMask::noise, TaskMask::scrambled}) {
    const ByteImage once = mask_image(reference, mask, 7, 1);
    EXPECT_EQ(once.values, mask_image(reference, mask, 7, 1).values);
    EXPECT_NE(once.values, mask_image(reference, mask, 8, 1).values);
    EXPECT_NE(once.values, mask_image(reference, mask, 7, 2).values);
    EXPECT_EQ(once.values.size(), reference.values.size());
  }
}

TEST(MaskImage, ScramblingKeepsEveryPixelAndMovesNearlyAll) {
  const ByteImage reference = different_pixels();
  const ByteImage mask = mask_image(reference, TaskMask::scrambled, 3, 0);
  EXPECT_EQ(sorted_pixels(mask), sorted_pixels(reference));
  int stayed = 0;
  for (std::size_t i = 0; i < mask.values.size(); i += 3)
    stayed += std::equal(mask.values.begin() + static_cast<std::ptrdiff_t>(i),
                         mask.values.begin() + static_cast<std::ptrdiff_t>(i + 3),
                         reference.values.begin() + static_cast<std::ptrdiff_t>(i))
                  ? 1
                  : 0;
  EXPECT_LT(stayed, reference.width_px * reference.height_px / 5);
}

TEST(MaskImage, NoiseIsGreyInSquaresAndEveryGreyIsEquallyLikely) {
  ByteImage reference{.width_px = 640, .height_px = 400, .channels = 3, .values = {}};
  reference.values.resize(std::size_t{3} * 640 * 400);
  const ByteImage mask = mask_image(reference, TaskMask::noise, 5, 0);
  std::map<int, int> counts;
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 640; ++x) {
      const std::size_t at = 3 * (static_cast<std::size_t>(y) * 640 + static_cast<std::size_t>(x));
      const std::size_t corner =
          3 * (static_cast<std::size_t>(y - y % 4) * 640 + static_cast<std::size_t>(x - x % 4));
      ASSERT_EQ(mask.values[at], mask.values[corner]);
      ASSERT_TRUE(mask.values[at] == mask.values[at + 1] && mask.values[at] == mask.values[at + 2]);
      if (at == corner) ++counts[mask.values[at]];
    }
  const double expected = 160.0 * 100 / 256;
  double chi_squared = 0;
  for (int grey = 0; grey < 256; ++grey) chi_squared += std::pow(counts[grey] - expected, 2) / expected;
  EXPECT_NEAR(chi_squared, 255, 4 * std::sqrt(2.0 * 255));
}

}  // namespace
}  // namespace seamline
