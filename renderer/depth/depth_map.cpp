#include "renderer/depth/depth_map.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>

#include "support/files/image.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

constexpr float hole = std::numeric_limits<float>::infinity();
constexpr float nothing_from_m = 1e9F;  ///< anything from here on was meant as "nothing there"

bool is_measured(float distance_m) {
  return distance_m > 0 && distance_m < nothing_from_m;
}  // false for NaN

}  // namespace

Eigen::Vector3d panorama_direction(double column, double row, int width_px, int height_px) {
  const double azimuth_rad = (column / width_px - 0.5) * 2 * std::numbers::pi;
  const double elevation_rad = (0.5 - row / height_px) * std::numbers::pi;
  return {std::sin(azimuth_rad) * std::cos(elevation_rad), std::sin(elevation_rad),
          -std::cos(azimuth_rad) * std::cos(elevation_rad)};
}

double texel_solid_angle_sr(int row, int width_px, int height_px) {
  // sin(top) - sin(bottom) as a product, which keeps its digits at the poles.
  const double row_rad = std::numbers::pi / height_px;
  const double elevation_rad = (0.5 - (row + 0.5) / height_px) * std::numbers::pi;
  return 2 * std::numbers::pi / width_px * 2 * std::cos(elevation_rad) * std::sin(row_rad / 2);
}

void clean_holes(DepthMap& map) {
  for (float& distance_m : map.distance_m) {
    if (is_measured(distance_m)) continue;
    if (distance_m != hole) ++map.cleaned_texels;
    distance_m = hole;
  }
}

DepthMap read_depth_map(const std::filesystem::path& path) {
  const auto refuse = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = path.string(), .wanted = wanted, .found = found});
  };
  // Eight-bit formats would be decoded as colours: their numbers are no metres.
  if (path.extension() != ".exr" && path.extension() != ".EXR")
    throw refuse("a depth map as an .exr file", "the extension `" + path.extension().string() + "`");
  Image image = read_image(path, [&](const ImageHeader& header) {
    if (!header.floating_point) throw refuse("an image of floating-point values", "whole numbers");
    if (header.channels != 1)
      throw refuse("a depth map with one channel", std::to_string(header.channels) + " channels");
    if (header.width_px < 2 || header.width_px % 2 != 0 || header.height_px != header.width_px / 2)
      throw refuse("an equirectangular depth map with an even width of at least 2 and half that height",
                   std::to_string(header.width_px) + " x " + std::to_string(header.height_px));
  });
  DepthMap map{.width_px = image.width_px,
               .height_px = image.height_px,
               .distance_m = std::move(image.values),
               .cleaned_texels = 0};
  clean_holes(map);
  return map;
}

void write_depth_map(const std::filesystem::path& path, const DepthMap& map) {
  Image image(map.width_px, map.height_px, 1);
  for (std::size_t i = 0; i < map.distance_m.size(); ++i)
    image.values[i] = is_measured(map.distance_m[i]) ? map.distance_m[i] : hole;
  write_exr(path, image);
}

}  // namespace seamline::renderer
