#include "study/app/pictures/picture_place.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::study::app {

Size needed_screen(Size picture_px, double em_px) {
  return {picture_px.width_px, picture_px.height_px + std::ceil(questions_em * em_px)};
}

bool fits(Size screen_px, Size picture_px, double em_px) {
  const Size needed = needed_screen(picture_px, em_px);
  return screen_px.width_px >= needed.width_px && screen_px.height_px >= needed.height_px;
}

TrialPlace place_trial(Size screen_px, Size picture_px, double em_px, const std::optional<Point>& corner_px) {
  const double strip_px = std::ceil(questions_em * em_px);
  TrialPlace place;
  if (!fits(screen_px, picture_px, em_px))
    place.scale = std::max(0.05, std::min(screen_px.width_px / picture_px.width_px,
                                          (screen_px.height_px - strip_px) / picture_px.height_px));
  const double width_px = std::round(picture_px.width_px * place.scale);
  const double height_px = std::round(picture_px.height_px * place.scale);
  const double x_px = std::floor((screen_px.width_px - width_px) / 2);
  const double y_px = std::floor(std::max(0.0, screen_px.height_px - height_px - strip_px) / 2);
  place.picture = {corner_px ? corner_px->x_px : x_px, corner_px ? corner_px->y_px : y_px, width_px,
                   height_px};
  place.questions = {0, place.picture.bottom_px(), screen_px.width_px, strip_px};
  return place;
}

std::optional<Point> picture_corner(const StudyDefinition& study) {
  const std::optional<View> view = panel_view(study);
  if (!view || view->kind != ViewKind::interleaved) return std::nullopt;
  const std::array<int, 2> corner_px = view->place_on_panel_px(study.width_px);
  return Point{static_cast<double>(corner_px[0]), static_cast<double>(corner_px[1])};
}

void require_panel(const StudyDefinition& study, Size screen_px, bool scaling_allowed) {
  const std::optional<View> view = panel_view(study);
  if (!view || (scaling_allowed && view->kind != ViewKind::interleaved)) return;
  if (screen_px.width_px == view->panel_px[0] && screen_px.height_px == view->panel_px[1]) return;
  throw input_error(
      {.field = "display",
       .wanted = fmt::format("the whole screen of {} x {} pixels that the study's view.panel_px states{}",
                             view->panel_px[0], view->panel_px[1],
                             view->kind == ViewKind::interleaved
                                 ? ": views under a lens sheet are seen nowhere else"
                                 : " (or " + request_name("allow_scaling") + ")"),
       .found = fmt::format("{:.0f} x {:.0f}", screen_px.width_px, screen_px.height_px)});
}

Point in_picture(const TrialPlace& place, const Point& on_screen) {
  return {(on_screen.x_px - place.picture.x_px) / place.scale,
          (on_screen.y_px - place.picture.y_px) / place.scale};
}

Rect on_screen(const TrialPlace& place, const PictureFrame& in_picture) {
  return {std::round(place.picture.x_px + in_picture.x_px * place.scale),
          std::round(place.picture.y_px + in_picture.y_px * place.scale),
          std::round(in_picture.width_px * place.scale), std::round(in_picture.height_px * place.scale)};
}

}  // namespace seamline::study::app
