#include "renderer/estimators/fast/scene_layers.h"

#include "renderer/common/parallel.h"

namespace seamline::renderer {
namespace {

const ObjectSums no_object;

/// The sums of one pixel and half, sorted by what one object covers.
struct PixelParts {
  const ObjectSums& own;
  Split no, with;
  float rest;

  PixelParts(const WorldSums& world, const ObjectSums& object, std::size_t k) : own(object) {
    rest = world.surfaces[k] - object.behind_surfaces;
    if (rest <= 0.0F) return;
    no = world.seen[k];
    with = world.seen[0];
    if (object.covered > 0.0F) {
      no -= object.behind;
      with -= object.object;
    }
  }
};

/// Turns one object's share of the sums into layers.
class LayerMaker {
 public:
  LayerMaker(const SceneSums& sums, const Camera& camera, const Rgb& sky, int object,
             const LayerOptions& options)
      : sums_(sums), camera_(camera), sky_(sky), k_(static_cast<std::size_t>(object)), options_(options) {}

  TruthLayers make() {
    const std::size_t pixels = sums_.halves[0].size();
    layers_.width_px = sums_.grid.width_px;
    layers_.height_px = sums_.grid.height_px;
    layers_.spp = *std::max_element(sums_.spp.begin(), sums_.spp.end());
    layers_.rays = sums_.counts.traced;
    for (auto& half : layers_.halves) half.resize(pixels);
    layers_.guides.resize(pixels);
    surfaces_.resize(pixels);
    texels_.resize(pixels);
    rows([&](int x, int y) { collect_rest(x, y); });
    filter_bounce(surfaces_, sums_.grid, options_.filter, options_.threads, texels_);
    rows([&](int x, int y) { write_rest(x, y); });
    std::fill(surfaces_.begin(), surfaces_.end(), Surface{});
    std::fill(texels_.begin(), texels_.end(), BounceTexel{});
    rows([&](int x, int y) { collect_object(x, y); });
    filter_bounce(surfaces_, sums_.grid, options_.filter, options_.threads, texels_,
                  tiles_of_object(sums_, static_cast<int>(k_)));
    rows([&](int x, int y) { write_object(x, y); });
    return std::move(layers_);
  }

 private:
  template <class Work>
  void rows(const Work& work) {
    parallel_for(layers_.height_px, options_.threads, [&](int y) {
      for (int x = 0; x < layers_.width_px; ++x) work(x, y);
    });
  }

  [[nodiscard]] const ObjectTile* object_tile(int x, int y) const {
    return sums_.objects[k_ - 1][static_cast<std::size_t>(sums_.grid.square_of(x, y))].get();
  }
  [[nodiscard]] PixelParts parts(int x, int y, std::size_t half) const {
    const ObjectTile* tile = object_tile(x, y);
    return {sums_.halves[half][sums_.index(x, y)],
            tile == nullptr ? no_object : tile->halves[half][static_cast<std::size_t>(TileGrid::place(x, y))],
            k_};
  }
  /// Scale from a pixel's own number of samples to the layers'.
  [[nodiscard]] float scale(int x, int y) const {
    return static_cast<float>(layers_.spp) / static_cast<float>(sums_.samples_at(x, y));
  }

  void collect_rest(int x, int y) {
    const std::size_t i = sums_.index(x, y);
    float samples = 0;
    for (const auto& half : sums_.halves) samples += half[i].surfaces[k_];
    const Surface surface = surface_of(sums_.guides[k_ - 1][i], samples, camera_, x, y);
    surfaces_[i] = surface;
    layers_.guides[i] = {surface.normal, surface.distance_m};
    if (samples <= 0.0F) return;
    for (std::size_t half = 0; half < 2; ++half) {
      const PixelParts pixel = parts(x, y, half);
      const WorldSums& world = sums_.halves[half][i];
      texels_[i].no(half) = world.seen[k_].bounce / surface.albedo;
      texels_[i].no_samples(half) = world.surfaces[k_];
      if (pixel.rest <= 0.0F) continue;
      texels_[i].change(half) = (pixel.with.bounce - pixel.no.bounce) / surface.albedo;
      texels_[i].change_samples(half) = pixel.rest;
    }
  }

  void write_rest(int x, int y) {
    const std::size_t i = sums_.index(x, y);
    const float to_layers = scale(x, y);
    const float half_samples = 0.5F * static_cast<float>(sums_.samples_at(x, y));
    for (std::size_t half = 0; half < 2; ++half) {
      PixelParts pixel = parts(x, y, half);
      const ObjectSums& own = pixel.own;
      TruthSums& out = layers_.halves[half][i];
      const float behind_sky = own.covered - own.behind_surfaces;
      const Rgb filtered_no = mean(texels_[i].no(half), texels_[i].no_samples(half)) * surfaces_[i].albedo;
      if (options_.filter.levels > 0) {
        pixel.no.bounce = filtered_no * pixel.rest;
        pixel.with.bounce = pixel.no.bounce + mean(texels_[i].change(half), texels_[i].change_samples(half)) *
                                                  surfaces_[i].albedo * pixel.rest;
      }
      const Rgb behind_bounce =
          options_.filter.levels > 0 ? Rgb(filtered_no * own.behind_surfaces) : own.behind.bounce;
      out.no = to_layers * pixel.no;
      out.with = to_layers * pixel.with;
      out.sky = to_layers * (half_samples - own.covered - pixel.rest) * sky_;
      out.behind = to_layers * (own.behind.direct + behind_bounce + behind_sky * sky_);
      out.covered = to_layers * own.covered;
      out.rest = to_layers * pixel.rest;
    }
  }

  void collect_object(int x, int y) {
    const ObjectTile* tile = object_tile(x, y);
    if (tile == nullptr) return;
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const std::size_t i = sums_.index(x, y);
    const float covered = tile->halves[0][place].covered + tile->halves[1][place].covered;
    surfaces_[i] = surface_of(tile->guides[place], covered, camera_, x, y);
    if (covered <= 0.0F) return;
    for (std::size_t half = 0; half < 2; ++half) {
      const ObjectSums& own = tile->halves[half][place];
      texels_[i].no(half) = own.object.bounce / surfaces_[i].albedo;
      texels_[i].no_samples(half) = own.covered;
    }
  }

  void write_object(int x, int y) {
    const ObjectTile* tile = object_tile(x, y);
    if (tile == nullptr) return;
    const std::size_t i = sums_.index(x, y);
    for (std::size_t half = 0; half < 2; ++half) {
      const ObjectSums& own = tile->halves[half][static_cast<std::size_t>(TileGrid::place(x, y))];
      if (own.covered <= 0.0F) continue;
      Split object = own.object;
      if (options_.filter.levels > 0)
        object.bounce =
            mean(texels_[i].no(half), texels_[i].no_samples(half)) * surfaces_[i].albedo * own.covered;
      layers_.halves[half][i].object = scale(x, y) * object;
    }
  }

  static Rgb mean(const Rgb& sum, float samples) { return samples > 0.0F ? Rgb(sum / samples) : Rgb::Zero(); }

  const SceneSums& sums_;
  const Camera& camera_;
  const Rgb& sky_;
  const std::size_t k_;
  const LayerOptions& options_;
  TruthLayers layers_;
  std::vector<Surface> surfaces_;
  std::vector<BounceTexel> texels_;
};

}  // namespace

TruthLayers truth_layers(const SceneSums& sums, const Camera& camera, const Rgb& environment_radiance,
                         int object, const LayerOptions& options) {
  return LayerMaker(sums, camera, environment_radiance, object, options).make();
}

}  // namespace seamline::renderer
