// Spherical harmonics, their rotation and triple products, and occlusion fields against brute force.
#include "renderer/realtime/harmonics/spherical_harmonics.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "raytracer/tracing/geometry.h"
#include "renderer/realtime/harmonics/occlusion_field.h"
#include "shapes.h"
#include "support/arithmetic/random.h"

namespace seamline::renderer {
namespace {

Eigen::Matrix3d some_rotation(double angle_rad, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(angle_rad, axis.normalized()).toRotationMatrix();
}

Eigen::VectorXd some_coefficients(int bands, std::uint64_t seed) {
  Random random(seed);
  Eigen::VectorXd out(coefficient_count(bands));
  for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = random.normal();
  return out;
}

double value_at(int bands, const Eigen::VectorXd& coefficients, const Eigen::Vector3d& direction) {
  std::vector<double> values(static_cast<std::size_t>(coefficients.size()));
  evaluate_harmonics(bands, direction, values);
  double sum = 0;
  for (Eigen::Index i = 0; i < coefficients.size(); ++i)
    sum += coefficients[i] * values[static_cast<std::size_t>(i)];
  return sum;
}

TEST(Harmonics, AreOrthonormal) {
  const int count = coefficient_count(most_bands);
  const SphereRule rule = sphere_rule(most_bands);
  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count);
  std::vector<double> values(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < rule.directions.size(); ++i) {
    evaluate_harmonics(most_bands, rule.directions[i], values);
    const Eigen::Map<const Eigen::VectorXd> at(values.data(), count);
    products += rule.weights_sr[i] * at * at.transpose();
  }
  EXPECT_LT((products - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff(), 1e-12);
}

TEST(Harmonics, ProjectionGivesBackWhatIsOfItsBands) {
  for (const int bands : {1, 2, 4, 6, 8}) {
    const Eigen::VectorXd planted = some_coefficients(bands, 3);
    const Eigen::VectorXd found = project_harmonics(
        bands, sphere_rule(bands), [&](const Eigen::Vector3d& w) { return value_at(bands, planted, w); });
    EXPECT_LT((found - planted).cwiseAbs().maxCoeff(), 1e-12) << bands;
  }
}

TEST(Harmonics, RotationByNothingIsNothingAndLengthsStay) {
  for (const int bands : {2, 4, 6}) {
    const int count = coefficient_count(bands);
    EXPECT_LT(
        (harmonic_rotation(bands, Eigen::Matrix3d::Identity()) - Eigen::MatrixXd::Identity(count, count))
            .cwiseAbs()
            .maxCoeff(),
        1e-12);
    const Eigen::MatrixXd turned = harmonic_rotation(bands, some_rotation(1.1, {1, 2, -0.5}));
    EXPECT_LT((turned * turned.transpose() - Eigen::MatrixXd::Identity(count, count)).cwiseAbs().maxCoeff(),
              1e-12);
    const Eigen::VectorXd planted = some_coefficients(bands, 8);
    for (int l = 0; l < bands; ++l)
      EXPECT_NEAR((turned * planted).segment(l * l, 2 * l + 1).norm(),
                  planted.segment(l * l, 2 * l + 1).norm(), 1e-12);
  }
}

TEST(Harmonics, TwoRotationsAreOne) {
  const Eigen::Matrix3d first = some_rotation(0.7, {0.3, 1, 0.2}),
                        second = some_rotation(-2.1, {1, 0.1, 0.9});
  EXPECT_LT(
      (harmonic_rotation(6, second) * harmonic_rotation(6, first) - harmonic_rotation(6, second * first))
          .cwiseAbs()
          .maxCoeff(),
      1e-12);
}

TEST(Harmonics, TurnedCoefficientsAreThoseOfTheTurnedFunction) {
  const Eigen::Matrix3d turn = some_rotation(0.9, {-1, 0.4, 0.3});
  const Eigen::VectorXd planted = some_coefficients(6, 5);
  const Eigen::VectorXd turned = harmonic_rotation(6, turn) * planted;
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d w = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    EXPECT_NEAR(value_at(6, turned, w), value_at(6, planted, turn.transpose() * w), 1e-12);
  }
}

TEST(Harmonics, ConvolutionWithTheClampedCosineIsTheIntegral) {
  const std::vector<double> of_bands = clamped_cosine_bands(6);
  const Eigen::Vector3d normal = Eigen::Vector3d(0.3, -0.8, 0.5).normalized();
  const Eigen::VectorXd found = project_harmonics(
      6, sphere_rule(600), [&](const Eigen::Vector3d& w) { return std::max(0.0, normal.dot(w)); });
  std::vector<double> values(36);
  evaluate_harmonics(6, normal, values);
  for (int l = 0, k = 0; l < 6; ++l)
    for (int m = -l; m <= l; ++m, ++k)
      EXPECT_NEAR(found[k], of_bands[static_cast<std::size_t>(l)] * values[static_cast<std::size_t>(k)],
                  1e-5);
}

TEST(TripleProducts, AreTheIntegralsOfThreeHarmonics) {
  constexpr int bands = 6, count = bands * bands;
  const SphereRule rule = sphere_rule(10);  // degree 19, of 15
  std::vector<double> values(count);
  std::vector<double> sums(static_cast<std::size_t>(count * count * count), 0.0);
  for (std::size_t d = 0; d < rule.directions.size(); ++d) {
    evaluate_harmonics(bands, rule.directions[d], values);
    std::size_t at = 0;
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) {
        const double two = rule.weights_sr[d] * values[i] * values[j];
        for (std::size_t k = 0; k < count; ++k) sums[at++] += two * values[k];
      }
  }
  std::size_t at = 0;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j)
      for (int k = 0; k < count; ++k)
        ASSERT_NEAR(triple_coefficient(i, j, k), sums[at++], 1e-12) << i << " " << j << " " << k;
  EXPECT_LT(triple_table(bands).entries.size(), 4000U) << "most are 0";
}

