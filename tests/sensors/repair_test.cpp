// Repairs: what each promises, against the slow way to compute it, and that nothing is invented silently.
#include "sensors/repair/repair.h"

#include <gtest/gtest.h>

#include <cstring>
#include <functional>
#include <numeric>

#include "support/arithmetic/random.h"
#include "tests/complaint.h"
#include "tests/sensors/distributions.h"

namespace seamline::sensors {
namespace {

using test::complaint_of;
using testing::moments;

DepthFrame frame_of(int width_px, int height_px, const std::function<double(int, int)>& depth_m) {
  DepthFrame frame;
  frame.camera = pinhole_of_field_of_view(width_px, height_px, 60);
  for (int row = 0; row < height_px; ++row)
    for (int column = 0; column < width_px; ++column)
      frame.depth_m.push_back(static_cast<float>(depth_m(column, row)));
  return frame;
}

DepthFrame random_frame(int width_px, int height_px, double share_of_holes, std::uint64_t seed) {
  Random random(seed);
  DepthFrame frame = frame_of(width_px, height_px, [&](int, int) {
    const double value = 0.5 + 4 * random.uniform();
    return random.uniform() < share_of_holes ? double{hole} : value;
  });
  frame.confidence.assign(frame.depth_m.size(), 0.5F);
  return frame;
}

Image random_photograph(const DepthFrame& frame, std::uint64_t seed) {
  Image image(frame.camera.width_px, frame.camera.height_px, 3);
  Random random(seed);
  for (float& value : image.values) value = static_cast<float>(random.uniform());
  return image;
}

std::vector<RepairMethod> every_method() {
  return {NoRepair{},     NearestRepair{},        MedianRepair{.radius_px = 2, .fills = true},
          MedianRepair{}, JointBilateralRepair{}, PlaneRepair{}};
}

bool same_bytes(const DepthFrame& a, const DepthFrame& b) {
  return a.depth_m.size() == b.depth_m.size() &&
         std::memcmp(a.depth_m.data(), b.depth_m.data(), a.depth_m.size() * sizeof(float)) == 0;
}

TEST(Repair, MarksAndCountsEveryPixelByWhatBecameOfIt) {
  const DepthFrame frame = random_frame(40, 30, 0.4, 1);
  const Image photograph = random_photograph(frame, 2);
  for (const RepairMethod& method : every_method()) {
    const Repaired found = repair(frame, method, &photograph);
    EXPECT_EQ(std::accumulate(found.counts.begin(), found.counts.end(), std::int64_t{0}), 40 * 30);
    for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
      const bool was = !DepthFrame::is_hole(frame.depth_m[i]),
                 is = !DepthFrame::is_hole(found.frame.depth_m[i]);
      EXPECT_TRUE(is || !was);  // no repair loses what was measured
      EXPECT_EQ(found.marks[i] == RepairMark::invented, is && !was);
      EXPECT_EQ(found.marks[i] == RepairMark::empty, !is);
      EXPECT_EQ(found.marks[i] == RepairMark::kept, was && found.frame.depth_m[i] == frame.depth_m[i]);
      EXPECT_EQ(found.frame.confidence[i], is && !was ? 0.0F : 0.5F);
    }
  }
}

TEST(Repair, TheSameBytesForAnyNumberOfThreads) {
  const DepthFrame frame = random_frame(70, 50, 0.5, 3);
  const Image photograph = random_photograph(frame, 2);
  for (const RepairMethod& method : every_method())
    EXPECT_TRUE(
        same_bytes(repair(frame, method, &photograph, 1).frame, repair(frame, method, &photograph, 5).frame));
}

TEST(Repair, AFrameOfHolesAloneStaysOne) {
  const DepthFrame frame = frame_of(20, 10, [](int, int) { return hole; });
  const Image photograph = random_photograph(frame, 2);
  for (const RepairMethod& method : every_method())
    EXPECT_EQ(repair(frame, method, &photograph).count(RepairMark::empty), 200);
}

TEST(Repair, AConstantFrameStaysConstantWherever) {
  const DepthFrame frame =
      frame_of(30, 20, [](int x, int y) { return (x * 7 + y * 5) % 4 == 0 ? double{hole} : 2.0; });
  const Image photograph = random_photograph(frame, 2);
  for (const RepairMethod& method : every_method())
    for (const float depth_m : repair(frame, method, &photograph).frame.depth_m)
      if (!DepthFrame::is_hole(depth_m)) {
        EXPECT_NEAR(depth_m, 2, 1e-6);
      }
}

TEST(Repair, NoneKeepsEveryBit) {
  const DepthFrame frame = random_frame(40, 30, 0.4, 1);
  EXPECT_TRUE(same_bytes(repair(frame, NoRepair{}).frame, frame));
  EXPECT_EQ(repair(frame, NoRepair{}).count(RepairMark::invented), 0);
}

// Nearest neighbour.

float nearest_by_hand(const DepthFrame& frame, int column, int row) {
  int best = 1 << 30;
  float value = hole;
  for (int y = 0; y < frame.camera.height_px; ++y)  // the first of several is the upper left one
    for (int x = 0; x < frame.camera.width_px; ++x) {
      const int square = (x - column) * (x - column) + (y - row) * (y - row);
      if (DepthFrame::is_hole(frame.at(x, y)) || square >= best) continue;
      best = square;
      value = frame.at(x, y);
    }
  return value;
}

TEST(Repair, NearestIsTheNearestOfAllMeasuredPixels) {
  for (const double holes : {0.1, 0.5, 0.95, 0.998}) {
    const DepthFrame frame = random_frame(41, 29, holes, 5);
    const Repaired found = fill_with_nearest(frame);
    EXPECT_EQ(found.count(RepairMark::empty), 0);
    EXPECT_EQ(found.count(RepairMark::changed), 0);
    for (int row = 0; row < 29; ++row)
      for (int column = 0; column < 41; ++column)
        ASSERT_EQ(found.frame.at(column, row), nearest_by_hand(frame, column, row)) << column << " " << row;
    EXPECT_TRUE(same_bytes(fill_with_nearest(found.frame).frame, found.frame));
  }
}

TEST(Repair, NearestOfEquallyNearOnesIsTheUpperThenTheLeft) {
  const DepthFrame frame = frame_of(5, 5, [](int x, int y) {
    const bool measured = std::abs(x - 2) + std::abs(y - 2) == 2 && (x == 2 || y == 2);
    return measured ? 1.0 + x + 10 * y : double{hole};
  });
  EXPECT_EQ(fill_with_nearest(frame).frame.at(2, 2), 3);   // the one above
  EXPECT_EQ(fill_with_nearest(frame).frame.at(0, 0), 3);   // (2, 0) and (0, 2) are as near: the higher row
  EXPECT_EQ(fill_with_nearest(frame).frame.at(4, 4), 25);  // (4, 2) and (2, 4): the higher row
}

// Median.

TEST(Repair, MedianIsTheMiddleOfItsWindow) {
  for (const int radius : {1, 3}) {
    const DepthFrame frame = random_frame(31, 23, 0.4, 7);
    const Repaired found = smooth_by_median(frame, {.radius_px = radius, .fills = true});
    for (int row = 0; row < 23; ++row)
      for (int column = 0; column < 31; ++column) {
        std::vector<float> window;
        int area = 0;
        for (int y = row - radius; y <= row + radius; ++y)
          for (int x = column - radius; x <= column + radius; ++x) {
            if (x < 0 || x >= 31 || y < 0 || y >= 23) continue;
            ++area;
            if (!DepthFrame::is_hole(frame.at(x, y))) window.push_back(frame.at(x, y));
          }
        std::sort(window.begin(), window.end());
        const bool fills = 2 * static_cast<int>(window.size()) >= area;
        const float expected =
            DepthFrame::is_hole(frame.at(column, row)) && !fills ? hole : window[(window.size() - 1) / 2];
        ASSERT_EQ(found.frame.at(column, row), expected);
      }
  }
}

TEST(Repair, MedianRemovesSingleOutliersAndKeepsAStep) {
  DepthFrame frame = frame_of(40, 30, [](int x, int) { return x < 20 ? 1.0 : 3.0; });
  const DepthFrame clean = frame;
  for (int i = 0; i < 12; ++i) frame.depth_m[frame.index(2 + 3 * i, 4 + 2 * (i % 10))] = 7;
  const Repaired found = smooth_by_median(frame, {});
  EXPECT_TRUE(same_bytes(found.frame, clean));
  EXPECT_EQ(found.count(RepairMark::changed), 12);
}

TEST(Repair, MedianGoesWithEveryRisingChangeOfScale) {
  const DepthFrame frame = random_frame(31, 23, 0.3, 8);
  DepthFrame squared = frame;
  for (float& depth_m : squared.depth_m) depth_m *= depth_m;
  DepthFrame median = smooth_by_median(frame, {.radius_px = 2, .fills = true}).frame;
  for (float& depth_m : median.depth_m) depth_m *= depth_m;
  EXPECT_TRUE(same_bytes(smooth_by_median(squared, {.radius_px = 2, .fills = true}).frame, median));
}

// Joint bilateral filter.

TEST(Repair, JointBilateralIsKopfsMean) {
  const DepthFrame frame = random_frame(31, 23, 0.4, 9);
  const Image photograph = random_photograph(frame, 10);
  const JointBilateralRepair how{.radius_px = 3, .sigma_px = 1.5, .sigma_colour = 0.4};
  const Repaired found = smooth_by_photograph(frame, photograph, how);
  for (int row = 0; row < 23; ++row)
    for (int column = 0; column < 31; ++column) {
      double weights = 0, sum = 0;
      for (int y = 0; y < 23; ++y)
        for (int x = 0; x < 31; ++x) {
          if (std::abs(x - column) > 3 || std::abs(y - row) > 3 || DepthFrame::is_hole(frame.at(x, y)))
            continue;
          const double place = std::hypot(x - column, y - row);
          const double colour =
              static_cast<double>((photograph.rgb(x, y) - photograph.rgb(column, row)).matrix().norm());
          const double weight =
              std::exp(-place * place / (2 * 1.5 * 1.5) - colour * colour / (2 * 0.4 * 0.4));
          weights += weight;
          sum += weight * static_cast<double>(frame.at(x, y));
        }
      if (DepthFrame::is_hole(frame.at(column, row)) && weights < how.least_weight) {
        ASSERT_TRUE(DepthFrame::is_hole(found.frame.at(column, row)));
      } else {
        ASSERT_NEAR(static_cast<double>(found.frame.at(column, row)), sum / weights, 1e-5);
      }
    }
}

TEST(Repair, JointBilateralLowersNoiseButNotAcrossAnEdgeOfThePhotograph) {
  Random random(11);
  const DepthFrame frame =
      frame_of(120, 90, [&](int x, int) { return (x < 60 ? 1.0 : 3.0) + 0.01 * random.normal(); });
  Image photograph(120, 90, 1, 0.2F);
  for (int y = 0; y < 90; ++y)
    for (int x = 60; x < 120; ++x) photograph.at(x, y) = 0.8F;
  const JointBilateralRepair how{.radius_px = 6, .sigma_px = 2, .sigma_colour = 0.05};
  const Repaired found = smooth_by_photograph(frame, photograph, how);
  // Of independent noise a mean with weights w keeps sum w^2 / (sum w)^2; w is a product of two axes.
  double w1 = 0, w2 = 0;
  for (int step = -6; step <= 6; ++step) {
    const double w = std::exp(-step * step / 8.0);
    w1 += w;
    w2 += w * w;
  }
  std::vector<double> errors;
  for (int y = 6; y < 84; ++y)
    for (int x = 6; x < 54; ++x) errors.push_back(static_cast<double>(found.frame.at(x, y)) - 1);
  EXPECT_NEAR(moments(errors).sigma, 0.01 * w2 / (w1 * w1), 0.1 * 0.01 * w2 / (w1 * w1));
  for (int y = 0; y < 90; ++y) {
    EXPECT_NEAR(found.frame.at(59, y), 1, 0.02);
    EXPECT_NEAR(found.frame.at(60, y), 3, 0.02);
  }
}

TEST(Repair, JointBilateralFillsFromWhatLooksAlikeOrNotAtAll) {
  // A hole over an edge of the photograph: each side takes the depth of its own colour.
  const DepthFrame frame = frame_of(40, 30, [](int x, int y) {
    return std::abs(x - 20) < 3 && std::abs(y - 15) < 3 ? double{hole} : x < 20 ? 1.0 : 3.0;
  });
  Image photograph(40, 30, 1, 0.2F);
  for (int y = 0; y < 30; ++y)
    for (int x = 20; x < 40; ++x) photograph.at(x, y) = 0.8F;
  JointBilateralRepair how{.radius_px = 5, .sigma_px = 2.5, .sigma_colour = 0.05};
  const Repaired found = smooth_by_photograph(frame, photograph, how);
  EXPECT_EQ(found.count(RepairMark::invented), 25);
  for (int y = 13; y <= 17; ++y)
    for (int x = 18; x <= 22; ++x) EXPECT_NEAR(found.frame.at(x, y), x < 20 ? 1 : 3, 1e-5);
  how.fills = false;
  EXPECT_EQ(smooth_by_photograph(frame, photograph, how).count(RepairMark::invented), 0);
}

TEST(Repair, ImpossibleRequestsAreRefused) {
  const DepthFrame frame = random_frame(12, 9, 0.1, 1);
  const Image small(11, 9, 3, 0.5F);
  Image broken = random_photograph(frame, 1);
  broken.values[7] = std::nanf("");
  const auto complaint = [&](const RepairMethod& method, const Image* photograph) {
    return complaint_of([&] { (void)repair(frame, method, photograph); });
  };
  EXPECT_EQ(complaint(JointBilateralRepair{}, nullptr),
            "repair: joint bilateral: wanted a photograph in the depth's own pixels, found none");
  EXPECT_EQ(complaint(JointBilateralRepair{}, &small),
            "joint bilateral: photograph: wanted 12 x 9 pixels, as the depth has, found 11 x 9");
  EXPECT_EQ(
      complaint(JointBilateralRepair{}, &broken),
      "joint bilateral: photograph: wanted a picture whose values are all numbers, found 1 that are none: "
      "light too strong to be added up");
  EXPECT_EQ(complaint(JointBilateralRepair{.sigma_px = 0}, &small),
            "joint bilateral: sigma_px: wanted a number above 0, found 0");
  EXPECT_EQ(complaint(MedianRepair{.radius_px = 0}, nullptr),
            "median: radius_px: wanted 1 to 50 pixels, found 0");
  EXPECT_EQ(complaint(PlaneRepair{.tolerance_m = -1}, nullptr),
            "planes: tolerance_m: wanted a number from 1e-06 to 1000, found -1");
}

}  // namespace
}  // namespace seamline::sensors
