#pragma once
#include <array>
#include <vector>

#include "raytracer/tracing/geometry.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// Paper 001, Fig. 6, and what the figure does not say: how far the compressed functions are from the true
/// ones.
struct FieldFigure {
  ByteImage picture;
  std::vector<int> bands;
  /// Of each chosen sample, for each number of bands: root mean square of what is visible (0 or 1) minus its
  /// projection, over all directions.
  std::vector<std::vector<double>> rms;
};

/// Left an object with a shell of its occlusion field around it, whose samples are dots; right, a row for
/// each of three highlighted samples: who is in the way in each direction (black: the object;
/// equirectangular, +Y up), and what spherical harmonics of 2, 4 and 6 bands keep of it, cut off at 0 and 1.
/// `shell`: the shell's radius as a multiple of the object's. The object has its centre at `centre_m`.
[[nodiscard]] FieldFigure field_figure(const Geometry& object, const Eigen::Vector3f& centre_m,
                                       float radius_m, double shell, int threads);

}  // namespace seamline::renderer
