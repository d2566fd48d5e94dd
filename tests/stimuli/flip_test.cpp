#include "stimuli/flip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "stimuli/flip_colour.h"
#include "stimuli/flip_filters.h"
#include "stimuli/support/random.h"

namespace seamline {
namespace {

constexpr double ppd = 67;  // the authors' default: 3840 px on 0.7 m from 0.7 m

ByteImage constant_picture(int width_px, int height_px, std::array<int, 3> code) {
  ByteImage image{width_px, height_px, 3, {}};
  for (int pixel = 0; pixel < width_px * height_px; ++pixel)
    for (const int value : code) image.values.push_back(static_cast<std::uint8_t>(value));
  return image;
}

/// Smooth patches with noise: edges, colours, and values that clip after filtering.
ByteImage random_picture(int width_px, int height_px, std::uint64_t seed) {
  Random random(seed);
  ByteImage image{width_px, height_px, 3, {}};
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x)
      for (int channel = 0; channel < 3; ++channel) {
        const bool inside = (x / 7 + y / 5 + channel) % 3 == 0;
        image.values.push_back(
            static_cast<std::uint8_t>((inside ? 190 : 5) + static_cast<int>(random.below(60))));
      }
  return image;
}

float middle_flip(std::array<int, 3> a, std::array<int, 3> b) {
  const Image flip = flip_difference(constant_picture(9, 9, a), constant_picture(9, 9, b), ppd);
  return flip.at(4, 4);
}

// An independent derivation for whole pictures: doubles throughout, two-dimensional kernels as the paper
// writes them, no shared code, matrices as
// decimals.
namespace independent {

using Triple = std::array<double, 3>;
using Plane = std::vector<double>;

constexpr double pi = 3.14159265358979323846;
constexpr double matrix[3][3] = {{0.4123865632529917, 0.35759149092062537, 0.18045049120356368},
                                 {0.21263682167732384, 0.7151829818412507, 0.07218019648142547},
                                 {0.019330620152483987, 0.11919716364020845, 0.9503725870054354}};
constexpr double inverse[3][3] = {{3.2410032329763587, -1.5373989694887855, -0.4986158819963629},
                                  {-0.9692242522025166, 1.875929983695176, 0.041554226340084724},
                                  {0.055639419851975444, -0.20401120612390997, 1.0571489771875335}};
constexpr double white[3] = {0.9504285453771807, 1.0, 1.0889003707981277};

double linear(double code) {
  const double v = code / 255;
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

Triple times(const double (&m)[3][3], const Triple& v) {
  Triple out{};
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) out[row] += m[row][column] * v[column];
  return out;
}

Triple opponent(const Triple& rgb) {
  const Triple xyz = times(matrix, rgb);
  const double x = xyz[0] / white[0], y = xyz[1] / white[1], z = xyz[2] / white[2];
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

Triple hunt_lab(const Triple& rgb) {
  const Triple xyz = times(matrix, rgb);
  Triple f{};
  for (int i = 0; i < 3; ++i) {
    const double t = xyz[i] / white[i];
    f[i] = t > 0.00885645167903563 ? std::pow(t, 1.0 / 3) : 7.787037037037037 * t + 0.13793103448275862;
  }
  const double lightness = 116 * f[1] - 16;
  return {lightness, 5 * lightness * (f[0] - f[1]), 2 * lightness * (f[1] - f[2])};
}

double distance(const Triple& a, const Triple& b) {
  return std::abs(a[0] - b[0]) + std::sqrt(std::pow(a[1] - b[1], 2) + std::pow(a[2] - b[2], 2));
}

struct Kernel {
  int radius;
  Plane weight;  // (2 radius + 1)^2, rows first
};

double at(const Plane& plane, int width, int height, int x, int y) {
  x = x < 0 ? 0 : x >= width ? width - 1 : x;
  y = y < 0 ? 0 : y >= height ? height - 1 : y;
  return plane[static_cast<std::size_t>(y * width + x)];
}

double filtered_at(const Plane& plane, int width, int height, int x, int y, const Kernel& kernel) {
  double sum = 0;
  std::size_t i = 0;
  for (int dy = -kernel.radius; dy <= kernel.radius; ++dy)
    for (int dx = -kernel.radius; dx <= kernel.radius; ++dx)
      sum += kernel.weight[i++] * at(plane, width, height, x + dx, y + dy);
  return sum;
}

Kernel sensitivity(double ppd_px, double a1, double b1, double a2, double b2) {
  Kernel kernel{static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * ppd_px)), {}};
  double sum = 0;
  for (int y = -kernel.radius; y <= kernel.radius; ++y)
    for (int x = -kernel.radius; x <= kernel.radius; ++x) {
      const double r2 = (x * x + y * y) / (ppd_px * ppd_px);
      kernel.weight.push_back(a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * r2 / b1) +
                              a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * r2 / b2));
      sum += kernel.weight.back();
    }
  for (double& weight : kernel.weight) weight /= sum;
  return kernel;
}

