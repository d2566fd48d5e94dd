#include "stimuli/study_file/parts/study_file_camera.h"

#include <fmt/core.h>

#include <algorithm>
#include <numbers>

#include "stimuli/settings/depth_settings.h"
#include "stimuli/settings/read_settings.h"

namespace seamline::inline stimuli {
namespace {

void read_size(const TomlTable& table, bool known, sensors::PinholeCamera& camera) {
  if (!table.has("size_px")) {
    if (!known) throw table.missing("size_px", "width and height of the depth map");
    return;
  }
  const std::vector<int> size = table.integers("size_px", NumberRange{2, 8192, "px"});
  if (size.size() != 2 || size[0] % 2 != 0)
    throw table.complaint("size_px", "two whole numbers, the first an even one: [width, height]",
                          size.size() == 2 ? fmt::format("[{}, {}]", size[0], size[1])
                                           : fmt::format("an array of {}", size.size()));
  camera = resized(camera, size[0], size[1]);
}

/// One way to say how wide the camera looks; fx = fy but where `fy` says otherwise.
void read_focal_lengths(const TomlTable& table, bool known, sensors::PinholeCamera& camera) {
  constexpr std::array ways = {"field_of_view_deg", "texels_per_degree", "fx"};
  const auto given = std::count_if(ways.begin(), ways.end(), [&](const char* key) { return table.has(key); });
  if (given > 1)
    throw table.complaint("field_of_view_deg", "one of field_of_view_deg, texels_per_degree and fx",
                          "several");
  if (given == 0 && !known)
    throw table.complaint("fx", "fx, field_of_view_deg or texels_per_degree of the pinhole", "none of them");
  constexpr NumberRange focal_range{1e-3, 1e6, "pixels"};
  if (table.has("fx")) camera.fx_px = camera.fy_px = table.number("fx", 0, focal_range);
  if (table.has("field_of_view_deg")) {
    const double deg = table.number("field_of_view_deg", 0, {1, 170, "degrees"});
    camera.fx_px = camera.fy_px =
        sensors::pinhole_of_field_of_view(camera.width_px, camera.height_px, deg).fx_px;
  }
  if (table.has("texels_per_degree"))
    camera.fx_px = camera.fy_px =
        table.number("texels_per_degree", 0, {1e-3, 1e4, "texels per degree"}) * 180 / std::numbers::pi;
  if (table.has("fy")) {
    if (given > 0 && !table.has("fx"))
      throw table.complaint("fy", "fx beside it, or neither", "another way to say how wide the camera looks");
    camera.fy_px = table.number("fy", 0, focal_range);
  }
}

}  // namespace

sensors::SensorRange read_range_m(const TomlTable& table, const sensors::SensorRange& usual) {
  if (!table.has("range_m")) return usual;
  const std::vector<double> ends = table.numbers("range_m", NumberRange{0, 1e9, "m"});
  if (ends.size() != 2 || !(ends[0] < ends[1]))
    throw table.complaint(
        "range_m", "two distances, the nearest and a larger one",
        fmt::format("{} numbers{}", ends.size(), ends.size() == 2 ? " that do not rise" : ""));
  return {.nearest_m = ends[0], .farthest_m = ends[1]};
}

sensors::PinholeCamera read_camera(const TomlTable& table, const sensors::PinholeCamera& usual, bool known) {
  sensors::PinholeCamera camera = usual;
  read_size(table, known, camera);
  read_focal_lengths(table, known, camera);
  if (!known) {
    camera.cx_px = 0.5 * camera.width_px;
    camera.cy_px = 0.5 * camera.height_px;
  }
  read_settings(table, camera);
  if (table.has("distortion")) {
    const std::vector<double> k = table.numbers("distortion", {-1e3, 1e3});
    if (k.size() != 5)
      throw table.complaint("distortion", "five numbers: k1, k2, p1, p2, k3", fmt::format("{}", k.size()));
    camera.distortion = {.k1 = k[0], .k2 = k[1], .p1 = k[2], .p2 = k[3], .k3 = k[4]};
  }
  return camera;
}

SensorPose read_pose(const TomlTable& table, const SensorPose& usual) {
  const auto pose = table.table("pose");
  if (!pose) return usual;
  SensorPose read = usual;
  read_settings(*pose, read);
  pose->finish();
  return read;
}

}  // namespace seamline::inline stimuli
