#include "analysis/matching/match_thresholds.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "analysis/statistics/distributions.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::analysis {
namespace {

using CurveName = std::pair<Artifact, std::string>;

double mean_of_matches(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Sample standard deviation; none of fewer than two.
std::optional<double> deviation_of(const std::vector<double>& values) {
  if (values.size() < 2) return std::nullopt;
  const double mean = mean_of_matches(values);
  double squares = 0;
  for (const double value : values) squares += (value - mean) * (value - mean);
  return std::sqrt(squares / (values.size() - 1));
}

PersonMatches person_matches(const std::vector<study::MatchRecord>& matches, Quantity quantity) {
  std::vector<double> all, clear, faint;
  int at_end = 0;
  for (const study::MatchRecord& match : matches) {
    all.push_back(along_axis(quantity, match.level));
    (match.began_clear ? clear : faint).push_back(all.back());
    at_end += match.at_end ? 1 : 0;
  }
  const bool both = !clear.empty() && !faint.empty();
  return {
      .participant = matches.front().participant,
      .artifact = matches.front().artifact,
      .condition = matches.front().condition,
      .matches = static_cast<int>(all.size()),
      .at_end = at_end,
      .mean = mean_of_matches(all),
      .sd = deviation_of(all),
      .start_effect = both ? std::optional(mean_of_matches(clear) - mean_of_matches(faint)) : std::nullopt};
}

/// Of matches on different scales each participant weighs as many degrees of freedom as matches less one.
std::optional<double> pooled_deviation(const std::vector<PersonMatches>& people) {
  double squares = 0, freedom = 0;
  for (const PersonMatches& person : people) {
    if (!person.sd) continue;
    squares += *person.sd * *person.sd * (person.matches - 1);
    freedom += person.matches - 1;
  }
  return freedom > 0 ? std::optional(std::sqrt(squares / freedom)) : std::nullopt;
}

CurveMatches curve_matches(const std::vector<PersonMatches>& people) {
  CurveMatches curve{.artifact = people.front().artifact,
                     .condition = people.front().condition,
                     .people = static_cast<int>(people.size()),
                     .threshold = {}};
  std::vector<double> means, effects;
  for (const PersonMatches& person : people) {
    curve.matches += person.matches;
    curve.at_end += person.at_end;
    means.push_back(person.mean);
    if (person.start_effect) effects.push_back(*person.start_effect);
  }
  curve.threshold = mean_over_people(means);
  curve.between_sd = deviation_of(means);
  curve.within_sd = pooled_deviation(people);
  if (!effects.empty()) curve.start_effect = mean_over_people(effects);
  return curve;
}

/// Where the simulated people of a log see half, if they are all `threshold` observers.
void add_planted(MatchAnalysis& analysis) {
  if (common_observer(analysis.people) != "threshold") return;
  const ObserverDefinition observer = read_study_text(analysis.log.study_text, analysis.log.file).observer;
  for (CurveMatches& curve : analysis.curves) {
    const auto own = observer.condition_midpoint.find(curve.condition);
    const auto& midpoints = own != observer.condition_midpoint.end() ? own->second : observer.midpoint;
    if (const auto found = midpoints.find(curve.artifact); found != midpoints.end())
      curve.planted = found->second;
  }
}

void add_notes(MatchAnalysis& analysis) {
  int at_end = 0, one_match = 0;
  for (const CurveMatches& curve : analysis.curves) at_end += curve.at_end;
  for (const PersonMatches& person : analysis.of_people) one_match += person.matches < 2 ? 1 : 0;
  if (at_end > 0)
    analysis.notes.push_back(fmt::format(
        "{} of {} matches stopped at the first or the last level: the level at which the seam is just seen may "
        "lie beyond, so means with many of them are nearer to the middle than they should be.",
        at_end, analysis.matches.size()));
  if (!analysis.curves.empty() && analysis.curves.front().people < 2)
    analysis.notes.emplace_back("One participant gives no interval over participants.");
  if (one_match > 0)
    analysis.notes.emplace_back(
        "Somebody matched a curve once: a standard deviation of single matches needs two (task.repetitions).");
}

}  // namespace

double along_axis(Quantity quantity, double level) {
  return facts(quantity).axis == Axis::log2 ? std::log2(level) : level;
}

double level_along(Quantity quantity, double along) {
  return facts(quantity).axis == Axis::log2 ? std::exp2(along) : along;
}

MatchMean mean_over_people(const std::vector<double>& values) {
  MatchMean found{.mean = mean_of_matches(values)};
  const std::optional<double> sd = deviation_of(values);
  if (!sd) return found;
  constexpr double upper_tail = 0.975;
  const double n = values.size();
  const double half = student_quantile(n - 1, upper_tail) * *sd / std::sqrt(n);
  found.low = found.mean - half;
  found.high = found.mean + half;
  return found;
}

MatchAnalysis analyze_matches(study::LogContents log, std::vector<ParticipantUse> people) {
  MatchAnalysis analysis{.log = std::move(log), .people = std::move(people)};
  std::set<std::string> used;
  for (const ParticipantUse& person : analysis.people)
    if (person.use == Use::used) used.insert(person.record.code);
  if (used.empty())
    throw input_error({.file = analysis.log.file.string(),
                       .field = "participants",
                       .wanted = "at least one who finished and is not excluded (pilots count with " +
                                 request_name("include_pilot") + ")",
                       .found = fmt::format("{} in the log", analysis.people.size())});
  std::vector<CurveName> order;
  std::map<CurveName, std::map<std::string, std::vector<study::MatchRecord>>> of_curve;
  for (study::MatchRecord& match : study::read_matches(analysis.log)) {
    if (!used.contains(match.participant)) continue;
    const CurveName name{match.artifact, match.condition};
    if (!of_curve.contains(name)) order.push_back(name);
    of_curve[name][match.participant].push_back(match);
    analysis.matches.push_back(std::move(match));
  }
  std::sort(order.begin(), order.end());
  for (const CurveName& name : order) {
    std::vector<PersonMatches> persons;
    for (const auto& [code, matches] : of_curve[name])
      persons.push_back(person_matches(matches, analysis.log.quantity));
    analysis.curves.push_back(curve_matches(persons));
    analysis.of_people.insert(analysis.of_people.end(), persons.begin(), persons.end());
  }
  add_planted(analysis);
  add_notes(analysis);
  return analysis;
}

}  // namespace seamline::analysis
