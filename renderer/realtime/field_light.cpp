#include "renderer/realtime/field_light.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "raytracer/common/parallel.h"
#include "renderer/realtime/depth_normals.h"
#include "renderer/realtime/harmonics/spherical_harmonics.h"
#include "support/arithmetic/grid_index.h"

namespace seamline::renderer {
namespace {

constexpr std::size_t most_vertices = 20000;
constexpr float off_surface = 1e-4F;  ///< of the object's size, where a vertex' rays start

using Coefficients = std::array<float, most_bands * most_bands>;

std::array<int, 3> cell_of(const VertexTransfers& transfers, const Eigen::Vector3f& point_m) {
  std::array<int, 3> cell{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<Eigen::Index>(axis);
    cell[axis] = std::clamp(static_cast<int>((point_m[i] - transfers.corner_m[i]) / transfers.cell_m), 0,
                            transfers.cells[axis] - 1);
  }
  return cell;
}

std::size_t number_of(const VertexTransfers& transfers, const std::array<int, 3>& cell) {
  return grid_index(cell[2], cell[1], transfers.cells[1]) * static_cast<std::size_t>(transfers.cells[0]) +
         static_cast<std::size_t>(cell[0]);
}

/// Takes vertices evenly from all meshes, with their mean normals.
void take_vertices(std::span<const TriangleSpan> object, VertexTransfers& out) {
  std::size_t all = 0;
  for (const TriangleSpan& mesh : object) all += mesh.positions_m.size();
  const std::size_t step = (all + most_vertices - 1) / most_vertices;
  std::size_t number = 0;
  for (const TriangleSpan& mesh : object) {
    const std::vector<Eigen::Vector3f> normals = triangle_mean_normals(mesh);
    for (std::size_t i = 0; i < normals.size(); ++i, ++number)
      if (number % std::max<std::size_t>(step, 1) == 0 && !normals[i].isZero()) {
        out.positions_m.push_back(mesh.positions_m[i]);
        out.normals.push_back(normals[i]);
      }
  }
}

/// Sorts vertices into cells of about four on a surface.
void sort_into_cells(VertexTransfers& out) {
  Eigen::Array3f least = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity()), most = -least;
  for (const Eigen::Vector3f& position_m : out.positions_m) {
    least = least.min(position_m.array());
    most = most.max(position_m.array());
  }
  if (out.positions_m.empty()) least = most = 0.0F;
  const Eigen::Array3f size = (most - least).max(1e-6F);
  const float area = 2 * (size[0] * size[1] + size[1] * size[2] + size[2] * size[0]);
  const auto count = static_cast<float>(std::max<std::size_t>(out.positions_m.size(), 1));
  out.cell_m = std::max(std::sqrt(4 * area / count), size.maxCoeff() / 256);
  out.corner_m = least.matrix();
  std::size_t cells = 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    out.cells[axis] = static_cast<int>(size[static_cast<Eigen::Index>(axis)] / out.cell_m) + 1;
    cells *= static_cast<std::size_t>(out.cells[axis]);
  }
  out.starts.assign(cells + 1, 0);
  for (const Eigen::Vector3f& position_m : out.positions_m)
    ++out.starts[number_of(out, cell_of(out, position_m)) + 1];
  for (std::size_t i = 0; i < cells; ++i) out.starts[i + 1] += out.starts[i];
  std::vector<std::uint32_t> next(out.starts.begin(), out.starts.end() - 1);
  out.members.resize(out.positions_m.size());
  for (std::size_t i = 0; i < out.positions_m.size(); ++i)
    out.members[next[number_of(out, cell_of(out, out.positions_m[i]))]++] = static_cast<std::uint32_t>(i);
}

/// Directions over a hemisphere, evenly, about +Z.
std::vector<Eigen::Vector3f> hemisphere(int rays) {
  constexpr float golden = 2.39996322972865F;
  std::vector<Eigen::Vector3f> out;
  for (int i = 0; i < rays; ++i) {
    const float z = (static_cast<float>(i) + 0.5F) / static_cast<float>(rays);
    const float flat = std::sqrt(1 - z * z), angle = golden * static_cast<float>(i);
    out.emplace_back(flat * std::cos(angle), flat * std::sin(angle), z);
  }
  return out;
}

