#include "sensors/repair/planes.h"

#include <fmt/core.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <optional>

#include "support/arithmetic/random.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::size_t most_judges = 20000;  ///< pixels that samples are judged by
constexpr int fits_of_sample = 4, fits_at_end = 8;

/// A measured pixel as planes see it.
struct PlanePixel {
  Vector3d metre;  ///< m: the point of its ray whose depth is 1 m
  double depth_m = 0;
  double tolerance_m = 0;
  std::size_t index = 0;
  int column = 0, row = 0;
};

std::vector<PlanePixel> measured_pixels(const DepthFrame& frame, const PlaneRepair& repair) {
  std::vector<PlanePixel> pixels;
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < frame.camera.width_px; ++column) {
      const auto point_m = point_of_pixel(frame, column, row);
      if (!point_m) continue;
      const double depth_m = frame.at(column, row);
      pixels.push_back({.metre = *point_m / depth_m,
                        .depth_m = depth_m,
                        .tolerance_m = repair.tolerance_m + repair.tolerance_relative * depth_m,
                        .index = frame.index(column, row),
                        .column = column,
                        .row = row});
    }
  return pixels;
}

/// The depth of the plane on the pixel's ray; none where the ray does not meet it before the camera.
std::optional<double> plane_depth_m(const Vector3d& plane, const PlanePixel& pixel) {
  const double inverse = plane.dot(pixel.metre);
  if (!(inverse > 1e-9)) return std::nullopt;
  return 1 / inverse;
}

bool supports(const PlanePixel& pixel, const Vector3d& plane) {
  const auto depth_m = plane_depth_m(plane, pixel);
  return depth_m && std::abs(*depth_m - pixel.depth_m) <= pixel.tolerance_m;
}

std::int64_t support(const std::vector<PlanePixel>& pixels, const Vector3d& plane) {
  return std::count_if(pixels.begin(), pixels.end(),
                       [&](const PlanePixel& pixel) { return supports(pixel, plane); });
}

/// One step of Gauss and Newton on the plane's present support.
std::optional<Vector3d> fitted(const std::vector<PlanePixel>& pixels, const Vector3d& plane) {
  Matrix3d normal = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero();
  for (const PlanePixel& pixel : pixels) {
    if (!supports(pixel, plane)) continue;
    const double depth_m = *plane_depth_m(plane, pixel);
    const Vector3d slope = -depth_m * depth_m / pixel.tolerance_m * pixel.metre;
    normal += slope * slope.transpose();
    right += slope * ((pixel.depth_m - depth_m) / pixel.tolerance_m);
  }
  const Eigen::LDLT<Matrix3d> solver(normal);
  if (solver.info() != Eigen::Success || !(solver.rcond() > 1e-14)) return std::nullopt;
  const Vector3d next = plane + solver.solve(right);
  if (!next.allFinite()) return std::nullopt;
  return next;
}

Vector3d fitted_often(const std::vector<PlanePixel>& pixels, Vector3d plane, int times) {
  for (int time = 0; time < times; ++time)
    if (const auto next = fitted(pixels, plane)) plane = *next;
  return plane;
}

/// A plane through three pixels of one neighbourhood.
std::optional<Vector3d> sampled_plane(const std::vector<PlanePixel>& pixels, int reach_px, Random& random) {
  const auto any = [&]() -> const PlanePixel& { return pixels[random.below(pixels.size())]; };
  const PlanePixel& first = any();
  // Pixels lie row by row: those of the rows within reach are one stretch.
  const auto row_before = [](const PlanePixel& pixel, int row) { return pixel.row < row; };
  const auto begin =
      std::lower_bound(pixels.begin(), pixels.end(), first.row - reach_px, row_before) - pixels.begin();
  const auto end =
      std::lower_bound(pixels.begin(), pixels.end(), first.row + reach_px + 1, row_before) - pixels.begin();
  const PlanePixel* others[2] = {nullptr, nullptr};
  for (const PlanePixel*& other : others)
    for (int tries = 0; tries < 50 && other == nullptr; ++tries) {
      const auto& candidate = pixels[static_cast<std::size_t>(begin) + random.below(end - begin)];
      if (std::abs(candidate.column - first.column) <= reach_px) other = &candidate;
    }
  if (others[0] == nullptr || others[1] == nullptr) return std::nullopt;
  Matrix3d rays;
  rays << first.metre.transpose(), others[0]->metre.transpose(), others[1]->metre.transpose();
  const Vector3d inverses(1 / first.depth_m, 1 / others[0]->depth_m, 1 / others[1]->depth_m);
  const Eigen::FullPivLU<Matrix3d> solver(rays);
  if (!solver.isInvertible()) return std::nullopt;
  const Vector3d plane = solver.solve(inverses);
  if (!plane.allFinite()) return std::nullopt;
  return plane;
}

