#pragma once
#include <array>
#include <cstddef>
#include <string_view>

#include "sensors/files/depth_file.h"
#include "sensors/files/estimated_depth.h"
#include "sensors/frame/depth_frame.h"

// Words of files, in the order of their enumerations.
namespace seamline::sensors {

inline constexpr std::array<std::string_view, 2> words_of_conventions = {"radial", "planar"};
inline constexpr std::array<std::string_view, 2> words_of_packings = {"whole", "red_green"};
inline constexpr std::array<std::string_view, 3> words_of_values = {"metres", "inverse", "relative"};

[[nodiscard]] constexpr std::string_view word(DepthConvention convention) {
  return words_of_conventions.at(static_cast<std::size_t>(convention));
}
[[nodiscard]] constexpr std::string_view word(DepthPacking packing) {
  return words_of_packings.at(static_cast<std::size_t>(packing));
}
[[nodiscard]] constexpr std::string_view word(DepthValue value) {
  return words_of_values.at(static_cast<std::size_t>(value));
}

}  // namespace seamline::sensors
