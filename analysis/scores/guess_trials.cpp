#include "analysis/scores/guess_trials.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

namespace seamline::analysis {

namespace {

/// A participant in a cell, and which object they judged there.
using PersonCell = std::pair<int, int>;
using ObjectOf = std::tuple<std::string, int, std::string>;  // scene, object_index, object

struct Placed {
  const study::Answer* answer = nullptr;
  PersonCell where;
};

/// The people of a log in its order who are on some curve.
std::vector<std::string> people_on_curves(const study::LogContents& log, const NoticeabilityData& data) {
  std::set<std::string> on_curve;
  for (const ArtifactScores& scores : data.artifacts)
    on_curve.insert(scores.people.begin(), scores.people.end());
  std::vector<std::string> people;
  for (const study::ParticipantRecord& record : log.participants)
    if (on_curve.contains(record.code)) people.push_back(record.code);
  return people;
}

/// The answers that are on the curves, each with its place.
std::vector<Placed> placed_answers(const study::LogContents& log, const NoticeabilityData& data,
                                   const GuessTrials& trials) {
  std::map<std::string, int> person_of;
  for (std::size_t p = 0; p < trials.people.size(); ++p) person_of[trials.people[p]] = static_cast<int>(p);
  std::map<std::tuple<Artifact, std::string, double>, int> cell_of;
  for (std::size_t c = 0; c < trials.cells.size(); ++c)
    cell_of[{trials.cells[c].artifact, trials.cells[c].condition, trials.cells[c].level}] =
        static_cast<int>(c);
  std::set<std::tuple<Artifact, std::string, std::string>> on_curve;
  for (const ArtifactScores& scores : data.artifacts)
    for (const std::string& code : scores.people) on_curve.insert({scores.artifact, scores.condition, code});

  std::vector<Placed> placed;
  for (const study::Answer& answer : log.answers)
    if (on_curve.contains({answer.artifact, answer.condition, answer.participant}))
      placed.push_back({.answer = &answer,
                        .where = {person_of.at(answer.participant),
                                  cell_of.at({answer.artifact, answer.condition, answer.level})}});
  return placed;
}

}  // namespace

GuessTrials count_guess_trials(const study::LogContents& log, const NoticeabilityData& data,
                               const std::vector<ReferenceAnswer>& references) {
  GuessTrials trials;
  trials.task = facts_of(log.task.get());
  trials.people = people_on_curves(log, data);
  for (const ArtifactScores& scores : data.artifacts)
    for (const double level : scores.level)
      trials.cells.push_back({.artifact = scores.artifact, .condition = scores.condition, .level = level});
  const auto people = static_cast<Eigen::Index>(trials.people.size());
  const CellShape shape = trials.shape();
  trials.answers =
      Eigen::MatrixXd::Zero(people, static_cast<Eigen::Index>(trials.cells.size()) * shape.of_cell());
  trials.references = Eigen::MatrixXd::Zero(people, shape.of_trial());

  const std::vector<Placed> placed = placed_answers(log, data, trials);
  std::map<PersonCell, std::map<ObjectOf, int>> objects;
  std::map<int, int> cell_answers;
  std::map<int, std::set<int>> cell_people;
  for (const Placed& one : placed) {
    ++objects[one.where][{one.answer->scene, one.answer->object_index, one.answer->object}];
    ++cell_answers[one.where.second];
    cell_people[one.where.second].insert(one.where.first);
  }
  for (const Placed& one : placed) {
    const auto [person, cell] = one.where;
    const auto& of_person = objects.at(one.where);
    const int repeats = of_person.at({one.answer->scene, one.answer->object_index, one.answer->object});
    const double per_person = cell_answers.at(cell) / static_cast<double>(cell_people.at(cell).size());
    trials.answers(person, cell * shape.of_cell() + shape.place(one.answer->right(), one.answer->chosen_index,
                                                                one.answer->rating)) +=
        per_person / (static_cast<double>(of_person.size()) * repeats);
  }
  for (const ReferenceAnswer& reference : references) {
    const auto found = std::find(trials.people.begin(), trials.people.end(), reference.participant);
    if (found == trials.people.end()) continue;
    trials.references(found - trials.people.begin(),
                      (reference.chosen_index - 1) * study::highest_rating + reference.rating - 1) += 1;
  }
  return trials;
}

}  // namespace seamline::analysis
