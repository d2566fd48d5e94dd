#include "stimuli/pictures/flip_map.h"

#include <algorithm>
#include <array>

namespace seamline::inline stimuli {
namespace {

std::array<std::uint8_t, 3> colour_of(float value) {
  constexpr std::array<std::array<double, 3>, 5> stops = {
      {{0, 0, 4}, {81, 18, 124}, {183, 55, 121}, {252, 137, 97}, {252, 253, 191}}};
  const double at = std::clamp(double{value}, 0.0, 1.0) * (stops.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double share = at - static_cast<double>(low);
  std::array<std::uint8_t, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c)
    colour[c] = static_cast<std::uint8_t>((1 - share) * stops[low][c] + share * stops[low + 1][c] + 0.5);
  return colour;
}

}  // namespace

ByteImage flip_map(const Image& flip) {
  ByteImage picture{flip.width_px, flip.height_px, 3, {}};
  picture.values.reserve(flip.values.size() * 3);
  for (const float value : flip.values)
    for (const std::uint8_t code : colour_of(value)) picture.values.push_back(code);
  return picture;
}

}  // namespace seamline::inline stimuli
