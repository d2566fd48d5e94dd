#include "renderer/views/depth_parallax.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "raytracer/common/parallel.h"
#include "support/arithmetic/bilinear.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

/// The panorama from the axis, the lowest one of a picture; colours between four pixels.
class AxisPanorama {
 public:
  AxisPanorama(const Image& all, const Camera& camera)
      : all_(all),
        rows_(camera.eyes->panorama_rows),
        first_row_(camera.height_px - rows_),
        middle_(
            camera.direction(0.5F * static_cast<float>(camera.width_px), 0.5F * static_cast<float>(rows_))) {}

  [[nodiscard]] Rgb at(const Eigen::Vector3f& direction) const {
    constexpr float pi = std::numbers::pi_v<float>;
    const float ahead = direction.x() * middle_.x() + direction.z() * middle_.z(),
                right = direction.z() * middle_.x() - direction.x() * middle_.z();
    const float column =
        (std::atan2(right, ahead) / (2 * pi) + 0.5F) * static_cast<float>(all_.width_px) - 0.5F;
    const float row =
        (0.5F - std::atan2(direction.y(), std::hypot(ahead, right)) / pi) * static_cast<float>(rows_) - 0.5F;
    return bilinear(between_cells(column, row), [&](int x, int y) { return pixel(x, y); });
  }

 private:
  [[nodiscard]] Rgb pixel(int x, int y) const {
    return all_.rgb((x + all_.width_px) % all_.width_px, first_row_ + std::clamp(y, 0, rows_ - 1));
  }

  const Image& all_;
  int rows_, first_row_;
  Eigen::Vector3f middle_;
};

Rgb seen_on_mesh(const DepthParallax& from, const AxisPanorama& panorama, int x, int y) {
  Rgb sum = Rgb::Zero();
  for (const float right : {0.25F, 0.75F})
    for (const float down : {0.25F, 0.75F}) {
      const Ray ray{from.camera.place_m(x, y), from.camera.direction_within(x, y, right, down)};
      const std::optional<SurfacePoint> hit = from.mesh.nearest(ray);
      sum += panorama.at(hit ? hit->position_m : ray.direction);
    }
  return 0.25F * sum;
}

}  // namespace

void take_depth_parallax(const DepthParallax& from, Composite& composite) {
  if (from.view.parallax != Parallax::depth) return;
  const AxisPanorama panorama(from.photographs, from.camera);
  const float share = 1.0F / static_cast<float>(from.sums.spp);
  const int rows = from.view.views * from.camera.eyes->panorama_rows;
  parallel_for(rows, from.threads, [&](int y) {
    for (int x = 0; x < from.camera.width_px; ++x) {
      const auto i = grid_index(y, x, from.camera.width_px);
      const StimulusPixel &first = from.sums.halves[0][i], &second = from.sums.halves[1][i];
      const float surfaces = first.uncovered_surfaces + second.uncovered_surfaces;
      if (surfaces <= 0) continue;
      Rgb change =
          share * (surfaces * seen_on_mesh(from, panorama, x, y) - first.background - second.background);
      if (from.sums.compositing == Compositing::ratio) change *= composite.ratio.rgb(x, y);
      composite.picture.set_rgb(x, y, composite.picture.rgb(x, y) + change);
    }
  });
}

}  // namespace seamline::renderer
