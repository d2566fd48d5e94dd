#include <array>
#include <ctime>

#include "study/app/screens/stage.h"
#include "study/app/screens/text_size.h"

namespace seamline::study::app {

Outcome draw(const ConsentScreen&, const Visit&, Stage& stage) {
  const ConsentDefinition& consent = stage.set.study.consent;
  Ui& ui = stage.ui;
  ui.begin_card(38);
  ui.heading(stage.phrase(Phrase::consent_title));
  ui.paragraph(consent.text);
  // Nothing has the focus at first, and Enter alone agrees to nothing.
  const std::array<Ui::ButtonText, 2> answers = {
      {{"decline", consent.decline}, {"accept", consent.accept, Ui::ButtonKind::leading}}};
  const std::optional<int> used = ui.buttons(answers, false);
  ui.gap(1);
  choose_text_size(stage);
  ui.end_card();
  if (used == 0) return ConsentRefused{};
  if (used == 1) return ConsentGiven{static_cast<std::int64_t>(std::time(nullptr))};
  return std::nullopt;
}

}  // namespace seamline::study::app
