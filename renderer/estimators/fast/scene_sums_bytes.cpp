#include "renderer/estimators/fast/scene_sums_bytes.h"

namespace seamline::renderer {
namespace {

// Numbers without gaps between them: equal sums have equal bytes.
static_assert(sizeof(SeenSurface) == 8 * sizeof(float));
static_assert(sizeof(WorldPixel) == 28 * sizeof(float));
static_assert(sizeof(ObjectPixel) == 27 * sizeof(float));
static_assert(sizeof(WorldPart) == 12 * sizeof(float));
static_assert(sizeof(ObjectPart) == 12 * sizeof(float));
static_assert(sizeof(RayCounts) == 5 * sizeof(std::int64_t));

/// Samples of a block, at most: what a damaged file may ask memory for.
constexpr std::size_t most_samples = std::size_t{1} << 17;

}  // namespace

void write_sums(const SceneSums& sums, ByteWriter& out) {
  for (const auto& half : sums.halves) out.put_all(half);
  out.put(static_cast<std::uint8_t>(sums.mirrored[0].empty() ? 0 : 1));
  for (const auto& half : sums.mirrored) out.put_all(half);
  out.put(static_cast<std::uint8_t>(sums.sky[0].empty() ? 0 : 1));
  for (const auto& half : sums.sky) out.put_all(half);
  for (const auto& guides : sums.guides) out.put_all(guides);
  out.put_all(sums.spp);
  out.put(sums.counts);
  for (const auto& object : sums.objects)
    for (const std::unique_ptr<ObjectTile>& tile : object) {
      out.put(static_cast<std::uint8_t>(tile ? 1 : 0));
      if (!tile) continue;
      for (const auto& half : tile->halves) out.put_all(half);
      for (const auto& half : tile->mirrored) out.put_all(half);
      for (const auto& half : tile->sky) out.put_all(half);
      out.put_all(tile->guides);
      for (const ObjectOnRays& block : tile->on_rays) out.put_all(block.all());
    }
}

bool read_sums(ByteReader& in, SceneSums& sums) {
  for (auto& half : sums.halves) in.get_all(half, half.size());
  std::uint8_t mirrors = 0;
  in.get(mirrors);
  for (std::size_t half = 0; half < 2; ++half)
    in.get_all(sums.mirrored[half], mirrors == 0 ? 0 : sums.halves[half].size());
  std::uint8_t skies = 0;
  in.get(skies);
  for (std::size_t half = 0; half < 2; ++half)
    in.get_all(sums.sky[half], skies == 0 ? 0 : sums.halves[half].size());
  for (auto& guides : sums.guides) in.get_all(guides, guides.size());
  in.get_all(sums.spp, sums.spp.size());
  in.get(sums.counts);
  for (auto& object : sums.objects)
    for (std::unique_ptr<ObjectTile>& tile : object) {
      std::uint8_t there = 0;
      in.get(there);
      tile.reset();
      if (there == 0 || in.failed()) continue;
      tile = std::make_unique<ObjectTile>();
      for (auto& half : tile->halves) in.get_all(half, tile_pixels);
      for (auto& half : tile->mirrored) in.get_all(half, mirrors == 0 ? 0 : tile_pixels);
      for (auto& half : tile->sky) in.get_all(half, skies == 0 ? 0 : tile_pixels);
      in.get_all(tile->guides, tile_pixels);
      for (ObjectOnRays& block : tile->on_rays)
        in.get_some(block.all(), most_samples * BlockGrid::side_px * BlockGrid::side_px);
    }
  return in.is_done();
}

}  // namespace seamline::renderer
