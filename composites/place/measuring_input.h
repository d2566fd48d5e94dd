#pragma once
#include <optional>
#include <string>
#include <vector>

#include "composites/measured_places.h"
#include "window/input.h"

namespace seamline::place {

/// Distances that a person types to places that were clicked.
struct Measuring {
  std::vector<renderer::MeasuredPlace> known;
  std::optional<renderer::MeasuredPlace> open;  ///< clicked, its distance not yet entered
  std::string typed;
  std::string complaint;  ///< about what was typed; empty: none
};

/// As many as a scale and a shift need.
inline constexpr std::size_t least_known = 2;

enum class MeasuringWish { nothing, known_changed, go_on, leave };

/// What a frame's input changes where the picture fills `picture`. A click opens a place, digits and a point
/// or comma are its distance in metres, Enter enters it, Backspace takes a character back, Ctrl+Z or Delete
/// the place, or the one before. Enter without an open place goes on, if enough are known; Esc leaves.
[[nodiscard]] MeasuringWish measure(const FrameInput& input, const Rect& picture, Measuring& measuring);

}  // namespace seamline::place
