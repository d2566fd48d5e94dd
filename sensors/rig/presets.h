#pragma once
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "sensors/rig/rig.h"

namespace seamline::sensors {

/// A sensor by its name in files. `source` says where its numbers come from, and which are ours because no
/// source states them.
struct SensorPreset {
  std::string_view key;
  std::string_view title;
  std::string_view source;
  std::variant<Rig, Scanner> sensor;
};

/// All presets: "tof_160x120" (paper 002's rig), "structured_light_640x480" (Kinect 1), "tof_640x576" (Azure
/// Kinect) and "scanner_360" (Leica BLK360).
[[nodiscard]] const std::vector<SensorPreset>& sensor_presets();

/// The preset of this name. Throws InputError, naming `field` and the nearest name, where there is none.
[[nodiscard]] const SensorPreset& sensor_preset(const std::string& key, const std::string& field);

}  // namespace seamline::sensors
