#include "analysis/scores/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/numbers.h"
#include "support/text/request_name.h"

namespace seamline::analysis {

namespace {

/// Sum over answers, so that repeats of one stimulus become one value.
struct AnswerTally {
  double noticeability = 0;
  double correct = 0;
  int answers = 0;
};

struct CurveKey {
  Artifact artifact = Artifact::none;
  int condition = 0;  ///< its place in the study's order
  std::string scene;
  int object_index = 0;
  std::string object;
  auto operator<=>(const CurveKey&) const = default;
};

/// Along the curve.
struct LevelOrder {
  LevelAxis axis;
  bool operator()(double a, double b) const { return comes_before(axis, a, b); }
};

template <class Value>
using ByLevel = std::map<double, Value, LevelOrder>;

using PersonTallies = std::map<int, AnswerTally>;                           // person -> answers
using ObjectTallies = std::map<CurveKey, ByLevel<PersonTallies>>;           // object -> level -> person
using PersonMeans = std::map<int, std::vector<std::pair<double, double>>>;  // person -> objects' means

ObjectTallies tally_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people,
                            const std::vector<std::string>& conditions) {
  const LevelOrder order{level_axis(log)};
  std::map<std::string, int> person_of;
  for (int person = 0; person < std::ssize(people); ++person) person_of[people[person].record.code] = person;

  ObjectTallies tallies;
  for (const study::Answer& answer : log.answers) {
    const auto found = person_of.find(answer.participant);
    if (found == person_of.end())
      throw input_error({.file = log.file.string(),
                         .field = "answers",
                         .wanted = "a participant that the log lists",
                         .found = "'" + answer.participant + "'"});
    if (people[found->second].use != Use::used) continue;
    const auto condition = std::find(conditions.begin(), conditions.end(), answer.condition);
    const CurveKey key{answer.artifact, static_cast<int>(condition - conditions.begin()), answer.scene,
                       answer.object_index, answer.object};
    const auto object = tallies.try_emplace(key, order).first;
    AnswerTally& tally = object->second[answer.level][found->second];
    tally.noticeability += answer.noticeability();
    tally.correct += answer.correct() ? 1 : 0;
    ++tally.answers;
  }
  return tallies;
}

/// `means` holds (noticeability, share correct) of one participant each.
CellMean cell(double level, const std::vector<std::pair<double, double>>& means) {
  std::vector<double> noticeability;
  double correct = 0;
  for (const auto& [value, right] : means) {
    noticeability.push_back(value);
    correct += right;
  }
  CellMean result = mean_over_participants(noticeability);
  result.level = level;
  result.correct = correct / means.size();
  return result;
}

ObjectCurve object_curve(const CurveKey& key, const std::string& condition,
                         const ByLevel<PersonTallies>& levels) {
  ObjectCurve curve{.artifact = key.artifact,
                    .condition = condition,
                    .scene = key.scene,
                    .object = key.object,
                    .object_index = key.object_index,
                    .cells = {}};
  for (const auto& [level, persons] : levels) {
    std::vector<std::pair<double, double>> means;
    for (const auto& [person, tally] : persons)
      means.emplace_back(tally.noticeability / tally.answers, tally.correct / tally.answers);
    curve.cells.push_back(cell(level, means));
  }
  return curve;
}

std::pair<double, double> mean_of_objects(const std::vector<std::pair<double, double>>& objects) {
  double value = 0, right = 0;
  for (const auto& [object_value, object_right] : objects) {
    value += object_value;
    right += object_right;
  }
  return {value / objects.size(), right / objects.size()};
}

/// Everybody with an answer at one of the levels is on the curve; each mean is over those who answered there.
ArtifactScores artifact_scores(Artifact artifact, const std::string& condition,
                               const ByLevel<PersonMeans>& levels,
                               const std::vector<ParticipantUse>& people) {
  ArtifactScores scores{.artifact = artifact,
                        .condition = condition,
                        .axis = levels.key_comp().axis,
                        .level = {},
                        .people = {},
                        .noticeability = {},
                        .cells = {},
                        .incomplete = {}};
  std::map<int, int> levels_of;  // person -> number of levels
  for (const auto& [level, persons] : levels) {
    scores.level.push_back(level);
    for (const auto& entry : persons) ++levels_of[entry.first];
  }
  std::map<int, Eigen::Index> row_of;
  for (const auto& [person, count] : levels_of) {
    const std::string& code = people[person].record.code;
    row_of[person] = static_cast<Eigen::Index>(scores.people.size());
    scores.people.push_back(code);
    if (count < std::ssize(levels)) scores.incomplete.push_back(code);
  }
  scores.noticeability.setConstant(static_cast<Eigen::Index>(scores.people.size()),
                                   static_cast<Eigen::Index>(levels.size()), nan);
  Eigen::Index column = 0;
  for (const auto& [level, persons] : levels) {
    std::vector<std::pair<double, double>> means;
    for (const auto& [person, objects] : persons) {
      means.push_back(mean_of_objects(objects));
      scores.noticeability(row_of.at(person), column) = means.back().first;
    }
    scores.cells.push_back(cell(level, means));
    ++column;
  }
  return scores;
}

ObjectTallies tallies_of_somebody(const study::LogContents& log, const std::vector<ParticipantUse>& people,
                                  const std::vector<std::string>& conditions) {
  ObjectTallies tallies = tally_answers(log, people, conditions);
  if (tallies.empty())
    throw input_error({.file = log.file.string(),
                       .field = "",
                       .wanted = "answers of at least one completed participant who is not excluded",
                       .found = "none among " + counted(people.size(), "participant") + " (pilot data need " +
                                request_name("include_pilot") + ")"});
  return tallies;
}

}  // namespace

