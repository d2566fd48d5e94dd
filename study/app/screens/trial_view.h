#pragma once
#include "study/app/pictures/picture_place.h"
#include "study/app/screens/stage.h"

namespace seamline::study::app {

// What trials, practice and feedback draw alike.

[[nodiscard]] TrialPlace trial_place(const Stage& stage);

/// How the picture of a trial is looked at; null: whole, as it is.
[[nodiscard]] const LookDefinition* look_at(const Stage& stage, const Trial& trial);

/// Puts a trial's picture on the screen, whole or as the view of it.
void show_picture(Stage& stage, const Trial& trial, const WindowTexture& picture, const TrialPlace& place);

/// The objects of a trial as they are seen in the picture or the view of it.
[[nodiscard]] std::vector<PictureFrame> seen_frames(const Stage& stage, const Trial& trial);

/// Grey with a mark where the middle of the picture will be, or of each eye's half of it.
void draw_fixation(Stage& stage, bool two_eyes);

/// What corners around an object say: it is pointed at, or it is the choice, whose corners are bolder.
enum class Bracket { pointed, chosen };

/// Corners around an object's frame. They look the same for every object, and never follow its outline.
void draw_bracket(Stage& stage, const TrialPlace& place, const PictureFrame& frame_in_picture,
                  Bracket bracket = Bracket::pointed);

/// A line of text in the middle of the strip below the picture, `from_top_em` below its upper edge.
void draw_question(Stage& stage, const TrialPlace& place, Font font, const std::string& text,
                   double from_top_em);

/// A thin bar at the bottom edge of the screen, of the background's colours.
void draw_progress(Stage& stage, int done, int all);

}  // namespace seamline::study::app