Kernel feature(double ppd_px, bool point, bool vertical) {
  const double sd = 0.5 * 0.082 * ppd_px;
  Kernel kernel{static_cast<int>(std::ceil(3 * sd)), {}};
  double positive = 0, negative = 0;
  for (int y = -kernel.radius; y <= kernel.radius; ++y)
    for (int x = -kernel.radius; x <= kernel.radius; ++x) {
      const int along = vertical ? y : x;
      const double g = std::exp(-(x * x + y * y) / (2 * sd * sd));
      const double weight = point ? (along * along / (sd * sd) - 1) * g : -along * g;
      kernel.weight.push_back(weight);
      (weight > 0 ? positive : negative) += std::abs(weight);
    }
  for (double& weight : kernel.weight) weight /= weight > 0 ? positive : negative;
  return kernel;
}

struct Picture {
  int width, height;
  std::array<Plane, 3> channel;
};

Picture picture_of(const ByteImage& image) {
  Picture picture{image.width_px, image.height_px, {}};
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    const Triple ycc =
        opponent({linear(image.values[i]), linear(image.values[i + 1]), linear(image.values[i + 2])});
    for (int c = 0; c < 3; ++c) picture.channel[static_cast<std::size_t>(c)].push_back(ycc[c]);
  }
  return picture;
}

Triple seen_colour(const Picture& p, int x, int y, const std::array<Kernel, 3>& kernels) {
  Triple ycc{};
  for (std::size_t c = 0; c < 3; ++c) ycc[c] = filtered_at(p.channel[c], p.width, p.height, x, y, kernels[c]);
  const double yy = (ycc[0] + 16) / 116;
  Triple rgb = times(inverse, {white[0] * (yy + ycc[1] / 500), yy, white[2] * (yy - ycc[2] / 200)});
  for (double& value : rgb) value = std::min(1.0, std::max(0.0, value));
  return hunt_lab(rgb);
}

double strength(const Picture& p, int x, int y, const Kernel& horizontal, const Kernel& vertical) {
  Plane grey = p.channel[0];
  for (double& value : grey) value = (value + 16) / 116;
  return std::hypot(filtered_at(grey, p.width, p.height, x, y, horizontal),
                    filtered_at(grey, p.width, p.height, x, y, vertical));
}

Plane flip(const ByteImage& reference, const ByteImage& test, double ppd_px) {
  const Picture r = picture_of(reference), t = picture_of(test);
  const std::array<Kernel, 3> kernels = {sensitivity(ppd_px, 1, 0.0047, 0, 1e-5),
                                         sensitivity(ppd_px, 1, 0.0053, 0, 1e-5),
                                         sensitivity(ppd_px, 34.1, 0.04, 13.5, 0.025)};
  const double most = std::pow(distance(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1})), 0.7);
  const Kernel ex = feature(ppd_px, false, false), ey = feature(ppd_px, false, true);
  const Kernel px = feature(ppd_px, true, false), py = feature(ppd_px, true, true);
  Plane out;
  for (int y = 0; y < r.height; ++y)
    for (int x = 0; x < r.width; ++x) {
      const double power =
          std::pow(distance(seen_colour(r, x, y, kernels), seen_colour(t, x, y, kernels)), 0.7);
      const double colour = power < 0.4 * most ? 0.95 / (0.4 * most) * power
                                               : 0.95 + (power - 0.4 * most) / (most - 0.4 * most) * 0.05;
      const double edges = std::abs(strength(r, x, y, ex, ey) - strength(t, x, y, ex, ey));
      const double points = std::abs(strength(r, x, y, px, py) - strength(t, x, y, px, py));
      out.push_back(std::pow(colour, 1 - std::sqrt(std::max(edges, points) / std::sqrt(2.0))));
    }
  return out;
}

}  // namespace independent

TEST(Flip, APictureDiffersFromItselfNowhere) {
  const ByteImage image = random_picture(40, 30, 1);
  for (const float value : flip_difference(image, image, ppd).values) EXPECT_EQ(value, 0.0F);
}

