#include "renderer/depth/panorama_chain.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "renderer/depth/capture.h"
#include "renderer/depth/coarse_model.h"
#include "renderer/depth/dense_sphere.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/sensor/estimated_map.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "support/arithmetic/grid_index.h"
#include "support/running/parallel.h"

namespace seamline::renderer {
namespace {

using sensors::DepthFrame;

struct MeasuredMap {
  DepthMap map;
  SensorCounts counts;
  std::optional<DepthErrorRecord> depth_error = {};
};

/// The estimate of a file in place of the true map, as far as its share says. Returns the true distances.
std::vector<float> put_estimate(const PanoramaFile& file, DepthMap& map) {
  sensors::PinholeCamera size;  // of a panorama, whose rays it does not have
  size.width_px = map.width_px;
  size.height_px = map.height_px;
  std::vector<float> true_m = map.distance_m;
  map.distance_m = depth_of_estimate({file.path, file.estimate, file.metres_per_step, file.packing}, size,
                                     sensors::DepthConvention::radial, true_m);
  sensors::mix_with_truth(true_m, file.estimate.share, map.distance_m);
  return true_m;
}

/// Texels outside the scanner's elevations or its range see nothing.
void blind(DepthMap& map, const PanoramaSource& source) {
  for (int row = 0; row < map.height_px; ++row) {
    const double elevation_deg = (0.5 - (row + 0.5) / map.height_px) * 180;
    const bool sees =
        elevation_deg >= source.lowest_elevation_deg && elevation_deg <= source.highest_elevation_deg;
    for (int column = 0; column < map.width_px; ++column) {
      float& distance_m = map.distance_m[grid_index(row, column, map.width_px)];
      const double value = static_cast<double>(distance_m);
      if (!sees || value < source.range.nearest_m || value > source.range.farthest_m)
        distance_m = sensors::hole;
    }
  }
}

void add_noise(DepthMap& map, const SourceNoise& noise, const sensors::SensorRange& range,
               const sensors::NoiseKey& key, SensorCounts& counts) {
  sensors::GenericNoise model = std::get<sensors::GenericNoise>(noise.model);
  model.convention = sensors::DepthConvention::radial;
  model.range = range;
  counts.measured = 0;
  for (std::size_t i = 0; i < map.distance_m.size(); ++i) {
    sensors::SeenPixel seen;
    seen.centre.radial_m = static_cast<double>(map.distance_m[i]);
    const sensors::MeasuredPixel pixel =
        sensors::measure_pixel(model, seen, sensors::NoiseStream(key, i), noise.scale);
    map.distance_m[i] = pixel.depth_m;
    counts.measured += pixel.state == sensors::PixelState::measured ? 1 : 0;
    counts.outliers += pixel.state == sensors::PixelState::outlier ? 1 : 0;
  }
}

/// A picture with half of itself again on both sides, in which the seam has both of its neighbours.
template <class Value>
std::vector<Value> widened(const std::vector<Value>& values, int width, int height) {
  const int half = width / 2;
  std::vector<Value> wide;
  wide.reserve(2 * values.size());
  for (int row = 0; row < height; ++row)
    for (int column = -half; column < width + half; ++column)
      wide.push_back(values[grid_index(row, (column + width) % width, width)]);
  return wide;
}

/// Albedo times cosine along the texels' rays.
std::vector<float> guide_values(const Geometry& truth, const DepthMap& map, double yaw_texels, int threads) {
  std::vector<float> values(map.distance_m.size());
  run_parallel(map.height_px, threads, [&](int row) {
    for (int column = 0; column < map.width_px; ++column) {
      const Ray ray{Eigen::Vector3f::Zero(),
                    panorama_direction(column + yaw_texels + 0.5, row + 0.5, map.width_px, map.height_px)
                        .cast<float>()};
      if (const auto hit = truth.nearest(ray))
        values[grid_index(row, column, map.width_px)] =
            hit->albedo.mean() * std::abs(hit->geometric_normal.dot(ray.direction));
    }
  });
  return values;
}

/// Returns how many texels it invented.
std::int64_t mend(const Geometry& truth, const DepthSettings& settings, int threads, DepthMap& map) {
  const sensors::RepairMethod& method = settings.chain->repair;
  const int wide = 2 * map.width_px, half = map.width_px / 2;
  DepthFrame frame;
  frame.camera.width_px = wide;
  frame.camera.height_px = map.height_px;
  frame.convention = sensors::DepthConvention::radial;
  frame.depth_m = widened(map.distance_m, map.width_px, map.height_px);
  Image guide(wide, map.height_px, 1);
  const bool guided = std::holds_alternative<sensors::JointBilateralRepair>(method);
  if (guided)
    guide.values =
        widened(guide_values(truth, map, settings.yaw_texels, threads), map.width_px, map.height_px);
  const sensors::Repaired repaired = sensors::repair(frame, method, guided ? &guide : nullptr, threads);
  std::int64_t invented = 0;
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < map.width_px; ++column) {
      const std::size_t in_wide = repaired.frame.index(column + half, row);
      map.distance_m[grid_index(row, column, map.width_px)] = repaired.frame.depth_m[in_wide];
      invented += repaired.marks[in_wide] == sensors::RepairMark::invented ? 1 : 0;
    }
  return invented;
}

MeasuredMap capture_panorama(const Geometry& truth, const DepthSettings& settings, int threads) {
  const DepthChain& chain = *settings.chain;
  const auto& source = std::get<PanoramaSource>(chain.sources.front());
  const int factor = source.reduction_factor;
  MeasuredMap made;
  const bool merges = factor > 1 && source.reduction != Reduction::boxes;
  const int finer = merges ? factor : 1;
  made.map = capture_depth(truth, settings.width_px * finer, settings.yaw_texels * finer, threads);
  if (merges) made.map = reduced(made.map, source.reduction, factor, threads);
  std::vector<float> true_m;
  if (source.file) true_m = put_estimate(*source.file, made.map);
  blind(made.map, source);
  if (source.file) add_depth_error(sensors::depth_error(made.map.distance_m, true_m), made.depth_error);
  made.counts.measured = std::count_if(made.map.distance_m.begin(), made.map.distance_m.end(),
                                       [](float distance_m) { return !is_hole(distance_m); });
  if (source.noise)
    add_noise(made.map, *source.noise, source.range, {.seed = chain.seed, .frame = 0}, made.counts);
  made.counts.holes = std::ssize(made.map.distance_m) - made.counts.measured - made.counts.outliers;
  if (!std::holds_alternative<sensors::NoRepair>(chain.repair))
    made.counts.invented = mend(truth, settings, threads, made.map);
  return made;
}

/// Whether a triangle lies between texels that jump: by the four around its middle, if it is no larger than
/// about one texel. Larger ones hold the mesh's bound, which no jump does.
class TexelJumps {
 public:
  TexelJumps(const DepthMap& map, double yaw_texels, double ratio)
      : map_(map), yaw_texels_(yaw_texels), ratio_(ratio) {}

