#include "sensors/frame/depth_test.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "support/text/error.h"

namespace seamline::sensors {
namespace {

double largest_step(const DepthBuffer& buffer) {
  return std::exp2(buffer.bits) - 1;
}

float value_at(const DepthFrame& frame, double x_px, double y_px) {
  const int column = std::clamp(static_cast<int>(std::floor(x_px)), 0, frame.camera.width_px - 1);
  const int row = std::clamp(static_cast<int>(std::floor(y_px)), 0, frame.camera.height_px - 1);
  return frame.at(column, row);
}

}  // namespace

void require_valid(const DepthBuffer& buffer, const std::string& where) {
  if (!(buffer.nearest_m > 0 && buffer.nearest_m < buffer.farthest_m && std::isfinite(buffer.farthest_m)))
    throw input_error({.field = where,
                       .wanted = "two planes, the nearer first, both farther than 0 m",
                       .found = fmt::format("{} and {} m", buffer.nearest_m, buffer.farthest_m)});
  if (buffer.bits < 8 || buffer.bits > 32)
    throw input_error({.field = where, .wanted = "8 to 32 bits", .found = std::to_string(buffer.bits)});
}

std::int64_t depth_buffer_step(const DepthBuffer& buffer, double planar_m) {
  const double z = std::clamp(planar_m, buffer.nearest_m, buffer.farthest_m);
  const double share = (1 / buffer.nearest_m - 1 / z) / (1 / buffer.nearest_m - 1 / buffer.farthest_m);
  return std::llround(largest_step(buffer) * share);
}

double depth_buffer_step_m(const DepthBuffer& buffer, double planar_m) {
  return planar_m * planar_m * (1 / buffer.nearest_m - 1 / buffer.farthest_m) / largest_step(buffer);
}

bool hides_in_metres(const DepthFrame& planar, double x_px, double y_px, double virtual_planar_m) {
  return value_at(planar, x_px, y_px) < virtual_planar_m;
}

bool hides_in_buffer(const DepthFrame& planar, double x_px, double y_px, double virtual_planar_m,
                     const DepthBuffer& buffer) {
  const float real_m = value_at(planar, x_px, y_px);
  if (DepthFrame::is_hole(real_m)) return false;
  return depth_buffer_step(buffer, real_m) < depth_buffer_step(buffer, virtual_planar_m);
}

bool hides(double real_planar_m, double virtual_planar_m, const DepthBuffer* buffer) {
  if (buffer == nullptr || !std::isfinite(real_planar_m)) return real_planar_m < virtual_planar_m;
  return depth_buffer_step(*buffer, real_planar_m) < depth_buffer_step(*buffer, virtual_planar_m);
}

float depth_between(const DepthFrame& frame, double x_px, double y_px) {
  const int last_column = frame.camera.width_px - 1, last_row = frame.camera.height_px - 1;
  return linear_between(std::clamp(x_px - 0.5, 0.0, static_cast<double>(last_column)),
                        std::clamp(y_px - 0.5, 0.0, static_cast<double>(last_row)), [&](int column, int row) {
                          return frame.at(std::clamp(column, 0, last_column), std::clamp(row, 0, last_row));
                        });
}

}  // namespace seamline::sensors
