#pragma once
#include "stimuli/definition/methods/analysis_definition.h"
#include "stimuli/definition/methods/late_frames.h"
#include "stimuli/settings/settings_text.h"

namespace seamline::inline stimuli {

template <>
inline constexpr std::array<std::string_view, 2> words_of<LateTrials> = {"used", "left_out"};

inline constexpr std::array<std::string_view, 2> words_of_model = {"joint", "paper"};

/// `[analysis]`. None of it is in the hash.
template <>
inline constexpr auto settings_of<AnalysisDefinition> = std::to_array<Setting<AnalysisDefinition>>({
    {.key = "model",
     .slot = one_of<&AnalysisDefinition::joint, true, false>(words_of_model),
     .meaning = "Thresholds of record: the joint model's, or straight lines between the tested levels.",
     .changes = Changes::presentation,
     .of_condition = false},
    {.key = "share",
     .slot = Described{"texts"},
     .meaning = "What the curves of the [joint model](../explanation/joint_model.md) share. `[\"tested\"]`: "
                "all four, but what a test refuses becomes each curve's own. A list of blocks fixes it "
                "before the study; `[\"nothing\"]`: each curve has its own. `plan` always tests.",
     .changes = Changes::presentation,
     .of_condition = false,
     .is_read_apart = true,
     .form = "`\"scale\"`, `\"criteria\"`, `\"lapse\"`, `\"guess_ratings\"`",
     .usual = "`[\"tested\"]`"},
    {.key = "compare",
     .slot = &AnalysisDefinition::compare,
     .meaning = "What `analyze` and `freeze` compare people by where no `--compare` is given.",
     .changes = Changes::presentation,
     .of_condition = false,
     .form = "form fields, `\"group\"`, ...",
     .usual = "none"},
});
static_assert(are_sound<AnalysisDefinition>(settings_of<AnalysisDefinition>));

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