CellMean mean_over_participants(const std::vector<double>& values) {
  const double n = values.size();
  double sum = 0, squares = 0;
  for (double value : values) sum += value;
  const double mean = sum / n;
  for (double value : values) squares += (value - mean) * (value - mean);
  const double sem = values.size() > 1 ? std::sqrt(squares / (n - 1) / n) : nan;
  return {.level = 0, .n = static_cast<int>(values.size()), .mean = mean, .sem = sem, .correct = 0};
}

std::pair<int, int> people_at_levels(const ArtifactScores& scores) {
  std::pair<int, int> range;
  for (const CellMean& cell : scores.cells) {
    if (&cell == &scores.cells.front()) range = {cell.n, cell.n};
    range = {std::min(range.first, cell.n), std::max(range.second, cell.n)};
  }
  return range;
}

void require_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people) {
  static_cast<void>(tallies_of_somebody(log, people, conditions_of(log, {})));
}

std::string in_condition(const std::string& condition) {
  return condition.empty() ? "" : " (" + condition + ")";
}

bool has_conditions(const NoticeabilityData& data) {
  return std::any_of(data.conditions.begin(), data.conditions.end(),
                     [](const std::string& name) { return !name.empty(); });
}

std::vector<std::string> conditions_of(const study::LogContents& log, const std::vector<std::string>& order) {
  std::set<std::string> seen;
  std::vector<std::string> as_they_appear;
  for (const study::Answer& answer : log.answers)
    if (seen.insert(answer.condition).second) as_they_appear.push_back(answer.condition);
  std::vector<std::string> conditions;
  for (const std::string& name : order)
    if (seen.erase(name) > 0) conditions.push_back(name);
  for (const std::string& name : as_they_appear)
    if (seen.erase(name) > 0) conditions.push_back(name);
  return conditions;
}

NoticeabilityData average_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people,
                                  const std::vector<std::string>& order) {
  NoticeabilityData data;
  data.axis = level_axis(log);
  data.conditions = conditions_of(log, order);
  const ObjectTallies tallies = tallies_of_somebody(log, people, data.conditions);
  std::map<std::pair<Artifact, int>, ByLevel<PersonMeans>> by_artifact;
  for (const auto& [key, levels] : tallies) {
    data.objects.push_back(object_curve(key, data.conditions[key.condition], levels));
    ByLevel<PersonMeans>& curve =
        by_artifact.try_emplace({key.artifact, key.condition}, LevelOrder{data.axis}).first->second;
    for (const auto& [level, persons] : levels)
      for (const auto& [person, tally] : persons)
        curve[level][person].emplace_back(tally.noticeability / tally.answers, tally.correct / tally.answers);
  }
  for (const auto& [key, levels] : by_artifact)
    data.artifacts.push_back(artifact_scores(key.first, data.conditions[key.second], levels, people));
  return data;
}

std::vector<double> levels_on_axis(const ArtifactScores& scores) {
  return x_of_levels(scores.axis, scores.level);
}

std::vector<double> means_on_axis(const ArtifactScores& scores) {
  std::vector<double> means;
  for (const CellMean& cell : scores.cells)
    if (!stands_apart(scores.axis, cell.level)) means.push_back(cell.mean);
  return means;
}

}  // namespace seamline::analysis
