#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "raytracer/common/tiles.h"
#include "raytracer/tracing/ray.h"
#include "renderer/transport/worlds.h"

namespace seamline::renderer {

/// Mean surface that samples saw, as sums.
struct SeenSurface {
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Rgb albedo = Rgb::Zero();
  float distance_m = 0;
  float inverse_reach =
      0;  ///< 1 / how far gather rays get: large in creases, where bounce light changes fast

  void add(const SurfacePoint& point, float reach_m) {
    inverse_reach += 1.0F / (reach_m + 1e-3F * point.distance_m);
    normal += point.normal;
    albedo += point.albedo;
    distance_m += point.distance_m;
  }
};

/// Light without what is mirrored. Sums of mirrored light stand apart, so that scenes in which nothing is
/// glossy have none.
struct Unmirrored {
  Rgb direct = Rgb::Zero(), bounce = Rgb::Zero();

  Unmirrored& operator+=(const Split& light) {
    direct += light.direct;
    bounce += light.bounce;
    return *this;
  }
  [[nodiscard]] Split with(const Rgb& mirrored) const { return {direct, bounce, mirrored}; }
};

/// Worlds that stand together: those of the usual three objects.
inline constexpr std::size_t worlds_a_group = 4;

/// What the camera sees through one pixel in each world of a group, summed over the samples of one half.
struct WorldPixel {
  std::array<Unmirrored, worlds_a_group> seen = {};  ///< light of the surfaces that each world shows
  std::array<float, worlds_a_group> surfaces = {};   ///< samples that show a surface; the others show sky
};

/// Where a world of a pixel stands among groups.
struct WorldPlace {
  std::size_t pixel = 0;  ///< in `SceneSums::halves`
  std::size_t world = 0;  ///< in the group
};

/// Where an object lies on the camera ray, before or behind other things; of one pixel and half.
struct ObjectPixel {
  Unmirrored object;       ///< its own light where it is in front
  Unmirrored behind;       ///< light of what it covers, in the world without it,
  Unmirrored behind_with;  ///< and in the world with it (only when the study asks who is in front)
  Unmirrored hidden;       ///< its own light where something covers it (likewise)
  float covered = 0, behind_surfaces = 0, hidden_samples = 0;
};

/// A further part of the light that a `WorldPixel` and an `ObjectPixel` are about: what is mirrored, or the
/// sky.
struct WorldPart {
  std::array<Rgb, worlds_a_group> seen = {Rgb::Zero(), Rgb::Zero(), Rgb::Zero(), Rgb::Zero()};
};
struct ObjectPart {
  Rgb object = Rgb::Zero(), behind = Rgb::Zero(), behind_with = Rgb::Zero(), hidden = Rgb::Zero();
};

/// Of a pixel of such sums; nothing where there are none.
template <class Part>
[[nodiscard]] const Part& part_at(const std::vector<Part>& sums, std::size_t pixel) {
  static const Part nothing;
  return sums.empty() ? nothing : sums[pixel];
}

inline constexpr std::size_t tile_pixels =
    static_cast<std::size_t>(TileGrid::side_px) * static_cast<std::size_t>(TileGrid::side_px);

/// Whether the camera ray of each sample of a block meets an object, and whether something else is nearer; of
/// all pixels of a sample together. A byte a sample: there are hundreds of millions.
class ObjectOnRays {
 public:
  enum class Is : std::uint8_t { absent, in_front, covered };

  void set(int sample, int x, int y, Is found) { found_[place(sample, x, y)] = found; }
  /// Room for so many samples.
  void extend(int samples) {
    const std::size_t size = place(samples, 0, 0);
    if (found_.size() >= size) return;
    found_.reserve(size);  // and no more
    found_.resize(size, Is::absent);
  }
  /// All of them, as they are kept.
  [[nodiscard]] const std::vector<Is>& all() const { return found_; }
  [[nodiscard]] std::vector<Is>& all() { return found_; }
  [[nodiscard]] Is at(int sample, int x, int y) const {
    const std::size_t i = place(sample, x, y);
    return i < found_.size() ? found_[i] : Is::absent;
  }

