#pragma once
#include <optional>
#include <string>
#include <variant>

#include "stimuli/definition/axis.h"
#include "stimuli/definition/methods/parameter_range.h"
#include "stimuli/definition/methods/sigmoid.h"

namespace seamline::inline stimuli {

/// Method of constant stimuli: everybody sees every stimulus once, in an order of their own (paper
/// section 4.2).
struct ConstantDefinition {};

/// What of an answer QUEST+ learns from.
enum class PlacementOutcome {
  correct,        ///< binary: was the right object chosen
  noticeability,  ///< ordinal, 0 to 4: 0 for the wrong object, else the rating
  joint,          ///< the same five, by the joint model of seeing, guessing and rating
};

/// Which stimuli share one psychometric function, and so one track of trials.
enum class PlacementTrack {
  artifact,  ///< all objects of an artifact together
  object,    ///< each object of each artifact alone
};

/// QUEST+ (Watson 2017): the next condition is the one whose answer is expected to leave the least entropy in
/// the posterior over the parameters' grid. documentation/explanation/quest_plus.md has the equations.
struct QuestPlusDefinition {
  PlacementOutcome outcome = PlacementOutcome::correct;
  PlacementTrack track = PlacementTrack::artifact;
  Sigmoid sigmoid = Sigmoid::logistic;
  Axis axis = Axis::log2;                       ///< of the level
  Direction direction = Direction::decreasing;  ///< of the noticeability, as the level grows
  /// In equal ratios on the log2 axis and equal steps on the linear one, unless it says otherwise; as read,
  /// an octave more than the tested levels each way. In the level's unit.
  ParameterRange threshold = {};
  ParameterRange scale = {0.125, 2, 9};  ///< on the axis (octaves or the level's unit), equal ratios
  ParameterRange lapse = {0, 0.08, 5};   ///< equal steps
  ParameterRange guess = {1.0 / 3.0, 1.0 / 3.0, 1};  ///< equal steps
  /// All but `correct`, on the axis, equal ratios. `noticeability`: the level at which a rating of at least k
  /// is as likely as not lies (k - 1) steps beyond the threshold, where more is noticed, k = 2, 3, 4. Not
  /// known beforehand, because people use the words of a rating as they like; a step that is taken for known
  /// and is not biases the threshold.
  ParameterRange rating_step = {0.125, 1, 4};
  int max_shows_per_image = 1;               ///< to one participant; the study file must say it
  int min_trials = 10;                       ///< of a track before it may stop for its interval or entropy
  int max_trials = 40;                       ///< of a track
  std::optional<double> stop_interval = {};  ///< 95 % interval of the threshold at most so wide, on the axis
  std::optional<double> stop_entropy_nats = {};  ///< entropy of the posterior at most this
  double edge_share = 0.1;  ///< alarm when a parameter's outermost value holds more of the posterior
};

/// How a session finds the next stimulus.
using ProcedureDefinition = std::variant<ConstantDefinition, QuestPlusDefinition>;

/// The meaning of a procedure as text, for the study's hash. Empty for constant stimuli, so that studies that
/// were rendered before there was a choice keep their hash.
[[nodiscard]] std::string canonical_text(const ProcedureDefinition& procedure);

}  // namespace seamline::inline stimuli
