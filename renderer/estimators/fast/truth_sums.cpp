#include "renderer/estimators/fast/truth_sums.h"

#include "raytracer/common/parallel.h"
#include "renderer/estimators/fast/pixel_sky.h"

namespace seamline::renderer {
namespace {

const ObjectPixel no_object;
const ObjectPart no_part;

/// All light of an object's pixel and half.
struct OwnLight {
  const ObjectPixel& pixel;
  const ObjectPart& mirrored;
  const ObjectPart& sky;
  [[nodiscard]] Split object() const { return pixel.object.with(mirrored.object); }
  [[nodiscard]] Split behind() const { return pixel.behind.with(mirrored.behind); }
};

/// The sums of one pixel and half, sorted by what one object covers.
struct PixelOfObject {
  OwnLight own;
  Split without_object, with_object;
  Rgb sky_without_object = Rgb::Zero(), sky_with_object = Rgb::Zero();  ///< what is kept apart from them
  float uncovered_surfaces;

  PixelOfObject(const SceneSums& sums, std::size_t half, std::size_t pixel, const OwnLight& object,
                std::size_t k)
      : own(object) {
    uncovered_surfaces = sums.surfaces(half, pixel, k) - object.pixel.behind_surfaces;
    if (uncovered_surfaces <= 0.0F) return;
    without_object = sums.seen(half, pixel, k);
    with_object = sums.seen(half, pixel, 0);
    sky_without_object = sums.seen_sky(half, pixel, k);
    sky_with_object = sums.seen_sky(half, pixel, 0);
    if (object.pixel.covered > 0.0F) {
      without_object -= object.behind();
      sky_without_object -= object.sky.behind;
      with_object -= object.object();
    }
  }
};

/// Takes one object's truth from the sums of the scene.
class TruthSumsMaker {
 public:
  TruthSumsMaker(const SceneSums& sums, const Camera& camera, const Light& light, int object,
                 const TruthSumsOptions& options)
      : sums_(sums),
        camera_(camera),
        light_(light),
        k_(static_cast<std::size_t>(object)),
        options_(options) {}

  TruthSums make() {
    const std::size_t pixels = sums_.halves[0].size() / sums_.groups;
    truth_.width_px = sums_.grid.width_px;
    truth_.height_px = sums_.grid.height_px;
    truth_.spp = *std::max_element(sums_.spp.begin(), sums_.spp.end());
    truth_.rays = sums_.counts.traced;
    for (auto& half : truth_.halves) half.resize(pixels);
    truth_.guides.resize(pixels);
    surfaces_.resize(pixels);
    texels_.resize(pixels);
    rows([&](int x, int y) { collect_uncovered(x, y, true); });
    filter_bounce(surfaces_, sums_.grid, options_.filter, options_.threads, texels_);
    rows([&](int x, int y) { write_uncovered(x, y); });
    if (options_.sky_apart && options_.filter.levels > 0 && !sums_.sky[0].empty()) {
      start_anew();
      rows([&](int x, int y) { collect_uncovered(x, y, false); });
      filter_bounce(surfaces_, sums_.grid, options_.filter, options_.threads, texels_);
      rows([&](int x, int y) { set_sky_apart(x, y); });
    }
    start_anew();
    rows([&](int x, int y) { collect_object(x, y); });
    filter_bounce(surfaces_, sums_.grid, options_.filter, options_.threads, texels_,
                  tiles_of_object(sums_, static_cast<int>(k_)));
    rows([&](int x, int y) { write_object(x, y); });
    return std::move(truth_);
  }

 private:
  template <class Work>
  void rows(const Work& work) {
    parallel_for(truth_.height_px, options_.threads, [&](int y) {
      for (int x = 0; x < truth_.width_px; ++x) work(x, y);
    });
  }

  void start_anew() {
    std::fill(surfaces_.begin(), surfaces_.end(), Surface{});
    std::fill(texels_.begin(), texels_.end(), BounceTexel{});
  }

  [[nodiscard]] const ObjectTile* object_tile(int x, int y) const {
    return sums_.objects[k_ - 1][static_cast<std::size_t>(sums_.grid.square_of(x, y))].get();
  }
  [[nodiscard]] PixelOfObject parts(int x, int y, std::size_t half) const {
    const ObjectTile* tile = object_tile(x, y);
    const std::size_t i = sums_.index(x, y);
    const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
    const OwnLight own = tile == nullptr
                             ? OwnLight{no_object, no_part, no_part}
                             : OwnLight{tile->halves[half][place], part_at(tile->mirrored[half], place),
                                        part_at(tile->sky[half], place)};
    return {sums_, half, i, own, k_};
  }
  /// Scale from a pixel's own number of samples to the truth's.
  [[nodiscard]] float scale(int x, int y) const {
    return static_cast<float>(truth_.spp) / static_cast<float>(sums_.samples_at(x, y));
  }

