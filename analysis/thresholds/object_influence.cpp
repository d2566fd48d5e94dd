#include "analysis/thresholds/object_influence.h"

#include <algorithm>

#include "analysis/statistics/isotonic.h"

namespace seamline::analysis {

namespace {

bool shows(const study::Answer& answer, const ObjectCurve& object) {
  return answer.artifact == object.artifact && answer.scene == object.scene &&
         answer.object_index == object.object_index && answer.object == object.object;
}

/// The artifact's curve without one of its objects; none when nobody answered all that is left.
std::optional<ArtifactScores> scores_without(const study::LogContents& log,
                                             const std::vector<ParticipantUse>& people,
                                             const ObjectCurve& object) {
  study::LogContents rest;
  rest.file = log.file;
  rest.participants = log.participants;
  for (const study::Answer& answer : log.answers)
    if (answer.artifact == object.artifact && !shows(answer, object)) rest.answers.push_back(answer);
  NoticeabilityData data = average_answers(rest, people);
  if (data.artifacts.front().people.empty()) return std::nullopt;
  return data.artifacts.front();
}

void widen(std::optional<WidthInterval>& range, const WidthInterval& by) {
  if (!range) range = by;
  range->low_log2_px = std::min(range->low_log2_px, by.low_log2_px);
  range->high_log2_px = std::max(range->high_log2_px, by.high_log2_px);
}

WidthInterval crossing(double level, const std::vector<double>& log2_px, const CurveThresholds& curve) {
  const double width = largest_log2_width_at(level, log2_px, curve.isotonic.value);
  return {.low_log2_px = width, .high_log2_px = width};
}

void add_without(const ObjectCurve& object, const ArtifactScores& scores, ObjectInfluence& influence) {
  const std::vector<double> log2_px = log2_widths(scores.width_px);
  std::vector<double> means;
  for (const CellMean& cell : scores.cells) means.push_back(cell.mean);
  const CurveThresholds found = thresholds_of_means(log2_px, means);
  widen(influence.perceptual, crossing(perceptual_level, log2_px, found));
  widen(influence.slightly_noticeable, crossing(slight_level, log2_px, found));
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
  std::vector<ObjectInfluence> influences;
  for (const ArtifactScores& scores : data.artifacts) {
    ObjectInfluence influence;
    influence.artifact = scores.artifact;
    const auto objects =
        std::count_if(data.objects.begin(), data.objects.end(),
                      [&](const ObjectCurve& object) { return object.artifact == scores.artifact; });
    for (const ObjectCurve& object : data.objects)
      if (objects > 1 && object.artifact == scores.artifact)
        if (const std::optional<ArtifactScores> rest = scores_without(log, people, object))
          add_without(object, *rest, influence);
    influences.push_back(influence);
  }
  return influences;
}

}  // namespace seamline::analysis
