#include "analysis/log_analysis/response_times.h"

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

/// Artifact (-1: all), width, which answers: in the order of the rows.
using Key = std::tuple<int, int, TimedAnswers>;

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
  std::map<Key, TimeTally> tallies;
  for (const study::Answer& answer : analysis.log.answers) {
    if (!timed.contains(answer.participant)) continue;
    for (int artifact : {-1, static_cast<int>(answer.artifact)})
      for (TimedAnswers which :
           {TimedAnswers::all, answer.correct() ? TimedAnswers::right : TimedAnswers::wrong}) {
        TimeTally& tally = tallies[{artifact, answer.depth_width_px, which}];
        tally.people.insert(answer.participant);
        tally.choice_s.push_back(static_cast<double>(answer.choice_ns) * 1e-9);
        tally.rating_s.push_back(static_cast<double>(answer.rating_ns - answer.choice_ns) * 1e-9);
      }
  }
  ResponseTimes times;
  for (const auto& [key, tally] : tallies) {
    const auto& [artifact, width_px, which] = key;
    times.rows.push_back(
        {.artifact = artifact < 0 ? std::nullopt : std::optional(static_cast<Artifact>(artifact)),
         .width_px = width_px,
         .which = which,
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
