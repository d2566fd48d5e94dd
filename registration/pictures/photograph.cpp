#include "registration/pictures/photograph.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "sensors/repair/nearest.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::registration {
namespace {

bool is_edge(const sensors::DepthFrame& frame, int column, int row, double ratio) {
  const float here_m = frame.at(column, row);
  const auto jumps_to = [&](int other_column, int other_row) {
    if (other_column >= frame.camera.width_px || other_row >= frame.camera.height_px) return false;
    const float there_m = frame.at(other_column, other_row);
    if (sensors::DepthFrame::is_hole(here_m) || sensors::DepthFrame::is_hole(there_m)) return false;
    const auto [nearest_m, farthest_m] = std::minmax(here_m, there_m);
    return static_cast<double>(farthest_m) > ratio * static_cast<double>(nearest_m);
  };
  return jumps_to(column + 1, row) || jumps_to(column, row + 1);
}

}  // namespace

Image read_photograph(const std::filesystem::path& path, const sensors::PinholeCamera& colour) {
  Image photograph = read_image(path, [&](const ImageHeader& header) {
    if (header.channels < 3)
      throw input_error({.file = path.string(),
                         .wanted = "three colour channels",
                         .found = fmt::format("{} channels", header.channels)});
    if (header.width_px != colour.width_px || header.height_px != colour.height_px)
      throw input_error({.file = path.string(),
                         .field = "size",
                         .wanted = fmt::format("{} x {} pixels, as the colour camera is stated",
                                               colour.width_px, colour.height_px),
                         .found = fmt::format("{} x {}", header.width_px, header.height_px)});
  });
  require_numbers(photograph, path.string());
  return photograph;
}

Image photograph_in_depth_pixels(const Image& photograph, const sensors::DepthFrame& measured,
                                 const Eigen::Isometry3d& colour_from_depth,
                                 const sensors::PinholeCamera& colour, int threads) {
  const sensors::DepthFrame filled = sensors::fill_with_nearest(measured, threads).frame;
  const std::vector<Eigen::Vector3d> points_m = points_in_colour_frame(filled, colour_from_depth, threads);
  Image guide(measured.camera.width_px, measured.camera.height_px, 3);
  run_parallel(measured.camera.height_px, threads, [&](int row) {
    for (int column = 0; column < measured.camera.width_px; ++column) {
      const auto place_px = sensors::project(colour, points_m[measured.index(column, row)]);
      if (!place_px) continue;
      const auto nearest = [](double place, int size) {
        return static_cast<int>(std::clamp(std::floor(place), 0.0, size - 1.0));
      };
      guide.set_rgb(
          column, row,
          photograph.rgb(nearest(place_px->x(), colour.width_px), nearest(place_px->y(), colour.height_px)));
    }
  });
  return guide;
}

ByteImage edges_over_photograph(const RegisteredFrame& registered, const Image& photograph, double ratio) {
  ByteImage picture = display_image(photograph);
  const sensors::DepthFrame& frame = registered.frame;
  ByteImage edges{picture.width_px, picture.height_px, 3, {}};
  edges.values.reserve(frame.depth_m.size() * 3);
  for (int row = 0; row < picture.height_px; ++row)
    for (int column = 0; column < picture.width_px; ++column) {
      const std::size_t at = frame.index(column, row);
      const int thirds = registered.filled[at] == 0 ? 1 : registered.extruded[at] != 0 ? 2 : 3;
      const bool red = is_edge(frame, column, row, ratio);
      for (std::size_t channel = 0; channel < 3; ++channel) {
        const int code = picture.values[at * static_cast<std::size_t>(picture.channels) + channel];
        const int edge_code = channel == 0 ? 255 : 0;
        edges.values.push_back(static_cast<std::uint8_t>(red ? edge_code : code * thirds / 3));
      }
    }
  return edges;
}

ByteImage mask_picture(const sensors::PinholeCamera& camera, std::span<const std::uint8_t> mask) {
  ByteImage picture{camera.width_px, camera.height_px, 1, {}};
  for (const std::uint8_t one : mask) picture.values.push_back(one != 0 ? 255 : 0);
  return picture;
}

}  // namespace seamline::registration
