#pragma once
#include <cstdint>
#include <string>

#include "stimuli/definition/parts/task_definition.h"
#include "study/app/pictures/picture_place.h"
#include "study/app/screens/stage.h"

namespace seamline::study::app {

// Trials of tasks other than the paper's: pairs, intervals, yes or no, ratings.

/// Whether a trial asks for an alternative with a name, and not for an object in the picture.
[[nodiscard]] bool asks_for_alternatives(const RenderedSet& set, const Trial& trial);

/// What a trial asks and says.
[[nodiscard]] AskedTexts asked_by(const Stage& stage, const Trial& trial);

/// Whether all that a trial shows is in graphics memory; of every task.
[[nodiscard]] bool pictures_are_ready(const Stage& stage, const Trial& trial);

/// The next frame is seen a period from now, and what is due within half a period of that is due then: 1.5
/// periods of the screen.
[[nodiscard]] std::int64_t next_frame_ns(const DisplayInfo& display);

/// A trial of practice or of the study, whatever its phase shows.
[[nodiscard]] Outcome draw_task_trial(const Session& session, Stage& stage);

/// The pictures of the practice trial once more.
void draw_task_feedback(Stage& stage, const TrialPlace& place, const Trial& trial);

/// What the right choice of a task is called: an alternative, or the object's side.
[[nodiscard]] std::string name_of_right(const Stage& stage, const Trial& trial, int right_index);

}  // namespace seamline::study::app