  [[nodiscard]] bool at(const Eigen::Vector3f& a_m, const Eigen::Vector3f& b_m,
                        const Eigen::Vector3f& c_m) const {
    const Eigen::Vector3d a = a_m.cast<double>().normalized(), b = b_m.cast<double>().normalized(),
                          c = c_m.cast<double>().normalized();
    const double texel_rad = std::numbers::pi / map_.height_px;
    if (std::max({(a - b).norm(), (b - c).norm(), (c - a).norm()}) > 2 * texel_rad) return false;
    const Eigen::Vector3d middle = (a + b + c).normalized();
    const double column =
        (std::atan2(middle.x(), -middle.z()) / (2 * std::numbers::pi) + 0.5) * map_.width_px - yaw_texels_ -
        0.5;
    const double row =
        (0.5 - std::asin(std::clamp(middle.y(), -1.0, 1.0)) / std::numbers::pi) * map_.height_px - 0.5;
    const int left = static_cast<int>(std::floor(column)), top = static_cast<int>(std::floor(row));
    float near_m = sensors::hole, far_m = 0;
    for (const int y : {top, top + 1})
      for (const int x : {left, left + 1}) {
        const float distance_m = map_.at(((x % map_.width_px) + map_.width_px) % map_.width_px,
                                         std::clamp(y, 0, map_.height_px - 1));
        if (is_hole(distance_m)) continue;
        near_m = std::min(near_m, distance_m);
        far_m = std::max(far_m, distance_m);
      }
    return static_cast<double>(far_m) > static_cast<double>(near_m) * ratio_;
  }

