#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/axis.h"
#include "stimuli/definition/parts/staircase_definition.h"
#include "stimuli/definition/stimulus.h"
#include "study/placement/stimulus_tracks.h"
#include "study/placement/trial.h"

namespace seamline::study {

/// What does not change in a session; shared by all participants.
struct StaircaseDesign {
  struct Start {
    int curve = 0, level = 0;
  };
  StaircaseDefinition definition;
  std::vector<StimulusTrack> curves;  ///< levels from where most is seen to where least is
  std::vector<TrackPlace> places;     ///< of each stimulus
  std::vector<Start> starts;          ///< one a staircase; those of a curve follow each other
};

/// `noticeability`: as the level grows. A start that a curve does not have is moved to its nearest level.
[[nodiscard]] StaircaseDesign make_staircase_design(const StaircaseDefinition& definition,
                                                    Direction noticeability,
                                                    const std::vector<Stimulus>& stimuli);

/// One staircase: pure arithmetic of right and wrong.
struct Staircase {
  int level = 0;             ///< index into the curve's levels: where it stands
  int heading = 0;           ///< 1: to where less is seen, -1: back, 0: it has not moved yet
  int right = 0, wrong = 0;  ///< in a row, since the last step
  int answered = 0;
  std::vector<int> reversals = {};  ///< levels at which it turned
  bool stopped = false;
  bool operator==(const Staircase&) const = default;
};

/// The staircase after an answer at its level. A step beyond the last level of either side is none: it stays.
[[nodiscard]] Staircase after_answer(Staircase stairs, bool correct, int levels,
                                     const StaircaseDefinition& definition);

/// Staircases of all curves, interleaved: the next trial belongs to one drawn from those unfinished ones that
/// have the fewest answers; its image is drawn from those of the level that the participant has seen least.
/// The draws of trial t come from stream t of the participant's seed.
struct StaircaseProcedure {
  std::shared_ptr<const StaircaseDesign> design;
  std::uint64_t seed = 0;  ///< of the participant
  std::vector<Staircase> stairs;
  std::vector<int> shows;  ///< of each stimulus, answered ones
  int answered = 0;
  std::optional<int> due;  ///< stimulus of the next trial; none when every staircase has stopped
};

[[nodiscard]] StaircaseProcedure begin_staircases(std::shared_ptr<const StaircaseDesign> design,
                                                  std::uint64_t seed);

/// What was answered to a stimulus.
struct StaircaseAnswer {
  int stimulus = 0;
  bool correct = false;
};

/// The procedure after trials that the log holds; `due` may name the one that was decided and not answered.
[[nodiscard]] StaircaseProcedure resume_staircases(StaircaseProcedure procedure,
                                                   const std::vector<StaircaseAnswer>& answers,
                                                   std::optional<int> due);

/// Moves the staircase whose stimulus was due; the answer is right where it names the object's place
/// (`placed_answer`). Precondition: one was due.
[[nodiscard]] StaircaseProcedure after_answer(StaircaseProcedure procedure, const TrialAnswer& answer);

/// How many trials there will be at most.
[[nodiscard]] int most_trials(const StaircaseProcedure& procedure);

/// The mean of the levels, on the axis, at which a staircase turned: the last even number of its reversals
/// without the first two. None where fewer than two are left. It approaches the level that is answered
/// rightly with `staircase_target`.
[[nodiscard]] std::optional<double> reversals_mean(const Staircase& stairs, const StimulusTrack& curve,
                                                   Axis axis);

/// The share of right answers p at which the staircase is as likely to go one way as the other: of D right in
/// a row before U wrong in a row, probability 1/2 each (Levitt 1971; p^D = 1/2 for U = 1).
[[nodiscard]] double staircase_target(const StaircaseDefinition& definition);

}  // namespace seamline::study
