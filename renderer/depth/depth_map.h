#pragma once
#include <Eigen/Core>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace seamline::renderer {

/// Equirectangular radial distance in metres from the camera position, world axes. Row 0 is the zenith, texel
/// centres are at half integers, the centre column looks along -Z, the right half is +X. A hole (sky, no
/// measurement) is +infinity.
struct DepthMap {
  int width_px = 0;   ///< W, even, >= 2
  int height_px = 0;  ///< W / 2
  std::vector<float> distance_m;
  std::int64_t cleaned_texels = 0;  ///< values <= 0, NaN or >= 1e9 that were read as holes

  [[nodiscard]] float at(int column, int row) const {
    return distance_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(width_px) +
                      static_cast<std::size_t>(column)];
  }
};

/// Unit direction of panorama coordinates (column in [0, W], row in [0, H], not necessarily texel centres;
/// texel (c, r) has its centre at (c + 0.5, r + 0.5)): azimuth phi = (column / W - 0.5) 2 pi, elevation e =
/// (0.5 - row / H) pi, direction = (sin phi cos e, sin e, -cos phi cos e).
[[nodiscard]] Eigen::Vector3d panorama_direction(double column, double row, int width_px, int height_px);

/// Solid angle of each texel of one row, in steradian, 2 pi / W (sin e_top - sin e_bottom); over a whole map
/// they sum to 4 pi.
[[nodiscard]] double texel_solid_angle_sr(int row, int width_px, int height_px);

/// Turns values <= 0, NaN and >= 1e9 into holes (+infinity) and counts them (infinities are holes already,
/// and not counted).
void clean_holes(DepthMap& map);

/// Reads a one-channel float EXR and cleans its holes. Throws InputError for another kind of file, more
/// channels, odd or non-2:1 sizes.
[[nodiscard]] DepthMap read_depth_map(const std::filesystem::path& path);

/// Writes a one-channel 32-bit float EXR, atomically; every hole is written as +infinity.
void write_depth_map(const std::filesystem::path& path, const DepthMap& map);

}  // namespace seamline::renderer
