#pragma once
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <variant>

#include "window/geometry.h"

namespace seamline::inline window {

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
  remove,  ///< Delete
  digit,
  letter,
};

struct KeyPress {
  Key key = Key::other;
  int digit = 0;    ///< 0..9 with Key::digit, of the row or of the number pad
  char letter = 0;  ///< 'a'..'z' with Key::letter
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
enum class MouseButton { left, right };
struct MousePressed {
  std::int64_t now_ns = 0;
  MouseButton button = MouseButton::left;
};
struct MouseReleased {
  MouseButton button = MouseButton::left;
};
struct Scrolled {
  double lines = 0;  ///< positive: the wheel turned away from the person
  bool shift = false;
};
struct FocusChanged {
  bool focused = false;
  std::int64_t now_ns = 0;
};
struct WindowResized {
  std::int64_t now_ns = 0;
};
struct Exposed {};  ///< part of the window must be drawn again
struct CloseAsked {};
using RawInput = std::variant<KeyPressed, CharacterTyped, MouseMoved, MousePressed, MouseReleased, Scrolled,
                              FocusChanged, WindowResized, Exposed, CloseAsked>;

/// What one frame reacts to: at most one key, press or release, so that two quick ones are never merged.
struct FrameInput {
  std::int64_t now_ns = 0;  ///< of the key or press; else of the frame
  std::optional<KeyPress> key = {};
  std::u32string typed = {};
  Point mouse = {-1, -1};
  bool mouse_pressed = false, mouse_released = false;  ///< the left button
  bool right_pressed = false, right_released = false;
  double scrolled_lines = 0;
  bool scrolled_with_shift = false;
  std::optional<FocusChanged> focus = {};
  bool resized = false, close = false;
  bool anything = false;  ///< something happened, if only the mouse moved

  [[nodiscard]] bool pressed(Key wanted) const { return key && key->key == wanted; }
  /// A letter's key, held down or not; `control` tells Ctrl and the letter from the letter alone.
  [[nodiscard]] bool pressed_letter(char wanted, bool control = false) const {
    return key && key->key == Key::letter && key->letter == wanted && key->control == control;
  }
  /// The digit of a key that was pressed (not held), or 0.
  [[nodiscard]] int digit() const {
    return key && key->key == Key::digit && !key->repeated && !key->control ? key->digit : 0;
  }
};

/// Takes from `queue` what the next frame reacts to: up to and including the first key, press, release or
/// change of focus, with the characters that the key typed. `mouse` is where the pointer was before.
[[nodiscard]] FrameInput take_frame_input(std::deque<RawInput>& queue, const Point& mouse,
                                          std::int64_t now_ns);

}  // namespace seamline::inline window
