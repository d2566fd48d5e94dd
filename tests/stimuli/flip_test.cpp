#include "stimuli/pictures/flip.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "flip_by_hand.h"
#include "stimuli/pictures/flip_colour.h"
#include "stimuli/pictures/flip_filters.h"
#include "support/arithmetic/random.h"

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

TEST(Flip, APictureDiffersFromItselfNowhere) {
  const ByteImage image = random_picture(40, 30, 1);
  for (const float value : flip_difference(image, image, ppd).values) EXPECT_EQ(value, 0.0F);
}

/// By hand from the equations: see documentation/explanation/image_observer.md for black and white.
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
/// values follow by hand (documentation/explanation/image_observer.md). At a line the point detector is the
/// stronger, at a step the edge detector.
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
