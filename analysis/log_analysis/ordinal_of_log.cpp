#include "analysis/log_analysis/ordinal_of_log.h"

#include <set>

namespace seamline::analysis {

std::vector<study::Answer> used_answers(const study::LogContents& log,
                                        const std::vector<ParticipantUse>& people) {
  std::set<std::string> used;
  for (const ParticipantUse& person : people)
    if (person.use == Use::used) used.insert(person.record.code);
  std::vector<study::Answer> answers;
  for (const study::Answer& answer : log.answers)
    if (used.contains(answer.participant)) answers.push_back(answer);
  return answers;
}

OrdinalStudy ordinal_study(const Analysis& analysis, const ParticipantGroups& groups,
                           const OrdinalStudyRequest& request) {
  return fit_ordinal_study(used_answers(analysis.log, analysis.people), groups, request);
}

}  // namespace seamline::analysis
