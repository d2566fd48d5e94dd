// Estimated depth beside the truth: its line comes back, its errors are those of the definitions, and a share
// of it lies between.
#include "sensors/files/estimate_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <fstream>

#include "support/files/temporary_folder.h"
#include "tests/complaint.h"

namespace seamline::sensors {
namespace {

constexpr int width_px = 48, height_px = 32;

PinholeCamera camera_of_size() {
  return pinhole_of_field_of_view(width_px, height_px, 60);
}

/// From 1 to 9 m, in no order.
std::vector<float> true_depth_m() {
  std::vector<float> depth_m(std::size_t{width_px} * height_px);
  for (std::size_t i = 0; i < depth_m.size(); ++i)
    depth_m[i] = 1 + 8 * static_cast<float>((i * 37) % depth_m.size()) / static_cast<float>(depth_m.size());
  return depth_m;
}

/// A PFM by its definition: little-endian, rows from the bottom.
std::filesystem::path write_values(const TemporaryFolder& folder, const std::vector<float>& values) {
  const std::filesystem::path path = folder.path() / "values.pfm";
  std::ofstream out(path, std::ios::binary);
  out << "Pf\n" << width_px << " " << height_px << "\n-1.0\n";
  for (int y = height_px - 1; y >= 0; --y)
    for (int x = 0; x < width_px; ++x) {
      const float value = values[static_cast<std::size_t>(y * width_px + x)];
      std::array<char, sizeof value> bytes{};
      std::memcpy(bytes.data(), &value, sizeof value);
      out.write(bytes.data(), bytes.size());
    }
  return path;
}

std::vector<float> values_of(DepthValue kind, double scale, double shift) {
  std::vector<float> values;
  for (const float depth_m : true_depth_m()) {
    const double straight =
        kind == DepthValue::inverse ? 1 / static_cast<double>(depth_m) : static_cast<double>(depth_m);
    values.push_back(static_cast<float>((straight - shift) / scale));
  }
  return values;
}

double largest_relative_error(const std::vector<float>& depth_m, const std::vector<float>& true_m) {
  double largest = 0;
  for (std::size_t i = 0; i < depth_m.size(); ++i)
    largest =
        std::max(largest, std::abs(static_cast<double>(depth_m[i]) / static_cast<double>(true_m[i]) - 1));
  return largest;
}

TEST(EstimateError, PlantedScaleAndShiftComeBack) {
  const TemporaryFolder folder;
  for (const DepthValue kind : {DepthValue::inverse, DepthValue::relative}) {
    const double scale = kind == DepthValue::inverse ? 0.0031 : 2.7, shift = 0.04;
    const auto path = write_values(folder, values_of(kind, scale, shift));
    const std::vector<float> fitted =
        estimated_depth(path, kind, std::nullopt, DepthPacking::whole, camera_of_size(), true_depth_m());
    EXPECT_LT(largest_relative_error(fitted, true_depth_m()), 1e-6);
    const std::vector<float> stated =
        estimated_depth(path, kind, DepthLine{scale, shift}, DepthPacking::whole, camera_of_size(), {});
    EXPECT_LT(largest_relative_error(stated, true_depth_m()), 1e-6);
  }
}

TEST(EstimateError, ValuesThatGrowTheWrongWayAreRefused) {
  const TemporaryFolder folder;
  const auto path = write_values(folder, values_of(DepthValue::relative, 1, 0));
  EXPECT_NE(test::complaint_of([&] {
              (void)estimated_depth(path, DepthValue::inverse, std::nullopt, DepthPacking::whole,
                                    camera_of_size(), true_depth_m());
            }).find("larger values where it is nearer"),
            std::string::npos);
  PinholeCamera other = camera_of_size();
  other.width_px = 50;
  EXPECT_NE(test::complaint_of([&] {
              (void)estimated_depth(path, DepthValue::relative, std::nullopt, DepthPacking::whole, other,
                                    std::vector<float>(50 * 32, 1.0F));
            }).find("50 x 32"),
            std::string::npos);
}

TEST(EstimateError, IsByTheDefinitions) {
  const std::vector<float> truth = {1, 2, 4, 10, hole, 5}, depth = {1.1F, 2, 5.2F, 8.2F, 3, hole};
  const DepthError error = depth_error(depth, truth);
  EXPECT_EQ(error.compared, 4);
  EXPECT_NEAR(error.abs_rel, (0.1 + 0 + 0.3 + 0.18) / 4, 1e-6);
  EXPECT_NEAR(error.rmse_m, std::sqrt((0.01 + 0 + 1.44 + 3.24) / 4), 1e-6);
  EXPECT_NEAR(error.within_quarter, 3.0 / 4, 1e-12);  // 5.2 / 4 is 1.3
  EXPECT_EQ(depth_error(std::vector<float>{hole}, std::vector<float>{1.0F}).compared, 0);
}

TEST(EstimateError, AShareLiesBetweenAndItsEndsAreExact) {
  const std::vector<float> truth = {1, 2, hole, 4, 0.3F}, estimate = {2, 1.7F, 5, hole, 0.31F};
  std::vector<float> none = estimate, all = estimate, half = estimate;
  mix_with_truth(truth, 0, none);
  mix_with_truth(truth, 1, all);
  mix_with_truth(truth, 0.5, half);
  EXPECT_EQ(none, truth);
  EXPECT_EQ(all, estimate);
  EXPECT_FLOAT_EQ(half[0], 1 / (0.5F / 1 + 0.5F / 2));
  EXPECT_FLOAT_EQ(half[2], 10);  // nothing is infinitely far
  EXPECT_EQ(half[3], hole);
}

}  // namespace
}  // namespace seamline::sensors
