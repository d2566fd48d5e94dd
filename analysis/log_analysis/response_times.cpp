#include "analysis/log_analysis/response_times.h"

#include <algorithm>
#include <map>
#include <set>

#include "analysis/statistics/interval.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

struct TimeTally {
  std::set<std::string> people;
  std::vector<double> choice_s, rating_s;
};

/// Artifact (-1: all), condition, level, which answers.
struct Key {
  int artifact = -1;
  int condition = 0;
  double level = 0;
  TimedAnswers which = TimedAnswers::all;
};

/// In the order of the rows.
struct RowOrder {
  LevelAxis axis;
  bool operator()(const Key& a, const Key& b) const {
    if (a.artifact != b.artifact) return a.artifact < b.artifact;
    if (a.condition != b.condition) return a.condition < b.condition;
    if (a.level != b.level) return comes_before(axis, a.level, b.level);
    return a.which < b.which;
  }
};

}  // namespace

std::string_view word(TimedAnswers answers) {
  switch (answers) {
    case TimedAnswers::all:
      return "all";
    case TimedAnswers::right:
      return "right";
    case TimedAnswers::wrong:
      return "wrong";
  }
  return "";
}

Quartiles quartiles(std::vector<double> values) {
  if (values.empty()) return {.lower_s = nan, .median_s = nan, .upper_s = nan};
  const double lower = quantile(values, 0.25), median = quantile(values, 0.5);
  return {.lower_s = lower, .median_s = median, .upper_s = quantile(values, 0.75)};
}

ResponseTimes response_times(const Analysis& analysis) {
  std::set<std::string> timed;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used && !person.record.simulated) timed.insert(person.record.code);
  const std::vector<std::string>& conditions = analysis.data.conditions;
  std::map<Key, TimeTally, RowOrder> tallies(RowOrder{analysis.data.axis});
  for (const study::Answer& answer : analysis.log.answers) {
    if (!timed.contains(answer.participant)) continue;
    const auto place = std::find(conditions.begin(), conditions.end(), answer.condition);
    for (int artifact : {-1, static_cast<int>(answer.artifact)})
      for (TimedAnswers which :
           {TimedAnswers::all, answer.correct() ? TimedAnswers::right : TimedAnswers::wrong}) {
        TimeTally& tally =
            tallies[{.artifact = artifact,
                     .condition = artifact < 0 ? 0 : static_cast<int>(place - conditions.begin()),
                     .level = answer.level,
                     .which = which}];
        tally.people.insert(answer.participant);
        tally.choice_s.push_back(answer.choice_ns * 1e-9);
        tally.rating_s.push_back(static_cast<double>(answer.rating_ns - answer.choice_ns) * 1e-9);
      }
  }
  ResponseTimes times;
  for (const auto& [key, tally] : tallies) {
    const int artifact = key.artifact;
    times.rows.push_back(
        {.artifact = artifact < 0 ? std::nullopt : std::optional(static_cast<Artifact>(artifact)),
         .condition = artifact < 0 ? "" : conditions[key.condition],
         .level = key.level,
         .which = key.which,
         .answers = static_cast<int>(tally.choice_s.size()),
         .people = static_cast<int>(tally.people.size()),
         .choice = quartiles(tally.choice_s),
         .rating = quartiles(tally.rating_s)});
  }
  if (times.rows.empty())
    times.missing =
        "There are no response times: everybody used is a simulated observer, and those take no time.";
  return times;
}

}  // namespace seamline::analysis
