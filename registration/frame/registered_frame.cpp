#include "registration/frame/registered_frame.h"

#include <fmt/core.h>

#include <numeric>

#include "sensors/rig/rig.h"
#include "support/running/parallel.h"
#include "support/text/error.h"
#include "support/text/numbers.h"

namespace seamline::registration {
namespace {

std::size_t pixels_of(const sensors::PinholeCamera& camera) {
  return static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
}

}  // namespace

RegisteredFrame empty_frame(const sensors::PinholeCamera& colour) {
  const std::size_t pixels = pixels_of(colour);
  RegisteredFrame registered;
  registered.frame.camera = colour;
  registered.frame.convention = sensors::DepthConvention::planar;
  registered.frame.depth_m.assign(pixels, sensors::hole);
  registered.filled.assign(pixels, 0);
  registered.extruded.assign(pixels, 0);
  registered.invented.assign(pixels, 0);
  return registered;
}

std::int64_t count_of(std::span<const std::uint8_t> mask) {
  return std::accumulate(mask.begin(), mask.end(), std::int64_t{0});
}

std::vector<Eigen::Vector3d> points_in_colour_frame(const sensors::DepthFrame& measured,
                                                    const Eigen::Isometry3d& colour_from_depth, int threads) {
  std::vector<Eigen::Vector3d> points_m(measured.depth_m.size());
  run_parallel(measured.camera.height_px, threads, [&](int row) {
    for (int column = 0; column < measured.camera.width_px; ++column) {
      const auto point_m = sensors::point_of_pixel(measured, column, row);
      points_m[measured.index(column, row)] =
          point_m ? Eigen::Vector3d(colour_from_depth * *point_m) : Eigen::Vector3d::Constant(nan);
    }
  });
  return points_m;
}

void require_valid(const sensors::DepthFrame& measured, const Eigen::Isometry3d& colour_from_depth,
                   const sensors::PinholeCamera& colour, std::span<const std::uint8_t> invented) {
  sensors::require_valid(measured.camera, "registration: depth.");
  sensors::require_valid(colour, "registration: colour.");
  sensors::require_rigid(colour_from_depth, "registration: colour_from_depth");
  const std::size_t pixels = pixels_of(measured.camera);
  const auto require_size = [&](const char* field, std::size_t found) {
    if (found != pixels)
      throw input_error({.field = std::string("registration: ") + field,
                         .wanted = fmt::format("{} values, one for each pixel", pixels),
                         .found = std::to_string(found)});
  };
  require_size("depth_m", measured.depth_m.size());
  if (!invented.empty()) require_size("invented", invented.size());
}

}  // namespace seamline::registration
