#include "sensors/rig/presets.h"

#include <fmt/core.h>
#include <fmt/format.h>

#include <cmath>

#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/suggest.h"

namespace seamline::sensors {
namespace {

/// A pinhole of the two angles of a data sheet, whose pixels are square only if the angles say so.
PinholeCamera pinhole_of_angles(int width_px, int height_px, double horizontal_deg, double vertical_deg) {
  PinholeCamera camera = pinhole_of_field_of_view(width_px, height_px, horizontal_deg);
  camera.fy_px = height_px / (2 * std::tan(vertical_deg * std::numbers::pi / 360));
  return camera;
}

PinholeCamera pinhole_of_focal_length(int width_px, int height_px, double focal_px) {
  return {.width_px = width_px,
          .height_px = height_px,
          .fx_px = focal_px,
          .fy_px = focal_px,
          .cx_px = 0.5 * width_px,
          .cy_px = 0.5 * height_px,
          .skew_px = 0,
          .distortion = {}};
}

SensorPreset pmd_19k() {
  Rig rig;
  rig.depth = pinhole_of_field_of_view(160, 120, 30);
  rig.colour = pinhole_of_field_of_view(640, 480, 34);
  rig.colour_from_depth.translation() = Eigen::Vector3d(0, 0.06, 0);  // the colour camera is on top
  rig.noise = TimeOfFlightNoise{.modulation_hz = 20e6,
                                .amplitude_at_1m_e = 36530,
                                .contrast = 0.5,
                                .background_e = 5000,
                                .readout_e = 50,
                                .weakest_amplitude_e = 100,
                                .outliers = {.share = 0.001, .nearest_m = 0.1, .farthest_m = 7.5},
                                .range = {.nearest_m = 0.1, .farthest_m = 7.5}};
  return {
      "tof_160x120", "PMD[vision] 19k with a Matrix Vision BlueFox, the rig of paper 002",
      "Paper 002 (sections 3, 3.1 and 7): 160 x 120, 12 mm lens, about 30 degrees; colour 1600 x 1200, 12 mm "
      "lens, about 34 degrees, used at 640 x 480, on top of the depth camera. Ours: 20 MHz (the usual "
      "modulation of such cameras, 7.5 m); 0.06 m between the lenses; electrons such that two standard "
      "deviations are 2 % of 1.176 m on a surface of albedo 0.5, after the paper's deviation of 'less than "
      "2 %', which bounds the noise from above; one outlier in a thousand pixels for 'sporadically'.",
      rig};
}

SensorPreset kinect_1() {
  Rig rig;
  rig.depth = pinhole_of_focal_length(640, 480, 585.6);
  rig.colour = pinhole_of_focal_length(640, 480, 525);
  rig.colour_from_depth.translation() = Eigen::Vector3d(-0.025, 0, 0);
  rig.projector_m = Eigen::Vector3d(0.075, 0, 0);
  rig.noise = StructuredLightNoise{.focal_px = 585.6,
                                   .baseline_m = 0.075,
                                   .sigma_px = 0.0625,
                                   .step_px = 0.125,
                                   .grazing_sigma_m = 0.0001,
                                   .sure_deg = 70,
                                   .lost_deg = 88,
                                   .sure_signal = 0.004,
                                   .lost_signal = 0.001,
                                   .range = {.nearest_m = 0.5, .farthest_m = 5}};
  return {
      "structured_light_640x480", "Kinect for Xbox 360 (PrimeSense)",
      "Khoshelham and Elberink 2012: 0.075 m to the projector, disparities in eighths of a pixel with a "
      "standard deviation of half a step, 0.5 to 5 m (about 4 cm at 5 m). 585.6 pixels is the focal length "
      "in use for its infrared camera. Colour: OpenNI's default of 525 pixels. Konolige and Mihelich, "
      "'Technical description of Kinect calibration' (ROS, 2010): 0.025 m between the lenses, the colour "
      "camera on the projector's side. Nguyen, Izadi and Lovell 2012: noise at grazing angles. Ours: where "
      "dropouts by angle and darkness begin and end. Single devices differ by some pixels; calibrate yours.",
      rig};
}

SensorPreset azure_kinect() {
  Rig rig;
  rig.depth = pinhole_of_angles(640, 576, 75, 65);
  rig.colour = pinhole_of_angles(1280, 720, 90, 59);
  rig.colour_from_depth = pose_of({-0.032, -0.002, 0.004}, Eigen::Vector3d::UnitX(), -6);
  rig.noise = TimeOfFlightNoise{.modulation_hz = 100e6,
                                .amplitude_at_1m_e = 40925,
                                .contrast = 0.5,
                                .background_e = 500,
                                .readout_e = 20,
                                .weakest_amplitude_e = 100,
                                .wraps = false,
                                .range = {.nearest_m = 0.5, .farthest_m = 3.86}};
  return {
      "tof_640x576", "Azure Kinect, narrow field of view, unbinned",
      "Microsoft, 'Azure Kinect DK hardware specifications': 640 x 576, 75 x 65 degrees, 0.5 to 3.86 m, "
      "random error at most 17 mm for reflectivities of 15 to 95 %; colour 1280 x 720, 90 x 59 degrees; the "
      "depth camera is tilted 6 degrees down. Toelgyessy, Dekan, Chovanec and Hubinsky, Sensors 21(2), 2021, "
      "measured the same error. Ours: one frequency of 100 MHz, whose ambiguity the several real ones "
      "resolve; electrons such that sigma is 17 mm at 3.86 m and albedo 0.15; 0.032 m between the lenses, as "
      "single devices report. The real lens has a rational distortion that is not modelled, and the device "
      "delivers planar values.",
      rig};
}

SensorPreset leica_blk360() {
  Scanner scanner;
  scanner.noise = GenericNoise{.convention = DepthConvention::radial,
                               .relative_sigma = 4e-4,
                               .step_m = 0,
                               .dropout_share = 0,
                               .outliers = {},
                               .range = {.nearest_m = 0.6, .farthest_m = 60}};
  return {
      "scanner_360", "Leica BLK360, medium resolution",
      "Leica Geosystems, data sheet of the BLK360 (2017): 360 x 300 degrees, 0.6 to 60 m, 4 mm at 10 m and "
      "7 mm at 20 m, points 10 mm apart at 10 m in its medium resolution. Ours: one relative sigma for both "
      "distances (8 mm at 20 m).",
      scanner};
}

}  // namespace

const std::vector<SensorPreset>& sensor_presets() {
  static const std::vector<SensorPreset> presets = {pmd_19k(), kinect_1(), azure_kinect(), leica_blk360()};
  return presets;
}

const SensorPreset& sensor_preset(const std::string& key, const std::string& field) {
  std::vector<std::string> keys;
  for (const SensorPreset& preset : sensor_presets()) {
    if (preset.key == key) return preset;
    keys.emplace_back(preset.key);
  }
  const std::string nearest = nearest_word(key, keys);
  throw input_error({.file = {},
                     .field = field,
                     .wanted = fmt::format("one of {}", fmt::join(keys, ", ")),
                     .found = nearest.empty()
                                  ? printable(key)
                                  : fmt::format("{}; did you mean {}?", printable(key), nearest)});
}

}  // namespace seamline::sensors
