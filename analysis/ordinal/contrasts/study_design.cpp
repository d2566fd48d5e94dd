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
  int same_name = 0, same_scene_and_name = 0;
  for (const auto& [other_scene, other_place, other_name] : all) {
    same_name += other_name == name ? 1 : 0;
    same_scene_and_name += other_name == name && other_scene == scene ? 1 : 0;
  }
  if (same_name == 1) return name;
  const std::string scene_and_name = same_scene_and_name == same_name ? name : scene + " " + name;
  if (same_scene_and_name == 1) return scene_and_name;
  constexpr std::array<std::string_view, study::objects_per_stimulus> places = {"left", "middle", "right"};
  const bool known = place >= 1 && place <= study::objects_per_stimulus;
  return fmt::format(
      "{} ({})", scene_and_name,
      known ? std::string(places[static_cast<std::size_t>(place - 1)]) : std::to_string(place));
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

/// Plans the columns; `names` receives one name each.
void plan_columns(StudyDesign& design, const std::vector<std::set<ObjectKey>>& objects, bool several_widths) {
  std::vector<std::string>& names = design.data.predictor_names;
  const auto next = [&] { return static_cast<int>(names.size()); };
  for (std::size_t a = 0; a < design.artifacts.size(); ++a) {
    DesignArtifact& artifact = design.artifacts[a];
    const std::string_view name = word(artifact.artifact);
    for (const ObjectKey& key : objects[a]) artifact.objects.push_back(object_name(key, objects[a]));
    if (a > 0) {
      artifact.level_column = next();
      names.push_back(fmt::format("{} - {} at {:.0f} px", name, word(design.artifacts.front().artifact),
                                  design.reference_width_px));
    }
    if (several_widths) {
      artifact.slope_column = next();
      names.push_back(fmt::format("{}, per octave of width", name));
    }
    if (artifact.objects.size() > 1) artifact.first_object_column = next();
    for (std::size_t o = 0; o + 1 < artifact.objects.size(); ++o)
      names.push_back(fmt::format("{}, {} - mean of objects", name, artifact.objects[o]));
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

StudyDesign study_design(std::span<const study::Answer> answers, const ParticipantGroups& groups,
                         double reference_width_px) {
  if (answers.empty())
    throw input_error(
        {.field = "answers", .wanted = "at least one answer of a participant used", .found = "none"});
  if (!(reference_width_px >= 0))
    throw input_error({.field = "reference width",
                       .wanted = "a width in pixels",
                       .found = fmt::format("{}", reference_width_px)});
  StudyDesign design;
  std::map<Artifact, std::set<ObjectKey>> objects_of;
  std::set<std::string> people;
  int smallest_px = answers.front().depth_width_px, largest_px = smallest_px;
  for (const study::Answer& answer : answers) {
    if (answer.depth_width_px <= 0)
      throw input_error({.field = fmt::format("depth width of stimulus '{}'", answer.stimulus_id),
                         .wanted = "a positive number of pixels",
                         .found = std::to_string(answer.depth_width_px)});
    objects_of[answer.artifact].insert(key_of(answer));
    people.insert(answer.participant);
    smallest_px = std::min(smallest_px, answer.depth_width_px);
    largest_px = std::max(largest_px, answer.depth_width_px);
  }
  std::vector<std::set<ObjectKey>> objects;
  for (const Artifact artifact : every_artifact)
    if (objects_of.contains(artifact)) {
      design.artifacts.emplace_back().artifact = artifact;
      objects.push_back(objects_of[artifact]);
    }
  design.reference_width_px = reference_width_px > 0
                                  ? reference_width_px
                                  : std::round(std::sqrt(static_cast<double>(smallest_px) * largest_px));
  if (design.reference_width_px < smallest_px || design.reference_width_px > largest_px)
    design.notes.push_back(
        fmt::format("The reference width {:.0f} px lies outside the widths tested, {} to {} px.",
                    design.reference_width_px, smallest_px, largest_px));
  if (smallest_px == largest_px)
    design.notes.push_back(
        fmt::format("Only {} px was tested: there are no slopes over width.", smallest_px));
  design.groups = usable_groups(people, groups, design.notes);
  plan_columns(design, objects, smallest_px < largest_px);

  OrdinalData& data = design.data;
  data.highest = study::highest_rating;
  data.predictors = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(answers.size()),
                                          static_cast<Eigen::Index>(data.predictor_names.size()));
  std::map<std::string, int> number_of;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const study::Answer& answer = answers[i];
    Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(data.predictors.cols());
    std::size_t a = 0;
    while (design.artifacts[a].artifact != answer.artifact) ++a;
    const DesignArtifact& artifact = design.artifacts[a];
    if (artifact.level_column >= 0) row[artifact.level_column] = 1;
    if (artifact.slope_column >= 0)
      row[artifact.slope_column] = std::log2(answer.depth_width_px / design.reference_width_px);
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
