#pragma once
#include "analysis/log_analysis/analysis.h"
#include "analysis/ordinal/contrasts/study_model.h"

namespace seamline::analysis {

/// The answers of the participants marked `Use::used`, in the log's order.
[[nodiscard]] std::vector<study::Answer> used_answers(const study::LogContents& log,
                                                      const std::vector<ParticipantUse>& people);

/// The ordinal mixed model of a log's used answers. `groups` may be empty. Throws InputError as
/// fit_ordinal_study.
[[nodiscard]] OrdinalStudy ordinal_study(const Analysis& analysis, const ParticipantGroups& groups,
                                         const OrdinalStudyRequest& request);

}  // namespace seamline::analysis
