#include "composites/photo_composite.h"

#include "raytracer/common/parallel.h"
#include "raytracer/error/sampling_rounds.h"
#include "raytracer/scene/seen_surface.h"
#include "renderer/estimators/seen_emission.h"
#include "support/running/interrupt.h"

namespace seamline::renderer {
namespace {

constexpr int first_spp = 16, most_spp = 1 << 14;  // where the error decides

/// Where a sample of a pixel is in the picture, and its ray.
struct Sight {
  int x, y;  ///< the pixel
  MaskPlace place;
  Ray ray;
};

Sight sight_of(const Camera& camera, int x, int y, const Eigen::Array2f& within) {
  const Eigen::Array2f at(static_cast<float>(x) + within[0], static_cast<float>(y) + within[1]);
  const Eigen::Vector3f direction = camera.direction(at[0], at[1]);
  const Eigen::Array2f size(static_cast<float>(camera.width_px), static_cast<float>(camera.height_px));
  return {x, y, {direction, at / size}, {Eigen::Vector3f::Zero(), direction}};
}

/// The parts of a scene that samples ask for, made once.
class PhotoSampler {
 public:
  explicit PhotoSampler(const PhotoScene& scene)
      : scene_(scene),
        nothing_(std::span<const std::shared_ptr<const SurfaceMesh>>{}),
        light_past_nothing_(scene.light) {
    suns_.suns = scene.light.suns;
    suns_.bounces = 0;
    suns_.skips_sky = true;
    light_past_nothing_.photographed = nullptr;
    light_past_nothing_.hidden_sky = nullptr;
  }

  /// `added`: null without added light.
  void add(const Sight& sight, const Sampler& sampler, const Rgb& photograph, StimulusPixel& out,
           AddedPixel* added) const {
    if (sight.ray.direction.isZero()) {
      out.sky += photograph;
      return;
    }
    const std::optional<SurfacePoint> real = scene_.depth.nearest(sight.ray);
    if (auto hit = seen_object(sight, real)) {
      if (scene_.seen != nullptr) scene_.seen->even_out(sight.x, sight.y, hit->object_index, *hit);
      const bool shaded = !scene_.occlusion.nothing_hides;
      const RealQuestion question =
          shaded ? asked_of_mesh(&scene_.depth, real, *hit) : RealQuestion{&scene_.objects, &*hit};
      out.object += leaving_object(ObjectQuestions::all_of(question), scene_.objects, *hit,
                                   shaded ? scene_.light : light_past_nothing_, sampler)
                        .total();
      if (scene_.added != nullptr)
        out.object +=
            leaving_object(ObjectQuestions::all_of(question), scene_.objects, *hit, *scene_.added, sampler)
                .total();
    } else if (real && scene_.shadows) {
      const auto [without_object, with_object] = uncovered(sight, *real, sampler);
      out.without_object += without_object;
      out.with_object += with_object;
      out.background += photograph;
      ++out.uncovered_surfaces;
      if (added != nullptr) brighten(*real, sampler, *added);
    } else {
      out.sky += photograph;
    }
  }

 private:
  /// An object where it is seen: nearer than the mesh, or not hidden by what else decides.
  [[nodiscard]] std::optional<SurfacePoint> seen_object(const Sight& sight,
                                                        const std::optional<SurfacePoint>& real) const {
    const auto& [test, nothing_hides] = scene_.occlusion;
    Ray ray = sight.ray;
    if (test == nullptr && !nothing_hides && real) ray.far_m = real->distance_m;
    const auto hit = scene_.objects.nearest(ray);
    if (hit && test != nullptr && hides(*test, sight.place, hit->distance_m)) return std::nullopt;
    return hit;
  }

  void brighten(const SurfacePoint& real, const Sampler& sampler, AddedPixel& added) const {
    const Rgb sent = radiance_with_and_without(scene_.depth, &scene_.objects, real, *scene_.added, sampler)
                         .with_object.total();
    added.sent += sent;
    added.by_white += (real.albedo > 0.0F).select(sent / real.albedo, 0.0F);
  }

  /// Light of a real surface without and with the objects. With a matte the suns' own light there is what the
  /// matte lets through, and not what the local scene does.
  [[nodiscard]] std::pair<Rgb, Rgb> uncovered(const Sight& sight, const SurfacePoint& real,
                                              const Sampler& sampler) const {
    const RadiancePair pair =
        radiance_with_and_without(scene_.depth, &scene_.objects, real, scene_.light, sampler);
    Rgb without_object = pair.without_object.total(), with_object = pair.with_object.total();
    if (scene_.shadow_matte == nullptr || suns_.suns.empty()) return {without_object, with_object};
    const float lit = 1.0F - mask_at(*scene_.shadow_matte, sight.place);
    const RadiancePair past_scene =
        radiance_with_and_without(scene_.depth, &scene_.objects, real, suns_, sampler);
    const RadiancePair past_objects =
        radiance_with_and_without(nothing_, &scene_.objects, real, suns_, sampler);
    without_object += lit * past_objects.without_object.total() - past_scene.without_object.total();
    with_object += lit * past_objects.with_object.total() - past_scene.with_object.total();
    return {without_object.max(0.0F), with_object.max(0.0F)};
  }

