#include "composites/place_preview.h"

#include <algorithm>

#include "composites/change_probe.h"
#include "composites/objects/placing.h"

namespace seamline::renderer {
namespace {

constexpr int coarsening = 8, most_preview_spp = 256;

}  // namespace

Image photograph_sized(const Image& image, int width_px, int height_px) {
  Image small(width_px, height_px, 3);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const int left = x * image.width_px / width_px,
                right = std::max(left + 1, (x + 1) * image.width_px / width_px);
      const int top = y * image.height_px / height_px,
                bottom = std::max(top + 1, (y + 1) * image.height_px / height_px);
      Rgb sum = Rgb::Zero();
      for (int row = top; row < bottom; ++row)
        for (int column = left; column < right; ++column) sum += image.rgb(column, row);
      small.set_rgb(x, y, sum / static_cast<float>((right - left) * (bottom - top)));
    }
  return small;
}

PlacePreview::PlacePreview(const PhotoWorld& world, int width_px, int threads)
    : world_(world), threads_(threads) {
  for (int divisor = coarsening; divisor >= 1; divisor /= 2) {
    Level level{preview_sized(world.seen.camera, std::max(1, width_px / divisor)), {}};
    level.photograph =
        photograph_sized(world.seen.photograph.radiance, level.camera.width_px, level.camera.height_px);
    levels_.push_back(std::move(level));
  }
  picture_ = levels_.back().photograph;
}

std::vector<std::string> PlacePreview::stand(std::vector<PlacedModel>& models) {
  const PhotoObjects placed = place_objects(models, world_.seen.centre_m, nullptr, known_);
  std::vector<double> half_widths_m;
  for (const PhotoObjects::Size& size : placed.sizes) half_widths_m.push_back(renderer::half_width_m(size));
  auto put =
      stand_in_view(models, half_widths_m, world_.seen.camera, *world_.local.geometry, world_.seen.centre_m);
  for (PlacedModel& model : models) model.has_place = true;
  return put;
}

std::optional<FloorInView> PlacePreview::floor() const {
  return floor_in_view(levels_.back().camera, *world_.local.geometry, world_.seen.centre_m);
}

std::vector<std::uint8_t> PlacePreview::grid_on(const FloorInView& floor, double spacing_m) const {
  return floor_grid(levels_.back().camera, *world_.local.geometry, objects_.get(), floor,
                    world_.seen.centre_m, spacing_m, threads_);
}

void PlacePreview::set_objects(const std::vector<PlacedModel>& models) {
  placed_ = place_objects(models, world_.seen.centre_m, &world_.local.mesh, known_);
  objects_ = std::make_unique<Geometry>(placed_.meshes);
  level_ = 0;
  sums_.reset();
}

bool PlacePreview::refine() {
  if (!objects_) return false;
  const bool finest = level_ + 1 == levels_.size();
  if (finest && sums_ && sums_->spp >= most_preview_spp) return false;
  const Level& level = levels_[level_];
  const PhotoScene scene{.photograph = level.photograph,
                         .camera = level.camera,
                         .depth = *world_.local.geometry,
                         .objects = *objects_,
                         .light = world_.local.light,
                         .added = world_.known.added ? &*world_.known.added : nullptr};
  PhotoSums sums = sums_ ? std::move(*sums_) : empty_photo_sums(scene, threads_);
  const int so_far = sums.spp;
  add_photo_samples(scene, so_far, {.spp = so_far + 1, .seed = 1, .threads = threads_, .progress = {}}, sums);
  picture_ = compose_photo(sums, Compositing::ratio, threads_).picture;
  if (finest)
    sums_ = std::move(sums);
  else
    ++level_;
  return true;
}

PlacePreview::Sight PlacePreview::look(double x_share, double y_share) const {
  const Camera& camera = levels_.back().camera;
  const Ray ray{Eigen::Vector3f::Zero(), camera.direction(static_cast<float>(x_share * camera.width_px),
                                                          static_cast<float>(y_share * camera.height_px))};
  Sight sight;
  if (ray.direction.isZero()) return sight;
  const auto world_place = [&](float distance_m) -> Eigen::Vector3d {
    return (ray.direction * distance_m).cast<double>() + world_.seen.centre_m;
  };
  const auto real = world_.local.geometry->nearest(ray);
  if (real) {
    sight.real_m = world_place(real->distance_m);
    sight.normal = real->geometric_normal.cast<double>();
  }
  const auto hit = objects_ ? objects_->nearest(ray) : std::nullopt;
  if (!hit || (real && real->distance_m < hit->distance_m)) return sight;
  // The smallest box that holds the place.
  double smallest = 0;
  for (std::size_t i = 0; i < placed_.sizes.size(); ++i) {
    const Eigen::AlignedBox3d box(placed_.sizes[i].low_m, placed_.sizes[i].high_m);
    if (box.exteriorDistance(world_place(hit->distance_m)) > 1e-3 * box.diagonal().norm() + 1e-4) continue;
    if (sight.object && box.volume() >= smallest) continue;
    sight.object = i;
    smallest = box.volume();
  }
  return sight;
}

double PlacePreview::half_width_m(std::size_t object) const {
  return renderer::half_width_m(placed_.sizes[object]);
}

}  // namespace seamline::renderer