/// By hand from the equations: see documentation/predict_and_plan.md for black and white.
TEST(Flip, ConstantPairsAreTheColourDifferenceByHand) {
  EXPECT_NEAR(middle_flip({0, 0, 0}, {255, 255, 255}), 0.967379761, 1e-5);
  EXPECT_NEAR(middle_flip({0, 255, 0}, {0, 0, 255}), 1.0, 1e-5);
  EXPECT_NEAR(middle_flip({128, 128, 128}, {138, 128, 128}), 0.125676376, 1e-5);
  EXPECT_NEAR(middle_flip({128, 128, 128}, {129, 129, 129}), 0.029855207, 1e-5);
  EXPECT_NEAR(middle_flip({200, 30, 60}, {60, 120, 200}), 0.891746515, 1e-5);
}

TEST(Flip, WholePicturesAgreeWithAnIndependentDerivation) {
  const ByteImage reference = random_picture(36, 25, 2), test = random_picture(36, 25, 3);
  for (const double pixels_per_degree : {12.0, 38.0, 67.0}) {
    const Image flip = flip_difference(reference, test, pixels_per_degree);
    const independent::Plane expected = independent::flip(reference, test, pixels_per_degree);
    ASSERT_EQ(flip.values.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(flip.values[i], expected[i], 1e-4);
  }
}

TEST(Flip, IsSymmetric) {
  const ByteImage a = random_picture(30, 20, 4), b = random_picture(30, 20, 5);
  EXPECT_EQ(flip_difference(a, b, ppd).values, flip_difference(b, a, ppd).values);
}

/// From further away a fine pattern is less visible, and a constant shift is not.
TEST(Flip, PixelsPerDegreeMatter) {
  ByteImage fine = constant_picture(41, 41, {128, 128, 128});
  for (int y = 0; y < 41; ++y)
    for (int x = 0; x < 41; ++x)
      for (int c = 0; c < 3; ++c)
        fine.values[static_cast<std::size_t>((y * 41 + x) * 3 + c)] = (x + y) % 2 == 0 ? 108 : 148;
  const ByteImage flat = constant_picture(41, 41, {128, 128, 128});
  const float near = flip_difference(flat, fine, 20).at(20, 20);
  const float far = flip_difference(flat, fine, 80).at(20, 20);
  EXPECT_GT(near, 2 * far);
  const ByteImage lighter = constant_picture(41, 41, {140, 140, 140});
  EXPECT_NEAR(flip_difference(flat, lighter, 20).at(20, 20), flip_difference(flat, lighter, 80).at(20, 20),
              1e-5);
}

/// White where `white(x)`, else black, 61 x 21.
template <typename White>
ByteImage black_and_white(const White& white) {
  ByteImage image = constant_picture(61, 21, {0, 0, 0});
  for (int y = 0; y < 21; ++y)
    for (int x = 0; x < 61; ++x)
      for (int c = 0; c < 3; ++c)
        image.values[static_cast<std::size_t>((y * 61 + x) * 3 + c)] = white(x) ? 255 : 0;
  return image;
}

/// Against black. Both are grey and constant along y, so every filter is a sum of one line of weights: the
/// values follow by hand (documentation/predict_and_plan.md). At a line the point detector is the stronger,
/// at a step the edge detector.
TEST(Flip, AStepAndALineByHand) {
  const ByteImage black = constant_picture(61, 21, {0, 0, 0});
  const Image step = flip_difference(black, black_and_white([](int x) { return x >= 30; }), ppd);
  EXPECT_NEAR(step.at(30, 10), 0.993944, 1e-5);
  EXPECT_NEAR(step.at(27, 10), 0.591726, 1e-5);
  const Image line = flip_difference(black, black_and_white([](int x) { return x == 30; }), ppd);
  EXPECT_NEAR(line.at(30, 10), 0.975743, 1e-5);
  EXPECT_NEAR(line.at(28, 10), 0.737783, 1e-5);
}

/// A step from black to white: at the first white pixel the whole negative lobe lies on white, so the edge is
/// 1 strong; further away than the filter reaches there is no feature.
TEST(Flip, AStepIsAnEdgeOfItsHeight) {
  const ByteImage step = black_and_white([](int x) { return x >= 30; });
  const Image features = flip_picture(step, ppd).features;
  EXPECT_NEAR(features.at(30, 10, 0), 1, 1e-5);
  EXPECT_NEAR(features.at(29, 10, 0), 1, 1e-5);
  EXPECT_NEAR(features.at(5, 10, 0), 0, 1e-5);
  EXPECT_NEAR(features.at(55, 10, 1), 0, 1e-5);
}

/// The feature term raises the difference: colour^(1 - feature), here with every factor by itself.
TEST(Flip, FeaturesRaiseTheDifferenceAsTheEquationSays) {
  Image lab(1, 1, 3), other(1, 1, 3), flat(1, 1, 2), edge(1, 1, 2);
  other.values = {10, 3, 4};
  edge.values = {0.5F, 0.2F};
  const double colour = colour_difference_of_distance(15);
  const FlipPicture a{lab, flat}, b{other, flat}, c{other, edge}, d{lab, edge};
  EXPECT_NEAR(flip_difference(a, b).values[0], colour, 1e-6);
  EXPECT_NEAR(flip_difference(a, c).values[0], std::pow(colour, 1 - std::sqrt(0.5 / std::sqrt(2.0))), 1e-6);
  EXPECT_EQ(flip_difference(a, d).values[0], 0.0F);
}

TEST(FlipColour, OpponentSpaceIsUndone) {
  for (const Eigen::Array3d& rgb : {Eigen::Array3d{0.1, 0.5, 0.9}, Eigen::Array3d{1, 0, 0.2}})
    EXPECT_LT((linear_from_ycxcz(ycxcz_from_linear(rgb)) - rgb).abs().maxCoeff(), 1e-12);
  const Eigen::Array3d white = ycxcz_from_linear({1, 1, 1});
  EXPECT_NEAR(white[0], 100, 1e-12);
  EXPECT_NEAR(white[1], 0, 1e-12);
  EXPECT_NEAR(white[2], 0, 1e-12);
}

/// CIE values of the sRGB primaries.
TEST(FlipColour, LabOfGreenAndRed) {
  const Eigen::Array3d green = lab_from_linear({0, 1, 0}), red = lab_from_linear({1, 0, 0});
  EXPECT_NEAR(green[0], 87.7355, 1e-3);
  EXPECT_NEAR(green[1], -86.1816, 1e-2);
  EXPECT_NEAR(green[2], 83.1866, 1e-2);
  EXPECT_NEAR(red[0], 53.2371, 1e-3);
  EXPECT_NEAR(red[1], 80.0901, 1e-2);
  EXPECT_NEAR(red[2], 67.2033, 1e-2);
}

TEST(FlipColour, DistancesBendAtTheStatedShare) {
  const double most = std::pow(
      hyab_distance(hunt_adjusted(lab_from_linear({0, 1, 0})), hunt_adjusted(lab_from_linear({0, 0, 1}))),
      0.7);
  EXPECT_NEAR(most, 41.2761, 1e-4);  // as printed in ports of the authors' code
  EXPECT_NEAR(colour_difference_of_distance(std::pow(0.4 * most, 1 / 0.7)), 0.95, 1e-6);
  EXPECT_NEAR(colour_difference_of_distance(std::pow(0.2 * most, 1 / 0.7)), 0.475, 1e-6);
  EXPECT_NEAR(colour_difference_of_distance(std::pow(0.7 * most, 1 / 0.7)), 0.975, 1e-6);
  EXPECT_NEAR(colour_difference_of_distance(203.301655), 1, 1e-6);
  EXPECT_EQ(colour_difference_of_distance(0), 0);
}

TEST(FlipFilters, KeepConstantsAndWeighLobesAlike) {
  const Image constant(7, 5, 1, 0.3F);
  for (const auto& channel : sensitivity_filters(ppd)) {
    double sum = 0;
    for (const WeightedFilter& part : channel) sum += part.weight * filtered(constant, part.filter).at(3, 2);
    EXPECT_NEAR(sum, 0.3, 1e-6);
  }
  const FeatureFilters features = feature_filters(ppd);
  for (const SeparableFilter& filter : {features.edge_x, features.edge_y, features.point_x, features.point_y})
    EXPECT_NEAR(filtered(constant, filter).at(3, 2), 0, 1e-6);
}

TEST(Flip, PixelsPerDegreeOfTheAuthorsScreen) {
  EXPECT_NEAR(screen_pixels_per_degree(0.7, 3840, 0.7), 67.0206, 1e-4);
  EXPECT_NEAR(screen_pixels_per_degree(0.6, 1920, 0.531), 38, 0.2);
}

}  // namespace
}  // namespace seamline
