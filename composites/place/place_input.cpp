#include "composites/place/place_input.h"

#include <cmath>

namespace seamline::place {
namespace {

constexpr double step_m = 0.02, long_step_m = 0.2, turn_deg = 5, growth = 1.05;
constexpr double drag_px = 4;  ///< less is a click

std::optional<renderer::PlaceAction> by_key(const FrameInput& input) {
  if (!input.key) return std::nullopt;
  if (input.pressed(Key::tab)) return renderer::NextChosen{};
  if (input.pressed(Key::remove)) return renderer::Removed{};
  if (input.pressed_letter('d')) return renderer::Duplicated{};
  if (input.pressed_letter('z', true)) return renderer::TakenBack{};
  const double step = input.key->shift ? long_step_m : step_m;
  if (input.pressed(Key::left)) return renderer::Shifted{{-step, 0, 0}};
  if (input.pressed(Key::right)) return renderer::Shifted{{step, 0, 0}};
  if (input.pressed(Key::up)) return renderer::Shifted{{0, 0, -step}};
  if (input.pressed(Key::down)) return renderer::Shifted{{0, 0, step}};
  if (input.pressed(Key::page_up)) return renderer::Shifted{{0, step, 0}};
  if (input.pressed(Key::page_down)) return renderer::Shifted{{0, -step, 0}};
  return std::nullopt;
}

std::optional<renderer::PlaceAction> by_mouse(const FrameInput& input, const Rect& picture,
                                              const renderer::PlacePreview& preview,
                                              const renderer::Placing& placing, Dragging& dragging) {
  const auto sight = [&] {
    return preview.look((input.mouse.x_px - picture.x_px) / picture.width_px,
                        (input.mouse.y_px - picture.y_px) / picture.height_px);
  };
  if (input.mouse_pressed && picture.contains(input.mouse)) {
    const auto seen = sight();
    dragging = {.held = seen.object.has_value(), .from = input.mouse};
    if (seen.object) return renderer::Chosen{*seen.object};
  }
  if (dragging.held && picture.contains(input.mouse) &&
      (dragging.moved ||
       std::hypot(input.mouse.x_px - dragging.from.x_px, input.mouse.y_px - dragging.from.y_px) > drag_px)) {
    const auto seen = sight();
    const bool goes_on = dragging.moved;
    if (input.mouse_released) dragging = {};
    if (!seen.real_m) return std::nullopt;  // a hole of the depth map
    if (dragging.held) dragging.moved = true;
    return renderer::StoodOn{*seen.real_m, *seen.normal, preview.half_width_m(placing.chosen), goes_on};
  }
  if (input.mouse_released) dragging = {};
  if (input.scrolled_lines != 0)
    return input.scrolled_with_shift
               ? renderer::PlaceAction(renderer::Resized{std::pow(growth, input.scrolled_lines)})
               : renderer::PlaceAction(renderer::Turned{turn_deg * input.scrolled_lines});
  return std::nullopt;
}

}  // namespace

Asked asked(const FrameInput& input, const Rect& picture, const renderer::PlacePreview& preview,
            const renderer::Placing& placing, Dragging& dragging) {
  if (input.close || (input.pressed(Key::escape) && !input.key->repeated)) return {{}, Wish::leave};
  if (input.pressed_letter('s') || input.pressed_letter('s', true)) return {{}, Wish::save};
  if (input.pressed_letter('f')) return {{}, Wish::floor};
  if (auto action = by_key(input)) return {std::move(action), Wish::nothing};
  return {by_mouse(input, picture, preview, placing, dragging), Wish::nothing};
}

}  // namespace seamline::place
