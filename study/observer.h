#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>
#include <variant>

#include "stimuli/stimulus.h"
#include "stimuli/study_definition.h"
#include "stimuli/support/random.h"

namespace seamline {

/// The simulated people that `--observer` knows.
enum class ObserverKind { threshold, guesser, perfect };
inline constexpr std::array<ObserverKind, 3> every_observer_kind = {
    ObserverKind::threshold, ObserverKind::guesser, ObserverKind::perfect};

[[nodiscard]] std::string_view word(ObserverKind kind);
[[nodiscard]] std::optional<ObserverKind> observer_kind_from_word(std::string_view text);

/// Sees the seam with probability P = psi(W), a decreasing logistic in log2 W
/// (study/psychometric_function.h). When it is seen: the right object, rated 1 + Binomial(3, P). When not: a
/// uniform guess of the three, rated 1.
struct ThresholdObserver {
  ObserverDefinition definition;
  double shift_octaves = 0;  ///< this person's: added to log2 of every midpoint
};

/// Never sees anything: a uniform guess of the three, rated 1. Expected noticeability 1/3.
struct GuessingObserver {};

/// Always sees the seam: the right object, rated 4.
struct PerfectObserver {};

using Observer = std::variant<ThresholdObserver, GuessingObserver, PerfectObserver>;

/// What an observer answers to one stimulus.
struct Response {
  int chosen_index = 0;  ///< 1..3
  int rating = 0;        ///< 1..4
};

/// One simulated person of a kind. Draws the person's shift, Normal(0, people_sd_octaves), from `random`.
[[nodiscard]] Observer make_observer(ObserverKind kind, const ObserverDefinition& definition, Random& random);

/// The observer's answer. Throws InputError when the definition has no midpoint for the stimulus' artifact.
[[nodiscard]] Response respond(const Observer& observer, const Stimulus& stimulus, Random& random);

/// Planted value of the `threshold` observer: its exact mean noticeability over people at one depth width,
///
///     E = integral over s of N(s; 0, people_sd^2) [ P (1 + 3P) + (1 - P) / 3 ] ds,   P = P(seen | W, shift
///     s)
///
/// where (1 - P) / 3 is the floor from guessing: right by chance one time in three, and then rated 1.
/// Absolute error under 1e-12. Throws InputError when the definition has no midpoint for the artifact.
[[nodiscard]] double expected_noticeability(const ObserverDefinition& definition, Artifact artifact,
                                            double width_px);

}  // namespace seamline
