#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "window/look.h"
#include "window/ui.h"

namespace seamline::inline window {
namespace {

constexpr double control_em = 2.2;  ///< height
constexpr double corner_px = 6;

Point centred(const Canvas& canvas, Font font, std::string_view text, const Rect& rect) {
  const Size size = canvas.measure(font, text);
  return {rect.x_px + (rect.width_px - size.width_px) / 2, rect.y_px + (rect.height_px - size.height_px) / 2};
}

}  // namespace

double Ui::button_width_px(const ButtonText& text) const {
  return std::round(std::max(7 * em(), canvas_.measure(Font::body, text.text).width_px + 2.4 * em()));
}

bool Ui::button(const ButtonText& text, const Rect& rect, bool enter_leads) {
  const Use use = item(text.id, rect);
  const bool leading = text.kind == ButtonKind::leading;
  const Colour face = leading ? (use.hovered ? look::chosen_hover : look::chosen)
                              : (use.hovered ? look::control_hover : look::control);
  canvas_.fill(rect, face, corner_px);
  canvas_.outline(rect, leading ? look::chosen : look::control_edge, 1, corner_px);
  if (use.focused) ring(rect);
  canvas_.text(Font::body, centred(canvas_, Font::body, text.text, rect), text.text,
               leading ? look::ink_on_chosen : look::ink);
  const bool led = leading && enter_leads && focus_.empty() && input_.pressed(Key::enter) &&
                   !input_.key->repeated && !key_taken_;
  return acts(use.used || led);
}

std::optional<int> Ui::buttons(std::span<const ButtonText> texts, bool enter_leads) {
  gap(0.5);
  double total_px = (static_cast<double>(texts.size()) - 1) * em();
  for (const ButtonText& text : texts) total_px += button_width_px(text);
  double x_px = card_.right_px() - total_px;
  std::optional<int> used;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const Rect rect = on_its_side(
        {std::round(x_px), std::round(y_px_), button_width_px(texts[i]), std::round(control_em * em())});
    if (button(texts[i], rect, enter_leads)) used = static_cast<int>(i);
    x_px += rect.width_px + em();
  }
  y_px_ += std::round(control_em * em());
  return used;
}

bool Ui::button_in(const ButtonText& text, const Point& middle) {
  const double width_px = button_width_px(text), height_px = std::round(control_em * em());
  return button(
      text,
      {std::round(middle.x_px - width_px / 2), std::round(middle.y_px - height_px / 2), width_px, height_px},
      true);
}

int Ui::choice(const std::string& id, std::span<const std::string> options, int chosen, Font font) {
  // One control for the keyboard: Tab comes to it once, arrows change it.
  const int before = chosen;
  double x_px = card_.x_px;
  std::vector<Rect> rects;
  const double height_px = std::round(control_em * canvas_.size_px(font) * 0.9);
  for (const std::string& option : options) {
    const double width_px = std::round(canvas_.measure(font, option).width_px + 1.6 * canvas_.size_px(font));
    if (x_px > card_.x_px && x_px + width_px > card_.right_px()) {
      x_px = card_.x_px;
      y_px_ += height_px + std::round(0.4 * em());
    }
    rects.push_back(
        on_its_side({std::round(x_px), std::round(y_px_), std::min(width_px, card_.width_px), height_px}));
    x_px += width_px + std::round(0.4 * em());
  }
  y_px_ += height_px;
  Rect all = rects.front();
  for (const Rect& rect : rects) {
    const double right_px = std::max(all.right_px(), rect.right_px());
    all = {std::min(all.x_px, rect.x_px), all.y_px, 0, rect.bottom_px() - all.y_px};
    all.width_px = right_px - all.x_px;
  }
  const auto count = static_cast<int>(options.size());
  items_.push_back({id, all});
  const bool focused = focus_ == id;
  if (focused && input_.key && !key_taken_) {
    const int step = input_.pressed(Key::right) || input_.pressed(Key::space) ? 1
                     : input_.pressed(Key::left)                              ? -1
                                                                              : 0;
    if (step != 0) {
      chosen = chosen < 0 ? (step > 0 ? 0 : count - 1) : (chosen + step + count) % count;
      key_taken_ = true;
    } else if (input_.digit() >= 1 && input_.digit() <= count) {
      chosen = input_.digit() - 1;
      key_taken_ = true;
    }
  }
  for (int i = 0; i < count; ++i) {
    const Rect& rect = rects[i];
    const bool hovered = rect.contains(input_.mouse);
    const std::string option_id = fmt::format("{}/{}", id, i);
    if (input_.mouse_pressed && hovered) {
      held_ = option_id;
      focus_ = id;
    }
    if (input_.mouse_released && hovered && held_ == option_id) chosen = i;
    const bool on = chosen == i;
    canvas_.fill(rect, on ? look::chosen : hovered ? look::control_hover : look::control, corner_px);
    canvas_.outline(rect, on ? look::chosen : look::control_edge, 1, corner_px);
    canvas_.text(font, centred(canvas_, font, options[i], rect), options[i],
                 on ? look::ink_on_chosen : look::ink);
  }
  if (focused) ring(all);
  acts(chosen != before);
  return chosen;
}

