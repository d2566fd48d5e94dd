#include "stimuli/definition/quantity.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstddef>

namespace seamline::inline stimuli {
namespace {

/// In the order of the enumeration.
constexpr std::array<QuantityFacts, every_quantity.size()> table = {{
    {.key = "depth_width_px",
     .name = "depth map width",
     .unit = "px",
     .unit_key = "px",
     .axis = Axis::log2,
     .noticeability = Direction::decreasing,
     .changes_truth = false,
     .least = 2,
     .most = 16384,
     .whole = true,
     .digits = 4,
     .decimals = 0},
    {.key = "texels_per_degree",
     .name = "texels per degree",
     .unit = "texels per degree",
     .unit_key = "texels_per_degree",
     .axis = Axis::log2,
     .noticeability = Direction::decreasing,
     .changes_truth = false,
     .least = 2.0 / 360,
     .most = 16384.0 / 360,
     .whole = false,
     .digits = 2,
     .decimals = 4},
    {.key = "mesh_tolerance",
     .name = "mesh tolerance",
     .unit = "",
     .unit_key = "",
     .axis = Axis::log2,
     .noticeability = Direction::increasing,
     .changes_truth = false,
     .least = 0,
     .most = 1,
     .whole = false,
     .digits = 1,
     .decimals = 9},
    {.key = "sun_radius_deg",
     .name = "angular radius of the sun",
     .unit = "degrees",
     .unit_key = "deg",
     .axis = Axis::linear,
     .noticeability = Direction::decreasing,
     .changes_truth = true,
     .least = 0,
     .most = 45,
     .whole = false,
     .digits = 2,
     .decimals = 3},
    {.key = "depth_noise",
     .name = "depth noise",
     .unit = "",
     .unit_key = "",
     .axis = Axis::log2,
     .noticeability = Direction::increasing,
     .changes_truth = false,
     .least = 0,
     .most = 1000,
     .whole = false,
     .digits = 4,
     .decimals = 4},
    {.key = "outlier_share",
     .name = "share of outliers",
     .unit = "",
     .unit_key = "",
     .axis = Axis::log2,
     .noticeability = Direction::increasing,
     .changes_truth = false,
     .least = 0,
     .most = 1,
     .whole = false,
     .digits = 1,
     .decimals = 7},
    {.key = "calibration_error_deg",
     .name = "calibration error",
     .unit = "degrees",
     .unit_key = "deg",
     .axis = Axis::log2,
     .noticeability = Direction::increasing,
     .changes_truth = false,
     .least = 0,
     .most = 45,
     .whole = false,
     .digits = 2,
     .decimals = 4},
    {.key = "calibration_error_m",
     .name = "calibration error",
     .unit = "m",
     .unit_key = "m",
     .axis = Axis::log2,
     .noticeability = Direction::increasing,
     .changes_truth = false,
     .least = 0,
     .most = 10,
     .whole = false,
     .digits = 2,
     .decimals = 5},
    {.key = "depth_field_of_view_deg",
     .name = "depth field of view",
     .unit = "degrees",
     .unit_key = "deg",
     .axis = Axis::log2,
     .noticeability = Direction::decreasing,
     .changes_truth = false,
     .least = 1,
     .most = 170,
     .whole = false,
     .digits = 3,
     .decimals = 2},
    {.key = "depth_delay_ms",
     .name = "depth delay",
     .unit = "ms",
     .unit_key = "ms",
     .axis = Axis::log2,
     .noticeability = Direction::increasing,
     .changes_truth = false,
     .least = 0,
     .most = 10000,
     .whole = false,
     .digits = 5,
     .decimals = 2},
    {.key = "shadow_map_px",
     .name = "shadow map width",
     .unit = "px",
     .unit_key = "px",
     .axis = Axis::log2,
     .noticeability = Direction::decreasing,
     .changes_truth = false,
     .least = 8,
     .most = 8192,
     .whole = true,
     .digits = 4,
     .decimals = 0},
    {.key = "shadow_bias_texels",
     .name = "shadow bias",
     .unit = "texels",
     .unit_key = "texels",
     .axis = Axis::log2,
     .noticeability = Direction::increasing,
     .changes_truth = false,
     .least = 0,
     .most = 100,
     .whole = false,
     .digits = 3,
     .decimals = 4},
    {.key = "light_count",
     .name = "number of lights",
     .unit = "lights",
     .unit_key = "lights",
     .axis = Axis::log2,
     .noticeability = Direction::decreasing,
     .changes_truth = false,
     .least = 1,
     .most = 1024,
     .whole = true,
     .digits = 4,
     .decimals = 0},
    {.key = "field_bands",
     .name = "bands of the occlusion field",
     .unit = "bands",
     .unit_key = "bands",
     .axis = Axis::log2,
     .noticeability = Direction::decreasing,
     .changes_truth = false,
     .least = 1,
     .most = 8,
     .whole = true,
     .digits = 1,
     .decimals = 0},
    {.key = "field_shells",
     .name = "shells of the occlusion field",
     .unit = "shells",
     .unit_key = "shells",
     .axis = Axis::log2,
     .noticeability = Direction::decreasing,
     .changes_truth = false,
     .least = 1,
     .most = 64,
     .whole = true,
     .digits = 2,
     .decimals = 0},
}};

}  // namespace

const QuantityFacts& facts(Quantity quantity) {
  return table.at(static_cast<std::size_t>(quantity));
}

std::optional<Quantity> quantity_from_key(std::string_view key) {
  for (const Quantity quantity : every_quantity)
    if (facts(quantity).key == key) return quantity;
  return std::nullopt;
}

bool stands_apart(Axis axis, double level) {
  return axis == Axis::log2 && level == 0;
}

std::string level_in_id(Quantity quantity, double level) {
  const QuantityFacts& about = facts(quantity);
  const int length = about.digits + (about.decimals > 0 ? 1 + about.decimals : 0);
  std::string text = fmt::format("{:0{}.{}f}", level, length, about.decimals);
  std::replace(text.begin(), text.end(), '.', 'p');
  return text;
}

std::string level_text(Quantity quantity, double level) {
  const QuantityFacts& about = facts(quantity);
  if (stands_apart(about.axis, level)) return "none";
  return about.unit.empty() ? fmt::format("{}", level) : fmt::format("{} {}", level, about.unit);
}

}  // namespace seamline::inline stimuli
