#pragma once
#include <algorithm>
#include <array>
#include <string>

#include "stimuli/definition/depth_chain.h"
#include "support/files/toml_table.h"

namespace seamline::inline stimuli {

/// Keys of one source, by what they are for.
inline constexpr std::array camera_keys = {
    "size_px", "fx", "fy", "cx", "cy", "skew", "distortion", "field_of_view_deg", "texels_per_degree"};
inline constexpr std::array sensor_keys = {"convention", "pose"};
inline constexpr std::array panorama_keys = {"reduction", "reduction_factor"};
inline constexpr std::array file_keys = {"file", "metres_per_step", "packing"};
inline constexpr std::array noise_keys = {"noise", "projector_m"};
inline constexpr const char* no_key_of_panorama =
    "nothing: a panorama is the photograph's own camera all round";

template <class Keys>
void refuse_keys(const TomlTable& table, const Keys& keys, const std::string& wanted) {
  for (const char* key : keys)
    if (table.has(key)) throw table.complaint(key, wanted, "a setting of its own");
}

template <class Keys>
[[nodiscard]] bool has_any(const TomlTable& table, const Keys& keys) {
  return std::any_of(keys.begin(), keys.end(), [&](const char* key) { return table.has(key); });
}

/// `known`: `usual` is a camera, and not only defaults. Throws InputError where it is not said how large it
/// is and how wide it looks, or twice.
[[nodiscard]] sensors::PinholeCamera read_camera(const TomlTable& table, const sensors::PinholeCamera& usual,
                                                 bool known);
[[nodiscard]] sensors::SensorRange read_range_m(const TomlTable& table, const sensors::SensorRange& usual);
[[nodiscard]] SensorPose read_pose(const TomlTable& table, const SensorPose& usual);

}  // namespace seamline::inline stimuli