TEST(TripleProducts, MultiplyFunctions) {
  // Of 3 and 3 bands the product has 5, and 5 of the table hold it whole.
  Eigen::VectorXd a = Eigen::VectorXd::Zero(25), b = a;
  a.head(9) = some_coefficients(3, 1);
  b.head(9) = some_coefficients(3, 2);
  const Eigen::VectorXf af = a.cast<float>(), bf = b.cast<float>();
  Eigen::VectorXf product(25);
  multiply_harmonics(triple_table(5), {af.data(), 25}, {bf.data(), 25}, {product.data(), 25});
  Random random(4);
  for (int i = 0; i < 50; ++i) {
    const Eigen::Vector3d w = Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    EXPECT_NEAR(value_at(5, product.cast<double>(), w), value_at(5, a, w) * value_at(5, b, w), 2e-5);
  }
}

TEST(TransferCache, IsTheProjectionOfTheClampedCosine) {
  const TransferCache cache(4);
  std::vector<float> found(16);
  std::vector<double> values(16);
  const std::vector<double> of_bands = clamped_cosine_bands(4);
  Random random(6);
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector3d normal =
        Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized();
    cache.look_up(normal.cast<float>(), found);
    evaluate_harmonics(4, normal, values);
    for (int l = 0, k = 0; l < 4; ++l)
      for (int m = -l; m <= l; ++m, ++k)
        EXPECT_NEAR(static_cast<double>(found[static_cast<std::size_t>(k)]),
                    of_bands[static_cast<std::size_t>(l)] * values[static_cast<std::size_t>(k)], 4e-3);
  }
}

/// A box in a field of shells, under a sky that is brighter on one side.
struct BoxField {
  Geometry box{std::vector<std::shared_ptr<const SurfaceMesh>>{
      test::box({-0.3F, -0.5F, -4.2F}, {0.3F, 0.5F, -3.8F}, 0.5F, 1)}};
  Eigen::Vector3f centre_m{0, 0, -4};
  float radius_m = Eigen::Vector3f(0.3F, 0.5F, 0.2F).norm();

