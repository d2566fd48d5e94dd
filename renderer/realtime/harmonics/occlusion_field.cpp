#include "renderer/realtime/harmonics/occlusion_field.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "raytracer/common/parallel.h"
#include "renderer/realtime/harmonics/spherical_harmonics.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

/// A direction by latitude and longitude; `row` 0 is +Y.
Eigen::Vector3d direction_at(double row, double column, int latitudes, int longitudes) {
  const double polar = std::numbers::pi * row / (latitudes - 1),
               azimuth = 2 * std::numbers::pi * column / longitudes;
  return {std::sin(polar) * std::cos(azimuth), std::cos(polar), std::sin(polar) * std::sin(azimuth)};
}

/// The four crossings around a direction, and their weights.
struct Crossings {
  std::array<int, 2> rows, columns;
  float down, across;

  Crossings(const Eigen::Vector3f& direction, int latitudes, int longitudes) {
    const float row = std::acos(std::clamp(direction.y(), -1.0F, 1.0F)) / std::numbers::pi_v<float> *
                      static_cast<float>(latitudes - 1);
    const float turns = std::atan2(direction.z(), direction.x()) / (2 * std::numbers::pi_v<float>);
    const float column = (turns - std::floor(turns)) * static_cast<float>(longitudes);
    rows[0] = std::clamp(static_cast<int>(row), 0, latitudes - 2);
    rows[1] = rows[0] + 1;
    columns[0] = std::min(static_cast<int>(column), longitudes - 1);
    columns[1] = (columns[0] + 1) % longitudes;
    down = row - static_cast<float>(rows[0]);
    across = column - static_cast<float>(columns[0]);
  }
  template <class Add>
  void each(const Add& add) const {
    for (const int r : {0, 1})
      for (const int c : {0, 1})
        add(rows[r], columns[c], (r == 1 ? down : 1 - down) * (c == 1 ? across : 1 - across));
  }
};

/// Even directions within an angle of an axis: a spiral of the golden angle.
Eigen::Vector3f in_cone(const Eigen::Matrix3f& axes, int number, int count, float cosine) {
  constexpr float golden = 2.39996322972865F;
  const float z = 1.0F - (static_cast<float>(number) + 0.5F) / static_cast<float>(count) * (1.0F - cosine);
  const float flat = std::sqrt(std::max(0.0F, 1.0F - z * z));
  const float angle = golden * static_cast<float>(number);
  return axes * Eigen::Vector3f(flat * std::cos(angle), flat * std::sin(angle), z);
}

Eigen::Matrix3f frame_around(const Eigen::Vector3f& axis) {
  const Eigen::Vector3f aside =
      std::abs(axis.y()) < 0.9F ? Eigen::Vector3f::UnitY() : Eigen::Vector3f::UnitX();
  Eigen::Matrix3f axes;
  axes.col(0) = aside.cross(axis).normalized();
  axes.col(1) = axis.cross(axes.col(0));
  axes.col(2) = axis;
  return axes;
}

/// Samples one place: what is seen is everything but what is in the way.
class PlaceSampler {
 public:
  PlaceSampler(const FieldShape& shape, const AreBlocked& blocked, float things_radius_m, int rays)
      : shape_(shape),
        blocked_(blocked),
        things_radius_m_(things_radius_m),
        rays_(static_cast<std::size_t>(rays)),
        hits_(static_cast<std::size_t>(rays)),
        values_(static_cast<std::size_t>(coefficient_count(shape.bands))) {}

  void sample(const Eigen::Vector3f& place_m, std::span<float> out) {
    const Eigen::Vector3f to_centre = shape_.centre_m - place_m;
    const float distance_m = to_centre.norm();
    const bool outside = things_radius_m_ > 0.0F && distance_m > things_radius_m_;
    const float sine = outside ? things_radius_m_ / distance_m : 1.0F;
    const float cosine = outside ? std::sqrt(1.0F - sine * sine) : -1.0F;
    const Eigen::Matrix3f axes =
        frame_around(distance_m > 0.0F ? Eigen::Vector3f(to_centre / distance_m) : Eigen::Vector3f::UnitZ());
    for (std::size_t i = 0; i < rays_.size(); ++i)
      rays_[i] = {place_m, in_cone(axes, static_cast<int>(i), static_cast<int>(rays_.size()), cosine)};
    blocked_(rays_, hits_);
    const double weight_sr =
        2 * std::numbers::pi * (1.0 - static_cast<double>(cosine)) / static_cast<double>(rays_.size());
    std::vector<double> seen(values_.size(), 0.0);
    seen[0] = std::sqrt(4 * std::numbers::pi);
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      if (hits_[i] == 0) continue;
      evaluate_harmonics(shape_.bands, rays_[i].direction.cast<double>(), values_);
      for (std::size_t k = 0; k < seen.size(); ++k) seen[k] -= weight_sr * values_[k];
    }
    for (std::size_t k = 0; k < seen.size(); ++k) out[k] = static_cast<float>(seen[k]);
  }

 private:
  const FieldShape& shape_;
  const AreBlocked& blocked_;
  float things_radius_m_;
  std::vector<Ray> rays_;
  std::vector<std::uint8_t> hits_;
  std::vector<double> values_;
};

}  // namespace

