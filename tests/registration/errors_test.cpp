// Registered depth beside the truth: a planted scene in which it is known why each pixel is wrong.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "registration/errors/error_report.h"
#include "registration/mesh/register_by_mesh.h"
#include "registration/points/register_by_points.h"
#include "tests/complaint.h"
#include "tests/registration/synthetic_depth.h"

namespace seamline::registration {
namespace {

using namespace test;
using seamline::test::complaint_of;

/// A rectangle at a distance, x and y from the least to the most.
struct Plate {
  double z, left, right, top, bottom;
};

Scene plates(std::vector<Plate> all) {
  return [all = std::move(all)](const Vector3d& from_m, const Vector3d& direction) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Plate& plate : all) {
      const double way = (plate.z - from_m.z()) / direction.z();
      const Vector3d point_m = from_m + way * direction;
      if (way > 0 && point_m.x() >= plate.left && point_m.x() <= plate.right && point_m.y() >= plate.top &&
          point_m.y() <= plate.bottom)
        nearest = std::min(nearest, way);
    }
    return nearest;
  };
}

/// A wall at 2 m, above it on the left one at 6 m and on the right nothing; before it a plate at 1 m, one at
/// 0.3 m, and one at 1.5 m beyond the depth camera's view. The photograph's camera stands 5 cm to the right.
struct Planted {
  Scene scene = plates({{2, -5, 5, -0.5, 5},
                        {6, -9, 0, -9, 9},
                        {1, -0.15, 0.15, -0.15, 0.15},
                        {0.3, -0.15, -0.08, 0.03, 0.12},
                        {1.5, 0.9, 2, -0.3, 0.3}});
  PinholeCamera depth = sensors::pinhole_of_field_of_view(160, 120, 60);
  PinholeCamera colour = sensors::pinhole_of_field_of_view(320, 240, 70);
  Isometry3d colour_from_depth = sensors::pose_of({-0.05, 0, 0}, {0, 0, 1}, 0);
  DepthFrame measured, truth;
  ErrorSettings settings{.tolerance = 0.05, .range = {.nearest_m = 0.5, .farthest_m = 5}, .threads = 1};

  Planted() : measured(depth_of(scene, depth, DepthConvention::planar)), truth(measured) {
    for (int row = 0; row < depth.height_px; ++row)
      for (int column = 0; column < depth.width_px; ++column) {
        const double x = (column + 0.5 - depth.cx_px) / depth.fx_px,
                     y = (row + 0.5 - depth.cy_px) / depth.fy_px;
        float& depth_m = measured.depth_m[measured.index(column, row)];
        const auto is_in = [&](double left, double right, double top, double bottom) {
          return 2 * x > left && 2 * x < right && 2 * y > top && 2 * y < bottom;
        };
        if (!(depth_m >= 0.5F && depth_m <= 5)) depth_m = sensors::hole;
        if (is_in(0.5, 0.8, 0.3, 0.6)) depth_m *= 1.2F;
        if (is_in(0.5, 0.8, -0.3, 0)) depth_m = sensors::hole;
        if (is_in(0.4, 0.7, -0.82, -0.66)) depth_m = 2;
      }
    truth.camera = colour;
    truth.depth_m.clear();
    for (int row = 0; row < colour.height_px; ++row)
      for (int column = 0; column < colour.width_px; ++column)
        truth.depth_m.push_back(
            static_cast<float>(true_planar_m(scene, colour, colour_from_depth, {column + 0.5, row + 0.5})));
  }
  [[nodiscard]] RegisteredFrame by_mesh() const {
    return register_by_mesh(measured, colour_from_depth, colour, {.border_extrusion_px = 20, .threads = 1});
  }
  [[nodiscard]] ErrorClassMap errors(const RegisteredFrame& registered) const {
    return classify_errors(registered, truth, measured, colour_from_depth, settings);
  }
  [[nodiscard]] std::size_t pixel_of(const Vector3d& point_m) const {
    const Eigen::Vector2d place_px = *sensors::project(colour, colour_from_depth * point_m);
    return truth.index(static_cast<int>(place_px.x()), static_cast<int>(place_px.y()));
  }
  /// The true point of a pixel in the depth camera's frame.
  [[nodiscard]] Vector3d point_of(std::size_t pixel) const {
    const auto width = static_cast<std::size_t>(colour.width_px);
    return colour_from_depth.inverse() *
           *sensors::point_of_pixel(truth, static_cast<int>(pixel % width), static_cast<int>(pixel / width));
  }
  [[nodiscard]] bool is_hidden(const Vector3d& point_m) const {
    return scene(Vector3d::Zero(), point_m) < 1 - settings.tolerance;
  }
  /// Whether what a camera sees within so many pixels around a point is at very different depths.
  [[nodiscard]] bool has_outline(const PinholeCamera& camera, const Isometry3d& pose, const Vector3d& point_m,
                                 double reach_px) const {
    const Eigen::Vector2d middle_px = *sensors::project(camera, pose * point_m);
    double nearest = std::numeric_limits<double>::infinity(), farthest = 0;
    for (double y = -reach_px; y <= reach_px; y += 0.25)
      for (double x = -reach_px; x <= reach_px; x += 0.25) {
        const double seen_m = true_planar_m(scene, camera, pose, middle_px + Eigen::Vector2d(x, y));
        nearest = std::min(nearest, seen_m);
        farthest = std::max(farthest, seen_m);
      }
    return farthest > 1.05 * nearest;
  }
};

