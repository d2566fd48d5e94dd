#include "window/ui.h"

#include <algorithm>
#include <cmath>

#include "window/look.h"

namespace seamline::inline window {
namespace {

constexpr double padding_em = 1.6;
constexpr double margin_px = 16;

}  // namespace

void Ui::reset() {
  focus_.clear();
  held_.clear();
  scroll_px_ = 0;
  changed_ = true;
}

void Ui::move_focus(int step) {
  if (last_items_.empty()) return;
  const auto count = static_cast<int>(last_items_.size());
  const auto at =
      std::find_if(last_items_.begin(), last_items_.end(), [&](const UiItem& i) { return i.id == focus_; });
  int next = step > 0 ? 0 : count - 1;
  if (at != last_items_.end()) next = (static_cast<int>(at - last_items_.begin()) + step + count) % count;
  const UiItem& wanted = last_items_[next];
  focus_ = wanted.id;
  changed_ = true;
  // What has the focus is in view.
  if (wanted.rect.bottom_px() > screen_.height_px - margin_px)
    scroll_px_ += wanted.rect.bottom_px() - (screen_.height_px - 2 * margin_px);
  if (wanted.rect.y_px < margin_px) scroll_px_ -= 2 * margin_px - wanted.rect.y_px;
}

void Ui::begin(const FrameInput& input, Size framebuffer_px) {
  input_ = input;
  screen_ = framebuffer_px;
  last_items_ = std::move(items_);
  items_.clear();
  key_taken_ = false;
  changed_ = false;
  if (input.pressed(Key::tab)) {
    move_focus(input.key->shift ? -1 : 1);
    key_taken_ = true;
  }
  scroll_px_ -= input.scrolled_lines * 3 * em();
  const double page_px = screen_.height_px * 0.8;
  if (input.pressed(Key::page_down)) scroll_px_ += page_px;
  if (input.pressed(Key::page_up)) scroll_px_ -= page_px;
  canvas_.begin(framebuffer_px);
}

void Ui::end() {
  if (!input_.mouse_pressed && input_.mouse_released) held_.clear();
  // Arrows that no control has used.
  if (input_.key && !key_taken_) {
    const bool scrolls = content_px_ > screen_.height_px - 2 * margin_px;
    const int step = input_.pressed(Key::down) || input_.pressed(Key::right) ? 1
                     : input_.pressed(Key::up) || input_.pressed(Key::left)  ? -1
                                                                             : 0;
    const std::vector<UiItem> laid_out = items_;
    std::swap(last_items_, items_);
    if (step != 0 && scrolls && (input_.pressed(Key::down) || input_.pressed(Key::up)))
      scroll_px_ += step * 3 * em();
    else if (step != 0)
      move_focus(step);
    items_ = laid_out;
    changed_ = changed_ || step != 0;
  }
  if (items_ != last_items_) changed_ = true;
}

bool Ui::acts(bool acted) {
  changed_ = changed_ || acted;
  return acted;
}

bool Ui::activates() const {
  return input_.key && !input_.key->repeated && (input_.pressed(Key::enter) || input_.pressed(Key::space));
}

Ui::Use Ui::item(const std::string& id, const Rect& rect) {
  items_.push_back({id, rect});
  Use use{.hovered = rect.contains(input_.mouse), .focused = focus_ == id};
  if (input_.mouse_pressed && use.hovered) {
    held_ = id;
    focus_ = id;
    use.focused = true;
  }
  if (input_.mouse_released && use.hovered && held_ == id) use.used = true;
  if (use.focused && activates() && !key_taken_) {
    use.used = true;
    key_taken_ = true;
  }
  return use;
}

void Ui::ring(const Rect& rect) {
  canvas_.outline(rect.grown(4), look::focus_halo, 3, 9);
  canvas_.outline(rect.grown(5.5), look::focus, 2, 10);
}

void Ui::begin_card(double width_em) {
  const double padding_px = padding_em * em();
  const double width_px = std::min(width_em * em() + 2 * padding_px, screen_.width_px - 2 * margin_px);
  const double room_px = screen_.height_px - 2 * margin_px;
  const double most_scroll_px = std::max(0.0, content_px_ - room_px);
  scroll_px_ = std::clamp(scroll_px_, 0.0, most_scroll_px);
  const double top_px =
      content_px_ < room_px ? (screen_.height_px - content_px_) / 2 : margin_px - scroll_px_;
  const Rect outer{std::round((screen_.width_px - width_px) / 2), std::round(top_px), std::round(width_px),
                   std::round(content_px_)};
  canvas_.fill(outer, look::card, 10);
  canvas_.outline(outer, look::card_edge, 1, 10);
  if (most_scroll_px > 0) {  // a bar that says where one is
    const double bar_px = room_px * room_px / content_px_;
    canvas_.fill(
        {outer.right_px() + 4, margin_px + (room_px - bar_px) * scroll_px_ / most_scroll_px, 5, bar_px},
        look::ink_on_background, 2);
  }
  card_ = {outer.x_px + padding_px, outer.y_px + padding_px, outer.width_px - 2 * padding_px, 0};
  y_px_ = card_.y_px;
  card_open_ = true;
}

void Ui::end_card() {
  const double height_px = y_px_ - card_.y_px + 2 * padding_em * em();
  if (std::abs(height_px - content_px_) > 0.5) changed_ = true;
  content_px_ = height_px;
  card_open_ = false;
}

Rect Ui::on_its_side(const Rect& rect) const {
  Rect placed = rect;
  if (canvas_.right_to_left()) placed.x_px = std::round(card_.x_px + card_.right_px() - rect.right_px());
  return placed;
}

void Ui::write(Font font, std::string_view text, Colour colour) {
  const Size size = canvas_.measure(font, text, card_.width_px);
  canvas_.text(font, {card_.x_px, y_px_}, text, colour, card_.width_px);
  y_px_ += size.height_px;
}

void Ui::heading(std::string_view text) {
  write(Font::heading, text, look::ink);
  gap(0.6);
}

void Ui::paragraph(std::string_view text) {
  write(Font::body, text, look::ink);
  gap(0.6);
}

void Ui::label(std::string_view text) {
  write(Font::body, text, look::ink);
  gap(0.25);
}

void Ui::note(std::string_view text) {
  write(Font::small, text, look::quiet_ink);
  gap(0.3);
}

void Ui::problem(std::string_view text) {
  write(Font::small, text, look::problem);
  gap(0.3);
}

void Ui::gap(double em_count) {
  y_px_ = std::round(y_px_ + em_count * em());
}

Rect Ui::room(double width_px, double height_px) {
  const Rect rect{std::round(card_.x_px + (card_.width_px - width_px) / 2), std::round(y_px_),
                  std::round(width_px), std::round(height_px)};
  y_px_ += height_px;
  return rect;
}

void Ui::picture(const WindowTexture& texture) {
  const double scale = std::min(1.0, card_.width_px / texture.width_px());
  canvas_.picture(texture, room(texture.width_px() * scale, texture.height_px() * scale));
  gap(0.6);
}

}  // namespace seamline::inline window
