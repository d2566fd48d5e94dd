#include <fmt/core.h>

#include <array>

#include "study/app/screens/stage.h"

namespace seamline::study::app {

Outcome draw(const InstructionScreen& screen, const Visit& visit, Stage& stage) {
  Ui& ui = stage.ui;
  const std::size_t at = screen.page;
  const InstructionPage& page = stage.set.study.instructions.at(at);
  ui.begin_card(page.pictures.empty() ? 36 : 44);
  if (!page.text.empty()) {
    ui.heading(stage.phrase(Phrase::instructions_title));
    ui.paragraph(page.text);
  }
  for (const WindowTexture& picture : stage.instruction_pictures.at(at)) ui.picture(picture);
  ui.note(stage.phrase(Phrase::page_of, {{"page", fmt::format("{}", screen.page + 1)},
                                         {"pages", fmt::format("{}", visit.script->instruction_pages)}}));
  std::vector<Ui::ButtonText> buttons;
  if (screen.page > 0) buttons.push_back({"back", stage.phrase(Phrase::back_button)});
  buttons.push_back({"continue", stage.phrase(Phrase::continue_button), Ui::ButtonKind::leading});
  const std::optional<int> used = ui.buttons(buttons);
  ui.end_card();
  if (!used) return std::nullopt;
  if (*used + 1 < std::ssize(buttons)) return WentBack{};
  return Continued{};
}

}  // namespace seamline::study::app