 private:
  const DepthMap& map_;
  double yaw_texels_, ratio_;
};

double relative_sigma(const DepthSettings& settings) {
  const SourceNoise* noise = noise_of(settings.chain->sources.front());
  if (noise == nullptr) return 0;
  return noise->scale * std::get<sensors::GenericNoise>(noise->model).relative_sigma;
}

double mesh_tolerance(const DepthSettings& settings) {
  return std::max(settings.mesh_tolerance, settings.chain->noise_sigmas * relative_sigma(settings));
}

/// The model of a map so many times as wide.
struct FittedModel {
  CoarseModel model;
  ModelRecord record;
};

FittedModel fitted_model(const Geometry& truth, const DepthSettings& settings, int threads) {
  const auto& source = std::get<PanoramaSource>(settings.chain->sources.front());
  const int factor = source.reduction_factor;
  const double yaw_texels = settings.yaw_texels * factor;
  DepthMap finer = capture_depth(truth, settings.width_px * factor, yaw_texels, threads);
  blind(finer, source);
  SensorCounts unused;
  if (source.noise)  // of another moment than the texels'
    add_noise(finer, *source.noise, source.range, {.seed = settings.chain->seed, .frame = 1}, unused);
  PlaneSearch search;
  search.tolerance = std::max(search.tolerance, 3 * relative_sigma(settings));
  FittedModel fitted{.model = fit_coarse_model(finer, yaw_texels, search), .record = {}};
  fitted.record = judge(fitted.model, finer, yaw_texels, threads);
  return fitted;
}

/// Texels that a model leaves unexplained, and their neighbours, so that their mesh meets the model; all
/// others become holes, and in `map` the model's distances.
DepthMap left_over(DepthMap& map, double yaw_texels, const CoarseModel& model, int threads) {
  const auto at = [&](int row, int column) {
    return grid_index(row, (column + map.width_px) % map.width_px, map.width_px);
  };
  DepthMap rest = map;
  std::vector<char> explained(map.distance_m.size(), 0);
  run_parallel(map.height_px, threads, [&](int row) {
    for (int column = 0; column < map.width_px; ++column) {
      const Eigen::Vector3d direction =
          panorama_direction(column + yaw_texels + 0.5, row + 0.5, map.width_px, map.height_px);
      const std::size_t i = at(row, column);
      if (!explains(model, direction, map.distance_m[i])) continue;
      explained[i] = 1;
      map.distance_m[i] = static_cast<float>(distance_m(model, direction));
    }
  });
  for (int row = 0; row < map.height_px; ++row)
    for (int column = 0; column < map.width_px; ++column) {
      bool alone = true;
      for (int y = std::max(0, row - 1); y <= std::min(map.height_px - 1, row + 1); ++y)
        for (int x = column - 1; x <= column + 1; ++x) alone = alone && explained[at(y, x)] != 0;
      if (alone) rest.distance_m[at(row, column)] = sensors::hole;
    }
  return rest;
}

DepthMesh map_mesh(const DepthMap& map, const DepthSettings& settings, int threads) {
  DepthMesh mesh = build_depth_mesh(map, {.density = settings.mesh,
                                          .tolerance = mesh_tolerance(settings),
                                          .yaw_texels = settings.yaw_texels,
                                          .threads = threads});
  if (settings.chain->jumps != Jumps::cut) return mesh;
  return without_jumps(mesh, map, settings.yaw_texels, settings.chain->jump_ratio);
}

/// The lower median of the larger side of the largest jump; of all where none is by more than a tenth.
float middle_of_larger_side(std::vector<float>& distances_m) {
  constexpr float jump_ratio = 1.1F;
  std::sort(distances_m.begin(), distances_m.end());
  std::size_t first = 0, last = distances_m.size(), split = 0;
  float largest = jump_ratio;
  for (std::size_t i = 1; i < distances_m.size(); ++i) {
    if (is_hole(distances_m[i - 1])) break;
    const float ratio = distances_m[i] / distances_m[i - 1];
    if (ratio > largest) largest = ratio, split = i;
  }
  if (split > 0) (2 * split >= distances_m.size() ? last : first) = split;
  return distances_m[first + (last - first - 1) / 2];
}

}  // namespace