TEST(ErrorClasses, EachPlantedReasonIsFound) {
  const Planted planted;
  const ErrorClassMap errors = planted.errors(planted.by_mesh());
  const auto at = [&](double x, double y, double z) {
    return std::string(word(errors.classes[planted.pixel_of({x, y, z})]));
  };
  EXPECT_EQ(at(-0.6, -0.3, 2), "right");
  EXPECT_EQ(at(0, 0, 1), "right");
  EXPECT_EQ(at(0.98, 0, 1.5), "border");
  EXPECT_EQ(at(-0.115, 0.075, 0.3), "near");
  EXPECT_EQ(at(-1, -2, 6), "far");
  EXPECT_EQ(at(0.28, 0, 2), "occluded");
  EXPECT_EQ(at(0.55, -0.74, 2), "nothing");
  EXPECT_EQ(at(0.65, -0.15, 2), "unmeasured");
  EXPECT_EQ(at(0.65, 0.45, 2), "noise");
  EXPECT_NEAR(errors.of(ErrorClass::noise).median_error_m, 0.4, 1e-6);
  EXPECT_GT(errors.of(ErrorClass::edge).pixels, 0);
  EXPECT_EQ(errors.of(ErrorClass::gap).pixels, 0);
}

TEST(ErrorClasses, OfEveryPixelTheReasonHoldsByFormula) {
  const Planted planted;
  const RegisteredFrame registered = planted.by_mesh();
  const ErrorClassMap errors = planted.errors(registered);
  int hidden = 0, called_hidden = 0;
  for (std::size_t i = 0; i < errors.classes.size(); ++i) {
    const float found_m = registered.frame.depth_m[i], true_m = planted.truth.depth_m[i];
    const bool right = std::isinf(found_m) || std::isinf(true_m)
                           ? found_m == true_m
                           : std::abs(found_m - true_m) <= 0.05 * true_m;
    ASSERT_EQ(right, errors.classes[i] == ErrorClass::right) << i;
    if (right || std::isinf(true_m)) continue;
    const Vector3d point_m = planted.point_of(i);
    const ErrorClass one = errors.classes[i];
    if (one == ErrorClass::near) {
      EXPECT_LT(point_m.z(), 0.5);
    }
    if (one == ErrorClass::far) {
      EXPECT_GT(point_m.z(), 5);
    }
    if (one == ErrorClass::occluded) {
      EXPECT_TRUE(planted.is_hidden(point_m)) << point_m.transpose();
    }
    if (one == ErrorClass::edge) {
      EXPECT_TRUE(planted.has_outline(planted.depth, Isometry3d::Identity(), point_m, 3) ||
                  planted.has_outline(planted.colour, planted.colour_from_depth, point_m, 6))
          << point_m.transpose();
    }
    if (one == ErrorClass::noise) {
      // A triangle carries the planted patch a pixel farther.
      EXPECT_NEAR(point_m.x(), 0.65, 0.15 + 0.02) << point_m.transpose();
      EXPECT_NEAR(point_m.y(), 0.45, 0.15 + 0.02) << point_m.transpose();
    }
    if (one == ErrorClass::border || one == ErrorClass::near || one == ErrorClass::far) continue;
    if (planted.is_hidden(point_m)) ++hidden, called_hidden += one == ErrorClass::occluded ? 1 : 0;
  }
  EXPECT_GT(hidden, 300);
  EXPECT_GT(called_hidden, 0.8 * hidden) << "but for the outermost pixel along outlines";
}

