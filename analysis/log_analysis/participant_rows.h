#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// One line of the participant table.
struct ParticipantRow {
  std::string code;
  std::string kind;  ///< "person" or "simulated: threshold"
  Use use = Use::used;
  std::string why;  ///< why their answers are not used; empty when they are
  bool pilot = false;
  int answers = 0, stimulus_trials = 0;
  double correct = 0;             ///< share of right choices; NaN without answers
  double mean_rating = 0;         ///< of all answers, 1 to 4; NaN without answers
  std::string screens;            ///< screens that name them, "kurtosis, correlation"; empty when none does
  bool screened = false;          ///< whether any screen judged them: only those used before screening are
  double median_choice_s = 0;     ///< NaN when simulated or without answers
  std::vector<std::string> form;  ///< an answer a question of `answered_questions`; empty where there is none
  std::optional<study::ShownOn> display;
};

/// Everybody in the log, in the order of arrival.
[[nodiscard]] std::vector<ParticipantRow> participant_rows(const Analysis& analysis);

}  // namespace seamline::analysis
