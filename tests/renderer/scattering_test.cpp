#include "raytracer/material/scattering.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "raytracer/light/light.h"
#include "raytracer/material/microfacets.h"
#include "raytracer/material/reflectance_table.h"
#include "support/arithmetic/random.h"
#include "tests/sensors/distributions.h"

namespace seamline::renderer {
namespace {

/// No axis of the world, so that frames are used.
Eigen::Vector3f a_normal() {
  return Eigen::Vector3f(0.3F, -0.5F, 0.7F).normalized();
}

Eigen::Vector3f direction(const Eigen::Vector3f& normal, double cosine, double angle) {
  const double sine = std::sqrt(std::max(0.0, 1 - cosine * cosine));
  return (local_axes(normal) *
          Eigen::Vector3d(sine * std::cos(angle), sine * std::sin(angle), cosine).cast<float>())
      .normalized();
}

Eigen::Vector3f view_at(double degrees) {
  return direction(a_normal(), std::cos(degrees * std::numbers::pi / 180), 0.4);
}

Scatterer metal(double roughness, double f0 = 1) {
  return {Rgb::Zero(), Rgb::Constant(static_cast<float>(f0)), static_cast<float>(roughness * roughness)};
}
Scatterer dielectric(double roughness, double albedo = 1) {
  return {Rgb::Constant(static_cast<float>(albedo)), Rgb::Constant(0.04F),
          static_cast<float>(roughness * roughness)};
}
Scatterer half_metal(double roughness) {
  return {Rgb(0.5F, 0.2F, 0.05F), Rgb(0.52F, 0.22F, 0.07F), static_cast<float>(roughness * roughness)};
}

std::vector<double> all_roughness() {
  std::vector<double> all{0, 0.01, 0.02, 0.035, 0.05};
  for (int i = 2; i <= 20; ++i) all.push_back(0.05 * i);
  return all;
}

/// Point `i` of Roberts' sequence in the unit square.
std::array<double, 2> even_point(int i) {
  const double a = 0.5 + i * 0.7548776662466927, b = 0.5 + i * 0.5698402909980532;
  return {a - std::floor(a), b - std::floor(b)};
}

/// int (share, density) over the hemisphere, without the sampler: points even in mirrors' normals and points
/// even in the cosine, each counted by the density of both.
struct Integral {
  double share = 0, density = 0;
};
Integral integrate(const Scatterer& surface, const Eigen::Vector3f& to_viewer, int points) {
  const Eigen::Vector3f n = a_normal();
  const auto alpha = std::max(surface.alpha, least_alpha);
  Integral sum;
  const auto add = [&](const Eigen::Vector3f& to_light, const Eigen::Vector3f& mirror) {
    const float mu_i = n.dot(to_light), c = mirror.dot(to_viewer);
    if (!(mu_i > 0) || !(c > 0)) return;
    const float cosine = mirror.dot(n);
    const float squared_sine = (mirror - cosine * n).squaredNorm();
    const double both =
        mirror_density(squared_sine, alpha) * cosine / (4 * c) + mu_i / std::numbers::pi_v<float>;
    const ScatteredLight light = scattered_light(surface, n, to_viewer, to_light);
    sum.share += double{light.share[0]} / both / points;
    sum.density += light.density / both / points;
  };
  for (int i = 0; i < points; ++i) {
    const auto [u, turn] = even_point(i);
    const double angle = 2 * std::numbers::pi * turn, tangent = alpha * std::sqrt(u / (1 - u));
    const Eigen::Vector3f mirror = direction(n, 1 / std::sqrt(1 + tangent * tangent), angle);
    add(2 * mirror.dot(to_viewer) * mirror - to_viewer, mirror);
    const Eigen::Vector3f even = direction(n, std::sqrt(u), angle);
    add(even, (even + to_viewer).normalized());
  }
  return sum;
}

struct Sampled {
  double weight = 0;  ///< mean
  double found = 0;   ///< samples that have a direction
};
Sampled sample_often(const Scatterer& surface, const Eigen::Vector3f& to_viewer, int samples) {
  Sampled sum;
  for (int i = 0; i < samples; ++i) {
    const auto [a, b] = even_point(i);
    const Eigen::Array2f point(static_cast<float>(a), static_cast<float>(b));
    const auto next = sample_scattering(surface, a_normal(), to_viewer, point.min(0x1.fffffep-1F));
    if (!next) continue;
    sum.weight += double{next->weight[0]} / samples;
    sum.found += 1.0 / samples;
  }
  return sum;
}

TEST(Scattering, AWhiteSurfaceInWhiteLightIsWhite) {
  for (const double roughness : all_roughness())
    for (const double degrees : {0.0, 20.0, 40.0, 60.0, 75.0, 80.0, 85.0})
      for (const Scatterer& surface : {metal(roughness), dielectric(roughness)}) {
        EXPECT_NEAR(sample_often(surface, view_at(degrees), 10000).weight, 1, 0.01)
            << "sampled, f0 " << surface.f0[0] << ", roughness " << roughness << ", " << degrees
            << " degrees";
        EXPECT_NEAR(integrate(surface, view_at(degrees), 5000).share, 1, 0.01)
            << "summed up, f0 " << surface.f0[0] << ", roughness " << roughness << ", " << degrees
            << " degrees";
      }
}

TEST(Scattering, NoEnergyIsGainedAndSamplesFindWhatTheSumFinds) {
  for (const double roughness : {0.0, 0.03, 0.1, 0.23, 0.4, 0.57, 0.71, 0.9, 1.0})
    for (const double degrees : {0.0, 30.0, 60.0, 80.0, 87.0, 89.5})
      for (const Scatterer& surface : {metal(roughness), metal(roughness, 0.3), dielectric(roughness),
                                       dielectric(roughness, 0.2), half_metal(roughness)}) {
        const double sampled = sample_often(surface, view_at(degrees), 10000).weight;
        const double summed = integrate(surface, view_at(degrees), 20000).share;
        EXPECT_LE(sampled, 1.001) << roughness << " " << degrees << " " << surface.f0[0];
        EXPECT_NEAR(sampled, summed, 0.004) << roughness << " " << degrees << " " << surface.f0[0];
      }
}

TEST(Scattering, TheDensitySumsUpToTheSamplesThatHaveADirection) {
  for (const double roughness : {0.05, 0.3, 0.6, 1.0})
    for (const double degrees : {0.0, 45.0, 80.0, 89.0})
      for (const Scatterer& surface : {metal(roughness), dielectric(roughness), half_metal(roughness)})
        EXPECT_NEAR(integrate(surface, view_at(degrees), 40000).density,
                    sample_often(surface, view_at(degrees), 20000).found, 0.004)
            << roughness << " " << degrees << " " << surface.f0[0];
}

/// Counts in cells even in the root of 1 - cosine, beside the density summed up over each.
TEST(Scattering, SamplesFollowTheirDensity) {
  constexpr int rows = 16, columns = 32, inside = 16, samples = 60000;
  // A lobe seen at a grazing angle is narrow across.
  const Eigen::Vector3f n = a_normal();
  Random random(2024);
  for (const double roughness : {0.2, 0.35, 0.6, 1.0})
    for (const double degrees : {0.0, 40.0, 70.0, 85.0})
      for (const Scatterer& surface : {metal(roughness), dielectric(roughness), half_metal(roughness)}) {
        const Eigen::Vector3f to_viewer = view_at(degrees);
        const int across = roughness < 0.3 && degrees > 60 ? 80 : inside;
        std::vector<double> expected(rows * columns + 1), found(rows * columns + 1);
        double all = 0;
        for (int cell = 0; cell < rows * columns; ++cell)
          for (int i = 0; i < inside; ++i)
            for (int k = 0; k < across; ++k) {
              const double root = (cell / columns + (i + 0.5) / inside) / rows;
              const double angle = 2 * std::numbers::pi * (cell % columns + (k + 0.5) / across) / columns;
              expected[static_cast<std::size_t>(cell)] +=
                  scattering_density(surface, n, to_viewer, direction(n, 1 - root * root, angle)) * 2 * root *
                  2 * std::numbers::pi / (rows * columns * inside * across) * samples;
            }
        for (const double count : expected) all += count;
        expected.back() = std::max(0.0, samples - all);  // below the surface
        const Eigen::Matrix3f axes = local_axes(n);
        for (int i = 0; i < samples; ++i) {
          const Eigen::Array2f point(static_cast<float>(random.uniform()) * 0x1.fffffep-1F,
                                     static_cast<float>(random.uniform()) * 0x1.fffffep-1F);
          const auto next = sample_scattering(surface, n, to_viewer, point);
          if (!next) {
            ++found.back();
            continue;
          }
          const Eigen::Vector3f local = axes.transpose() * next->direction;
          const double turn = std::atan2(local.y(), local.x()) / (2 * std::numbers::pi);
          const double root = std::sqrt(std::max(0.0F, 1 - local.z()));
          const int row = std::min(rows - 1, static_cast<int>(root * rows));
          const int column = std::min(columns - 1, static_cast<int>((turn < 0 ? turn + 1 : turn) * columns));
          ++found[static_cast<std::size_t>(row * columns + column)];
        }
        std::vector<double> kept_found{0}, kept_expected{0};  // cells of fewer than 10 go together
        for (std::size_t i = 0; i < expected.size(); ++i) {
          if (expected[i] < 10) {
            kept_found[0] += found[i];
            kept_expected[0] += expected[i];
          } else {
            kept_found.push_back(found[i]);
            kept_expected.push_back(expected[i]);
          }
        }
        if (kept_expected[0] < 10) {
          EXPECT_LE(kept_found[0], kept_expected[0] + 5 * std::sqrt(kept_expected[0]) + 5);
          kept_found.erase(kept_found.begin());
          kept_expected.erase(kept_expected.begin());
        }
        EXPECT_LT(sensors::testing::chi_squared_ratio(kept_found, kept_expected), 1)
            << roughness << " " << degrees << " " << surface.f0[0];
      }
}

TEST(Scattering, ViewerAndLightMayBeExchanged) {
  Random random(7);
  const Eigen::Vector3f n = a_normal();
  for (int i = 0; i < 20000; ++i) {
    const double roughness = random.uniform();
    const Eigen::Vector3f a = direction(n, 0.001 + 0.999 * random.uniform(), 7 * random.uniform());
    const Eigen::Vector3f b = direction(n, 0.001 + 0.999 * random.uniform(), 7 * random.uniform());
    const Scatterer surface = half_metal(roughness);
    const Rgb there = scattered_share(surface, n, a, b) * n.dot(a),
              back = scattered_share(surface, n, b, a) * n.dot(b);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(there[c], back[c], 1e-5F * there[c]) << roughness;
  }
}

/// What is Lambert's stays what it was, bit for bit.
TEST(Scattering, WithoutALayerItIsTheCosineAlone) {
  Random random(11);
  for (int i = 0; i < 2000; ++i) {
    const auto number = [&] { return static_cast<float>(random.uniform()); };
    const Eigen::Vector3f n = Eigen::Vector3f(number() - 0.5F, number() - 0.5F, number() - 0.5F).normalized();
    const Eigen::Vector3f to_light =
        Eigen::Vector3f(number() - 0.5F, number() - 0.5F, number() - 0.5F).normalized();
    const Scatterer surface{Rgb(number(), number(), number())};
    const Eigen::Array2f point(number() * 0.999F, number() * 0.999F);
    const float cosine = std::max(0.0F, n.dot(to_light));
    EXPECT_TRUE((scattered_share(surface, n, -to_light, to_light) ==
                 surface.albedo * (std::numbers::inv_pi_v<float> * cosine))
                    .all());
    const auto next = sample_scattering(surface, n, n, point);
    ASSERT_TRUE(next);
    EXPECT_EQ(next->direction, cosine_weighted(n, point));
    EXPECT_TRUE((next->weight == surface.albedo).all());
    EXPECT_FALSE(next->specular_lobe);
  }
}

TEST(Scattering, AMirrorMirrors) {
  const Eigen::Vector3f n = a_normal();
  for (const double degrees : {0.0, 30.0, 85.0, 89.9}) {
    const Eigen::Vector3f to_viewer = view_at(degrees), mirrored = 2 * n.dot(to_viewer) * n - to_viewer;
    int sharp = 0, count = 0;
    for (int i = 0; i < 1000; ++i) {
      const auto next = sample_scattering(metal(0), n, to_viewer, {static_cast<float>(i) / 1000, 0.37F});
      if (!next) continue;
      ++count;
      if ((next->direction - mirrored).norm() < 0.01F) ++sharp;
    }
    EXPECT_GT(count, 970);
    EXPECT_GT(sharp, 970);
  }
}

TEST(Scattering, NothingIsNoNumberHoweverExtreme) {
  const Eigen::Vector3f n = a_normal();
  const std::array cosines = {-1.0, -1e-3, 0.0, 1e-30, 1e-9, 1e-6, 1e-3, 0.3, 1.0};
  const std::array points = {0.0F, 1e-30F, 1e-7F, 0.25F, 0.5F, 0.75F, 0x1.fffffep-1F};
  for (const float alpha : {-1.0F, 0.0F, 1e-20F, 1e-4F, 1e-3F, 0.3F, 1.0F, 7.0F})
    for (const float f0 : {1e-30F, 1e-6F, 0.04F, 0.999999F, 1.0F})
      for (const float albedo : {0.0F, 1.0F})
        for (const double cosine : cosines) {
          const Scatterer surface{Rgb::Constant(albedo), Rgb::Constant(f0), alpha};
          const Eigen::Vector3f to_viewer = direction(n, cosine, 1.0);
          for (const double other : cosines)
            for (const double angle : {1.0, 1.0 + 1e-7, 2.0, 1.0 + std::numbers::pi}) {
              const ScatteredLight light = scattered_light(surface, n, to_viewer, direction(n, other, angle));
              ASSERT_TRUE(light.share.isFinite().all() && (light.share >= 0).all()) << alpha << " " << cosine;
              ASSERT_TRUE(std::isfinite(light.density) && light.density >= 0) << alpha << " " << cosine;
              ASSERT_TRUE((light.share == 0).all() || light.density > 0);
            }
          for (const float a : points)
            for (const float b : points) {
              const auto next = sample_scattering(surface, n, to_viewer, {a, b});
              if (!next) continue;
              ASSERT_TRUE(next->weight.isFinite().all() && (next->weight >= 0).all())
                  << alpha << " " << cosine;
              ASSERT_LT(next->weight.maxCoeff(), 400) << alpha << " " << cosine << " " << f0;
              ASSERT_NEAR(next->direction.norm(), 1, 1e-5);
              ASSERT_GT(next->direction.dot(n), 0);
            }
        }
}

/// E(mu, 1) of a rough surface is known in closed form at normal incidence: 1 - ln 2... checked by brute
/// force.
TEST(ReflectanceTable, IsWhatAFinerQuadratureFinds) {
  const ReflectanceTable& table = reflectance_table();
  for (const double roughness : {0.05, 0.14, 0.33, 0.5, 0.77, 1.0})
    for (const double mu : {0.003, 0.02, 0.1, 0.35, 0.7, 1.0}) {
      const double alpha = roughness * roughness, sine = std::sqrt(1 - mu * mu);
      const int fine = 400;
      double all = 0;
      for (int i = 0; i < fine; ++i)
        for (int k = 0; k < fine; ++k) {
          const Eigen::Vector3d from(sine, 0, mu);
          const Eigen::Vector3d mirror =
              visible_mirror<double>(from, alpha, (k + 0.5) / fine, (i + 0.5) / fine);
          const double mu_i = 2 * from.dot(mirror) * mirror.z() - mu;
          if (mu_i > 0) all += share_unmasked(mu, mu_i, alpha) / fine / fine;
        }
      EXPECT_NEAR(1 - reflectance_row(table, static_cast<float>(alpha)).lost(static_cast<float>(mu)), all,
                  0.004)
          << roughness << " " << mu;
    }
}

}  // namespace
}  // namespace seamline::renderer