TEST(ErrorClasses, CountsAreOfAllPixelsAndTheSameForAnyNumberOfThreads) {
  Planted planted;
  for (const RegisteredFrame& registered :
       {planted.by_mesh(), register_by_points(planted.measured, planted.colour_from_depth, planted.colour)}) {
    const ErrorClassMap errors = planted.errors(registered);
    std::int64_t sum = 0, holes = 0;
    for (std::size_t i = 0; i < error_class_count; ++i) {
      EXPECT_EQ(errors.tallies[i].pixels,
                std::count(errors.classes.begin(), errors.classes.end(), static_cast<ErrorClass>(i)));
      sum += errors.tallies[i].pixels;
      holes += errors.tallies[i].without_depth;
    }
    EXPECT_EQ(sum, 320 * 240);
    EXPECT_EQ(holes, 320 * 240 - count_of(registered.filled));
    planted.settings.threads = 3;
    EXPECT_EQ(planted.errors(registered).classes, errors.classes);
    planted.settings.threads = 1;
  }
}

TEST(ErrorClasses, WhatPointsDoNotReachIsAGap) {
  const Planted planted;
  const RegisteredFrame registered =
      register_by_points(planted.measured, planted.colour_from_depth, planted.colour);
  const ErrorClassMap errors = planted.errors(registered);
  const std::int64_t holes =
      static_cast<std::int64_t>(registered.filled.size()) - count_of(registered.filled);
  EXPECT_GT(errors.of(ErrorClass::gap).pixels, holes / 4);
  EXPECT_LT(errors.of(ErrorClass::gap).pixels, holes);
  EXPECT_EQ(errors.of(ErrorClass::gap).without_depth, errors.of(ErrorClass::gap).pixels);
}

TEST(ErrorClasses, ExactDepthIsRightAndTheTableAndThePictureSayWhatTheMapSays) {
  const Planted planted;
  RegisteredFrame exact = empty_frame(planted.colour);
  exact.frame.depth_m = planted.truth.depth_m;
  EXPECT_EQ(planted.errors(exact).of(ErrorClass::right).pixels, 320 * 240);

  const ErrorClassMap errors = planted.errors(planted.by_mesh());
  const CsvTable table = errors_table(errors);
  ASSERT_EQ(table.rows.size(), error_class_count + 1);
  double share = 0, of_wrong = 0;
  for (std::size_t i = 0; i < error_class_count; ++i) {
    share += std::get<double>(table.rows[i][3]);
    if (i > 0) of_wrong += std::get<double>(table.rows[i][4]);
  }
  EXPECT_NEAR(share, 1, 1e-12);
  EXPECT_NEAR(of_wrong, 1, 1e-12);
  EXPECT_EQ(std::get<std::int64_t>(table.rows.back()[2]), 320 * 240);

  const Image photograph(320, 240, 3, 0.4F);
  const ByteImage picture = errors_over_photograph(errors, photograph), plain = display_image(photograph);
  for (std::size_t i = 0; i < errors.classes.size(); ++i) {
    const std::string colour = fmt::format("#{:02x}{:02x}{:02x}", picture.values[3 * i],
                                           picture.values[3 * i + 1], picture.values[3 * i + 2]);
    if (errors.classes[i] == ErrorClass::right)
      ASSERT_EQ(picture.values[3 * i], plain.values[3 * i] / 3);
    else
      ASSERT_EQ(colour, std::get<std::string>(table.rows[static_cast<std::size_t>(errors.classes[i])][1]));
  }
}

TEST(ErrorClasses, ATruthOfAnotherSizeIsRefused) {
  Planted planted;
  planted.truth.depth_m.pop_back();
  EXPECT_EQ(complaint_of([&] { (void)planted.errors(planted.by_mesh()); }),
            "registration: truth: wanted 76800 values, one for each pixel of the photograph, found 76799");
}

}  // namespace
}  // namespace seamline::registration
