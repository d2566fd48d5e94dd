#include "sets/pages/artists_map.h"

#include <gtest/gtest.h>

#include <array>

namespace seamline::renderer {
namespace {

constexpr int map_width_px = 40, map_height_px = 10;

PixelSet nothing() {
  return {map_width_px, map_height_px, std::vector<std::uint8_t>(map_width_px * map_height_px, 0)};
}

PixelSet with_pixel(int x, int y) {
  PixelSet set = nothing();
  set.values[static_cast<std::size_t>(y * map_width_px + x)] = 1;
  return set;
}

/// Every width of 64 to 2048, each with a seam where `has` says so.
template <class Has>
std::vector<SeamAtWidth> seams(const Has& has) {
  std::vector<SeamAtWidth> out;
  for (int map_px = 64; map_px <= 2048; map_px *= 2)
    out.push_back({map_px, has(map_px) ? with_pixel(20, 5) : nothing()});
  return out;
}

GeometryNeed need_at(const std::vector<GeometryNeed>& needs, int x, int y) {
  return needs[static_cast<std::size_t>(y * map_width_px + x)];
}

TEST(GeometryNeeds, IsTheSmallestWidthFromWhichOnNoMapHasASeam) {
  const ArtistsRule rule{.coarse_px = 256, .fine_px = 1024};
  const auto need = [&](const auto& has) {
    return need_at(geometry_needs(seams(has), nothing(), rule, 1), 20, 5);
  };
  EXPECT_EQ(need([](int) { return false; }), GeometryNeed::nothing);
  EXPECT_EQ(need([](int map_px) { return map_px <= 64; }), GeometryNeed::coarse);
  EXPECT_EQ(need([](int map_px) { return map_px <= 128; }), GeometryNeed::coarse) << "256 px has none";
  EXPECT_EQ(need([](int map_px) { return map_px <= 256; }), GeometryNeed::fine);
  EXPECT_EQ(need([](int map_px) { return map_px <= 512; }), GeometryNeed::fine) << "1024 px has none";
  EXPECT_EQ(need([](int map_px) { return map_px <= 1024; }), GeometryNeed::mask);
  EXPECT_EQ(need([](int map_px) { return map_px == 2048; }), GeometryNeed::mask) << "the finest still has it";
  EXPECT_EQ(need([](int map_px) { return map_px == 512; }), GeometryNeed::fine) << "coarser ones had luck";
}

TEST(GeometryNeeds, ASeamIsARegionAndAnObjectIsCoarseWhereItHasNone) {
  const auto needs = geometry_needs(seams([](int map_px) { return map_px <= 512; }), with_pixel(2, 2), {}, 3);
  for (int y = 0; y < map_height_px; ++y)
    for (int x = 0; x < map_width_px; ++x) {
      const int square = (x - 20) * (x - 20) + (y - 5) * (y - 5);
      const GeometryNeed expected = square <= 9        ? GeometryNeed::fine
                                    : x == 2 && y == 2 ? GeometryNeed::coarse
                                                       : GeometryNeed::nothing;
      EXPECT_EQ(need_at(needs, x, y), expected) << x << " " << y;
    }
}

TEST(GeometryNeeds, SpecksAreNoSeamsAndThinLinesAre) {
  PixelSet set = with_pixel(35, 2);
  set.values[3 * map_width_px + 36] = 1;  // two pixels that touch by a corner
  for (int x = 0; x < 8; ++x)
    set.values[static_cast<std::size_t>(5 * map_width_px + x)] = 1;  // a line of eight
  const PixelSet left = without_specks(set, 8);
  for (int y = 0; y < map_height_px; ++y)
    for (int x = 0; x < map_width_px; ++x)
      EXPECT_EQ(left.values[static_cast<std::size_t>(y * map_width_px + x)], y == 5 && x < 8 ? 1 : 0);
}

TEST(GeometryNeeds, TheWorstOfAllStimuliCounts) {
  auto all = seams([](int map_px) { return map_px <= 64; });
  const auto others = seams([](int map_px) { return map_px <= 512; });
  all.insert(all.end(), others.begin(), others.end());
  EXPECT_EQ(need_at(geometry_needs(all, nothing(), {}, 1), 20, 5), GeometryNeed::fine);
}

TEST(ArtistsPicture, NeedsDifferInLightnessForEveryEye) {
  ByteImage grey{4, 1, 3, std::vector<std::uint8_t>(12, 128)};
  const ByteImage picture = artists_picture(
      grey, {GeometryNeed::nothing, GeometryNeed::coarse, GeometryNeed::fine, GeometryNeed::mask}, {});
  EXPECT_GT(picture.height_px, 1) << "a legend";
  std::array<double, 4> luma{};
  for (std::size_t i = 0; i < 4; ++i)
    luma[i] = 0.2126 * picture.values[3 * i] + 0.7152 * picture.values[3 * i + 1] +
              0.0722 * picture.values[3 * i + 2];
  for (std::size_t i = 1; i < 4; ++i)
    for (std::size_t k = 1; k < i; ++k) EXPECT_GT(std::abs(luma[i] - luma[k]), 25) << i << " " << k;
}

}  // namespace
}  // namespace seamline::renderer
