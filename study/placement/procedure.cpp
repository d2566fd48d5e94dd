#include "study/placement/procedure.h"

#include <cassert>

#include "support/running/overloaded.h"

namespace seamline::study {

std::optional<int> current_stimulus(const Procedure& procedure) {
  return std::visit(Overloaded{[](const ConstantProcedure& constant) -> std::optional<int> {
                                 const std::size_t due = constant.answered;
                                 if (due >= constant.order.size()) return std::nullopt;
                                 return constant.order[due];
                               },
                               [](const QuestPlusProcedure& quest_plus) { return quest_plus.due; },
                               [](const StaircaseProcedure& stairs) { return stairs.due; }},
                    procedure);
}

Procedure after_answer(Procedure procedure, const TrialAnswer& answer) {
  assert(current_stimulus(procedure) && answer.trial_index == answered_trials(procedure));
  std::visit(
      Overloaded{
          [](ConstantProcedure& constant) { ++constant.answered; },
          [&](QuestPlusProcedure& quest_plus) { quest_plus = after_answer(std::move(quest_plus), answer); },
          [&](StaircaseProcedure& stairs) { stairs = after_answer(std::move(stairs), answer); }},
      procedure);
  return procedure;
}

int answered_trials(const Procedure& procedure) {
  return std::visit(Overloaded{[](const ConstantProcedure& constant) { return constant.answered; },
                               [](const QuestPlusProcedure& quest_plus) { return quest_plus.answered; },
                               [](const StaircaseProcedure& stairs) { return stairs.answered; }},
                    procedure);
}

int most_trials(const Procedure& procedure) {
  return std::visit(
      Overloaded{[](const ConstantProcedure& constant) { return static_cast<int>(constant.order.size()); },
                 [](const QuestPlusProcedure& quest_plus) { return most_trials(quest_plus); },
                 [](const StaircaseProcedure& stairs) { return most_trials(stairs); }},
      procedure);
}

}  // namespace seamline::study