  void collect_uncovered(int x, int y, bool with_sky) {
    const std::size_t i = sums_.index(x, y);
    float samples = 0;
    for (std::size_t half = 0; half < 2; ++half) samples += sums_.surfaces(half, i, k_);
    const Surface surface = surface_of(sums_.guides[k_ - 1][i], samples, camera_, x, y);
    surfaces_[i] = surface;
    truth_.guides[i] = {surface.normal, surface.distance_m};
    if (samples <= 0.0F) return;
    for (std::size_t half = 0; half < 2; ++half) {
      const PixelOfObject pixel = parts(x, y, half);
      const WorldPlace at = sums_.place_of(i, k_);
      const WorldPixel& worlds = sums_.halves[half][at.pixel];
      const Rgb sky = with_sky ? sums_.seen_sky(half, i, k_) : Rgb::Zero();
      texels_[i].without_object(half) = (worlds.seen[at.world].bounce + sky) / surface.albedo;
      texels_[i].without_samples(half) = worlds.surfaces[at.world];
      if (pixel.uncovered_surfaces <= 0.0F) continue;
      const Rgb change = pixel.with_object.bounce - pixel.without_object.bounce;
      const Rgb change_of_sky =
          with_sky ? Rgb(pixel.sky_with_object - pixel.sky_without_object) : Rgb(Rgb::Zero());
      texels_[i].change(half) = (change + change_of_sky) / surface.albedo;
      texels_[i].change_samples(half) = pixel.uncovered_surfaces;
    }
  }

  void write_uncovered(int x, int y) {
    const std::size_t i = sums_.index(x, y);
    const float to_sums = scale(x, y);
    const float half_samples = 0.5F * static_cast<float>(sums_.samples_at(x, y));
    for (std::size_t half = 0; half < 2; ++half) {
      PixelOfObject pixel = parts(x, y, half);
      const ObjectPixel& own = pixel.own.pixel;
      TruthPixel& out = truth_.halves[half][i];
      const float behind_sky = own.covered - own.behind_surfaces;
      const float seen_sky = half_samples - own.covered - pixel.uncovered_surfaces;
      const Rgb sky = behind_sky > 0.0F || seen_sky > 0.0F ? pixel_sky(light_, camera_, x, y) : Rgb::Zero();
      const Rgb filtered_without =
          mean(texels_[i].without_object(half), texels_[i].without_samples(half)) * surfaces_[i].albedo;
      if (options_.filter.levels > 0) {
        pixel.without_object.bounce = filtered_without * pixel.uncovered_surfaces;
        pixel.with_object.bounce =
            pixel.without_object.bounce + mean(texels_[i].change(half), texels_[i].change_samples(half)) *
                                              surfaces_[i].albedo * pixel.uncovered_surfaces;
      } else {
        pixel.without_object.direct += pixel.sky_without_object;
        pixel.with_object.direct += pixel.sky_with_object;
      }
      const Rgb behind_bounce = options_.filter.levels > 0 ? Rgb(filtered_without * own.behind_surfaces)
                                                           : Rgb(own.behind.bounce + pixel.own.sky.behind);
      out.without_object = to_sums * pixel.without_object;
      out.with_object = to_sums * pixel.with_object;
      out.sky = to_sums * seen_sky * sky;
      out.behind =
          to_sums * (own.behind.direct + pixel.own.mirrored.behind + behind_bounce + behind_sky * sky);
      out.covered = to_sums * own.covered;
      out.uncovered_surfaces = to_sums * pixel.uncovered_surfaces;
    }
  }

  /// Sorts what was filtered together, by the bounce light that was filtered alone.
  void set_sky_apart(int x, int y) {
    const std::size_t i = sums_.index(x, y);
    for (std::size_t half = 0; half < 2; ++half) {
      TruthPixel& out = truth_.halves[half][i];
      const Rgb to_out = surfaces_[i].albedo * out.uncovered_surfaces;
      const Rgb without = mean(texels_[i].without_object(half), texels_[i].without_samples(half)) * to_out;
      const Rgb with = without + mean(texels_[i].change(half), texels_[i].change_samples(half)) * to_out;
      move_to_direct(out.without_object.bounce - without, out.without_object);
      move_to_direct(out.with_object.bounce - with, out.with_object);
    }
  }
  static void move_to_direct(const Rgb& sky, Split& light) {
    light.direct += sky;
    light.bounce -= sky;
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
      const ObjectPixel& own = tile->halves[half][place];
      texels_[i].without_object(half) = own.object.bounce / surfaces_[i].albedo;
      texels_[i].without_samples(half) = own.covered;
    }
  }

  void write_object(int x, int y) {
    const ObjectTile* tile = object_tile(x, y);
    if (tile == nullptr) return;
    const std::size_t i = sums_.index(x, y);
    for (std::size_t half = 0; half < 2; ++half) {
      const auto place = static_cast<std::size_t>(TileGrid::place(x, y));
      const ObjectPixel& own = tile->halves[half][place];
      if (own.covered <= 0.0F) continue;
      Split object = own.object.with(part_at(tile->mirrored[half], place).object);
      if (options_.filter.levels > 0)
        object.bounce = mean(texels_[i].without_object(half), texels_[i].without_samples(half)) *
                        surfaces_[i].albedo * own.covered;
      truth_.halves[half][i].object = scale(x, y) * object;
    }
  }

  static Rgb mean(const Rgb& sum, float samples) { return samples > 0.0F ? Rgb(sum / samples) : Rgb::Zero(); }

  const SceneSums& sums_;
  const Camera& camera_;
  const Light& light_;
  const std::size_t k_;
  const TruthSumsOptions& options_;
  TruthSums truth_;
  std::vector<Surface> surfaces_;
  std::vector<BounceTexel> texels_;
};

}  // namespace

TruthSums truth_sums(const SceneSums& sums, const Camera& camera, const Light& light, int object,
                     const TruthSumsOptions& options) {
  return TruthSumsMaker(sums, camera, light, object, options).make();
}

}  // namespace seamline::renderer
