#include "analysis/ordinal/contrasts/study_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "study/placement/trial.h"
#include "support/text/error.h"

namespace seamline::analysis {

namespace {

/// An object of an artifact: scene, place (left, middle, right), name.
using ObjectKey = std::tuple<std::string, int, std::string>;

ObjectKey key_of(const study::Answer& answer) {
  return {answer.scene, answer.object_index, answer.object};
}

/// The shortest of "name", "scene name", "scene name (place)" that no other object of the artifact has.
std::string object_name(const ObjectKey& key, const std::set<ObjectKey>& all) {
  const auto& [scene, place, name] = key;
  int same_name = 0, same_scene_and_name = 0, objects = 0;
  for (const auto& [other_scene, other_place, other_name] : all) {
    objects = std::max(objects, other_place);
    same_name += other_name == name ? 1 : 0;
    same_scene_and_name += other_name == name && other_scene == scene ? 1 : 0;
  }
  if (same_name == 1) return name;
  const std::string scene_and_name = same_scene_and_name == same_name ? name : scene + " " + name;
  if (same_scene_and_name == 1) return scene_and_name;
  constexpr std::array<std::string_view, study::objects_per_stimulus> places = {"left", "middle", "right"};
  const bool known = place >= 1 && objects == study::objects_per_stimulus;
  return fmt::format("{} ({})", scene_and_name,
                     known ? std::string(places[place - 1]) : std::to_string(place) + " from the left");
}

/// The middle of the axis.
double middle_of(const LevelAxis& axis, double low, double high) {
  return is_linear(axis) ? (low + high) / 2 : std::sqrt(low * high);
}

/// As many digits as people read.
double three_digits(double value) {
  if (value == 0) return 0;
  const double step = std::pow(10.0, std::floor(std::log10(std::abs(value))) - 2);
  return std::round(value / step) * step;
}

/// Groups that can be compared; empty, with a note, when they cannot.
std::vector<std::string> usable_groups(const std::set<std::string>& people, const ParticipantGroups& groups,
                                       std::vector<std::string>& notes) {
  if (groups.empty()) return {};
  std::map<std::string, int> count;
  int unknown = 0;
  for (const std::string& code : people) {
    const auto found = groups.find(code);
    if (found == groups.end())
      ++unknown;
    else
      ++count[found->second];
  }
  if (unknown > 0) {
    notes.push_back(
        fmt::format("Groups are not compared: {} of {} participants have none.", unknown, people.size()));
    return {};
  }
  std::vector<std::string> names;
  for (const auto& [name, members] : count) {
    names.push_back(name);
    if (members >= 2) continue;
    notes.push_back(fmt::format("Groups are not compared: '{}' has one participant.", name));
    return {};
  }
  if (names.size() < 2) {
    notes.push_back(fmt::format("Groups are not compared: all participants are '{}'.", names.front()));
    return {};
  }
  return names;
}

/// Lays out the columns; `names` receives one name each.
void plan_columns(StudyDesign& design, const std::vector<std::set<ObjectKey>>& objects, bool several_levels) {
  std::vector<std::string>& names = design.data.predictor_names;
  const auto next = [&] { return static_cast<int>(names.size()); };
  for (std::size_t a = 0; a < design.artifacts.size(); ++a) {
    DesignArtifact& artifact = design.artifacts[a];
    const std::string name = name_of(artifact);
    for (const ObjectKey& key : objects[a]) artifact.objects.push_back(object_name(key, objects[a]));
    if (a > 0) {
      artifact.level_column = next();
      names.push_back(
          fmt::format("{} - {} {}", name, name_of(design.artifacts.front()), at_reference(design)));
    }
    if (several_levels) {
      artifact.slope_column = next();
      names.push_back(fmt::format("{}, {}", name, slope_text(design.axis)));
    }
    if (a > 0 && design.artifacts[a - 1].artifact == artifact.artifact) {  // the objects are the same ones
      artifact.first_object_column = design.artifacts[a - 1].first_object_column;
      continue;
    }
    if (artifact.objects.size() > 1) artifact.first_object_column = next();
    for (std::size_t o = 0; o + 1 < artifact.objects.size(); ++o)
      names.push_back(fmt::format("{}, {} - mean of objects", word(artifact.artifact), artifact.objects[o]));
  }
  if (design.groups.size() > 1) design.first_group_column = next();
  for (std::size_t g = 1; g < design.groups.size(); ++g)
    names.push_back(fmt::format("{} - {}", design.groups[g], design.groups.front()));
}

/// Writes the effect-coded columns of one of `count` levels.
void write_effect(Eigen::Ref<Eigen::RowVectorXd> columns, std::size_t level, std::size_t count) {
  if (level + 1 == count)
    columns.setConstant(-1);
  else
    columns[static_cast<Eigen::Index>(level)] = 1;
}

}  // namespace

std::string name_of(const DesignArtifact& artifact) {
  return std::string(word(artifact.artifact)) +
         (artifact.condition.empty() ? "" : " (" + artifact.condition + ")");
}

std::string step_text(const LevelAxis& axis) {
  if (!is_linear(axis)) return "octave of " + level_word(axis);
  const std::string unit = length_unit(axis);
  return unit.ends_with('s') ? unit.substr(0, unit.size() - 1) : unit;
}

std::string slope_text(const LevelAxis& axis) {
  return "per " + step_text(axis);
}

std::string reference_text(const StudyDesign& design) {
  const QuantityFacts& about = facts(design.axis.quantity);
  const std::string level = estimated_text(design.axis, design.reference_level);
  return about.unit.empty() ? fmt::format("a {} of {}", about.name, level)
                            : fmt::format("{} {}", level, about.unit);
}

std::string at_reference(const StudyDesign& design) {
  return "at " + reference_text(design);
}

StudyDesign study_design(std::span<const study::Answer> given, const ParticipantGroups& groups,
                         double reference_level, const LevelAxis& axis,
                         const std::vector<std::string>& order) {
  std::vector<study::Answer> answers;
  for (const study::Answer& answer : given)
    if (of_depth_widths(axis) || !stands_apart(axis, answer.level)) answers.push_back(answer);
  if (answers.empty())
    throw input_error(
        {.field = "answers", .wanted = "at least one answer of a participant used", .found = "none"});
  if (!(reference_level >= 0))
    throw input_error({.field = "reference width",
                       .wanted = of_depth_widths(axis) ? "a width in pixels" : "a level",
                       .found = fmt::format("{}", reference_level)});
  StudyDesign design;
  design.axis = axis;
  if (answers.size() < given.size())
    design.notes.emplace_back("Answers at the level none are no part of the model: it lies on no log axis.");
  std::vector<std::string> conditions = order;
  for (const study::Answer& answer : answers)
    if (std::find(conditions.begin(), conditions.end(), answer.condition) == conditions.end())
      conditions.push_back(answer.condition);
  std::set<std::pair<Artifact, std::string>> shown;
  std::map<Artifact, std::set<ObjectKey>> objects_of;
  std::set<std::string> people;
  double smallest = answers.front().level, largest = smallest;
  for (const study::Answer& answer : answers) {
    if (answer.level < 0 || (!is_linear(axis) && answer.level == 0))
      throw input_error(
          {.field = fmt::format("{} of stimulus '{}'", of_depth_widths(axis) ? "depth width" : "level",
                                answer.stimulus_id),
           .wanted = of_depth_widths(axis) ? "a positive number of pixels" : "a positive number",
           .found = fmt::format("{}", answer.level)});
    shown.insert({answer.artifact, answer.condition});
    objects_of[answer.artifact].insert(key_of(answer));
    people.insert(answer.participant);
    smallest = std::min(smallest, answer.level);
    largest = std::max(largest, answer.level);
  }
  std::vector<std::set<ObjectKey>> objects;
  for (const Artifact artifact : every_artifact)
    for (const std::string& condition : conditions)
      if (shown.contains({artifact, condition})) {
        design.artifacts.emplace_back().artifact = artifact;
        design.artifacts.back().condition = condition;
        objects.push_back(objects_of[artifact]);
      }
  design.reference_level = reference_level;
  if (!(reference_level > 0))
    design.reference_level = of_depth_widths(axis) ? std::round(std::sqrt(smallest * largest))
                                                   : three_digits(middle_of(axis, smallest, largest));
  if (design.reference_level < smallest || design.reference_level > largest)
    design.notes.push_back(fmt::format("The reference {} {} lies outside the {}s tested, {} to {}{}.",
                                       level_word(axis), reference_text(design), level_word(axis), smallest,
                                       largest, of_depth_widths(axis) ? " px" : ""));
  if (smallest == largest)
    design.notes.push_back(fmt::format("Only {} was tested: there are no slopes over {}.",
                                       level_text(axis.quantity, smallest), level_word(axis)));
  design.groups = usable_groups(people, groups, design.notes);
  plan_columns(design, objects, smallest < largest);

  OrdinalData& data = design.data;
  data.highest = study::highest_rating;
  data.predictors = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(answers.size()),
                                          static_cast<Eigen::Index>(data.predictor_names.size()));
  std::map<std::string, int> number_of;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const study::Answer& answer = answers[i];
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(data.predictors.cols());
    std::size_t a = 0;
    while (design.artifacts[a].artifact != answer.artifact ||
           design.artifacts[a].condition != answer.condition)
      ++a;
    const DesignArtifact& artifact = design.artifacts[a];
    if (artifact.level_column >= 0) row[artifact.level_column] = 1;
    if (artifact.slope_column >= 0)
      row[artifact.slope_column] = is_linear(axis) ? answer.level - design.reference_level
                                                   : std::log2(answer.level / design.reference_level);
    if (artifact.first_object_column >= 0)
      write_effect(
          row.segment(artifact.first_object_column, static_cast<Eigen::Index>(artifact.objects.size()) - 1),
          static_cast<std::size_t>(std::distance(objects[a].begin(), objects[a].find(key_of(answer)))),
          artifact.objects.size());
    if (!design.groups.empty()) {
      const auto group = std::find(design.groups.begin(), design.groups.end(), groups.at(answer.participant));
      if (group != design.groups.begin())
        row[design.first_group_column + static_cast<int>(group - design.groups.begin()) - 1] = 1;
    }
    data.predictors.row(static_cast<Eigen::Index>(i)) = row;
    data.score.push_back(answer.noticeability());
    data.participant.push_back(
        number_of.emplace(answer.participant, static_cast<int>(number_of.size())).first->second);
  }
  design.participants = static_cast<int>(number_of.size());
  return design;
}

}  // namespace seamline::analysis
