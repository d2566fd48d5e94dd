#include "study/app/screens/answer_row.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "window/look.h"

namespace seamline::study::app {
namespace {

std::string numbered(const AnswerRow& row, std::size_t i) {
  return fmt::format("{}  {}", i + 1, row.labels[i]);
}

std::vector<Rect> buttons_of(const Stage& stage, const Rect& questions, const AnswerRow& row, Font font) {
  double width_px = 0;
  for (std::size_t i = 0; i < row.labels.size(); ++i)
    width_px = std::max(width_px, stage.canvas().measure(font, numbered(row, i)).width_px);
  return row_of_buttons(stage, questions, static_cast<int>(row.labels.size()),
                        std::round(width_px + 1.4 * stage.ui.em()));
}

}  // namespace

std::vector<Rect> row_of_buttons(const Stage& stage, const Rect& questions, int count, double width_px) {
  const double em = stage.ui.em(), gap_px = std::round(0.5 * em);
  const double total_px = count * width_px + (count - 1) * gap_px;
  std::vector<Rect> buttons;
  for (int i = 0; i < count; ++i) {
    const int from_left = stage.canvas().right_to_left() ? count - 1 - i : i;
    buttons.push_back(
        {std::round((stage.screen_px.width_px - total_px) / 2 + from_left * (width_px + gap_px)),
         std::round(questions.y_px + 2.5 * em), width_px, std::round(2 * em)});
  }
  return buttons;
}

bool uses_focus(const Stage& stage) {
  return stage.input.key && !stage.input.key->repeated &&
         (stage.input.pressed(Key::enter) || stage.input.pressed(Key::space));
}

void move_focus(Stage& stage, int first, int last) {
  if (!stage.input.key) return;
  const bool back = stage.input.pressed(Key::left) || stage.input.pressed(Key::up) ||
                    (stage.input.pressed(Key::tab) && stage.input.key->shift);
  const bool on = !back && (stage.input.pressed(Key::right) || stage.input.pressed(Key::down) ||
                            stage.input.pressed(Key::tab));
  if (!back && !on) return;
  int& focus = stage.drafts.trial_focus;
  const int count = last - first + 1;
  if (focus < first || focus > last)
    focus = on ? first : last;
  else
    focus = first + (focus - first + (on ? 1 : count - 1)) % count;
}

int draw_answer_row(Stage& stage, const Rect& questions, const AnswerRow& row) {
  Font font = Font::body;
  std::vector<Rect> buttons = buttons_of(stage, questions, row, font);
  if (std::min(buttons.front().x_px, buttons.back().x_px) < 8)
    buttons = buttons_of(stage, questions, row, font = Font::small);
  int taken = -1;
  for (std::size_t i = 0; i < buttons.size(); ++i) {
    const Rect& rect = buttons[i];
    const int at = static_cast<int>(i);
    const bool hovered = rect.contains(stage.input.mouse);
    stage.ui.mark(fmt::format("{}/{}", row.id, i + 1), rect);
    stage.canvas().fill(rect, hovered ? look::control_hover : look::card, 6);
    stage.canvas().outline(rect, look::card_edge, 1, 6);
    if (row.focus == at) {
      stage.canvas().outline(rect.grown(4), look::focus_halo, 3, 9);
      stage.canvas().outline(rect.grown(5.5), look::focus, 2, 10);
    }
    const std::string text = numbered(row, i);
    const Size size = stage.canvas().measure(font, text);
    stage.canvas().text(
        font,
        {rect.x_px + (rect.width_px - size.width_px) / 2, rect.y_px + (rect.height_px - size.height_px) / 2},
        text, look::ink);
    if ((stage.input.mouse_pressed && hovered) || (row.focus == at && uses_focus(stage))) taken = at;
  }
  return taken;
}

}  // namespace seamline::study::app
