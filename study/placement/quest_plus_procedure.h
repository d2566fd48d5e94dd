#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "study/placement/quest_plus_design.h"
#include "study/placement/trial.h"

namespace seamline::study {

enum class StopReason {
  interval,    ///< of the threshold is narrow enough
  entropy,     ///< of the posterior is low enough
  trials,      ///< max_trials are done
  images_used  ///< every image has been seen max_shows_per_image times
};
[[nodiscard]] std::string_view word(StopReason reason);

/// What is known about one track.
struct QuestPlusTrack {
  QuestPlusPosterior posterior;
  int answered = 0;
  std::optional<StopReason> stopped = {};
  bool operator==(const QuestPlusTrack&) const = default;
};

/// Tracks of QUEST+, interleaved: the next trial belongs to a track drawn from those unfinished tracks that
/// have the fewest answers, so that every round visits each of them once, in an order that nobody can
/// foresee. Its level is the one whose answer is expected to leave the least entropy (the smaller one of two
/// equals) among those with an image that the participant has seen fewer than max_shows_per_image times; its
/// image is drawn from those of the level that the participant has seen least. The draws of trial t come from
/// stream t of the participant's seed, so that the same answers always lead to the same trials.
struct QuestPlusProcedure {
  std::shared_ptr<const QuestPlusDesign> design;
  std::uint64_t seed = 0;  ///< of the participant
  std::vector<QuestPlusTrack> tracks;
  std::vector<int> shows;  ///< of each stimulus, answered ones
  int answered = 0;
  std::optional<int> due;  ///< stimulus of the next trial; none when every track has stopped
};

/// Before the first trial.
[[nodiscard]] QuestPlusProcedure begin_quest_plus(std::shared_ptr<const QuestPlusDesign> design,
                                                  std::uint64_t seed);

/// The procedure after trials that the log holds. What was shown is taken from the log, not decided again;
/// `decided` may name one stimulus more than there are answers: the one that is due. The result is, bit for
/// bit, what it was before the session broke off.
[[nodiscard]] QuestPlusProcedure resume_quest_plus(QuestPlusProcedure procedure,
                                                   const std::vector<int>& decided,
                                                   const std::vector<TrialAnswer>& answers);

/// Learns from the answer to the stimulus that was due, and finds the next. Precondition: one was due.
[[nodiscard]] QuestPlusProcedure after_answer(QuestPlusProcedure procedure, const TrialAnswer& answer);

/// How many trials there will be at most.
[[nodiscard]] int most_trials(const QuestPlusProcedure& procedure);

}  // namespace seamline::study