std::vector<PlanePixel> judges_of(const std::vector<PlanePixel>& pixels) {
  const std::size_t stride = 1 + pixels.size() / most_judges;
  std::vector<PlanePixel> judges;
  for (std::size_t i = 0; i < pixels.size(); i += stride) judges.push_back(pixels[i]);
  return judges;
}

/// The best supported plane that was met, fitted to all its support; none when no sample gave one.
std::optional<Vector3d> best_plane(const std::vector<PlanePixel>& pixels, int reach_px, int draws,
                                   Random& random) {
  const std::vector<PlanePixel> judges = judges_of(pixels);
  std::optional<Vector3d> best;
  std::int64_t best_support = 0;
  for (int draw = 0; draw < draws; ++draw) {
    const auto sample = sampled_plane(pixels, reach_px, random);
    if (!sample) continue;
    if (support(judges, *sample) <= best_support / 4) continue;  // fitting brings in more, but not so many
    const Vector3d plane = fitted_often(judges, *sample, fits_of_sample);
    if (const std::int64_t found = support(judges, plane); found > best_support) {
      best_support = found;
      best = plane;
    }
  }
  if (best) best = fitted_often(pixels, *best, fits_at_end);
  return best;
}

}  // namespace

void require_valid(const PlaneRepair& repair, const std::string& where) {
  const auto require = [&](double value, double lowest, double highest, const char* field) {
    if (value >= lowest && value <= highest) return;
    throw input_error({.file = {},
                       .field = where + field,
                       .wanted = fmt::format("a number from {:g} to {:g}", lowest, highest),
                       .found = fmt::format("{:g}", value)});
  };
  require(repair.most_planes, 1, 1000, "most_planes");
  require(repair.least_share, 1e-4, 1, "least_share");
  require(repair.tolerance_m, 1e-6, 1e3, "tolerance_m");
  require(repair.tolerance_relative, 0, 1, "tolerance_relative");
  require(repair.draws, 1, 1e6, "draws");
}

RepairedPlanes replace_planes(const DepthFrame& measured, const PlaneRepair& repair) {
  require_valid(repair, "planes: ");
  std::vector<PlanePixel> pixels = measured_pixels(measured, repair);
  const double least = std::max(3.0, repair.least_share * measured.depth_m.size());
  const int reach_px = std::max(3, measured.camera.width_px / 12);
  std::vector<float> depth_m = measured.depth_m;
  RepairedPlanes result;
  result.plane_of_pixel.assign(measured.depth_m.size(), -1);
  Random random(repair.seed);
  while (std::ssize(result.planes) < repair.most_planes && pixels.size() >= least) {
    const auto plane = best_plane(pixels, reach_px, repair.draws, random);
    if (!plane) break;
    const auto rest = std::stable_partition(
        pixels.begin(), pixels.end(), [&](const PlanePixel& pixel) { return !supports(pixel, *plane); });
    if (pixels.end() - rest < least) break;
    for (auto pixel = rest; pixel != pixels.end(); ++pixel) {
      depth_m[pixel->index] = static_cast<float>(*plane_depth_m(*plane, *pixel));
      result.plane_of_pixel[pixel->index] = static_cast<int>(result.planes.size());
    }
    result.planes.push_back({*plane, pixels.end() - rest});
    pixels.erase(rest, pixels.end());
  }
  result.repaired = repaired_frame(measured, std::move(depth_m));
  return result;
}

}  // namespace seamline::sensors
