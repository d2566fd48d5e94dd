#include "sensors/files/estimate_error.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "sensors/files/raw_depth.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

void require_estimates_size(const std::filesystem::path& path, const RawDepth& raw,
                            const PinholeCamera& camera) {
  if (raw.width_px == camera.width_px && raw.height_px == camera.height_px) return;
  throw input_error(
      {.file = path.string(),
       .field = "size",
       .wanted = fmt::format("{} x {} pixels, as the study says", camera.width_px, camera.height_px),
       .found = fmt::format("{} x {}", raw.width_px, raw.height_px)});
}

DepthLine line_on_truth(const RawDepth& raw, DepthValue value, std::span<const float> true_m) {
  std::vector<KnownValue> known;
  known.reserve(raw.values.size());
  for (std::size_t i = 0; i < raw.values.size(); ++i)
    if (std::isfinite(raw.values[i]) && std::isfinite(true_m[i]))
      known.push_back({static_cast<double>(raw.values[i]), static_cast<double>(true_m[i])});
  return fit_depth(value, known, "depth.align").line;
}

}  // namespace

DepthError depth_error(std::span<const float> depth_m, std::span<const float> true_m) {
  assert(depth_m.size() == true_m.size());
  DepthError error;
  double relative = 0, squared = 0;
  std::int64_t near = 0;
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    if (!std::isfinite(depth_m[i]) || !std::isfinite(true_m[i])) continue;
    const double d = depth_m[i], truth = true_m[i];
    ++error.compared;
    relative += std::abs(d - truth) / truth;
    squared += (d - truth) * (d - truth);
    near += std::max(d / truth, truth / d) < 1.25 ? 1 : 0;
  }
  if (error.compared == 0) return error;
  const double count = error.compared;
  error.abs_rel = relative / count;
  error.rmse_m = std::sqrt(squared / count);
  error.within_quarter = near / count;
  return error;
}

void mix_with_truth(std::span<const float> true_m, double share, std::vector<float>& depth_m) {
  assert(depth_m.size() == true_m.size());
  if (share == 1) return;
  for (std::size_t i = 0; i < depth_m.size(); ++i) {
    if (share == 0) {
      depth_m[i] = true_m[i];
    } else if (std::isfinite(depth_m[i])) {
      const double inverse = (1 - share) / true_m[i] + share / depth_m[i];
      depth_m[i] = static_cast<float>(1 / inverse);
    }
  }
}

std::vector<float> estimated_depth(const std::filesystem::path& path, DepthValue value,
                                   const std::optional<DepthLine>& stated, DepthPacking packing,
                                   const PinholeCamera& camera, std::span<const float> true_m) {
  const RawDepth raw =
      read_raw_depth(path, {.packing = packing, .eight_bits = true},
                     [&](const RawDepth& header) { require_estimates_size(path, header, camera); });
  const DepthLine line = stated ? *stated : line_on_truth(raw, value, true_m);
  std::vector<float> depth_m;
  depth_m.reserve(raw.values.size());
  for (const float one : raw.values) {
    const double metres = metres_of_value(value, line, one);
    depth_m.push_back(metres < 1e9 ? static_cast<float>(metres) : hole);
  }
  if (std::none_of(depth_m.begin(), depth_m.end(), [](float one) { return std::isfinite(one); }))
    throw input_error({.file = path.string(),
                       .field = "depth.scale",
                       .wanted = "a scale and a shift that give some value a distance",
                       .found = fmt::format("scale {:g}, shift {:g}", line.scale, line.shift)});
  return depth_m;
}

}  // namespace seamline::sensors
