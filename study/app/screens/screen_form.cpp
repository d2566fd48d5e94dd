#include <fmt/core.h>

#include <algorithm>
#include <array>

#include "stimuli/definition/people/form_kinds.h"
#include "study/app/screens/stage.h"
#include "support/running/overloaded.h"

namespace seamline::study::app {
namespace {

std::string problem_text(const Stage& stage, const FormField& field, FormFault fault) {
  if (fault == FormFault::missing) return stage.phrase(Phrase::form_missing);
  if (fault == FormFault::not_a_number) return stage.phrase(Phrase::form_not_a_number);
  if (fault == FormFault::not_an_option) return stage.phrase(Phrase::form_not_an_option);
  const std::optional<NumberField> number = number_of(field);
  if (!number) return stage.phrase(Phrase::form_missing);
  return stage.phrase(Phrase::form_out_of_range, {{"least", fmt::format("{:g}", number->least)},
                                                  {"most", fmt::format("{:g}", number->most)}});
}

void draw_field(const FormField& field, Stage& stage) {
  std::string& value = stage.drafts.form[field.name];
  std::visit(Overloaded{[&](const NumberField&) { stage.ui.number(field.name, value, 6); },
                        [&](const ChoiceField& kind) {
                          const auto at = std::find(kind.options.begin(), kind.options.end(), value);
                          const int chosen =
                              at == kind.options.end() ? -1 : static_cast<int>(at - kind.options.begin());
                          const int now = stage.ui.choice(field.name, kind.options, chosen);
                          if (now >= 0) value = kind.options[static_cast<std::size_t>(now)];
                        }},
             field.kind);
}

}  // namespace

Outcome draw(const FormScreen& screen, const Visit& visit, Stage& stage) {
  Ui& ui = stage.ui;
  ui.begin_card(36);
  ui.heading(stage.phrase(Phrase::form_title));
  if (!visit.script->form.empty()) ui.prefer(visit.script->form.front().name);
  for (const FormField& field : visit.script->form) {
    ui.label(field.label);
    if (!field.required) ui.note(stage.phrase(Phrase::form_optional));
    draw_field(field, stage);
    ui.gap(0.3);
    for (const FormProblem& problem : screen.problems)
      if (problem.field == field.name)
        if (const auto fault = fault_of(field, stage.drafts.form[field.name]))  // until it is put right
          ui.problem(problem_text(stage, field, *fault));
    ui.gap(0.5);
  }
  const std::array<Ui::ButtonText, 1> submit = {
      {{"submit", stage.phrase(Phrase::form_submit), Ui::ButtonKind::leading}}};
  const bool submitted = ui.buttons(submit).has_value();
  ui.end_card();
  if (!submitted) return std::nullopt;
  FormSubmitted form;
  for (const FormField& field : visit.script->form)
    if (const std::string& value = stage.drafts.form[field.name]; !value.empty())
      form.answers.push_back({field.name, value});
  return form;
}

}  // namespace seamline::study::app
