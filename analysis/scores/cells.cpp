#include "analysis/scores/cells.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "support/text/error.h"
#include "support/text/numbers.h"

namespace seamline::analysis {

namespace {

/// Sum over answers, so that repeats of one stimulus become one value.
struct AnswerTally {
  double noticeability = 0;
  double correct = 0;
  int answers = 0;
};

struct ObjectKey {
  Artifact artifact = Artifact::none;
  std::string scene;
  int object_index = 0;
  std::string object;
  auto operator<=>(const ObjectKey&) const = default;
};

using PersonTallies = std::map<int, AnswerTally>;                           // person -> answers
using ObjectTallies = std::map<ObjectKey, std::map<int, PersonTallies>>;    // object -> width -> person
using PersonMeans = std::map<int, std::vector<std::pair<double, double>>>;  // person -> objects' means

ObjectTallies tally_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people) {
  std::map<std::string, int> person_of;
  for (int person = 0; person < static_cast<int>(people.size()); ++person)
    person_of[people[static_cast<std::size_t>(person)].record.code] = person;

  ObjectTallies tallies;
  for (const study::Answer& answer : log.answers) {
    const auto found = person_of.find(answer.participant);
    if (found == person_of.end())
      throw input_error({.file = log.file.string(),
                         .field = "answers",
                         .wanted = "a participant that the log lists",
                         .found = "'" + answer.participant + "'"});
    if (people[static_cast<std::size_t>(found->second)].use != Use::used) continue;
    const ObjectKey key{answer.artifact, answer.scene, answer.object_index, answer.object};
    AnswerTally& tally = tallies[key][answer.depth_width_px][found->second];
    tally.noticeability += answer.noticeability();
    tally.correct += answer.correct() ? 1 : 0;
    ++tally.answers;
  }
  return tallies;
}

/// `means` holds (noticeability, share correct) of one participant each.
CellMean cell(int width_px, const std::vector<std::pair<double, double>>& means) {
  std::vector<double> noticeability;
  double correct = 0;
  for (const auto& [value, right] : means) {
    noticeability.push_back(value);
    correct += right;
  }
  CellMean result = mean_over_participants(noticeability);
  result.width_px = width_px;
  result.correct = correct / static_cast<double>(means.size());
  return result;
}

ObjectCurve object_curve(const ObjectKey& key, const std::map<int, PersonTallies>& widths) {
  ObjectCurve curve{.artifact = key.artifact,
                    .scene = key.scene,
                    .object = key.object,
                    .object_index = key.object_index,
                    .cells = {}};
  for (const auto& [width_px, persons] : widths) {
    std::vector<std::pair<double, double>> means;
    for (const auto& [person, tally] : persons)
      means.emplace_back(tally.noticeability / tally.answers, tally.correct / tally.answers);
    curve.cells.push_back(cell(width_px, means));
  }
  return curve;
}

std::pair<double, double> mean_of_objects(const std::vector<std::pair<double, double>>& objects) {
  double value = 0, right = 0;
  for (const auto& [object_value, object_right] : objects) {
    value += object_value;
    right += object_right;
  }
  return {value / static_cast<double>(objects.size()), right / static_cast<double>(objects.size())};
}

/// The people with an answer at every width stay; the others are named. A mean over different people at
/// different widths would bend the curve.
ArtifactScores artifact_scores(Artifact artifact, const std::map<int, PersonMeans>& widths,
                               const std::vector<ParticipantUse>& people) {
  ArtifactScores scores{
      .artifact = artifact, .width_px = {}, .people = {}, .noticeability = {}, .cells = {}, .left_out = {}};
  std::map<int, int> widths_of;  // person -> number of widths
  for (const auto& [width_px, persons] : widths) {
    scores.width_px.push_back(width_px);
    for (const auto& entry : persons) ++widths_of[entry.first];
  }
  std::vector<int> rows;
  for (const auto& [person, count] : widths_of) {
    const std::string& code = people[static_cast<std::size_t>(person)].record.code;
    const bool complete = count == static_cast<int>(widths.size());
    (complete ? scores.people : scores.left_out).push_back(code);
    if (complete) rows.push_back(person);
  }
  scores.noticeability.resize(static_cast<Eigen::Index>(rows.size()),
                              static_cast<Eigen::Index>(widths.size()));
  Eigen::Index column = 0;
  for (const auto& [width_px, persons] : widths) {
    std::vector<std::pair<double, double>> means;
    for (std::size_t row = 0; row < rows.size(); ++row) {
      means.push_back(mean_of_objects(persons.at(rows[row])));
      scores.noticeability(static_cast<Eigen::Index>(row), column) = means.back().first;
    }
    if (!means.empty()) scores.cells.push_back(cell(width_px, means));
    ++column;
  }
  return scores;
}

ObjectTallies tallies_of_somebody(const study::LogContents& log, const std::vector<ParticipantUse>& people) {
  ObjectTallies tallies = tally_answers(log, people);
  if (tallies.empty())
    throw input_error({.file = log.file.string(),
                       .field = "",
                       .wanted = "answers of at least one completed participant who is not excluded",
                       .found = "none among " + std::to_string(people.size()) +
                                " participants (pilot data need --include-pilot)"});
  return tallies;
}

}  // namespace

CellMean mean_over_participants(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double sum = 0, squares = 0;
  for (double value : values) sum += value;
  const double mean = sum / n;
  for (double value : values) squares += (value - mean) * (value - mean);
  const double sem = values.size() > 1 ? std::sqrt(squares / (n - 1) / n) : nan;
  return {.width_px = 0, .n = static_cast<int>(values.size()), .mean = mean, .sem = sem, .correct = 0};
}

void require_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people) {
  static_cast<void>(tallies_of_somebody(log, people));
}

NoticeabilityData average_answers(const study::LogContents& log, const std::vector<ParticipantUse>& people) {
  const ObjectTallies tallies = tallies_of_somebody(log, people);
  NoticeabilityData data;
  std::map<Artifact, std::map<int, PersonMeans>> by_artifact;
  for (const auto& [key, widths] : tallies) {
    data.objects.push_back(object_curve(key, widths));
    for (const auto& [width_px, persons] : widths)
      for (const auto& [person, tally] : persons)
        by_artifact[key.artifact][width_px][person].emplace_back(tally.noticeability / tally.answers,
                                                                 tally.correct / tally.answers);
  }
  for (const auto& [artifact, widths] : by_artifact)
    data.artifacts.push_back(artifact_scores(artifact, widths, people));
  return data;
}

}  // namespace seamline::analysis
