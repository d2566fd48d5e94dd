#pragma once
#include <Eigen/Core>
#include <filesystem>
#include <vector>

#include "support/arithmetic/colour.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// Light that arrives from infinitely far away, by direction: an equirectangular picture of radiance, as
/// depth maps are (row 0 is the zenith, +Y is up, the centre column looks along -Z, the right half is +X),
/// turned about +Y. Between the texels' centres it is bilinear.
class EnvironmentMap {
 public:
  /// `radiance`: three channels, twice as wide as high, every value finite and not negative
  /// (`read_environment_map`). `rotation_rad`: about +Y, counter-clockwise seen from above, so that what the
  /// map shows at azimuth a is seen from azimuth a - rotation (azimuths grow from -Z to +X).
  EnvironmentMap(Image radiance, float rotation_rad, const Rgb& strength = Rgb::Ones());

  /// W/m2/sr from a unit direction (towards the sky).
  [[nodiscard]] Rgb radiance(const Eigen::Vector3f& direction) const;

  struct Direction {
    Eigen::Vector3f direction;  ///< unit
    float density_sr;           ///< per steradian; 0 when the map is black
  };
  /// A direction, chosen in proportion to the light that comes from it: texel by texel, by mean luminance of
  /// the texel and its eight neighbours (which bilinear lookup reaches) and by solid angle.
  [[nodiscard]] Direction sample(const Eigen::Array2f& point) const;
  /// The density with which `sample` chooses a direction.
  [[nodiscard]] float density_sr(const Eigen::Vector3f& direction) const;

  /// The integral of radiance over the whole sphere, W/m2: no surface gets more.
  [[nodiscard]] Rgb total_w_m2() const { return total_w_m2_; }
  /// Radiance of a texel, and the unit direction of a place of the map in texels from its left upper corner.
  [[nodiscard]] Rgb texel(int column, int row) const { return map_.rgb(column, row); }
  [[nodiscard]] Eigen::Vector3d direction_of(double column, double row) const;
  [[nodiscard]] int width_px() const { return map_.width_px; }
  [[nodiscard]] int height_px() const { return map_.height_px; }

 private:
  [[nodiscard]] Eigen::Array2f place(const Eigen::Vector3f& direction) const;
  [[nodiscard]] float density_of_texel(int column, int row) const;

  Image map_;
  float turn_;  ///< of the sphere, in parts of a whole turn
  Rgb total_w_m2_ = Rgb::Zero();
  // What is summed is not radiance but the choice's weight.
  std::vector<double> rows_;       ///< cumulated over rows, height + 1
  std::vector<float> in_row_;      ///< cumulated over the columns of each row, width + 1 each, ends at 1
  std::vector<double> row_sines_;  ///< sin(elevation) at the rows' edges, height + 1
};

/// Reads a map of radiance: EXR or HDR, 2:1, at most 16384 texels wide. Throws InputError naming the file at
/// another shape, at 8- or 16-bit pictures (whose curve to radiance nobody stated), and at values that are
/// negative or no numbers, with the first such texel.
[[nodiscard]] Image read_environment_map(const std::filesystem::path& path);

}  // namespace seamline::renderer
