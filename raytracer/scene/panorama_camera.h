#pragma once
#include "raytracer/scene/camera.h"

namespace seamline::renderer {

/// Directions of an equirectangular picture, +Y up. Its middle column looks along -Z turned by `azimuth_rad`
/// to the right; the columns on its right look further to the right.
struct PanoramaDirections {
  float width_px = 0, height_px = 0;
  float azimuth_rad = 0;
  /// Whether filters and errors know that the last column stands beside the first, and that rows near the
  /// poles show little. `composite` does not: its pictures keep their bytes.
  bool wraps = false;

  [[nodiscard]] Eigen::Vector3f operator()(float x, float y) const;
};

/// A camera that looks everywhere from the origin. The axes of the picture are the world's, turned about +Y.
[[nodiscard]] Camera panorama_camera(int width_px, int height_px, float azimuth_rad = 0, bool wraps = false);

/// Whether a camera's picture is a panorama that wraps around: the stimuli of a study in all directions.
[[nodiscard]] bool wraps(const Camera& camera);

}  // namespace seamline::renderer
