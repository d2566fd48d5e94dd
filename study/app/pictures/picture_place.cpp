#include "study/app/pictures/picture_place.h"

#include <algorithm>
#include <cmath>

namespace seamline::study::app {

Size needed_screen(Size picture_px, double em_px) {
  return {picture_px.width_px, picture_px.height_px + std::ceil(questions_em * em_px)};
}

bool fits(Size screen_px, Size picture_px, double em_px) {
  const Size needed = needed_screen(picture_px, em_px);
  return screen_px.width_px >= needed.width_px && screen_px.height_px >= needed.height_px;
}

TrialPlace place_trial(Size screen_px, Size picture_px, double em_px) {
  const double strip_px = std::ceil(questions_em * em_px);
  TrialPlace place;
  if (!fits(screen_px, picture_px, em_px))
    place.scale = std::max(0.05, std::min(screen_px.width_px / picture_px.width_px,
                                          (screen_px.height_px - strip_px) / picture_px.height_px));
  const double width_px = std::round(picture_px.width_px * place.scale);
  const double height_px = std::round(picture_px.height_px * place.scale);
  const double x_px = std::floor((screen_px.width_px - width_px) / 2);
  const double y_px = std::floor(std::max(0.0, screen_px.height_px - height_px - strip_px) / 2);
  place.picture = {x_px, y_px, width_px, height_px};
  place.questions = {0, y_px + height_px, screen_px.width_px, strip_px};
  return place;
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
