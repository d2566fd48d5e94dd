#pragma once
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "analysis/ordinal/contrasts/study_design.h"

namespace seamline::analysis {

/// The questions of the form that somebody in the log answered, by name.
[[nodiscard]] std::vector<std::string> answered_questions(const study::LogContents& log);

/// What somebody answered; empty where they did not.
[[nodiscard]] std::string answer_to(const study::ParticipantRecord& record, const std::string& question);

/// Who the participants used are and what they saw the pictures on, a sentence a question of the form
/// ("Vision: 19 normal, 1 neither.") and one on screens; empty where the log knows nothing.
[[nodiscard]] std::vector<std::string> participants_described(const Analysis& analysis);

/// The participants used by their technical background, "technical" and "other", for comparison; empty where
/// nobody was asked.
[[nodiscard]] ParticipantGroups technical_groups(const Analysis& analysis);

/// What two to four participants mean for intervals, as a sentence of report and methods text; empty for more
/// people, and for one.
[[nodiscard]] std::string few_people_sentence(const Analysis& analysis);

}  // namespace seamline::analysis
