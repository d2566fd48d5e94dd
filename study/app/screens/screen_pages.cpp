// Pages of a heading, a text and a button.
#include <fmt/core.h>

#include <array>
#include <vector>

#include "stimuli/definition/looks/study_look.h"
#include "study/app/screens/stage.h"
#include "study/app/screens/text_size.h"

namespace seamline::study::app {
namespace {

bool draw_page(Stage& stage, const std::string& title, const std::string& text, const std::string& button) {
  Ui& ui = stage.ui;
  ui.begin_card(30);
  ui.heading(title);
  ui.paragraph(text);
  const std::array<Ui::ButtonText, 1> only = {{{"continue", button, Ui::ButtonKind::leading}}};
  const bool used = ui.buttons(only).has_value();
  ui.end_card();
  return used;
}

Outcome draw_last_page(Stage& stage, Phrase title, const std::string& text) {
  if (draw_page(stage, stage.phrase(title), text, stage.phrase(Phrase::close_button))) stage.close = true;
  return std::nullopt;
}

}  // namespace

Outcome draw(const ReadyScreen&, const Visit&, Stage& stage) {
  if (draw_page(stage, stage.phrase(Phrase::ready_title), stage.phrase(Phrase::ready_text),
                stage.phrase(Phrase::ready_button)))
    return Continued{};
  return std::nullopt;
}

namespace {

/// A break in which people are asked how they feel; an answer ends it.
Outcome draw_asking_break(Stage& stage, const LookDefinition& asked, const std::string& text) {
  Ui& ui = stage.ui;
  ui.begin_card(40);
  ui.heading(stage.phrase(Phrase::break_title));
  ui.paragraph(text);
  ui.paragraph(asked.comfort_question);
  std::vector<Ui::ButtonText> labels;
  labels.reserve(asked.comfort_labels.size());
  for (std::size_t i = 0; i < asked.comfort_labels.size(); ++i)
    labels.push_back({fmt::format("comfort-{}", i + 1), asked.comfort_labels[i]});
  const std::optional<int> used = ui.buttons(labels, false);
  ui.end_card();
  if (!used) return std::nullopt;
  stage.comfort = *used + 1;
  return Continued{};
}

}  // namespace

Outcome draw(const BreakScreen&, const Visit& visit, Stage& stage) {
  const std::string text =
      stage.phrase(Phrase::break_text, {{"done", fmt::format("{}", answered_trials(visit.session.trials))},
                                        {"all", fmt::format("{}", most_trials(visit.session.trials))}});
  if (const LookDefinition* asked = comfort_asked(stage.set.study))
    return draw_asking_break(stage, *asked, text);
  if (draw_page(stage, stage.phrase(Phrase::break_title), text, stage.phrase(Phrase::continue_button)))
    return Continued{};
  return std::nullopt;
}

Outcome draw(const BriefingScreen&, const Visit& visit, Stage& stage) {
  const std::optional<Trial> due = current_trial(visit.session.trials);
  std::string text;
  if (due) {
    const ManifestStimulus& record = stage.set.manifest.stimuli.at(due->stimulus);
    for (const ConditionDefinition& condition : stage.set.study.conditions)
      if (condition.name == record.stimulus.condition) text = condition.instructions;
  }
  if (draw_page(stage, stage.phrase(Phrase::instructions_title), text, stage.phrase(Phrase::continue_button)))
    return Continued{};
  return std::nullopt;
}

Outcome draw(const PauseScreen&, const Visit&, Stage& stage) {
  Ui& ui = stage.ui;
  ui.begin_card(30);
  ui.heading(stage.phrase(Phrase::pause_title));
  ui.paragraph(stage.phrase(Phrase::pause_text));
  const std::array<Ui::ButtonText, 2> buttons = {
      {{"leave", stage.phrase(Phrase::pause_leave)},
       {"continue", stage.phrase(Phrase::pause_continue), Ui::ButtonKind::leading}}};
  const std::optional<int> used = ui.buttons(buttons);
  ui.gap(1);
  choose_text_size(stage);
  ui.end_card();
  if (used == 0) stage.leave = true;
  if (used == 1 || stage.input.pressed(Key::escape)) return Continued{};
  return std::nullopt;
}

Outcome draw(const ThanksScreen&, const Visit&, Stage& stage) {
  return draw_last_page(stage, Phrase::thanks_title, stage.phrase(Phrase::thanks_text));
}

Outcome draw(const DeclinedScreen&, const Visit&, Stage& stage) {
  return draw_last_page(stage, Phrase::declined_title, stage.phrase(Phrase::declined_text));
}

Outcome draw(const StoppedScreen& screen, const Visit&, Stage& stage) {
  return draw_last_page(stage, Phrase::stopped_title,
                        stage.phrase(Phrase::stopped_text, {{"message", screen.message}}));
}

}  // namespace seamline::study::app