  [[nodiscard]] static double sky(const Eigen::Vector3d& w) {
    return 1 + 0.6 * w.x() + 0.5 * w.y() + 0.3 * w.y() * w.y();
  }
  [[nodiscard]] OcclusionField field(int bands, int shells, int latitudes = 17) const {
    const FieldShape shape{centre_m, shell_radii(0.4F * radius_m, 4 * radius_m, shells), latitudes,
                           2 * (latitudes - 1), bands};
    return sample_field(
        shape,
        [&](std::span<const Ray> rays, std::span<std::uint8_t> hits) {
          box.occluded(rays, hits, Coherence::scattered);
        },
        radius_m, 1024, 2);
  }
  /// What of the sky's light reaches a surface past the box, by many rays.
  [[nodiscard]] double traced(const Eigen::Vector3f& place_m, const Eigen::Vector3f& normal) const {
    static const SphereRule rule = sphere_rule(90);
    double with = 0, without = 0;
    for (std::size_t i = 0; i < rule.directions.size(); ++i) {
      const double light = rule.weights_sr[i] * sky(rule.directions[i]) *
                           std::max(0.0, normal.cast<double>().dot(rule.directions[i]));
      if (light == 0) continue;
      without += light;
      if (!box.occluded({place_m, rule.directions[i].cast<float>()})) with += light;
    }
    return with / without;
  }
  [[nodiscard]] static std::vector<float> light(int bands) {
    const Eigen::VectorXd l = project_harmonics(bands, sphere_rule(8), sky);
    std::vector<float> out;
    for (Eigen::Index i = 0; i < l.size(); ++i) out.push_back(static_cast<float>(l[i]));
    return out;
  }
  /// By the field, at a place between its samples or on one.
  [[nodiscard]] double by_field(const OcclusionField& of, const Eigen::Vector3f& place_m,
                                const Eigen::Vector3f& normal) const {
    const int bands = of.shape.bands;
    const auto count = static_cast<std::size_t>(coefficient_count(bands));
    std::vector<float> visibility(count), transfer(count);
    if (!look_up(of, place_m, visibility)) return 1;
    TransferCache(bands).look_up(normal, transfer);
    return static_cast<double>(field_attenuation(triple_table(bands), light(bands), transfer, visibility));
  }
};

/// Places on a shell's own samples, outside the box, and normals in several directions.
template <class Check>
void each_sample(const OcclusionField& field, std::size_t shell, const Check& check) {
  for (int row = 1; row < field.shape.latitudes - 1; row += 3)
    for (int column = 0; column < field.shape.longitudes; column += 5) {
      const double polar = std::numbers::pi * row / (field.shape.latitudes - 1),
                   azimuth = 2 * std::numbers::pi * column / field.shape.longitudes;
      const Eigen::Vector3f direction(static_cast<float>(std::sin(polar) * std::cos(azimuth)),
                                      static_cast<float>(std::cos(polar)),
                                      static_cast<float>(std::sin(polar) * std::sin(azimuth)));
      const Eigen::Vector3f place = field.shape.centre_m + field.shape.radii_m[shell] * direction;
      for (const Eigen::Vector3f& normal : {Eigen::Vector3f(Eigen::Vector3f::UnitY()),
                                            Eigen::Vector3f(-direction), Eigen::Vector3f(0.6F, 0.8F, 0)})
        check(place, normal);
    }
}

