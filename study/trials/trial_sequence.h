#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "study/placement/procedure.h"
#include "study/placement/trial.h"
#include "study/trials/right_rule.h"

namespace seamline::study {

/// A catch trial, and its place: it comes once so many `stimulus` trials have been answered.
struct CatchTrial {
  int after_stimulus_trials = 0;
  Trial trial;
  bool operator==(const CatchTrial&) const = default;
};

/// All trials of a participant: those of the procedure, with catch trials between them. A procedure sees its
/// own trials alone, so an adaptive one learns from nothing else, and the same answers lead to the same
/// stimuli with catch trials or without.
struct TrialSequence {
  Procedure procedure;
  std::vector<CatchTrial> catches = {};  ///< in the order in which they come
  int catches_answered = 0;
  RightRule right = {};
};

/// The trial that is due, or none when the session is over. Catch trials that were drawn beyond the last
/// trial of a procedure that stopped early are left out.
[[nodiscard]] std::optional<Trial> current_trial(const TrialSequence& trials);

/// The trial after the one that is due, where it is known before the answer: what may be decoded ahead.
[[nodiscard]] std::optional<Trial> trial_after_current(const TrialSequence& trials);

/// The sequence once the trial that was due has been answered. Precondition: there was one, and
/// `answer.trial_index` is `answered_trials`.
[[nodiscard]] TrialSequence after_answer(TrialSequence trials, const TrialAnswer& answer);

/// How many trials of every kind have been answered: the 0-based index of the trial that is due.
[[nodiscard]] int answered_trials(const TrialSequence& trials);

/// How many trials of every kind there will be in all, or at most; what a progress bar is measured against.
[[nodiscard]] int most_trials(const TrialSequence& trials);

}  // namespace seamline::study
