#include "renderer/views/depth_image.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {

Image planar_depth_m(const Camera& camera, const std::function<std::optional<float>(const Ray&)>& nearest_m) {
  const Eigen::Vector3f forward = -camera.axes.col(2);
  Image depth_m(camera.width_px, camera.height_px, 1, std::numeric_limits<float>::infinity());
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const Ray ray = centre_ray(camera, x, y);
      if (const std::optional<float> along_m = nearest_m(ray))
        depth_m.at(x, y) = *along_m * ray.direction.dot(forward);
    }
  return depth_m;
}

ByteImage depth_codes(const Image& planar_m, double max_depth_m) {
  ByteImage codes{planar_m.width_px, planar_m.height_px, 1, {}};
  codes.values.reserve(planar_m.values.size());
  for (const float depth_m : planar_m.values) {
    const double share = std::clamp(static_cast<double>(depth_m) / max_depth_m, 0.0, 1.0);
    codes.values.push_back(static_cast<std::uint8_t>(std::lround(255 * share)));
  }
  return codes;
}

Image depth_of_codes(const ByteImage& codes, double max_depth_m) {
  Image depth_m(codes.width_px, codes.height_px, 1);
  const auto channels = static_cast<std::size_t>(codes.channels);
  for (std::size_t i = 0; i < depth_m.values.size(); ++i)
    depth_m.values[i] = static_cast<float>(codes.values[i * channels] / 255.0 * max_depth_m);
  return depth_m;
}

ByteImage beside(const ByteImage& left, const ByteImage& right) {
  assert(left.width_px == right.width_px && left.height_px == right.height_px);
  ByteImage both{2 * left.width_px, left.height_px, std::max(left.channels, right.channels), {}};
  const auto add = [&](const ByteImage& from, int y) {
    for (int x = 0; x < from.width_px; ++x)
      for (int channel = 0; channel < both.channels; ++channel)
        both.values.push_back(
            from.values[grid_index(y, x, from.width_px) * static_cast<std::size_t>(from.channels) +
                        static_cast<std::size_t>(std::min(channel, from.channels - 1))]);
  };
  for (int y = 0; y < left.height_px; ++y) {
    add(left, y);
    add(right, y);
  }
  return both;
}

ByteImage half_of(const ByteImage& picture, bool right) {
  const int width_px = picture.width_px / 2;
  ByteImage half{width_px, picture.height_px, picture.channels, {}};
  const auto row = static_cast<std::ptrdiff_t>(picture.width_px) * picture.channels;
  const auto length = static_cast<std::ptrdiff_t>(width_px) * picture.channels;
  for (int y = 0; y < picture.height_px; ++y) {
    const auto first = picture.values.begin() + y * row + (right ? length : 0);
    half.values.insert(half.values.end(), first, first + length);
  }
  return half;
}

}  // namespace seamline::renderer
