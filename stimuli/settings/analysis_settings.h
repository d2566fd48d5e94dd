#pragma once
#include "stimuli/definition/methods/late_frames.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 2> words_of<LateTrials> = {"used", "left_out"};

/// `[analysis]` of a study with `[clip]`.
template <>
inline constexpr auto settings_of<LateFrames> = std::to_array<Setting<LateFrames>>({
    {.key = "late_frames_most",
     .slot = &LateFrames::most_share,
     .range = {0, 1},
     .meaning =
         "Of a study with [`[clip]`](#clip-things-that-move): a trial is marked where a larger share of "
         "the frames that were due came late or never.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "late_trials",
     .slot = choice<&LateFrames::trials>(),
     .meaning = "What becomes of marked trials: used, with the thresholds without them beside; or no part of "
                "the analysis (refused where the answers place the levels).",
     .changes = Changes::presentation,
     .of_condition = false},
});
static_assert(are_sound<LateFrames>(settings_of<LateFrames>));

}  // namespace seamline::inline stimuli
