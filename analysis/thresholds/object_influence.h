#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/scores/cells.h"
#include "analysis/thresholds/thresholds.h"
#include "study/log/log.h"

namespace seamline::analysis {

/// The thresholds of an artifact when one of its objects is left out.
struct WithoutObject {
  std::string scene, object;
  int object_index = 0;
  CurveThresholds thresholds;  ///< estimates; intervals are left open
};

/// How much an artifact's thresholds rest on single objects: the range of what is found when each object in
/// turn is left out. It is no confidence interval: the objects of a study are few and not drawn at random.
/// Infinite ends: with some object left out the curve does not cross within the widths tested.
struct ObjectInfluence {
  Artifact artifact = Artifact::none;
  std::string condition;
  std::vector<WithoutObject> without;  ///< empty when there is one object only
  std::optional<LevelInterval> perceptual, slightly_noticeable,
      inflection;  ///< none when there is one object
};

/// One entry an artifact and condition, in the order of `data` (`average_answers` of the same log and
/// people).
[[nodiscard]] std::vector<ObjectInfluence> leave_one_object_out(const study::LogContents& log,
                                                                const std::vector<ParticipantUse>& people,
                                                                const NoticeabilityData& data);

}  // namespace seamline::analysis
