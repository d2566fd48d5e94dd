#include "registration/files/point_cloud.h"

#include <fmt/core.h>

#include <bit>
#include <cstring>

#include "support/text/error.h"

namespace seamline::registration {
namespace {

static_assert(std::endian::native == std::endian::little, "bytes are written as they lie in memory");

void append_point(std::string& bytes, const Eigen::Vector3d& point_m, const std::uint8_t* rgb) {
  const Eigen::Vector3f place = point_m.cast<float>();
  std::array<char, sizeof(float) * 3> block{};
  std::memcpy(block.data(), place.data(), block.size());
  bytes.append(block.data(), block.size());
  for (std::size_t channel = 0; channel < 3; ++channel) bytes += static_cast<char>(rgb[channel]);
}

}  // namespace

std::string point_cloud_ply(const RegisteredFrame& registered, const ByteImage& picture,
                            const Eigen::Isometry3d& frame_from_colour, const std::string& frame_name) {
  const sensors::DepthFrame& frame = registered.frame;
  if (picture.width_px != frame.camera.width_px || picture.height_px != frame.camera.height_px ||
      picture.channels < 3)
    throw input_error(
        {.field = "point cloud: picture",
         .wanted = fmt::format("{} x {} pixels of colour", frame.camera.width_px, frame.camera.height_px),
         .found =
             fmt::format("{} x {} of {} channels", picture.width_px, picture.height_px, picture.channels)});
  std::string points;
  std::int64_t count = 0;
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < frame.camera.width_px; ++column) {
      const std::size_t at = frame.index(column, row);
      if (registered.filled[at] == 0 || registered.extruded[at] != 0) continue;
      const auto point_m = sensors::point_of_pixel(frame, column, row);
      if (!point_m) continue;
      append_point(points, frame_from_colour * *point_m,
                   &picture.values[at * static_cast<std::size_t>(picture.channels)]);
      ++count;
    }
  return fmt::format(
             "ply\nformat binary_little_endian 1.0\ncomment metres, {}\nelement vertex {}\n"
             "property float x\nproperty float y\nproperty float z\n"
             "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
             frame_name, count) +
         points;
}

}  // namespace seamline::registration
