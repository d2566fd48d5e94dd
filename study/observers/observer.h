#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <variant>
#include <vector>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/definition/stimulus.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/pictures/visible_difference.h"
#include "study/placement/trial.h"
#include "support/arithmetic/random.h"

namespace seamline::study {

/// The simulated people that `--observer` knows.
enum class ObserverKind { threshold, image, guesser, perfect };
inline constexpr std::array<ObserverKind, 4> every_observer_kind = {
    ObserverKind::threshold, ObserverKind::image, ObserverKind::guesser, ObserverKind::perfect};

[[nodiscard]] std::string_view word(ObserverKind kind);
[[nodiscard]] std::optional<ObserverKind> observer_kind_from_word(std::string_view text);

/// Sees the seam with probability P = psi(x), a logistic of the level on the axis of its quantity, which
/// falls unless the definition says that it rises (study/placement/psychometric_function.h). A level of 0 on
/// a log2 axis ("none") lies at minus infinity: always seen where noticeability falls, never where it rises.
/// When it is seen: the right object, rated 1 + Binomial(3, P). When not: a uniform guess of the
/// alternatives, rated 1.
struct ThresholdObserver {
  ObserverDefinition definition;
  double shift_octaves = 0;  ///< this person's: added to log2 of every midpoint
  double shift_linear = 0;   ///< the same on linear axes, in the level's unit
};

/// Looks at the pictures: sees the seam with probability P = 1 / (1 + exp(-(log2(gain F) + shift) / scale)),
/// F the visible difference between stimulus and reference above the floor of *none*. Answers as
/// ThresholdObserver does.
struct ImageObserver {
  ObserverDefinition definition;
  std::shared_ptr<const VisibleDifferences> differences;  ///< of the whole set, shared by all people
  double shift_octaves = 0;                               ///< this person's: added to log2 of the gain
};

/// Never sees anything: a uniform guess, rated 1. Expected noticeability of three alternatives 1/3.
struct GuessingObserver {};

/// Always sees the seam: the right object, rated 4.
struct PerfectObserver {};

using Observer = std::variant<ThresholdObserver, ImageObserver, GuessingObserver, PerfectObserver>;

/// Among what an observer chooses in a trial.
struct Alternatives {
  int count = objects_per_stimulus;
  int right = 0;  ///< from 1; 0: nothing is
  /// Yes (1) or no (2): how often somebody who sees nothing says yes. None: a uniform guess.
  std::optional<double> false_alarms = {};
};

/// How often simulated people say yes where they see nothing.
inline constexpr double simulated_false_alarms = 0.1;

/// Of a trial in a task; `object_index` is the place of its stimulus' object. Simulated people who only rate
/// see nothing where nothing is.
[[nodiscard]] Alternatives alternatives_of(const TaskFacts& task, const Trial& trial, int object_index);

/// What an observer answers to one stimulus.
struct Response {
  int chosen_index = 0;  ///< from 1
  int rating = 0;        ///< 1..4
};

/// One simulated person of a kind. Draws the person's shift, Normal(0, people_sd) on either axis, from
/// `random`. `differences` is needed by `image` alone.
[[nodiscard]] Observer make_observer(ObserverKind kind, const ObserverDefinition& definition, Random& random,
                                     std::shared_ptr<const VisibleDifferences> differences = nullptr);

/// The observer's answer. Throws InputError when the definition has no midpoint for the stimulus' artifact,
/// or an `image` observer knows no gain or no visible difference of the stimulus.
[[nodiscard]] Response respond(const Observer& observer, const Stimulus& stimulus, Random& random);

/// The same among other alternatives than the three objects.
[[nodiscard]] Response respond(const Observer& observer, const Stimulus& stimulus,
                               const Alternatives& alternatives, Random& random);

/// How likely the observer sees the seam of a stimulus; of a guesser 0, of `perfect` 1. Throws as `respond`
/// does.
[[nodiscard]] double seen_probability(const Observer& observer, const Stimulus& stimulus);

/// Where the observer stops in a match, among stimuli from where most is seen to where least is: each time
/// the seam is seen while log(P / (1 - P)) is at least z, z drawn from the logistic distribution, and the
/// observer stops at the level where it is nearest to z. So a match scatters as the psychometric function
/// says, around its midpoint. A guesser stops anywhere. `ladder` is not empty.
[[nodiscard]] std::size_t matched_rung(const Observer& observer, const std::vector<Stimulus>& ladder,
                                       Random& random);

/// The answer to an attention trial: everybody who looks at the pictures sees it, chooses the right object
/// and rates it 4; a guesser guesses.
[[nodiscard]] Response respond_to_attention(const Observer& observer, int right_index, Random& random);
[[nodiscard]] Response respond_to_attention(const Observer& observer, const Alternatives& alternatives,
                                            Random& random);

/// The answer to a reference trial, where there is nothing to see: everybody guesses, rated 1.
[[nodiscard]] Response respond_to_reference(Random& random);
[[nodiscard]] Response respond_to_reference(const Alternatives& alternatives, Random& random);

/// Where a stimulus lies on the psychometric functions of a study.
struct LevelPlace {
  Artifact artifact = Artifact::none;
  std::string condition = {};
  Quantity quantity = Quantity::depth_width_px;
  double level = 0;
};
[[nodiscard]] LevelPlace place_of(const Stimulus& stimulus);

/// Planted value of the `threshold` observer: its exact mean noticeability over people at one level x,
///
///     E = integral over s of N(s; 0, people_sd^2) [ P (1 + 3P) + (1 - P) / 3 ] ds,   P = P(seen | x, shift
///     s)
///
/// of the task of three objects, where (1 - P) / 3 is the floor from guessing: right by chance one time in
/// three, and then rated 1. Absolute error under 1e-12. Throws InputError when the definition has no midpoint
/// for the artifact (and condition).
[[nodiscard]] double expected_noticeability(const ObserverDefinition& definition, const LevelPlace& place);

/// The same at a depth width of a study of one condition.
[[nodiscard]] double expected_noticeability(const ObserverDefinition& definition, Artifact artifact,
                                            double width_px);

/// Throws InputError unless the definition has the `image` observer's gain.
void require_image_gain(const ObserverDefinition& definition);

/// The same of the `image` observer, for a visible difference above the floor, at least 0.
[[nodiscard]] double expected_noticeability_of_difference(const ObserverDefinition& definition,
                                                          double visible_difference);

}  // namespace seamline::study