  const PhotoScene& scene_;
  Geometry nothing_;
  Light suns_;                ///< alone, at the first surface
  Light light_past_nothing_;  ///< where there are no real surfaces
};

}  // namespace

PhotoSums empty_photo_sums(const PhotoScene& scene, int threads) {
  const Camera& camera = scene.camera;
  PhotoSums sums;
  sums.width_px = camera.width_px;
  sums.height_px = camera.height_px;
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  for (auto& half : sums.halves) half.resize(pixels);
  if (scene.added != nullptr && scene.shadows)
    for (auto& half : sums.added) half.resize(pixels);
  sums.guides.resize(pixels);
  sums.depth_lights_uncovered = true;
  parallel_for(camera.height_px, threads, [&](int y) {
    for (int x = 0; x < camera.width_px; ++x) {
      if (const auto seen = seen_surface(camera, scene.depth, x, y))
        sums.guides[static_cast<std::size_t>(y) * static_cast<std::size_t>(camera.width_px) +
                    static_cast<std::size_t>(x)] = {seen->geometric_normal, seen->distance_m};
    }
  });
  return sums;
}

void add_photo_samples(const PhotoScene& scene, int first, const PassOptions& options, PhotoSums& sums) {
  const Camera& camera = scene.camera;
  const PhotoSampler photo(scene);
  const bool has_added = !sums.added[0].empty();
  parallel_for(
      camera.height_px, options.threads,
      [&](int y) {
        for (int x = 0; x < camera.width_px; ++x) {
          stop_if_interrupted();  // a row of many samples takes long
          const std::size_t pixel =
              scene.photograph.index(x, y) / static_cast<std::size_t>(scene.photograph.channels);
          for (int i = first; i < options.spp; ++i) {
            const Sampler sampler(options.seed, x, y, i);
            const auto half = static_cast<std::size_t>(i % 2);
            photo.add(sight_of(camera, x, y, sampler.point(dimension::pixel)), sampler,
                      scene.photograph.rgb(x, y), sums.halves[half][pixel],
                      has_added ? &sums.added[half][pixel] : nullptr);
          }
        }
      },
      [&](int rows) {
        if (options.progress) options.progress(static_cast<double>(rows) / camera.height_px);
      });
  sums.spp = options.spp;
}

namespace {

/// What added light brings in a pixel, of sums of samples.
Rgb brightened(const StimulusPixel& pixel, const AddedPixel& added, Compositing compositing) {
  if (compositing == Compositing::additive) return added.sent;
  const Rgb by_ratio = pixel.background * added.sent / pixel.without_object.max(1e-30F);
  return (pixel.without_object > 0.0F).select(by_ratio.min(added.by_white), added.sent);
}

/// Adds what added light brings to a picture of the halves `first` to `last`.
void brighten_picture(const PhotoSums& sums, std::size_t first, std::size_t last, Compositing compositing,
                      Image& picture) {
  if (sums.added[0].empty()) return;
  int samples = 0;
  for (std::size_t half = first; half <= last; ++half) samples += (sums.spp + 1 - static_cast<int>(half)) / 2;
  for (int y = 0; y < picture.height_px; ++y)
    for (int x = 0; x < picture.width_px; ++x) {
      const std::size_t i = picture.index(x, y) / 3;
      StimulusPixel pixel;
      AddedPixel added;
      for (std::size_t half = first; half <= last; ++half) {
        pixel += sums.halves[half][i];
        added.sent += sums.added[half][i].sent;
        added.by_white += sums.added[half][i].by_white;
      }
      if (!(added.sent > 0.0F).any()) continue;
      picture.set_rgb(
          x, y, picture.rgb(x, y) + brightened(pixel, added, compositing) / static_cast<float>(samples));
    }
}

Image compose_photo_half(const PhotoSums& sums, std::size_t half, int threads) {
  Image picture = compose_half(sums, half, threads).picture;
  brighten_picture(sums, half, half, sums.compositing, picture);
  return picture;
}

}  // namespace

Composite compose_photo(const PhotoSums& sums, Compositing compositing, int threads) {
  Composite made = compose(sums, compositing, threads);
  brighten_picture(sums, 0, 1, compositing, made.picture);
  return made;
}

PhotoEstimate photo_by_path(const PhotoScene& scene, const std::optional<double>& error, double exposure_ev,
                            const PassOptions& options) {
  PhotoEstimate out{empty_photo_sums(scene, options.threads), {}, {}};
  out.sums.compositing = scene.compositing;
  PassOptions pass = options;
  if (error) pass.spp = first_spp;
  for (;; pass.spp *= 2) {
    add_photo_samples(scene, out.sums.spp, pass, out.sums);
    out.taken = {out.sums.spp, out.sums.spp, double{1} * out.sums.spp};
    if (out.sums.spp < 2) return out;
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half)
      pictures.filtered[half] = pictures.sampled[half] = compose_photo_half(out.sums, half, options.threads);
    pictures.whole = compose_photo(out.sums, out.sums.compositing, options.threads).picture;
    out.error = estimate_error(pictures, exposure_ev, options.threads);
    if (!error || ErrorTarget{*error}.met_by(out.error) || pass.spp >= most_spp) return out;
  }
}

}  // namespace seamline::renderer