TEST(OcclusionField, ComesNearerToBruteForceWithMoreBandsAtItsOwnSamples) {
  const BoxField scene;
  double before = 1;
  // Root mean square of the share of light, and what it may be for 2, 4 and 6 bands.
  for (const auto& [bands, bound] : {std::pair(2, 0.06), std::pair(4, 0.02), std::pair(6, 0.012)}) {
    const OcclusionField field = scene.field(bands, 4);
    double squares = 0, deepest = 1;
    int count = 0;
    each_sample(field, 2, [&](const Eigen::Vector3f& place, const Eigen::Vector3f& normal) {
      const double traced = scene.traced(place, normal);
      squares += std::pow(scene.by_field(field, place, normal) - traced, 2);
      deepest = std::min(deepest, traced);
      ++count;
    });
    const double error = std::sqrt(squares / count);
    EXPECT_LT(error, bound) << bands;
    EXPECT_LT(error, before) << bands;
    EXPECT_LT(deepest, 0.9) << "the box takes light away";
    before = error;
  }
}

TEST(OcclusionField, BetweenShellsOnlyFinerShellsComeNearer) {
  const BoxField scene;
  const auto error = [&](int bands, int shells, int latitudes) {
    const OcclusionField field = scene.field(bands, shells, latitudes);
    double squares = 0;
    int count = 0;
    Random random(11);
    for (int i = 0; i < 150; ++i) {
      const Eigen::Vector3f direction =
          Eigen::Vector3d(random.normal(), random.normal(), random.normal()).normalized().cast<float>();
      const Eigen::Vector3f place =
          scene.centre_m + (1.05F + 1.5F * static_cast<float>(random.uniform())) * scene.radius_m * direction;
      squares += std::pow(scene.by_field(field, place, -direction) - scene.traced(place, -direction), 2);
      ++count;
    }
    return std::sqrt(squares / count);
  };
  const double few = error(4, 2, 9), few_of_more_bands = error(6, 2, 9), many = error(6, 12, 25);
  EXPECT_GT(few_of_more_bands, 0.5 * few) << "bands do not mend what lies between two shells";
  EXPECT_LT(many, 0.4 * few_of_more_bands);
}

TEST(OcclusionField, TurnsWithItsObject) {
  // The field of a turned box at a turned place is the field of the box there, turned by its coefficients.
  const BoxField scene;
  const OcclusionField field = scene.field(4, 4);
  const Eigen::Matrix3d turn = some_rotation(std::numbers::pi / 2, Eigen::Vector3d::UnitY());
  const std::vector<std::shared_ptr<const SurfaceMesh>> turned_box = {
      test::box({-0.2F, -0.5F, -4.3F}, {0.2F, 0.5F, -3.7F}, 0.5F, 1)};
  const Geometry turned(turned_box);
  const OcclusionField of_turned = sample_field(
      field.shape,
      [&](std::span<const Ray> rays, std::span<std::uint8_t> hits) {
        turned.occluded(rays, hits, Coherence::scattered);
      },
      scene.radius_m, 1024, 2);
  const Eigen::Vector3f from_centre(0.5F, 0.3F, 0.4F);
  std::vector<float> here(16), there(16);
  ASSERT_TRUE(look_up(field, scene.centre_m + from_centre, here));
  ASSERT_TRUE(look_up(of_turned, scene.centre_m + turn.cast<float>() * from_centre, there));
  const Eigen::MatrixXd by = harmonic_rotation(4, turn);
  for (int k = 0; k < 16; ++k) {
    double expected = 0;
    for (int i = 0; i < 16; ++i)
      expected += by(k, i) * static_cast<double>(here[static_cast<std::size_t>(i)]);
    EXPECT_NEAR(static_cast<double>(there[static_cast<std::size_t>(k)]), expected, 0.02) << k;
  }
}

TEST(OcclusionField, KnowsNothingBeyondItsLastShell) {
  const BoxField scene;
  const OcclusionField field = scene.field(2, 3, 9);
  std::vector<float> out(4);
  EXPECT_FALSE(look_up(field, scene.centre_m + Eigen::Vector3f(5, 0, 0), out));
  EXPECT_TRUE(look_up(field, scene.centre_m, out)) << "inside the first one it is that one's";
}

}  // namespace
}  // namespace seamline::renderer
