#include "renderer/depth/budget/samples_picture.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

/// Directions in bins of a panorama, for neighbours.
class DirectionBins {
 public:
  explicit DirectionBins(const DepthMesh& mesh) : bins_(std::size_t{width} * height) {
    for (const Eigen::Vector3f& vertex_m : mesh.vertices_m) {
      const Eigen::Vector3f direction = vertex_m.normalized();
      bins_[index(column(direction), row(direction))].push_back(direction);
    }
  }

  /// Whether one of them is nearer than an angle (small: less than a bin) to a direction.
  [[nodiscard]] bool has_near(const Eigen::Vector3f& direction, float angle_rad) const {
    const int at_column = column(direction), at_row = row(direction);
    // Bins are narrow near the poles: there a whole row may be near.
    const double sine = std::sqrt(std::max(1e-9, 1 - double{direction.y()} * double{direction.y()}));
    const int reach = std::min(width / 2, 1 + static_cast<int>(1 / sine));
    for (int y = std::max(0, at_row - 1); y <= std::min(height - 1, at_row + 1); ++y)
      for (int x = at_column - reach; x <= at_column + reach; ++x)
        for (const Eigen::Vector3f& other : bins_[index((x + width) % width, y)])
          if ((other - direction).squaredNorm() < angle_rad * angle_rad) return true;
    return false;
  }
  static constexpr int width = 1024, height = width / 2;

 private:
  static int column(const Eigen::Vector3f& d) {
    const double turns = std::atan2(d.x(), -d.z()) / (2 * std::numbers::pi) + 0.5;
    return std::clamp(static_cast<int>(turns * width), 0, width - 1);
  }
  static int row(const Eigen::Vector3f& d) {
    const double share = 0.5 - std::asin(std::clamp(double{d.y()}, -1.0, 1.0)) / std::numbers::pi;
    return std::clamp(static_cast<int>(share * height), 0, height - 1);
  }
  static std::size_t index(int column, int row) {
    return static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
  }

  std::vector<std::vector<Eigen::Vector3f>> bins_;
};

}  // namespace

Image samples_picture(const DepthMesh& mesh, const Camera& camera, const Image& display, int threads) {
  const DirectionBins bins(mesh);
  Image picture(camera.width_px, camera.height_px, 3);
  const Rgb dot(1.0F, 0.8F, 0.1F);
  run_parallel(camera.height_px, threads, [&](int y) {
    for (int x = 0; x < camera.width_px; ++x) {
      const Eigen::Vector3f direction = camera.centre_direction(x, y);
      if (direction.isZero()) continue;
      const Eigen::Vector3f beside = camera.centre_direction(x + 1 < camera.width_px ? x + 1 : x - 1, y);
      const float radius_rad =
          std::min(0.75F * (beside - direction).norm(), 3.0F / static_cast<float>(DirectionBins::height));
      picture.set_rgb(
          x, y, bins.has_near(direction, radius_rad) ? dot : Rgb::Constant(0.5F * display.rgb(x, y).mean()));
    }
  });
  return picture;
}

}  // namespace seamline::renderer
