#pragma once
#include <string>
#include <vector>

#include "study/log/log.h"
#include "study/placement/quest_plus_procedure.h"

namespace seamline::study {

/// What the posterior of one participant's track says. Levels are means and intervals on the study's
/// axis, turned into levels.
struct TrackEstimate {
  std::string participant;
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  std::string track;      ///< as `name_of`
  bool used = true;       ///< completed, not excluded and not a pilot
  int trials = 0;
  double threshold = 0;      ///< posterior mean: the level at which the object is seen half of the time
  double threshold_sd = 0;   ///< on the axis: octaves, or the level's unit where it is linear
  double low = 0, high = 0;  ///< equal-tailed 95 % credible interval
  double scale = 0;          ///< on the axis
  double lapse = 0;
  Axis axis = Axis::log2;
  Direction direction = Direction::decreasing;   ///< of the noticeability, as the level grows
  Quantity quantity = Quantity::depth_width_px;  ///< of the levels
  std::vector<Parameter> informed = {};          ///< parameters whose prior was not even
  std::vector<EdgeAlarm> alarms = {};
};

/// The estimates of every participant of an adaptive study, by repeating what was learnt from each answer.
/// Throws InputError when the study of the log has no adaptive procedure, or an answer is to a stimulus that
/// the study does not list.
[[nodiscard]] std::vector<TrackEstimate> quest_plus_estimates(const LogContents& log);

/// The unit of lengths on the axis, in words: "octaves", or the unit of the quantity ("px", "degrees"), or
/// "levels" where it has none.
[[nodiscard]] std::string length_unit(Axis axis, Quantity quantity);
/// The same for names of columns and fields: "octaves", "px", "deg", "levels".
[[nodiscard]] std::string length_key(Axis axis, Quantity quantity);

/// The estimates as a table of text, a line a track.
[[nodiscard]] std::string tracks_text(const std::vector<TrackEstimate>& estimates);

}  // namespace seamline::study
