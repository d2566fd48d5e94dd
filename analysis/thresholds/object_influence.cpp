#include "analysis/thresholds/object_influence.h"

#include <algorithm>
#include <map>
#include <utility>

#include "analysis/statistics/isotonic.h"

namespace seamline::analysis {

namespace {

using CurveAnswers = std::vector<const study::Answer*>;

/// Of two of one curve.
bool shows(const study::Answer& answer, const ObjectCurve& object) {
  return answer.scene == object.scene && answer.object_index == object.object_index &&
         answer.object == object.object;
}

/// The artifact's curve without one of its objects; none when nobody answered all that is left.
std::optional<ArtifactScores> scores_without(const study::LogContents& log, const CurveAnswers& of_curve,
                                             const std::vector<ParticipantUse>& people,
                                             const ObjectCurve& object, const LevelAxis& axis) {
  study::LogContents rest;
  rest.file = log.file;
  rest.quantity = log.quantity;
  rest.noticeability = log.noticeability;
  rest.participants = log.participants;
  for (const study::Answer* answer : of_curve)
    if (!shows(*answer, object)) rest.answers.push_back(*answer);
  NoticeabilityData data = average_answers(rest, people);
  if (data.artifacts.front().people.empty()) return std::nullopt;
  data.artifacts.front().axis = axis;  // with the unit of the whole log
  return data.artifacts.front();
}

void widen(std::optional<LevelInterval>& range, const LevelInterval& by) {
  if (!range) range = by;
  range->low_x = std::min(range->low_x, by.low_x);
  range->high_x = std::max(range->high_x, by.high_x);
}

LevelInterval crossing(double level, const std::vector<double>& level_x, const CurveThresholds& curve) {
  const double width = largest_x_at(level, level_x, curve.isotonic.value);
  return {.low_x = width, .high_x = width};
}

void add_without(const ObjectCurve& object, const ArtifactScores& scores, ObjectInfluence& influence) {
  const std::vector<double> level_x = levels_on_axis(scores);
  if (level_x.empty()) return;
  const CurveThresholds found = thresholds_of_means(level_x, means_on_axis(scores), scores.axis);
  widen(influence.perceptual, crossing(perceptual_level, level_x, found));
  widen(influence.slightly_noticeable, crossing(slight_level, level_x, found));
  widen(influence.inflection, found.logistic.centre_range);
  influence.without.push_back({.scene = object.scene,
                               .object = object.object,
                               .object_index = object.object_index,
                               .thresholds = found});
}

}  // namespace

std::vector<ObjectInfluence> leave_one_object_out(const study::LogContents& log,
                                                  const std::vector<ParticipantUse>& people,
                                                  const NoticeabilityData& data) {
  std::map<std::pair<Artifact, std::string>, CurveAnswers> answers;
  for (const study::Answer& answer : log.answers)
    answers[{answer.artifact, answer.condition}].push_back(&answer);
  std::map<std::pair<Artifact, std::string>, std::vector<const ObjectCurve*>> objects;
  for (const ObjectCurve& object : data.objects)
    objects[{object.artifact, object.condition}].push_back(&object);
  std::vector<ObjectInfluence> influences;
  for (const ArtifactScores& scores : data.artifacts) {
    ObjectInfluence influence;
    influence.artifact = scores.artifact;
    influence.condition = scores.condition;
    const auto& own = objects[{scores.artifact, scores.condition}];
    const CurveAnswers& of_curve = answers[{scores.artifact, scores.condition}];
    if (own.size() > 1)
      for (const ObjectCurve* object : own)
        if (const auto rest = scores_without(log, of_curve, people, *object, data.axis))
          add_without(*object, *rest, influence);
    influences.push_back(influence);
  }
  return influences;
}

}  // namespace seamline::analysis
