#include "study/trials/trial_sequence.h"

#include <algorithm>
#include <cassert>

#include "study/placement/placed_answer.h"
#include "support/running/overloaded.h"

namespace seamline::study {
namespace {

/// The catch trial that comes before the procedure's next trial, if one does.
const CatchTrial* due_catch(const TrialSequence& trials) {
  const std::size_t next = trials.catches_answered;
  if (next >= trials.catches.size()) return nullptr;
  const CatchTrial& candidate = trials.catches[next];
  return candidate.after_stimulus_trials <= answered_trials(trials.procedure) ? &candidate : nullptr;
}

std::optional<Trial> stimulus_trial(std::optional<int> stimulus) {
  if (!stimulus) return std::nullopt;
  return Trial{.kind = TrialKind::stimulus, .stimulus = *stimulus};
}

}  // namespace

std::optional<Trial> current_trial(const TrialSequence& trials) {
  const CatchTrial* due = due_catch(trials);
  std::optional<Trial> trial =
      due != nullptr ? due->trial : stimulus_trial(current_stimulus(trials.procedure));
  if (trial) trial->right_index = right_index_of(trials.right, *trial, answered_trials(trials));
  return trial;
}

std::optional<Trial> trial_after_current(const TrialSequence& trials) {
  TrialSequence after = trials;
  if (due_catch(trials) != nullptr) {
    ++after.catches_answered;
    return current_trial(after);
  }
  if (!current_stimulus(trials.procedure)) return std::nullopt;
  const std::size_t next = trials.catches_answered;
  if (next < trials.catches.size() &&
      trials.catches[next].after_stimulus_trials <= answered_trials(trials.procedure) + 1) {
    Trial trial = trials.catches[next].trial;
    trial.right_index = right_index_of(trials.right, trial, answered_trials(trials) + 1);
    return trial;
  }
  auto* constant = std::get_if<ConstantProcedure>(&after.procedure);
  if (constant == nullptr) return std::nullopt;  // an adaptive one decides by the answer
  ++constant->answered;
  return current_trial(after);
}

TrialSequence after_answer(TrialSequence trials, const TrialAnswer& answer) {
  assert(current_trial(trials) && answer.trial_index == answered_trials(trials));
  if (due_catch(trials) != nullptr) {
    ++trials.catches_answered;
    return trials;
  }
  TrialAnswer own = answer;
  const auto place_answer = [&](const auto& adaptive) {
    const Trial trial = current_trial(trials).value();
    const auto& place = adaptive.design->places[trial.stimulus];
    own = placed_answer(own, trial.right_index, place.object_index);
  };
  std::visit(Overloaded{[](const ConstantProcedure&) {}, place_answer}, trials.procedure);
  own.trial_index = answered_trials(trials.procedure);
  trials.procedure = after_answer(std::move(trials.procedure), own);
  return trials;
}

int answered_trials(const TrialSequence& trials) {
  return answered_trials(trials.procedure) + trials.catches_answered;
}

int most_trials(const TrialSequence& trials) {
  return most_trials(trials.procedure) + static_cast<int>(trials.catches.size());
}

}  // namespace seamline::study
