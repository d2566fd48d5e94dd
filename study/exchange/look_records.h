#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/study_definition.h"
#include "study/log/log.h"
#include "study/trials/looking.h"

namespace seamline::study {

/// Where somebody looked in a trial whose answer the log holds.
struct LookedTrial {
  std::string participant;
  int trial_index = 0;
  std::vector<PoseAt> poses;  ///< in the order of their times
};

/// Of the session in which the answer was given, ordered by participant and trial; empty where the log's
/// study has no panoramas. Throws InputError when the log cannot be read, or an event `look` is none.
[[nodiscard]] std::vector<LookedTrial> read_looks(const LogContents& log);

/// What the poses of one trial come to.
struct LookMeasures {
  double degrees_turned = 0;
  std::optional<double> first_look_s = {};  ///< when the view first faced the object; none: never
  double share_facing = 0;                  ///< of the time until the answer
};

/// Within so many degrees to the left or right of a thing, a view faces it.
inline constexpr double facing_deg = 15;

/// `object_yaw_deg`: of the object from the middle column; `end_ms`: when the answer was given.
[[nodiscard]] LookMeasures measure_look(const std::vector<PoseAt>& poses, double object_yaw_deg,
                                        double end_ms);

/// How somebody felt at a break.
struct ComfortAnswer {
  std::string participant;
  int answered = 0;  ///< trials before the break
  int comfort = 0;   ///< 1 to 5, place in `comfort_labels`
};

/// In the order of participants and of their answers; empty where the log's study does not ask. Throws
/// InputError when the log cannot be read, or an event `comfort` is none.
[[nodiscard]] std::vector<ComfortAnswer> read_comfort(const LogContents& log);

/// An answer to a stimulus, and how its panorama was looked round until the rating.
struct MeasuredLook {
  std::size_t answer = 0;  ///< its place in the log's answers
  double object_yaw_deg = 0;
  LookMeasures measures = {};
};

/// Of all answers whose trial has poses, in the log's order. Throws InputError as `read_looks` does.
[[nodiscard]] std::vector<MeasuredLook> measured_looks(const LogContents& log,
                                                       const std::vector<LookedTrial>& looks);

/// Yaw of an object's place from the middle column of its scene's panorama.
[[nodiscard]] double object_yaw_deg(const SceneDefinition& scene, const ObjectDefinition& object);

}  // namespace seamline::study
