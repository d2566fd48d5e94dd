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

namespace {

/// By how much the keyboard moves a slider.
int slider_step(const Stage& stage) {
  const FrameInput& input = stage.input;
  const int towards_more = stage.canvas().right_to_left() ? -1 : 1;
  const int by_arrows = towards_more * (input.pressed(Key::right) - input.pressed(Key::left)) +
                        input.pressed(Key::up) - input.pressed(Key::down);
  const int by_pages = input.pressed(Key::page_up) - input.pressed(Key::page_down);
  return (input.key && input.key->shift ? 10 : 1) * by_arrows + 10 * by_pages;
}

void move_slider(Stage& stage, const Rect& line) {
  Drafts& drafts = stage.drafts;
  const FrameInput& input = stage.input;
  if (const int step = slider_step(stage); step != 0)
    drafts.slider = std::clamp((drafts.slider < 0 ? slider_end / 2 : drafts.slider) + step, 0, slider_end);
  const double reach_px = stage.ui.em();
  if (input.mouse_pressed) drafts.slider_held = line.grown(reach_px).contains(input.mouse);
  if (drafts.slider_held) {
    const double along = std::clamp((input.mouse.x_px - line.x_px) / line.width_px, 0.0, 1.0);
    drafts.slider =
        static_cast<int>(std::lround(slider_end * (stage.canvas().right_to_left() ? 1 - along : along)));
  }
  if (input.mouse_released) drafts.slider_held = false;
}

/// Each label in the middle of its part of the line; two labels at its ends.
void draw_slider_labels(Stage& stage, const Rect& line, double bottom_px,
                        const std::vector<std::string>& labels) {
  const double count = labels.size();
  const double wrap_px = line.width_px / count - 0.5 * stage.ui.em();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    double along = (i + 0.5) / count;
    if (stage.canvas().right_to_left()) along = 1 - along;
    const double height_px = stage.canvas().measure(Font::small, labels[i], wrap_px).height_px;
    double left_px = line.x_px + along * line.width_px - wrap_px / 2, share = 0.5;
    if (labels.size() == 2) {
      share = along < 0.5 ? 0 : 1;
      left_px = line.x_px + share * (line.width_px - wrap_px);
    }
    stage.canvas().text_in(Font::small, {left_px, std::round(bottom_px - height_px)}, labels[i],
                           look::ink_on_background, wrap_px, share);
  }
}

void draw_line(Stage& stage, const Rect& line, std::size_t labels) {
  const double middle_px = line.y_px + line.height_px / 2, tick_px = std::round(0.4 * stage.ui.em());
  stage.canvas().fill(line, look::ink_on_background);
  const int parts = labels == 5 ? 5 : 1;
  for (int part = 0; part <= parts; ++part)
    stage.canvas().fill(
        {std::round(line.x_px + line.width_px * part / parts) - 1, middle_px - tick_px, 2, 2 * tick_px},
        look::ink_on_background);
  if (stage.drafts.slider < 0) return;
  double along = static_cast<double>(stage.drafts.slider) / slider_end;
  if (stage.canvas().right_to_left()) along = 1 - along;
  const double width_px = std::round(0.5 * stage.ui.em()), height_px = std::round(1.2 * stage.ui.em());
  const Rect handle{std::round(line.x_px + along * line.width_px - width_px / 2),
                    std::round(middle_px - height_px / 2), width_px, height_px};
  stage.canvas().fill(handle.grown(2), look::focus_halo, 5);
  stage.canvas().fill(handle, look::focus, 3);
}

}  // namespace

std::optional<int> draw_slider(Stage& stage, const Rect& questions, const std::vector<std::string>& labels) {
  const double em = stage.ui.em();
  const bool mirrored = stage.canvas().right_to_left();
  const std::string done = stage.phrase(Phrase::continue_button);
  const Size text = stage.canvas().measure(Font::body, done);
  const double button_px = std::round(text.width_px + 1.4 * em);
  const double line_px = std::round(std::min(52 * em, stage.screen_px.width_px - button_px - 5 * em));
  const double left_px = std::round((stage.screen_px.width_px - line_px - button_px - 2 * em) / 2);
  const Rect line{mirrored ? left_px + button_px + 2 * em : left_px, std::round(questions.y_px + 4.3 * em),
                  line_px, 3};
  move_slider(stage, line);
  draw_slider_labels(stage, line, questions.y_px + 3.75 * em, labels);
  draw_line(stage, line, labels.size());
  stage.ui.mark("slider", line);

  const Rect button{mirrored ? left_px : line.right_px() + 2 * em, std::round(line.y_px - em), button_px,
                    std::round(2 * em)};
  const bool hovered = button.contains(stage.input.mouse), ready = stage.drafts.slider >= 0;
  stage.ui.mark("slider/done", button);
  stage.canvas().fill(button, hovered && ready ? look::control_hover : look::card, 6);
  stage.canvas().outline(button, look::card_edge, 1, 6);
  stage.canvas().text(Font::body,
                      {button.x_px + (button.width_px - text.width_px) / 2,
                       button.y_px + (button.height_px - text.height_px) / 2},
                      done, ready ? look::ink : look::quiet_ink);
  if (!ready || !((stage.input.mouse_pressed && hovered) || uses_focus(stage))) return std::nullopt;
  return stage.drafts.slider;
}

}  // namespace seamline::study::app