 private:
  [[nodiscard]] static std::size_t place(int sample, int x, int y) {
    constexpr int pixels = BlockGrid::side_px * BlockGrid::side_px;
    return static_cast<std::size_t>(sample) * pixels + static_cast<std::size_t>(BlockGrid::place(x, y));
  }
  std::vector<Is> found_;
};

/// One object's part of a tile; only tiles that it is seen or hidden in have one.
struct ObjectTile {
  std::array<std::vector<ObjectPixel>, 2> halves;
  std::array<std::vector<ObjectPart>, 2> mirrored;  ///< likewise, or empty as the scene's
  std::array<std::vector<ObjectPart>, 2> sky;       ///< likewise
  std::vector<SeenSurface> guides;
  /// Of each block. Only when the study asks who is in front.
  std::array<ObjectOnRays, 4> on_rays;

  [[nodiscard]] static std::size_t block_in_tile(int x, int y) {
    static_assert(TileGrid::side_px == 2 * BlockGrid::side_px);
    return static_cast<std::size_t>(y / BlockGrid::side_px % 2 * 2 + x / BlockGrid::side_px % 2);
  }
};

/// All sums of a scene, its worlds and its objects.
struct SceneSums {
  TileGrid grid;
  std::size_t groups = 1;                          ///< of worlds, a pixel: as many as its objects need
  std::array<std::vector<WorldPixel>, 2> halves;   ///< row by row, groups of a pixel side by side
  std::array<std::vector<WorldPart>, 2> mirrored;  ///< likewise; empty where nothing is glossy
  /// The sky on the room's surfaces, where it is kept apart: else empty, and in the light.
  std::array<std::vector<WorldPart>, 2> sky;
  std::vector<std::vector<SeenSurface>> guides;  ///< of the surfaces that world k shows, at [k - 1]
  std::vector<std::vector<std::unique_ptr<ObjectTile>>> objects;  ///< [object][tile], may be null
  std::vector<int> spp;                                           ///< of each block, even
  RayCounts counts;

  [[nodiscard]] std::size_t index(int x, int y) const { return grid.index(x, y); }
  [[nodiscard]] WorldPlace place_of(std::size_t pixel, std::size_t world) const {
    return {pixel * groups + world / worlds_a_group, world % worlds_a_group};
  }
  /// Samples of a half that show a surface in a world.
  [[nodiscard]] float surfaces(std::size_t half, std::size_t pixel, std::size_t world) const {
    const WorldPlace at = place_of(pixel, world);
    return halves[half][at.pixel].surfaces[at.world];
  }
  /// Light of a half that a world shows.
  [[nodiscard]] Split seen(std::size_t half, std::size_t pixel, std::size_t world) const {
    const WorldPlace at = place_of(pixel, world);
    return halves[half][at.pixel].seen[at.world].with(part_at(mirrored[half], at.pixel).seen[at.world]);
  }
  /// The sky that is kept apart from it.
  [[nodiscard]] const Rgb& seen_sky(std::size_t half, std::size_t pixel, std::size_t world) const {
    const WorldPlace at = place_of(pixel, world);
    return part_at(sky[half], at.pixel).seen[at.world];
  }
  [[nodiscard]] BlockGrid blocks() const { return {grid.width_px, grid.height_px, grid.wraps}; }
  /// Samples of a pixel.
  [[nodiscard]] int samples_at(int x, int y) const {
    return spp[static_cast<std::size_t>(blocks().square_of(x, y))];
  }
};

/// The tiles that an object (from 1) is seen or hidden in.
[[nodiscard]] inline TileSet tiles_of_object(const SceneSums& sums, int object) {
  TileSet tiles;
  for (const auto& there : sums.objects[static_cast<std::size_t>(object - 1)])
    tiles.push_back(there != nullptr ? 1 : 0);
  return tiles;
}

}  // namespace seamline::renderer
