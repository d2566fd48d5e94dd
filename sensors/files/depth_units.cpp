#include "sensors/files/depth_units.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/suggest.h"

namespace seamline::sensors {

std::span<const DepthUnit> depth_units() {
  constexpr double kitti = 1.0 / 256, tum = 1.0 / 5000, tenth = 1e-4, replica = 1.0 / 6553.5;
  static const std::vector<DepthUnit> units = {
      {"metres", 1, {}, "metres"},
      {"millimetres", 1e-3, {65535}, "millimetres: most depth cameras and data sets"},
      {"kinect", 1e-3, {65535}, "millimetres: Kinect of both generations, Azure Kinect (0: nothing)"},
      {"realsense", 1e-3, {65535}, "millimetres: Intel RealSense D400 as it is delivered"},
      {"realsense_l515", 0.00025, {65535}, "a quarter of a millimetre: Intel RealSense L515"},
      {"scannet", 1e-3, {65535}, "millimetres: ScanNet, ARKitScenes, Redwood, SUN3D"},
      {"7scenes", 1e-3, {65535}, "millimetres, 65535: nothing: 7-Scenes"},
      {"kitti", kitti, {}, "1/256 m: KITTI (0: nothing)"},
      {"vkitti", 1e-2, {65535}, "centimetres, 65535: sky: Virtual KITTI"},
      {"tum", tum, {}, "1/5000 m: TUM RGB-D, ICL-NUIM (0: nothing)"},
      {"tenths", tenth, {65535}, "tenths of a millimetre"},
      {"replica", replica, {}, "1/6553.5 m: Replica as NICE-SLAM renders it"},
      {"matterport", 0.00025, {}, "1/4000 m: Matterport3D"},
      {"2d3ds", 1.0 / 512, {65535}, "1/512 m, 65535: nothing: Stanford 2D-3D-S, radial panoramas"}};
  return units;
}

const DepthUnit& depth_unit(const std::string& name, const std::string& field) {
  std::vector<std::string> known;
  for (const DepthUnit& unit : depth_units()) {
    if (unit.name == name) return unit;
    known.emplace_back(unit.name);
  }
  const std::string nearest = nearest_word(name, known);
  throw input_error({.field = field,
                     .wanted = fmt::format("one of {}", fmt::join(known, ", ")),
                     .found = printable(name) + (nearest.empty() ? "" : "; did you mean " + nearest + "?")});
}

}  // namespace seamline::sensors