Eigen::Matrix3f frame_about(const Eigen::Vector3f& axis) {
  Eigen::Matrix3f axes;
  axes.col(0) = (std::abs(axis.y()) < 0.9F ? Eigen::Vector3f::UnitY() : Eigen::Vector3f::UnitX())
                    .cross(axis)
                    .normalized();
  axes.col(1) = axis.cross(axes.col(0));
  axes.col(2) = axis;
  return axes;
}

Rgb inner(const FieldLight& fields, std::span<const float> transfer) {
  Rgb sum = Rgb::Zero();
  for (int channel = 0; channel < 3; ++channel) {
    const std::vector<float>& light = fields.light[channel];
    for (std::size_t k = 0; k < transfer.size(); ++k) sum[channel] += light[k] * transfer[k];
  }
  return sum;
}

}  // namespace

VertexTransfers sample_transfers(std::span<const TriangleSpan> object, const AreBlocked& blocked, int bands,
                                 int rays, int threads) {
  VertexTransfers out;
  out.bands = bands;
  take_vertices(object, out);
  sort_into_cells(out);
  const auto count = static_cast<std::size_t>(coefficient_count(bands));
  out.transfers.resize(out.positions_m.size() * count);
  const std::vector<double> of_bands = clamped_cosine_bands(bands);
  const std::vector<Eigen::Vector3f> directions = hemisphere(rays);
  const float off_m =
      off_surface * out.cell_m * static_cast<float>(std::max({out.cells[0], out.cells[1], out.cells[2]}));
  constexpr std::size_t at_a_time = 64;
  const auto parts = static_cast<int>((out.positions_m.size() + at_a_time - 1) / at_a_time);
  parallel_for(parts, threads, [&](int part) {
    std::vector<Ray> asked(directions.size());
    std::vector<std::uint8_t> hits(directions.size());
    std::vector<double> values(count), sum(count);
    const std::size_t first = static_cast<std::size_t>(part) * at_a_time;
    for (std::size_t i = first; i < std::min(out.positions_m.size(), first + at_a_time); ++i) {
      const Eigen::Matrix3f axes = frame_about(out.normals[i]);
      for (std::size_t r = 0; r < directions.size(); ++r)
        asked[r] = {out.positions_m[i] + off_m * out.normals[i], axes * directions[r]};
      blocked(asked, hits);
      // All that would arrive, less what is hidden.
      evaluate_harmonics(bands, out.normals[i].cast<double>(), values);
      for (int l = 0, k = 0; l < bands; ++l)
        for (int m = -l; m <= l; ++m, ++k) sum[k] = of_bands[l] * values[k];
      for (std::size_t r = 0; r < directions.size(); ++r) {
        if (hits[r] == 0) continue;
        evaluate_harmonics(bands, asked[r].direction.cast<double>(), values);
        const double weight =
            2 * std::numbers::pi / static_cast<double>(rays) * static_cast<double>(directions[r].z());
        for (std::size_t k = 0; k < count; ++k) sum[k] -= weight * values[k];
      }
      for (std::size_t k = 0; k < count; ++k) out.transfers[i * count + k] = static_cast<float>(sum[k]);
    }
  });
  return out;
}

