#include "renderer/depth/sensor/sensor_view.h"

#include <array>

#include "raytracer/common/parallel.h"

namespace seamline::renderer {
namespace {

using sensors::SeenFrame;
using sensors::SubRay;

/// Rays from one place through positions of a picture, traced some at a time; `found(place, hit)` for each in
/// order, null where it meets nothing or the lens lets no direction through.
class PictureRays {
 public:
  PictureRays(const Geometry& truth, const sensors::PinholeCamera& camera, const Eigen::Isometry3d& pose)
      : truth_(truth), camera_(camera), pose_(pose), origin_m_(pose.translation().cast<float>()) {}

  template <class Found>
  void ask(const Eigen::Vector2d& position_px, const Found& found) {
    has_direction_[count_] = false;
    if (const auto direction = sensors::direction_through(camera_, position_px)) {
      has_direction_[count_] = true;
      rays_[traced_++] = {origin_m_, (pose_.linear() * *direction).normalized().cast<float>()};
    }
    if (++count_ == rays_a_call) answer(found);
  }

  template <class Found>
  void answer(const Found& found) {
    truth_.nearest(std::span(rays_.data(), traced_), std::span(hits_.data(), traced_));
    std::size_t next = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      const std::optional<SurfacePoint> nothing;
      const std::optional<SurfacePoint>& hit = has_direction_[i] ? hits_[next] : nothing;
      found(hit, has_direction_[i] ? rays_[next].direction : Eigen::Vector3f(Eigen::Vector3f::Zero()));
      if (has_direction_[i]) ++next;
    }
    count_ = traced_ = 0;
  }

 private:
  const Geometry& truth_;
  const sensors::PinholeCamera& camera_;
  const Eigen::Isometry3d& pose_;
  Eigen::Vector3f origin_m_;
  std::array<Ray, rays_a_call> rays_;
  std::array<std::optional<SurfacePoint>, rays_a_call> hits_;
  std::array<bool, rays_a_call> has_direction_;
  std::size_t count_ = 0, traced_ = 0;
};

SubRay sub_ray_of(const std::optional<SurfacePoint>& hit, const Eigen::Vector3f& direction) {
  if (!hit) return {};
  return {.radial_m = static_cast<double>(hit->distance_m),
          .albedo = static_cast<double>(hit->albedo.mean()),
          .cosine = static_cast<double>(std::abs(hit->geometric_normal.dot(direction)))};
}

bool is_lit(const Geometry& truth, const SurfacePoint& point, const Eigen::Vector3f& projector_m) {
  const Eigen::Vector3f way_m = projector_m - point.position_m;
  const float distance_m = way_m.norm();
  if (!(distance_m > 0.0F)) return true;
  const Eigen::Vector3f direction = way_m / distance_m;
  if (!above_horizon(point, direction)) return false;
  return !truth.occluded(leaving_ray(point, direction, distance_m * (1 - 1e-4F)));
}

/// A footprint mixes the distances of so many times as many rays.
constexpr int mixed_rays_across = 3;

}  // namespace

SensorSight sight_for(const sensors::NoiseModel& model, const std::optional<Eigen::Vector3d>& projector_m) {
  const auto* flight = std::get_if<sensors::TimeOfFlightNoise>(&model);
  return {.surfaces = true,
          .sub_rays_across = flight != nullptr && flight->mixes ? mixed_rays_across : 0,
          .projector_m = projector_m};
}

SeenFrame see_truth(const Geometry& truth, const sensors::PinholeCamera& camera,
                    const Eigen::Isometry3d& world_from_sensor, const SensorSight& sight, int threads) {
  SeenFrame seen;
  seen.camera = camera;
  const auto width = static_cast<std::size_t>(camera.width_px);
  const std::size_t pixels = width * static_cast<std::size_t>(camera.height_px);
  seen.radial_m.resize(pixels, sensors::hole);
  if (sight.surfaces) {
    seen.albedo.resize(pixels);
    seen.cosine.resize(pixels);
  }
  const int across = sight.sub_rays_across;
  seen.sub_rays_per_pixel = across * across;
  seen.sub_rays.resize(pixels * static_cast<std::size_t>(across * across));
  std::optional<Eigen::Vector3f> projector_m;
  if (sight.projector_m) {
    seen.lit_by_projector.resize(pixels, 1);
    projector_m = (world_from_sensor * *sight.projector_m).cast<float>();
  }
  parallel_for(camera.height_px, threads, [&](int row) {
    PictureRays rays(truth, camera, world_from_sensor);
    std::size_t at = static_cast<std::size_t>(row) * width;
    const auto centre = [&](const std::optional<SurfacePoint>& hit, const Eigen::Vector3f& direction) {
      const SubRay ray = sub_ray_of(hit, direction);
      seen.radial_m[at] = static_cast<float>(ray.radial_m);
      if (sight.surfaces) {
        seen.albedo[at] = static_cast<float>(ray.albedo);
        seen.cosine[at] = static_cast<float>(ray.cosine);
      }
      if (projector_m && hit) seen.lit_by_projector[at] = is_lit(truth, *hit, *projector_m) ? 1 : 0;
      ++at;
    };
    for (int column = 0; column < camera.width_px; ++column) rays.ask({column + 0.5, row + 0.5}, centre);
    rays.answer(centre);
    std::size_t sub = static_cast<std::size_t>(row) * width * static_cast<std::size_t>(across * across);
    const auto part = [&](const std::optional<SurfacePoint>& hit, const Eigen::Vector3f& direction) {
      seen.sub_rays[sub++] = sub_ray_of(hit, direction);
    };
    for (int column = 0; column < camera.width_px; ++column)
      for (int y = 0; y < across; ++y)
        for (int x = 0; x < across; ++x)
          rays.ask({column + (x + 0.5) / across, row + (y + 0.5) / across}, part);
    rays.answer(part);
  });
  return seen;
}

Image headlight_picture(const SeenFrame& seen) {
  Image picture(seen.camera.width_px, seen.camera.height_px, 1);
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] =
        sensors::DepthFrame::is_hole(seen.radial_m[i]) ? 0.0F : seen.albedo[i] * seen.cosine[i];
  return picture;
}

}  // namespace seamline::renderer