OcclusionField sample_field(const FieldShape& shape, const AreBlocked& blocked, float things_radius_m,
                            int rays, int threads) {
  const auto count = static_cast<std::size_t>(coefficient_count(shape.bands));
  OcclusionField field{shape, std::vector<float>(shape.samples() * count)};
  const auto in_shell =
      static_cast<std::size_t>(shape.latitudes) * static_cast<std::size_t>(shape.longitudes);
  const auto rows = static_cast<int>(shape.radii_m.size()) * shape.latitudes;
  parallel_for(rows, threads, [&](int number) {
    PlaceSampler sampler(shape, blocked, things_radius_m, rays);
    const auto shell = static_cast<std::size_t>(number / shape.latitudes);
    const int row = number % shape.latitudes;
    for (int column = 0; column < shape.longitudes; ++column) {
      const Eigen::Vector3f direction =
          direction_at(row, column, shape.latitudes, shape.longitudes).cast<float>();
      const std::size_t place = shell * in_shell + grid_index(row, column, shape.longitudes);
      sampler.sample(shape.centre_m + shape.radii_m[shell] * direction,
                     std::span(field.visibility).subspan(place * count, count));
    }
  });
  return field;
}

bool look_up(const OcclusionField& field, const Eigen::Vector3f& place_m, std::span<float> out) {
  const FieldShape& shape = field.shape;
  const Eigen::Vector3f from_centre = place_m - shape.centre_m;
  const float radius_m = from_centre.norm();
  if (!(radius_m <= shape.radii_m.back())) return false;
  const auto above = std::upper_bound(shape.radii_m.begin(), shape.radii_m.end(), radius_m);
  const auto outer = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      above - shape.radii_m.begin(), 0, static_cast<std::ptrdiff_t>(shape.radii_m.size()) - 1));
  const std::size_t inner = outer > 0 ? outer - 1 : 0;
  const float share =
      outer == inner || radius_m <= shape.radii_m[inner]
          ? 0.0F
          : std::log(radius_m / shape.radii_m[inner]) / std::log(shape.radii_m[outer] / shape.radii_m[inner]);
  const Crossings crossings(
      radius_m > 0.0F ? Eigen::Vector3f(from_centre / radius_m) : Eigen::Vector3f::UnitY(), shape.latitudes,
      shape.longitudes);
  const auto count = static_cast<std::size_t>(coefficient_count(shape.bands));
  std::fill(out.begin(), out.end(), 0.0F);
  for (const auto& [shell, weight] : {std::pair(inner, 1.0F - share), std::pair(outer, share)}) {
    if (weight == 0.0F) continue;
    crossings.each([&, shell = shell, weight = weight](int row, int column, float part) {
      const std::size_t place =
          (shell * static_cast<std::size_t>(shape.latitudes) + static_cast<std::size_t>(row)) *
              static_cast<std::size_t>(shape.longitudes) +
          static_cast<std::size_t>(column);
      const float* from = &field.visibility[place * count];
      for (std::size_t k = 0; k < count; ++k) out[k] += weight * part * from[k];
    });
  }
  return true;
}

std::vector<float> shell_radii(float first_m, float last_m, int shells) {
  std::vector<float> radii_m;
  for (int i = 0; i < shells; ++i)
    radii_m.push_back(first_m *
                      std::pow(last_m / first_m,
                               shells > 1 ? static_cast<float>(i) / static_cast<float>(shells - 1) : 0.5F));
  if (shells > 1) radii_m.back() = last_m;
  return radii_m;
}

TransferCache::TransferCache(int bands, int latitudes)
    : bands_(bands), latitudes_(latitudes), longitudes_(2 * (latitudes - 1)) {
  const auto count = static_cast<std::size_t>(coefficient_count(bands));
  transfers_.resize(static_cast<std::size_t>(latitudes_) * static_cast<std::size_t>(longitudes_) * count);
  const std::vector<double> of_bands = clamped_cosine_bands(bands);
  std::vector<double> values(count);
  std::size_t place = 0;
  for (int row = 0; row < latitudes_; ++row)
    for (int column = 0; column < longitudes_; ++column) {
      evaluate_harmonics(bands, direction_at(row, column, latitudes_, longitudes_), values);
      for (int l = 0, k = 0; l < bands; ++l)
        for (int m = -l; m <= l; ++m, ++k) transfers_[place++] = static_cast<float>(of_bands[l] * values[k]);
    }
}

void TransferCache::look_up(const Eigen::Vector3f& normal, std::span<float> out) const {
  const Crossings crossings(normal, latitudes_, longitudes_);
  const auto count = static_cast<std::size_t>(coefficient_count(bands_));
  std::fill(out.begin(), out.end(), 0.0F);
  crossings.each([&](int row, int column, float weight) {
    const float* from = &transfers_[grid_index(row, column, longitudes_) * count];
    for (std::size_t k = 0; k < count; ++k) out[k] += weight * from[k];
  });
}

float field_attenuation(const TripleTable& table, std::span<const float> light,
                        std::span<const float> transfer, std::span<const float> visibility) {
  std::array<float, most_bands * most_bands> product;
  const auto count = static_cast<std::size_t>(coefficient_count(table.bands));
  const std::span<float> hidden(product.data(), count);
  multiply_harmonics(table, transfer, visibility, hidden);
  float with = 0, without = 0;
  for (std::size_t k = 0; k < count; ++k) {
    with += light[k] * hidden[k];
    without += light[k] * transfer[k];
  }
  return without > 0.0F ? std::clamp(with / without, 0.0F, 1.0F) : 1.0F;
}

}  // namespace seamline::renderer
