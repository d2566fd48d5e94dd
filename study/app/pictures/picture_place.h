#pragma once
#include <optional>

#include "stimuli/definition/study_definition.h"
#include "study/trials/object_map.h"
#include "window/geometry.h"

namespace seamline::study::app {

/// Where a trial's picture and its questions go on the screen.
struct TrialPlace {
  Rect picture;      ///< integer corners
  Rect questions;    ///< the strip below the picture
  double scale = 1;  ///< screen pixels a picture pixel
};

/// Height of the strip with questions and answers, in multiples of the type's size.
inline constexpr double questions_em = 6.0;

/// The screen that pictures need to be shown pixel for pixel, with the questions below them.
[[nodiscard]] Size needed_screen(Size picture_px, double em_px);

[[nodiscard]] bool fits(Size screen_px, Size picture_px, double em_px);

/// Pixel for pixel where it fits; else, with scaling allowed, as large as there is room. `corner_px`: where
/// the picture's upper left corner must be; none: the picture is in the middle of the screen.
[[nodiscard]] TrialPlace place_trial(Size screen_px, Size picture_px, double em_px,
                                     const std::optional<Point>& corner_px = {});

/// Where the pictures of a study must stand: those under a lens sheet were made for one place on the screen,
/// and the others of such a study stand there too. None: anywhere.
[[nodiscard]] std::optional<Point> picture_corner(const StudyDefinition& study);

/// Throws InputError unless a screen is the one that a study's views were made for (`view.panel_px`).
void require_panel(const StudyDefinition& study, Size screen_px, bool scaling_allowed);

/// A place on the screen in the picture's own pixels.
[[nodiscard]] Point in_picture(const TrialPlace& place, const Point& on_screen);

/// A frame in picture pixels on the screen.
[[nodiscard]] Rect on_screen(const TrialPlace& place, const PictureFrame& in_picture);

}  // namespace seamline::study::app