void look_up(const VertexTransfers& transfers, const TransferCache& unhidden, const Eigen::Vector3f& point_m,
             const Eigen::Vector3f& normal, std::span<float> out) {
  const std::array<int, 3> middle = cell_of(transfers, point_m);
  std::fill(out.begin(), out.end(), 0.0F);
  float weights = 0;
  for (int z = std::max(middle[2] - 1, 0); z <= std::min(middle[2] + 1, transfers.cells[2] - 1); ++z)
    for (int y = std::max(middle[1] - 1, 0); y <= std::min(middle[1] + 1, transfers.cells[1] - 1); ++y)
      for (int x = std::max(middle[0] - 1, 0); x <= std::min(middle[0] + 1, transfers.cells[0] - 1); ++x) {
        const std::size_t cell = number_of(transfers, {x, y, z});
        for (std::uint32_t m = transfers.starts[cell]; m < transfers.starts[cell + 1]; ++m) {
          const std::size_t vertex = transfers.members[m];
          const float facing = transfers.normals[vertex].dot(normal);
          const float near = 1.0F - (transfers.positions_m[vertex] - point_m).squaredNorm() /
                                        (transfers.cell_m * transfers.cell_m);
          if (!(facing > 0.3F) || !(near > 0.0F)) continue;
          const float weight = facing * near * near;
          weights += weight;
          for (std::size_t k = 0; k < out.size(); ++k)
            out[k] += weight * transfers.transfers[vertex * out.size() + k];
        }
      }
  if (!(weights > 0.0F)) return unhidden.look_up(normal, out);
  for (float& value : out) value /= weights;
}

std::array<std::vector<float>, 3> light_harmonics(const Light& light, int bands) {
  const auto count = static_cast<std::size_t>(coefficient_count(bands));
  std::array<std::vector<double>, 3> sums;
  for (std::vector<double>& sum : sums) sum.assign(count, 0.0);
  std::vector<double> values(count);
  const auto add = [&](const Eigen::Vector3d& direction, const Eigen::Array3d& weight) {
    evaluate_harmonics(bands, direction, values);
    for (std::size_t channel = 0; channel < 3; ++channel)
      for (std::size_t k = 0; k < count; ++k)
        sums[channel][k] += weight[static_cast<Eigen::Index>(channel)] * values[k];
  };
  for (const Sun& sun : light.suns)
    add(sun.to_sun.cast<double>().normalized(), sun.irradiance_w_m2.cast<double>());
  for (std::size_t channel = 0; channel < 3; ++channel)
    sums[channel][0] += std::sqrt(4 * std::numbers::pi) *
                        static_cast<double>(light.environment_radiance[static_cast<Eigen::Index>(channel)]);
  if (light.environment) {
    const EnvironmentMap& map = *light.environment;
    for (int row = 0; row < map.height_px(); ++row) {
      const double texel_sr = 2 * std::numbers::pi / map.width_px() *
                              (std::cos(std::numbers::pi * row / map.height_px()) -
                               std::cos(std::numbers::pi * (row + 1) / map.height_px()));
      for (int column = 0; column < map.width_px(); ++column)
        add(map.direction_of(column + 0.5, row + 0.5), map.texel(column, row).cast<double>() * texel_sr);
    }
  }
  std::array<std::vector<float>, 3> out;
  for (std::size_t channel = 0; channel < 3; ++channel)
    out[channel].assign(sums[channel].begin(), sums[channel].end());
  return out;
}

Rgb field_shadow(const FieldLight& fields, const Eigen::Vector3f& point_m, const Eigen::Vector3f& normal) {
  const int bands = fields.object.shape.bands;
  const auto count = static_cast<std::size_t>(coefficient_count(bands));
  Coefficients visible, transfer;
  const std::span<float> seen(visible.data(), count), unhidden(transfer.data(), count);
  if (!look_up(fields.object, point_m, seen)) return Rgb::Ones();
  fields.unhidden.look_up(normal, unhidden);
  Rgb out;
  for (int channel = 0; channel < 3; ++channel)
    out[channel] = field_attenuation(triple_table(bands), fields.light[channel], unhidden, seen);
  return out;
}

Rgb field_irradiance(const FieldLight& fields, const Eigen::Vector3f& point_m,
                     const Eigen::Vector3f& normal) {
  const int bands = fields.real.shape.bands;
  const auto count = static_cast<std::size_t>(coefficient_count(bands));
  Coefficients own, visible, product;
  const std::span<float> transfer(own.data(), count), seen(visible.data(), count),
      both(product.data(), count);
  look_up(fields.self, fields.unhidden, point_m, normal, transfer);
  if (!look_up(fields.real, point_m, seen)) return inner(fields, transfer).max(0.0F);
  multiply_harmonics(triple_table(bands), transfer, seen, both);
  return inner(fields, both).max(0.0F);
}

}  // namespace seamline::renderer
