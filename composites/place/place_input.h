#pragma once
#include <optional>

#include "composites/objects/placing.h"
#include "composites/place_preview.h"
#include "window/input.h"

namespace seamline::place {

/// What the mouse is doing from one frame to the next.
struct Dragging {
  bool held = false, moved = false;
  Point from;
};

/// What the person asks for in a frame, beside what objects do.
enum class Wish { nothing, save, floor, leave };
struct Asked {
  std::optional<renderer::PlaceAction> action;
  Wish wish = Wish::nothing;
};

/// What a frame's input means where the picture fills `picture`. Mouse: a click chooses an object, dragging
/// puts it onto the surface below the pointer, the wheel turns it, with Shift it resizes it. Keys: arrows and
/// Page Up and Down shift it by 2 cm, with Shift by 20; Tab the next; D another one like it; Delete; Ctrl+Z;
/// F shows the floor or not; S or Ctrl+S saves; Esc leaves.
[[nodiscard]] Asked asked(const FrameInput& input, const Rect& picture, const renderer::PlacePreview& preview,
                          const renderer::Placing& placing, Dragging& dragging);

}  // namespace seamline::place
