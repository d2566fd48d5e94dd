#include "analysis/screening/screening_effect.h"

#include <algorithm>

namespace seamline::analysis {

namespace {

std::vector<ArtifactThresholds> thresholds_of(const study::LogContents& log,
                                              const std::vector<ParticipantUse>& people,
                                              const ResamplingRequest& request,
                                              const std::vector<std::string>& order) {
  if (count_participants(people).used == 0) return {};
  std::vector<ArtifactThresholds> thresholds;
  for (const ArtifactScores& scores : average_answers(log, people, order).artifacts)
    thresholds.push_back(estimate_thresholds(scores, request));
  return thresholds;
}

}  // namespace

std::vector<ParticipantUse> leave_out(std::vector<ParticipantUse> people,
                                      const std::vector<std::string>& codes) {
  for (ParticipantUse& person : people)
    if (person.use == Use::used && std::find(codes.begin(), codes.end(), person.record.code) != codes.end())
      person.use = Use::screened;
  return people;
}

std::vector<ScreenedThresholds> thresholds_with_and_without(const study::LogContents& log,
                                                            const std::vector<ParticipantUse>& people,
                                                            const Screening& screening,
                                                            const ResamplingRequest& request,
                                                            const std::vector<std::string>& order) {
  std::vector<ScreenedThresholds> results = {{.who = "everybody", .left_out = {}, .thresholds = {}}};
  for (ScreeningRule rule : every_screening_rule)
    if (const std::vector<std::string> named = screening.named_by(rule); !named.empty())
      results.push_back(
          {.who = "without those named by " + std::string(word(rule)), .left_out = named, .thresholds = {}});
  if (results.size() > 2)
    results.push_back({.who = "without anybody named", .left_out = screening.named(), .thresholds = {}});
  for (auto result = results.begin(); result != results.end(); ++result) {
    const auto same = std::find_if(results.begin(), result, [&](const ScreenedThresholds& earlier) {
      return earlier.left_out == result->left_out;
    });
    result->thresholds = same != result
                             ? same->thresholds
                             : thresholds_of(log, leave_out(people, result->left_out), request, order);
  }
  return results;
}

}  // namespace seamline::analysis
