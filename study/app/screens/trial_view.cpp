#include "study/app/screens/trial_view.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "stimuli/definition/looks/condition_tasks.h"
#include "study/app/pictures/picture_store.h"
#include "study/trials/right_rule.h"
#include "study/trials/trial_picture.h"
#include "window/look.h"

namespace seamline::study::app {
namespace {

/// Of the trial that was drawn last, which is the one on the screen.
Size shown_size(const Stage& stage) {
  const auto size = [](int width_px, int height_px) {
    return Size{static_cast<double>(width_px), static_cast<double>(height_px)};
  };
  if (is_panorama(stage.set.study) && stage.looking.trial) {
    const std::array<int, 2>& view_px = look_at(stage, *stage.looking.trial)->view_px;
    return size(view_px[0], view_px[1]);
  }
  const bool by_trial = stage.trial_drawn && has_own_tasks(stage.set.study);
  const auto [width_px, height_px] =
      by_trial ? shown_size_px(stage.set, facts_of(task_of(stage.set, *stage.trial_drawn).get()).kind)
               : shown_size_px(stage.set);
  return size(width_px, height_px);
}

}  // namespace

const LookDefinition* look_at(const Stage& stage, const Trial& trial) {
  if (!is_panorama(stage.set.study)) return nullptr;
  if (stage.looking.zoomed && stage.looking.trial == trial) return &*stage.looking.zoomed;
  return look_of(stage.set.study, stage.set.manifest.stimuli.at(trial.stimulus).stimulus.condition);
}

void show_picture(Stage& stage, const Trial& trial, const WindowTexture& picture, const TrialPlace& place) {
  const LookDefinition* view = look_at(stage, trial);
  if (view == nullptr) return stage.canvas().picture(picture, place.picture);
  stage.panorama = {&picture, place.picture, {axes_of(stage.looking.pose), half_tangents(*view)}};
}

std::vector<PictureFrame> seen_frames(const Stage& stage, const Trial& trial) {
  const ObjectMap& objects = stage.pictures.objects(trial);
  const LookDefinition* view = look_at(stage, trial);
  return view == nullptr ? objects.frames : frames_in_view(*view, stage.looking.pose, objects);
}

TrialPlace trial_place(const Stage& stage) {
  return place_trial(stage.screen_px, shown_size(stage), stage.ui.em(), picture_corner(stage.set.study));
}

void draw_fixation(Stage& stage, bool two_eyes) {
  const Rect picture = trial_place(stage).picture;
  const auto draw = [&](double x_px) {
    const double arm_px = 12, y_px = std::round(picture.centre().y_px);
    stage.canvas().fill({x_px - arm_px, y_px - 1, 2 * arm_px, 2}, look::ink_on_background);
    stage.canvas().fill({x_px - 1, y_px - arm_px, 2, 2 * arm_px}, look::ink_on_background);
  };
  if (!two_eyes) return draw(std::round(picture.centre().x_px));
  for (const double share : {0.25, 0.75}) draw(std::round(picture.x_px + share * picture.width_px));
}

void draw_bracket(Stage& stage, const TrialPlace& place, const PictureFrame& frame_in_picture,
                  Bracket bracket) {
  if (frame_in_picture.width_px <= 0) return;
  const Rect frame = on_screen(place, frame_in_picture);
  const double arm_px = std::round(std::min({24.0, frame.width_px / 3, frame.height_px / 3}));
  const auto corner = [&](double x_px, double y_px, double to_right, double to_bottom, double edge_px,
                          Colour colour) {
    // Two bars that meet at the corner, with an edge that is seen on any picture.
    const double across_px = bracket == Bracket::chosen ? 7 : 3;
    const Rect lying{to_right > 0 ? x_px : x_px - arm_px, to_bottom > 0 ? y_px : y_px - across_px, arm_px,
                     across_px};
    const Rect standing{to_right > 0 ? x_px : x_px - across_px, to_bottom > 0 ? y_px : y_px - arm_px,
                        across_px, arm_px};
    stage.canvas().fill(lying.grown(edge_px), colour);
    stage.canvas().fill(standing.grown(edge_px), colour);
  };
  for (const bool edge : {true, false}) {
    const double edge_px = edge ? 1.0 : 0.0;
    const Colour colour = edge ? look::bracket_edge : look::bracket;
    corner(frame.x_px, frame.y_px, 1, 1, edge_px, colour);
    corner(frame.right_px(), frame.y_px, -1, 1, edge_px, colour);
    corner(frame.x_px, frame.bottom_px(), 1, -1, edge_px, colour);
    corner(frame.right_px(), frame.bottom_px(), -1, -1, edge_px, colour);
  }
}

void draw_question(Stage& stage, const TrialPlace& place, Font font, const std::string& text,
                   double from_top_em) {
  const Size size = stage.canvas().measure(font, text);
  const double x_px = place.questions.x_px + (place.questions.width_px - size.width_px) / 2;
  stage.canvas().text(font, {x_px, place.questions.y_px + from_top_em * stage.ui.em()}, text,
                      font == Font::small ? look::quiet_on_background : look::ink_on_background);
}

void draw_progress(Stage& stage, int done, int all) {
  const double height_px = 4, bottom_px = stage.screen_px.height_px - height_px;
  stage.canvas().fill({0, bottom_px, stage.screen_px.width_px, height_px}, grey(116));
  const bool mirrored = stage.canvas().right_to_left();
  const double done_px = all > 0 ? std::round(stage.screen_px.width_px * done / all) : 0;
  stage.canvas().fill({mirrored ? stage.screen_px.width_px - done_px : 0, bottom_px, done_px, height_px},
                      grey(84));
  const std::string text =
      stage.phrase(Phrase::progress, {{"done", fmt::format("{}", done)}, {"all", fmt::format("{}", all)}});
  const Size size = stage.canvas().measure(Font::small, text);
  const double margin_px = stage.ui.em();
  stage.canvas().text(Font::small,
                      {mirrored ? margin_px : stage.screen_px.width_px - size.width_px - margin_px,
                       bottom_px - size.height_px - 0.4 * margin_px},
                      text, look::quiet_on_background);
}

}  // namespace seamline::study::app
