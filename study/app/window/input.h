#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <variant>

#include "study/app/window/geometry.h"

namespace seamline::study::app {

enum class Key {
  other,
  tab,
  enter,
  space,
  escape,
  backspace,
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  digit,
};

struct KeyPress {
  Key key = Key::other;
  int digit = 0;  ///< 0..9 with Key::digit, of the row or of the number pad
  bool shift = false, control = false;
  bool repeated = false;  ///< held down: never an answer
};

// What the window system reports, in the order it happened; times are monotonic nanoseconds.

struct KeyPressed {
  KeyPress press;
  std::int64_t now_ns = 0;
};
struct CharacterTyped {
  char32_t character = 0;
};
struct MouseMoved {
  Point position;
};
struct MousePressed {
  std::int64_t now_ns = 0;
};
struct MouseReleased {};
struct Scrolled {
  double lines = 0;  ///< positive: the wheel turned away from the person
};
struct FocusChanged {
  bool focused = false;
  std::int64_t now_ns = 0;
};
struct Resized {
  std::int64_t now_ns = 0;
};
struct Exposed {};  ///< part of the window must be drawn again
struct CloseAsked {};
using RawInput = std::variant<KeyPressed, CharacterTyped, MouseMoved, MousePressed, MouseReleased, Scrolled,
                              FocusChanged, Resized, Exposed, CloseAsked>;

/// What one frame reacts to: at most one key, press or release, so that two quick ones are never merged.
struct FrameInput {
  std::int64_t now_ns = 0;  ///< of the key or press; else of the frame
  std::optional<KeyPress> key = {};
  std::u32string typed = {};
  Point mouse = {-1, -1};
  bool mouse_pressed = false, mouse_released = false;
  double scrolled_lines = 0;
  std::optional<FocusChanged> focus = {};
  bool resized = false, close = false;
  bool anything = false;  ///< something happened, if only the mouse moved

  [[nodiscard]] bool pressed(Key wanted) const { return key && key->key == wanted; }
  /// The digit of a key that was pressed (not held), or 0.
  [[nodiscard]] int digit() const {
    return key && key->key == Key::digit && !key->repeated && !key->control ? key->digit : 0;
  }
};

/// Takes from `queue` what the next frame reacts to: up to and including the first key, press, release or
/// change of focus, with the characters that the key typed. `mouse` is where the pointer was before.
[[nodiscard]] FrameInput take_frame_input(std::deque<RawInput>& queue, const Point& mouse,
                                          std::int64_t now_ns);

}  // namespace seamline::study::app
