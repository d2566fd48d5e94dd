#pragma once
#include <string_view>
#include <vector>

#include "study/log/log.h"

namespace seamline::analysis {

/// Questions of the usual form (`default_form`): about vision, with the answer of those who see the pictures
/// unsharp, and about a technical background, "yes" or "no".
inline constexpr const char* vision_question = "vision";
inline constexpr const char* uncorrected_vision = "neither";
inline constexpr const char* technical_question = "technical_background";

/// What becomes of a participant's answers. Nobody is left out in silence: each has a verdict, and each
/// verdict is counted.
enum class Use {
  used,
  excluded,    ///< the researcher excluded them (`seamline log exclude`)
  pilot,       ///< pilot data, and `--include-pilot` was not given
  incomplete,  ///< the session was not finished: their means would be over other stimuli than everybody
               ///< else's
  screened,    ///< named by a screen (analysis/screening/screening.h), and `--exclude-screened` was given, or
               ///< by catch trials, and `--exclude-inattentive` was
  vision  ///< says that their vision is neither normal nor corrected, and `--exclude-uncorrected` was given
};

[[nodiscard]] std::string_view word(Use use);

struct ParticipantUse {
  study::ParticipantRecord record;
  Use use = Use::used;
  int answers = 0;
  double correct = 0;  ///< share of right choices among all answers; NaN without answers
  double median_choice_s =
      0;  ///< seconds from the image to the choice; NaN when simulated or without answers
};

struct ParticipantCounts {
  int in_log = 0, used = 0, excluded = 0, pilot = 0, incomplete = 0, screened = 0, vision = 0;
  int simulated = 0;  ///< among those used
};

/// Decides for each participant of the log. Excluded comes before pilot, pilot before incomplete.
[[nodiscard]] std::vector<ParticipantUse> select_participants(const study::LogContents& log,
                                                              bool include_pilot);

/// Whether somebody said in the form that their vision is neither normal nor corrected to normal; false where
/// the study did not ask.
[[nodiscard]] bool has_uncorrected_vision(const study::ParticipantRecord& record);

[[nodiscard]] ParticipantCounts count_participants(const std::vector<ParticipantUse>& people);

/// The kind of simulated observer when every used participant is of that one kind, else empty.
[[nodiscard]] std::string_view common_observer(const std::vector<ParticipantUse>& people);

}  // namespace seamline::analysis