DepthMesh without_jumps(const DepthMesh& mesh, const DepthMap& map, double yaw_texels, double ratio) {
  const TexelJumps jumps(map, yaw_texels, ratio);
  constexpr std::uint32_t unused = 0xffffffff;
  DepthMesh kept{.vertices_m = {}, .triangles = {}, .max_relative_error = mesh.max_relative_error};
  std::vector<std::uint32_t> number(mesh.vertices_m.size(), unused);
  for (const Triangle& t : mesh.triangles) {
    if (jumps.at(mesh.vertices_m[t[0]], mesh.vertices_m[t[1]], mesh.vertices_m[t[2]])) continue;
    Triangle renumbered{};
    for (std::size_t i = 0; i < 3; ++i) {
      std::uint32_t& n = number[t[i]];
      if (n == unused) {
        n = static_cast<std::uint32_t>(kept.vertices_m.size());
        kept.vertices_m.push_back(mesh.vertices_m[t[i]]);
      }
      renumbered[i] = n;
    }
    kept.triangles.push_back(renumbered);
  }
  return kept;
}

DepthMap reduced(const DepthMap& finer, Reduction reduction, int factor, int threads) {
  DepthMap map{.width_px = finer.width_px / factor, .height_px = finer.height_px / factor, .distance_m = {}};
  map.distance_m.resize(static_cast<std::size_t>(map.width_px) * static_cast<std::size_t>(map.height_px));
  run_parallel(map.height_px, threads, [&](int row) {
    std::vector<float> under(static_cast<std::size_t>(factor) * static_cast<std::size_t>(factor));
    for (int column = 0; column < map.width_px; ++column) {
      auto next = under.begin();
      for (int y = row * factor; y < (row + 1) * factor; ++y)
        for (int x = column * factor; x < (column + 1) * factor; ++x) *next++ = finer.at(x, y);
      const auto middle = under.begin() + static_cast<std::ptrdiff_t>((under.size() - 1) / 2);
      const auto chosen = [&]() -> float {
        switch (reduction) {
          case Reduction::minimum:
            return *std::min_element(under.begin(), under.end());
          case Reduction::maximum:
            return *std::max_element(under.begin(), under.end());
          case Reduction::edge_aware:
            return middle_of_larger_side(under);
          case Reduction::median:
          case Reduction::sample:  // has a factor of 1
          case Reduction::boxes:   // reduces no texels
          case Reduction::jumps:   // nor do these
          case Reduction::budgeted:
            std::nth_element(under.begin(), middle, under.end());
            return *middle;
        }
        return sensors::hole;
      };
      map.distance_m[grid_index(row, column, map.width_px)] = chosen();
    }
  });
  return map;
}

SensorCounts panorama_counts(const Geometry& truth, DepthSettings settings, int threads) {
  settings.chain->repair = sensors::NoRepair{};
  return capture_panorama(truth, settings, threads).counts;
}

MeasuredPanorama panorama_mesh(const Geometry& truth, const DepthSettings& settings, int threads) {
  MeasuredMap captured = capture_panorama(truth, settings, threads);
  MeasuredPanorama made{.map = std::move(captured.map),
                        .mesh = {},
                        .counts = captured.counts,
                        .depth_error = captured.depth_error};
  if (!has_boxes(*settings.chain)) {
    made.mesh = map_mesh(made.map, settings, threads);
    return made;
  }
  const FittedModel fitted = fitted_model(truth, settings, threads);
  const DepthMap rest = left_over(made.map, settings.yaw_texels, fitted.model, threads);
  if (!std::all_of(rest.distance_m.begin(), rest.distance_m.end(), is_hole))
    made.mesh = map_mesh(rest, settings, threads);
  append(made.mesh, model_mesh(fitted.model));
  made.model = fitted.record;
  return made;
}

}  // namespace seamline::renderer
