#include "window/input.h"

#include "support/running/overloaded.h"

namespace seamline::inline window {
namespace {

/// Adds one report; returns whether it was an edge, after which only characters may follow.
bool add(FrameInput& frame, const RawInput& input) {
  return std::visit(
      Overloaded{
          [&](const KeyPressed& key) {
            frame.key = key.press;
            frame.now_ns = key.now_ns;
            return true;
          },
          [&](const CharacterTyped& typed) {
            frame.typed.push_back(typed.character);
            return false;
          },
          [&](const MouseMoved& moved) {
            frame.mouse = moved.position;
            return false;
          },
          [&](const MousePressed& pressed) {
            (pressed.button == MouseButton::left ? frame.mouse_pressed : frame.right_pressed) = true;
            frame.now_ns = pressed.now_ns;
            return true;
          },
          [&](const MouseReleased& released) {
            (released.button == MouseButton::left ? frame.mouse_released : frame.right_released) = true;
            return true;
          },
          [&](const Scrolled& scrolled) {
            frame.scrolled_lines += scrolled.lines;
            frame.scrolled_with_shift = scrolled.shift;
            return false;
          },
          [&](const FocusChanged& focus) {
            frame.focus = focus;
            return true;
          },
          [&](const WindowResized&) {
            frame.resized = true;
            return false;
          },
          [&](const Exposed&) { return false; },
          [&](const CloseAsked&) {
            frame.close = true;
            return true;
          },
      },
      input);
}

}  // namespace

FrameInput take_frame_input(std::deque<RawInput>& queue, const Point& mouse, std::int64_t now_ns) {
  FrameInput frame{.now_ns = now_ns, .mouse = mouse};
  bool edge = false;
  while (!queue.empty()) {
    if (edge && !std::holds_alternative<CharacterTyped>(queue.front())) break;
    const RawInput input = std::move(queue.front());
    queue.pop_front();
    edge = add(frame, input) || edge;
    frame.anything = true;
  }
  return frame;
}

}  // namespace seamline::inline window