bool Ui::number(const std::string& id, std::string& text, double width_em) {
  const Rect rect = on_its_side(
      {card_.x_px, std::round(y_px_), std::round(width_em * em()), std::round(control_em * em() * 0.9)});
  y_px_ += rect.height_px;
  items_.push_back({id, rect});
  if (input_.mouse_pressed && rect.contains(input_.mouse)) focus_ = id;
  const bool focused = focus_ == id;
  bool edited = false;
  if (focused) {
    for (const char32_t character : input_.typed)
      if ((character >= U'0' && character <= U'9') || character == U'.' || character == U'-')
        if (text.size() < 12) {
          text.push_back(static_cast<char>(character));
          edited = true;
        }
    if (input_.pressed(Key::backspace) && !text.empty()) {
      text.pop_back();
      edited = true;
    }
    if (input_.pressed(Key::left) || input_.pressed(Key::right)) key_taken_ = true;
    if (input_.pressed(Key::enter)) move_focus(1);
  }
  canvas_.fill(rect, look::control, corner_px);
  canvas_.outline(rect, focused ? look::chosen : look::control_edge, 1, corner_px);
  const Size size = canvas_.measure(Font::body, text);
  const double top_px = rect.y_px + (rect.height_px - size.height_px) / 2;
  const double left_px =
      canvas_.right_to_left() ? rect.right_px() - 0.6 * em() - size.width_px - 4 : rect.x_px + 0.6 * em();
  canvas_.text(Font::body, {left_px, top_px}, text, look::ink);
  if (focused) {
    const double caret_px = left_px + size.width_px + 2;
    canvas_.line({caret_px, rect.y_px + 0.4 * em()}, {caret_px, rect.bottom_px() - 0.4 * em()}, look::ink, 2);
    ring(rect);
  }
  return acts(edited);
}

bool Ui::slider(const std::string& id, double& value, double least, double most, double step) {
  const Rect rect{card_.x_px, std::round(y_px_), card_.width_px, std::round(1.6 * em())};
  y_px_ += rect.height_px;
  items_.push_back({id, rect});
  const double before = value;
  if (input_.mouse_pressed && rect.contains(input_.mouse)) {
    held_ = id;
    focus_ = id;
  }
  const bool focused = focus_ == id;
  if (held_ == id && !input_.mouse_released)
    value = least + (most - least) * (input_.mouse.x_px - rect.x_px) / rect.width_px;
  if (focused && input_.key && !key_taken_) {
    const double by = step * (input_.key->shift ? 10 : 1);
    if (input_.pressed(Key::right)) value += by;
    if (input_.pressed(Key::left)) value -= by;
    key_taken_ = input_.pressed(Key::right) || input_.pressed(Key::left);
  }
  value = std::clamp(value, least, most);
  const double middle_px = std::round(rect.centre().y_px);
  const double at_px = std::round(rect.x_px + rect.width_px * (value - least) / (most - least));
  canvas_.fill({rect.x_px, middle_px - 3, rect.width_px, 6}, look::control_edge, 3);
  canvas_.fill({rect.x_px, middle_px - 3, at_px - rect.x_px, 6}, look::chosen, 3);
  const Rect knob{at_px - 8, middle_px - 0.6 * em(), 16, 1.2 * em()};
  canvas_.fill(knob, look::control, 5);
  canvas_.outline(knob, look::chosen, 2, 5);
  if (focused) ring(rect);
  return acts(value != before);
}

bool Ui::checkbox(const std::string& id, std::string_view text, bool& on) {
  const double side_px = std::round(1.2 * em());
  const double wrap_px = card_.width_px - 2 * em();
  const Size size = canvas_.measure(Font::body, text, wrap_px);
  const Rect rect =
      on_its_side({card_.x_px, std::round(y_px_), std::min(card_.width_px, size.width_px + 2.2 * em()),
                   std::max(side_px, size.height_px)});
  y_px_ += rect.height_px;
  const Use use = item(id, rect);
  if (use.used) on = !on;
  const bool mirrored = canvas_.right_to_left();
  const Rect box{mirrored ? rect.right_px() - side_px : rect.x_px, rect.y_px, side_px, side_px};
  canvas_.fill(box, on ? look::chosen : use.hovered ? look::control_hover : look::control, 4);
  canvas_.outline(box, on ? look::chosen : look::control_edge, 1, 4);
  if (on) {
    const double x_px = box.x_px, y_px = box.y_px, s = side_px;
    canvas_.line({x_px + 0.24 * s, y_px + 0.52 * s}, {x_px + 0.43 * s, y_px + 0.72 * s}, look::ink_on_chosen,
                 3);
    canvas_.line({x_px + 0.43 * s, y_px + 0.72 * s}, {x_px + 0.78 * s, y_px + 0.28 * s}, look::ink_on_chosen,
                 3);
  }
  canvas_.text(Font::body,
               {mirrored ? rect.right_px() - 2 * em() - wrap_px : rect.x_px + 2 * em(), rect.y_px}, text,
               look::ink, wrap_px);
  if (use.focused) ring(rect);
  gap(0.4);
  return acts(use.used);
}

}  // namespace seamline::inline window
