#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "stimuli/definition/parts/task_definition.h"

namespace seamline::study {

/// Where the study does not say how many (`TaskDefinition::objects`).
inline constexpr int objects_per_stimulus = usual_objects;
inline constexpr int highest_rating = 4;

/// What a trial is for.
enum class TrialKind {
  stimulus,   ///< a picture of the set: what the study is about
  attention,  ///< an insertion that nobody who looks can miss (stimuli/pictures/attention_image.h)
  reference,  ///< nothing was inserted: there is no right answer
  mask        ///< no trial: what covers a picture's place after it (stimuli/pictures/mask_image.h)
};
/// Those that there are trials of.
inline constexpr std::array<TrialKind, 3> every_trial_kind = {TrialKind::stimulus, TrialKind::attention,
                                                              TrialKind::reference};
[[nodiscard]] std::string_view word(TrialKind kind);
[[nodiscard]] std::optional<TrialKind> trial_kind_from_word(std::string_view text);

/// A trial of a participant. `stimulus` is an index into the set. An attention trial shows the reference of
/// its scene with its object changed, a reference trial the reference of its scene as it is.
struct Trial {
  TrialKind kind = TrialKind::stimulus;
  int stimulus = 0;
  /// The right alternative from 1, of tasks that draw it or ask for yes (1) or no (2). 0: the object's own
  /// place, or nothing is right (study/trials/right_rule.h).
  int right_index = 0;
  bool operator==(const Trial&) const = default;
};

/// What a participant did in one trial: chose one of the objects (or of the task's alternatives), then
/// rated how noticeable the insertion was (1 where the task does not ask it). Of a rating task alone, the
/// lowest label is no seam seen (choice 2, rating 1), and the others are one (choice 1, rating 1 to 4).
struct TrialAnswer {
  int trial_index = 0;         ///< 0-based place among all trials of the participant, of every kind
  int chosen_index = 0;        ///< from 1; of three objects 1 left, 2 middle, 3 right
  int rating = 0;              ///< 1 slightly .. 4 extremely noticeable
  int matched = -1;            ///< of a match, the stimulus at which the participant stopped; -1: none
  int position = -1;           ///< of a slider, 0 to `slider_end`; its rating is the fifth; -1: none
  std::int64_t choice_ns = 0;  ///< from the image's onset to the choice that counted
  std::int64_t rating_ns = 0;  ///< from the image's onset to the rating; at least choice_ns
  bool operator==(const TrialAnswer&) const = default;
};

}  // namespace seamline::study
