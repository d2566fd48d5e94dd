// Presets are what their sources say; a rig that is none is refused by field.
#include <gtest/gtest.h>

#include <functional>

#include "sensors/rig/presets.h"
#include "tests/complaint.h"
#include "tests/sensors/noise_samples.h"

namespace seamline::sensors {
namespace {

using namespace testing;
using test::complaint_of;

const Rig& rig_of(const std::string& key) {
  return std::get<Rig>(sensor_preset(key, "preset").sensor);
}

TEST(Presets, AreAllValidAndStateTheirSources) {
  EXPECT_EQ(sensor_presets().size(), 4U);
  for (const SensorPreset& preset : sensor_presets()) {
    EXPECT_NO_THROW(std::visit([](const auto& sensor) { require_valid(sensor, ""); }, preset.sensor))
        << preset.key;
    EXPECT_FALSE(preset.source.empty());
    EXPECT_EQ(&sensor_preset(std::string(preset.key), "preset"), &preset);
  }
}

TEST(Presets, TheRigOfPaper002HasItsLensesAndItsDeviation) {
  const Rig& rig = rig_of("tof_160x120");
  EXPECT_EQ(rig.depth.width_px, 160);
  EXPECT_NEAR(horizontal_field_of_view_deg(rig.depth), 30, 1e-9);
  EXPECT_NEAR(horizontal_field_of_view_deg(rig.colour), 34, 1e-9);
  const auto& model = std::get<TimeOfFlightNoise>(rig.noise);
  EXPECT_NEAR(2 * noise_sigma_m(model, head_on(1.176, 0.5), 1), 0.02 * 1.176, 0.0002);
  EXPECT_NEAR(ambiguity_range_m(model), 7.5, 0.01);
}

TEST(Presets, TheStructuredLightCameraHasAboutFourCentimetresAtFiveMetres) {
  const Rig& rig = rig_of("structured_light_640x480");
  EXPECT_NEAR(horizontal_field_of_view_deg(rig.depth), 57.3, 0.1);
  EXPECT_NEAR(noise_sigma_m(rig.noise, head_on(5), 1), 0.04, 0.005);
  EXPECT_LT(rig.colour_from_depth.translation().x(), 0);  // between depth camera and projector
  EXPECT_GT(rig.projector_m->x(), 0);
}

TEST(Presets, TheTimeOfFlightCameraHasItsDataSheetsError) {
  const Rig& rig = rig_of("tof_640x576");
  EXPECT_NEAR(horizontal_field_of_view_deg(rig.depth), 75, 1e-9);
  EXPECT_NEAR(noise_sigma_m(rig.noise, head_on(3.86, 0.15), 1), 0.017, 0.0002);
  EXPECT_LT(noise_sigma_m(rig.noise, head_on(3.86, 0.95), 1), 0.017);
  // The depth camera looks down: what lies on its axis lies below the axis of the colour camera.
  EXPECT_GT((rig.colour_from_depth * Eigen::Vector3d(0, 0, 1)).y(), 0.09);
}

TEST(Presets, TheScannerHasFourMillimetresAtTenMetres) {
  const auto& scanner = std::get<Scanner>(sensor_preset("scanner_360", "preset").sensor);
  EXPECT_NEAR(noise_sigma_m(scanner.noise, head_on(10), 1), 0.004, 1e-9);
  const double step_rad = 2 * std::numbers::pi / scanner.width_px;
  EXPECT_NEAR(10 * step_rad, 0.010, 1e-4);
  EXPECT_NEAR((scanner.highest_elevation_deg - scanner.lowest_elevation_deg) / scanner.height_px,
              360.0 / scanner.width_px, 1e-4);
}

TEST(Presets, AnUnknownNameIsRefusedWithTheNearest) {
  EXPECT_EQ(
      complaint_of([] { (void)sensor_preset("tof_160x121", "depth.preset"); }),
      "depth.preset: wanted one of tof_160x120, structured_light_640x480, tof_640x576, scanner_360, found "
      "tof_160x121; did you mean tof_160x120?");
}

TEST(Rig, APoseIsARotationThenATranslation) {
  const Eigen::Isometry3d pose = pose_of({1, 2, 3}, {0, 0, 2}, 90);
  EXPECT_LT((pose * Eigen::Vector3d(1, 0, 0) - Eigen::Vector3d(1, 3, 3)).norm(), 1e-12);
  EXPECT_NO_THROW(require_rigid(pose, "pose"));
}

TEST(Rig, WhatIsNoneIsRefusedByField) {
  const auto refused = [](const std::function<void(Rig&)>& spoil) {
    Rig rig = rig_of("structured_light_640x480");
    spoil(rig);
    return complaint_of([&] { require_valid(rig, "rig."); });
  };
  EXPECT_EQ(refused([](Rig& rig) { rig.depth.fx_px = 0; }),
            "rig.depth.fx: wanted a focal length above 0 pixels, found 0");
  EXPECT_EQ(
      refused([](Rig& rig) { rig.colour_from_depth.linear() *= 1.01; }),
      "rig.colour_from_depth: wanted a rotation, whose columns are of length 1 and at right angles, found a "
      "matrix that is off by 0.02");
  EXPECT_EQ(refused([](Rig& rig) { rig.colour_from_depth.linear() *= -1; }),
            "rig.colour_from_depth: wanted a rotation, found a reflection (determinant -1)");
  EXPECT_EQ(refused([](Rig& rig) { rig.colour_from_depth.translation().x() = std::nan(""); }),
            "rig.colour_from_depth: wanted finite numbers, found others");
  EXPECT_EQ(refused([](Rig& rig) { std::get<StructuredLightNoise>(rig.noise).sigma_px = -1; }),
            "rig.noise.sigma_px: wanted a number from 0 to 1e+06, found -1");
}

}  // namespace
}  // namespace seamline::sensors
