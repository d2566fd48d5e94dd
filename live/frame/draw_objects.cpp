#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "live/frame/codes.h"
#include "live/frame/live_eye.h"
#include "live/frame/moving_objects.h"
#include "live/frame/pixel_rays.h"
#include "raytracer/common/parallel.h"
#include "sensors/frame/depth_test.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::live {
namespace {

using renderer::Ray;
using renderer::SurfacePoint;

/// Pixels from `first` to before `last`.
struct PixelBox {
  Eigen::Array2i first, last;
};

/// The pixels in which some boxes lie, as an eye sees them; all where one reaches behind the eye.
PixelBox box_of(const LiveScene& scene, const LiveEye& eye) {
  const Eigen::Array2i size(eye.codes.width_px, eye.codes.height_px);
  Eigen::Array2f least = Eigen::Array2f::Constant(std::numeric_limits<float>::infinity()), most = -least;
  for (const auto& mesh : scene.objects.meshes) {
    if (mesh->positions_m.empty()) continue;
    Eigen::Vector3f low_m = mesh->positions_m.front(), high_m = low_m;
    for (const Eigen::Vector3f& place_m : mesh->positions_m) {
      low_m = low_m.cwiseMin(place_m);
      high_m = high_m.cwiseMax(place_m);
    }
    for (int corner = 0; corner < 8; ++corner) {
      const Eigen::Vector3f place_m((corner & 1) != 0 ? high_m.x() : low_m.x(),
                                    (corner & 2) != 0 ? high_m.y() : low_m.y(),
                                    (corner & 4) != 0 ? high_m.z() : low_m.z());
      const renderer::ViewedPoint seen = renderer::view_point(eye.view, eye.real, place_m);
      if (!(seen.depth_m > 1e-3F)) return {{0, 0}, size};
      const Eigen::Array2f place_px(seen.x_px, seen.y_px);
      least = least.min(place_px);
      most = most.max(place_px);
    }
  }
  PixelBox box{{0, 0}, {0, 0}};
  for (int axis = 0; axis < 2; ++axis) {
    const auto side = static_cast<float>(size[axis]);
    box.first[axis] = static_cast<int>(std::clamp(std::floor(least[axis] - 1.0F), 0.0F, side));
    box.last[axis] = static_cast<int>(std::clamp(std::ceil(most[axis] + 1.0F), 0.0F, side));
  }
  return box;
}

class ObjectDrawing {
 public:
  ObjectDrawing(const ObjectPass& pass, LiveEye& eye)
      : pass_(pass), eye_(eye), rays_(eye.view, eye.codes.width_px, eye.codes.height_px) {}

  void draw_row(int y, int first, int last) {
    std::array<Ray, renderer::rays_a_call> rays;
    std::array<std::optional<SurfacePoint>, renderer::rays_a_call> hits;
    for (int x = first; x < last; x += static_cast<int>(renderer::rays_a_call)) {
      const int count = std::min(static_cast<int>(renderer::rays_a_call), last - x);
      for (int i = 0; i < count; ++i) rays[i] = {rays_.eye_m(), rays_.direction(x + i, y).normalized()};
      const std::size_t used = count;
      nearest_objects(pass_.scene, std::span(rays).first(used), std::span(hits).first(used));
      if (pass_.occlusion == Occlusion::mesh)
        hide_behind_mesh(std::span(rays).first(used), std::span(hits).first(used));
      for (int i = 0; i < count; ++i)
        if (const auto& hit = hits[i]) draw_pixel(x + i, y, *hit);
    }
  }

 private:
  void hide_behind_mesh(std::span<const Ray> rays, std::span<std::optional<SurfacePoint>> hits) const {
    if (std::none_of(hits.begin(), hits.end(), [](const auto& hit) { return hit.has_value(); })) return;
    // A ray through a pixel that was measured meets the mesh in a corner, and one in 25 of such slips through
    // (in Embree's robust mode one in 100). So rays go a hundredth of a pixel beside, off its edges too.
    const Eigen::Vector3f beside = rays_.right_per_px() * 0.013F + rays_.down_per_px() * 0.006F;
    std::array<Ray, renderer::rays_a_call> beside_corners;
    std::array<float, renderer::rays_a_call> real_m;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      beside_corners[i] = rays[i];
      beside_corners[i].direction = (rays[i].direction + beside).normalized();
    }
    pass_.local_scene->distances(std::span(beside_corners).first(rays.size()),
                                 std::span(real_m).first(rays.size()));
    for (std::size_t i = 0; i < rays.size(); ++i)
      if (hits[i] && real_m[i] < hits[i]->distance_m) hits[i].reset();
  }

  [[nodiscard]] bool is_hidden(int x, int y, float planar_m) const {
    switch (pass_.occlusion) {
      case Occlusion::nobody:
      case Occlusion::mesh:
      case Occlusion::depth_buffer:
      case Occlusion::mask:
      case Occlusion::edges:
        return false;
      case Occlusion::depth_test:
        return sensors::hides(static_cast<double>(eye_.real.at(x, y)), static_cast<double>(planar_m),
                              nullptr);
      case Occlusion::ghosts:
        return sensors::hides(static_cast<double>(eye_.ghosts.at(x, y)), static_cast<double>(planar_m),
                              nullptr);
    }
    return false;
  }

  void draw_pixel(int x, int y, const SurfacePoint& hit) {
    if (is_hidden(x, y, rays_.planar_m(hit.position_m))) return;
    const Rgb seen = radiance(hit, turn_of_pixel(x, y)) * pass_.scene.display_factor;
    const std::size_t pixel = grid_index(y, x, eye_.codes.width_px);
    eye_.covered[pixel] = 1;
    for (std::size_t c = 0; c < 3; ++c)
      eye_.codes.values[3 * pixel + c] = codes_.code(seen[static_cast<Eigen::Index>(c)]);
  }

  /// albedo (sky + sum over lights of E cos V / pi) + emission.
  [[nodiscard]] Rgb radiance(const SurfacePoint& hit, float turn) const {
    Rgb light = pass_.scene.ambient_radiance;
    const LitPoint point{hit.position_m, hit.geometric_normal, hit.distance_m, turn};
    for (std::size_t i = 0; i < pass_.scene.light_count(); ++i) {
      const SeenLight seen = seen_light(pass_.scene.light, i, hit.position_m);
      const float cosine = renderer::sun_cosine(hit, seen.to_light);
      if (!(cosine > 0.0F)) continue;
      float arrives = pass_.shadows.arriving(Caster::object, i, seen, point);
      if (arrives > 0.0F) arrives *= pass_.shadows.arriving(Caster::real, i, seen, point);
      light += seen.irradiance_w_m2 * (arrives * cosine * renderer::inverse_pi);
    }
    return hit.albedo * light + hit.emission;
  }

  const ObjectPass& pass_;
  LiveEye& eye_;
  PixelRays rays_;
  const CodeTables& codes_ = code_tables();
};

}  // namespace

void draw_objects(const ObjectPass& pass, LiveEye& eye) {
  eye.covered.assign(eye.real.depth_m.size(), 0);
  const PixelBox box = box_of(pass.scene, eye);
  if ((box.first >= box.last).any()) return;
  ObjectDrawing drawing(pass, eye);
  renderer::parallel_for(box.last[1] - box.first[1], pass.threads,
                         [&](int row) { drawing.draw_row(box.first[1] + row, box.first[0], box.last[0]); });
}

}  // namespace seamline::live
