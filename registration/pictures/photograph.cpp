#include "registration/pictures/photograph.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "sensors/repair/nearest.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::registration {
namespace {

/// The logarithm of the ratio of two depths.
using Contrast = double;

/// Contrasts along one direction of a registered frame, across `span_px`: the spacing of the depth map in the
/// photograph, over which a mesh spreads a jump.
class ContrastsAlong {
 public:
  ContrastsAlong(const sensors::DepthFrame& frame, int span_px, int right, int down)
      : frame_(frame), span_px_(span_px), right_(right), down_(down) {
    contrasts_.reserve(frame.depth_m.size());
    for (int row = 0; row < frame.camera.height_px; ++row)
      for (int column = 0; column < frame.camera.width_px; ++column)
        contrasts_.push_back(across(column, row));
  }

  /// Whether depth jumps here, and no less than anywhere within half of the span.
  [[nodiscard]] bool is_edge(int column, int row, Contrast least) const {
    const Contrast here = at(column, row);
    if (!(here > least)) return false;
    for (int step = 1; step <= span_px_ / 2; ++step)
      if (at(column - step * right_, row - step * down_) >= here ||
          at(column + step * right_, row + step * down_) > here)
        return false;
    return true;
  }

 private:
  [[nodiscard]] bool inside(int column, int row) const {
    return column >= 0 && row >= 0 && column < frame_.camera.width_px && row < frame_.camera.height_px;
  }
  [[nodiscard]] Contrast at(int column, int row) const {
    return inside(column, row) ? contrasts_[frame_.index(column, row)] : 0;
  }
  /// The depth there or, where registration by points left a hole, of the nearest pixel within half of the
  /// span; infinite where there is none.
  [[nodiscard]] float depth_m(int column, int row) const {
    for (int step = 0; step <= span_px_ / 2; ++step)
      for (const int way : {step, -step})
        if (inside(column + way * right_, row + way * down_))
          if (const float found_m = frame_.at(column + way * right_, row + way * down_);
              !sensors::DepthFrame::is_hole(found_m))
            return found_m;
    return sensors::hole;
  }
  /// The lower median of the pixel of the depth camera there and its two neighbours beside, so that a noisy
  /// one alone makes no edge.
  [[nodiscard]] float side_m(int column, int row) const {
    std::vector<float> depths_m;
    for (int beside = -span_px_; beside <= span_px_; beside += span_px_)
      if (const float found_m = depth_m(column + beside * down_, row + beside * right_);
          !sensors::DepthFrame::is_hole(found_m))
        depths_m.push_back(found_m);
    const auto middle = depths_m.begin() + static_cast<std::ptrdiff_t>((depths_m.size() - 1) / 2);
    std::nth_element(depths_m.begin(), middle, depths_m.end());
    return *middle;
  }
  [[nodiscard]] Contrast across(int column, int row) const {
    const int before = (span_px_ - 1) / 2, after = span_px_ - before;
    const int left = column - before * right_, up = row - before * down_;
    const int right = column + after * right_, below = row + after * down_;
    if (!inside(left, up) || !inside(right, below)) return 0;
    if (sensors::DepthFrame::is_hole(depth_m(left, up)) ||
        sensors::DepthFrame::is_hole(depth_m(right, below)))
      return 0;
    const float a_m = side_m(left, up), b_m = side_m(right, below);
    return std::abs(std::log(static_cast<double>(a_m) / static_cast<double>(b_m)));
  }

  const sensors::DepthFrame& frame_;
  int span_px_, right_, down_;
  std::vector<Contrast> contrasts_;
};

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

ByteImage edges_over_photograph(const RegisteredFrame& registered, const Image& photograph, double ratio,
                                double depth_pixel_px) {
  ByteImage picture = display_image(photograph);
  const sensors::DepthFrame& frame = registered.frame;
  const int span_px = std::max(1, static_cast<int>(std::ceil(depth_pixel_px)));
  const ContrastsAlong rightward(frame, span_px, 1, 0), downward(frame, span_px, 0, 1);
  const Contrast least = std::log(ratio);
  ByteImage edges{picture.width_px, picture.height_px, 3, {}};
  edges.values.reserve(frame.depth_m.size() * 3);
  for (int row = 0; row < picture.height_px; ++row)
    for (int column = 0; column < picture.width_px; ++column) {
      const std::size_t at = frame.index(column, row);
      const int thirds = registered.filled[at] == 0 ? 1 : registered.extruded[at] != 0 ? 2 : 3;
      const bool red = registered.extruded[at] == 0 &&
                       (rightward.is_edge(column, row, least) || downward.is_edge(column, row, least));
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
