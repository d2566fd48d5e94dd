#pragma once
#include <optional>
#include <variant>
#include <vector>

#include "study/placement/quest_plus_procedure.h"
#include "study/placement/staircase.h"
#include "study/placement/trial.h"

namespace seamline::study {

/// Method of constant stimuli: a fixed order, whatever is answered (paper section 4.2).
struct ConstantProcedure {
  std::vector<int> order;  ///< indices into the set's stimuli
  int answered = 0;        ///< how many of them have an answer
};

/// How the next stimulus is found: a closed set. An adaptive procedure keeps its belief in its own
/// alternative, learns and picks in `after_answer`, and shows its pick in `current_stimulus`; nothing else in
/// a session knows which procedure runs.
using Procedure = std::variant<ConstantProcedure, QuestPlusProcedure, StaircaseProcedure>;

/// The stimulus of the trial that is due (an index into the set's stimuli), or none when the procedure is
/// over.
[[nodiscard]] std::optional<int> current_stimulus(const Procedure& procedure);

/// The procedure once the trial that was due has been answered. Precondition: there was one.
[[nodiscard]] Procedure after_answer(Procedure procedure, const TrialAnswer& answer);

/// How many trials have been answered: the 0-based index of the trial that is due.
[[nodiscard]] int answered_trials(const Procedure& procedure);

/// How many trials there will be in all, or at most; what a progress bar is measured against.
[[nodiscard]] int most_trials(const Procedure& procedure);

}  // namespace seamline::study
