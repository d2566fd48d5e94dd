#include "stimuli/pictures/attention_image.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/arithmetic/random.h"
#include "support/text/error.h"

namespace seamline {
namespace {

constexpr int width = 64, height = 32;

ByteImage noise(std::uint64_t seed, int least, int most) {
  ByteImage image{.width_px = width, .height_px = height, .channels = 3, .values = {}};
  Random random(seed);
  for (int i = 0; i < width * height * 3; ++i)
    image.values.push_back(static_cast<std::uint8_t>(
        least + static_cast<int>(random.below(static_cast<std::uint64_t>(most - least + 1)))));
  return image;
}

/// Three objects side by side, with background between them.
ByteImage three_objects() {
  ByteImage ids{.width_px = width, .height_px = height, .channels = 1, .values = {}};
  for (int i = 0; i < width * height; ++i) {
    const int x = i % width;
    ids.values.push_back(static_cast<std::uint8_t>(x % 16 < 8 ? std::min(3, x / 16 + 1) : 0));
  }
  return ids;
}

TEST(AttentionImage, ChangesTheObjectAndNothingElse) {
  const ByteImage reference = noise(1, 0, 255);
  const ByteImage ids = three_objects();
  for (const int object : {1, 2, 3}) {
    const ByteImage image = attention_image(reference, ids, object);
    ASSERT_EQ(image.values.size(), reference.values.size());
    for (std::size_t pixel = 0; pixel < ids.values.size(); ++pixel)
      if (ids.values[pixel] != object) {
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_EQ(image.values[3 * pixel + c], reference.values[3 * pixel + c]) << pixel;
      }
    EXPECT_EQ(image.values, attention_image(reference, ids, object).values);
  }
}

double distance(const std::uint8_t* one, const std::uint8_t* other) {
  double sum = 0;
  for (int c = 0; c < 3; ++c) sum += std::pow(one[c] - other[c], 2.0);
  return std::sqrt(sum);
}

/// However dark, bright or coloured a surface is, each of its pixels moves far in codes of 0 to 255.
TEST(AttentionImage, NoPixelOfTheObjectStaysNearWhatItWas) {
  const ByteImage ids = three_objects();
  for (const auto& [least, most] :
       {std::pair(0, 10), std::pair(20, 60), std::pair(90, 140), std::pair(180, 220), std::pair(245, 255)}) {
    const ByteImage reference = noise(7, least, most);
    const ByteImage image = attention_image(reference, ids, 2);
    double nearest = 1000;
    for (std::size_t pixel = 0; pixel < ids.values.size(); ++pixel)
      if (ids.values[pixel] == 2)
        nearest = std::min(nearest, distance(&image.values[3 * pixel], &reference.values[3 * pixel]));
    EXPECT_GT(nearest, 45) << least << " to " << most;
  }
}

ByteImage grey_ramp() {
  ByteImage ramp{.width_px = 256, .height_px = 1, .channels = 3, .values = {}};
  for (int code = 0; code < 256; ++code)
    for (int c = 0; c < 3; ++c) ramp.values.push_back(static_cast<std::uint8_t>(code));
  return ramp;
}

const ByteImage ramp_ids{
    .width_px = 256, .height_px = 1, .channels = 1, .values = std::vector<std::uint8_t>(256, 1)};

/// The built-in objects are grey.
TEST(AttentionImage, EveryGreyMovesByAtLeast80Codes) {
  const ByteImage ramp = grey_ramp();
  const ByteImage image = attention_image(ramp, ramp_ids, 1);
  for (std::size_t code = 0; code < 256; ++code)
    EXPECT_GT(distance(&image.values[3 * code], &ramp.values[3 * code]), 80) << code;
}

/// Its shading is left: what was brighter in a channel is not darker afterwards.
TEST(AttentionImage, KeepsTheOrderOfShades) {
  const ByteImage image = attention_image(grey_ramp(), ramp_ids, 1);
  for (std::size_t i = 3; i < image.values.size(); ++i) EXPECT_GE(image.values[i], image.values[i - 3]);
}

TEST(AttentionImage, RefusesPicturesThatDoNotBelongTogether) {
  const ByteImage reference = noise(1, 0, 255);
  ByteImage ids = three_objects();
  EXPECT_THROW((void)attention_image(reference, ids, 4), InputError);
  EXPECT_THROW((void)attention_image(reference, reference, 1), InputError);
  ids.width_px /= 2;
  EXPECT_THROW((void)attention_image(reference, ids, 1), InputError);
}

}  // namespace
}  // namespace seamline
