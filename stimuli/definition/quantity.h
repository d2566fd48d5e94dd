#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "stimuli/definition/axis.h"

namespace seamline::inline stimuli {

/// What the levels of a study are values of.
enum class Quantity {
  depth_width_px,
  texels_per_degree,
  mesh_tolerance,
  sun_radius_deg,
  depth_noise,
  outlier_share,
  calibration_error_deg,
  calibration_error_m,
  depth_field_of_view_deg,
  depth_delay_ms,
  shadow_map_px,
  shadow_bias_texels,
  light_count,
  field_bands,
  field_shells,
  object_speed_m_s,
  depth_frames_per_s,
  depth_samples,
  estimate_share
};
inline constexpr std::array<Quantity, 19> every_quantity = {
    Quantity::depth_width_px,        Quantity::texels_per_degree,   Quantity::mesh_tolerance,
    Quantity::sun_radius_deg,        Quantity::depth_noise,         Quantity::outlier_share,
    Quantity::calibration_error_deg, Quantity::calibration_error_m, Quantity::depth_field_of_view_deg,
    Quantity::depth_delay_ms,        Quantity::shadow_map_px,       Quantity::shadow_bias_texels,
    Quantity::light_count,           Quantity::field_bands,         Quantity::field_shells,
    Quantity::object_speed_m_s,      Quantity::depth_frames_per_s,  Quantity::depth_samples,
    Quantity::estimate_share};

/// What is known of a quantity: one row of the table in quantity.cpp.
struct QuantityFacts {
  std::string_view key;       ///< as in study files, manifests and logs
  std::string_view name;      ///< as in figures and tables: "depth map width"
  std::string_view unit;      ///< behind a number: "px"; empty: a ratio
  std::string_view unit_key;  ///< at the end of keys and column names: "px"; empty: none
  Axis axis = Axis::log2;     ///< on which a psychometric function is a sigmoid
  Direction noticeability = Direction::decreasing;  ///< as the level grows, unless a study says otherwise
  bool changes_truth = false;                       ///< else only the depth
  double least = 0, most = 0;  ///< that a level may be; least is above 0 where 0 means nothing
  bool whole = false;          ///< levels are whole numbers
  int digits = 0,
      decimals = 0;  ///< of a level in ids: at least so many digits before the point, so many behind
};

[[nodiscard]] const QuantityFacts& facts(Quantity quantity);
[[nodiscard]] std::optional<Quantity> quantity_from_key(std::string_view key);

/// A level of 0 on a log2 axis is "none": it stands apart, at the end of the curve, and is no part of a
/// sigmoid.
[[nodiscard]] bool stands_apart(Axis axis, double level);

/// A level as ids hold it: of fixed length, so that ids sort by it, without a point, so that no part of it
/// looks like a file's ending: `0512`, `0p000100000`, `02p500`.
[[nodiscard]] std::string level_in_id(Quantity quantity, double level);

/// A level for people, with its unit: `512 px`, `0.0001`, `2.5 degrees`, `none`.
[[nodiscard]] std::string level_text(Quantity quantity, double level);

}  // namespace seamline::inline stimuli
