#pragma once
#include <optional>
#include <string>
#include <vector>

#include "study/app/screens/stage.h"
#include "window/geometry.h"

namespace seamline::study::app {

/// A row of numbered answers in the strip below a picture.
struct AnswerRow {
  std::string id;                   ///< of its buttons in the trace: `id/1`, `id/2`, ...
  std::vector<std::string> labels;  ///< shown with their numbers from 1
  int focus = -1;                   ///< the one that the keyboard is on, from 0; -1: none
};

/// Places for so many buttons of one width side by side in that strip, the first where lines begin.
[[nodiscard]] std::vector<Rect> row_of_buttons(const Stage& stage, const Rect& questions, int count,
                                               double width_px);

/// Draws the row, and returns the answer from 0 that was clicked, or used by Enter or Space; -1: none. Digits
/// are the caller's: what they mean depends on the question.
[[nodiscard]] int draw_answer_row(Stage& stage, const Rect& questions, const AnswerRow& row);

/// A line in the strip below a picture, with two labels at its ends or five over its fifths, and a button
/// that ends it. A press of the mouse or an arrow key gives the slider its first place; arrows move it by 1,
/// with Shift and by Page Up and Page Down by 10. The place that Enter, Space or the button confirms; none:
/// not yet.
[[nodiscard]] std::optional<int> draw_slider(Stage& stage, const Rect& questions,
                                             const std::vector<std::string>& labels);

/// Whether Enter or Space was pressed anew.
[[nodiscard]] bool uses_focus(const Stage& stage);

/// Moves the keyboard's place within [first, last]; Tab and arrows go round.
void move_focus(Stage& stage, int first, int last);

}  // namespace seamline::study::app
