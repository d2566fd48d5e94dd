#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "study/app/pictures/picture_store.h"
#include "study/app/screens/answer_row.h"
#include "study/app/screens/screen_task.h"
#include "study/app/screens/stage.h"
#include "study/app/screens/trial_view.h"
#include "support/running/overloaded.h"
#include "window/look.h"

namespace seamline::study::app {
namespace {

/// A trial while it is on the screen.
struct TrialOnScreen {
  Stage& stage;
  TrialPlace place;
  const ObjectMap& objects;
  const LookDefinition* view = nullptr;  ///< of a panorama
  AskedTexts texts = {};
  std::vector<PictureFrame> frames = {};

  [[nodiscard]] bool turns() const { return view != nullptr && view->kind == LookKind::mouse; }
  [[nodiscard]] int object_at_place(const Point& at) const {
    if (view != nullptr) return object_in_view(*view, stage.looking.pose, objects, {at.x_px, at.y_px});
    return object_at(objects, at.x_px, at.y_px);
  }
  [[nodiscard]] int object_under_mouse() const {
    return stage.looking.dragged ? 0 : object_at_place(in_picture(place, stage.input.mouse));
  }
  [[nodiscard]] int object_in_middle() const {
    return object_at_place({view->view_px[0] / 2.0, view->view_px[1] / 2.0});
  }
  /// Whether an object was clicked: a view that can be dragged, where the button is let go without a drag.
  [[nodiscard]] bool clicked() const {
    return turns() ? stage.input.mouse_released && !stage.looking.dragged : stage.input.mouse_pressed;
  }
  [[nodiscard]] bool mouse_has_moved() const {
    const Point& before = stage.drafts.mouse_at_onset;
    return stage.input.mouse.x_px != before.x_px || stage.input.mouse.y_px != before.y_px;
  }
  void bracket(int object, Bracket kind) const {
    if (object < 1) return;
    const std::size_t index = object - 1;
    draw_bracket(stage, place, frames.at(index), kind);
    draw_bracket(stage, place, objects.right_eye_frames.at(index), kind);
  }
};

/// The keyboard's place among ratings 0..3 and objects from 4 on.
constexpr int first_object_place = highest_rating;
int places_of(const TrialOnScreen& trial) {
  return first_object_place + static_cast<int>(trial.frames.size());
}

bool arrows(const Stage& stage) {
  return stage.input.pressed(Key::left) || stage.input.pressed(Key::right) || stage.input.pressed(Key::up) ||
         stage.input.pressed(Key::down);
}

Outcome choose(const TrialOnScreen& trial) {
  Stage& stage = trial.stage;
  draw_question(stage, trial.place, Font::body, trial.texts.question, 0.9);
  draw_question(stage, trial.place, Font::small, trial.turns() ? trial.view->hint : trial.texts.hint, 2.4);
  if (trial.turns())
    stage.drafts.trial_focus = -1;
  else
    move_focus(stage, first_object_place, places_of(trial) - 1);
  const int hovered = trial.object_under_mouse();
  const int focused = stage.drafts.trial_focus - first_object_place + 1;
  trial.bracket(hovered != 0 && trial.mouse_has_moved() ? hovered : focused, Bracket::pointed);
  int chosen = 0;
  if (trial.clicked()) chosen = hovered;
  if (const int digit = stage.input.digit();
      digit >= 1 && digit <= std::ssize(trial.frames) && !trial.turns())
    chosen = digit;
  if (trial.turns() && uses_focus(stage)) chosen = trial.object_in_middle();
  if (focused >= 1 && uses_focus(stage)) chosen = focused;
  if (chosen == 0) return std::nullopt;
  return Event(ObjectChosen{chosen, stage.input.now_ns});
}

std::vector<Rect> rating_buttons(const TrialOnScreen& trial, Font font) {
  const Stage& stage = trial.stage;
  double width_px = 0;
  for (std::size_t i = 0; i < 4; ++i)
    width_px = std::max(
        width_px, stage.canvas()
                      .measure(font, fmt::format("{}  {}", i + 1, stage.set.study.session.rating_labels[i]))
                      .width_px);
  return row_of_buttons(stage, trial.place.questions, highest_rating,
                        std::round(width_px + 1.4 * stage.ui.em()));
}

Outcome rate(const TrialOnScreen& trial, const Rating& phase) {
  Stage& stage = trial.stage;
  draw_question(stage, trial.place, Font::body, stage.set.study.session.rating_question, 0.9);
  draw_question(stage, trial.place, Font::small, trial.texts.rating_hint, 4.85);
  if (!(trial.turns() && arrows(stage)))  // which turn the view
    move_focus(stage, 0, trial.turns() ? first_object_place - 1 : places_of(trial) - 1);
  const int hovered_object = trial.object_under_mouse();
  const int focus = stage.drafts.trial_focus;
  if (hovered_object != 0) trial.bracket(hovered_object, Bracket::pointed);
  if (focus >= first_object_place) trial.bracket(focus - first_object_place + 1, Bracket::pointed);
  trial.bracket(phase.chosen_index, Bracket::chosen);  // over the others

  Font font = Font::body;
  std::vector<Rect> buttons = rating_buttons(trial, font);
  if (std::min(buttons.front().x_px, buttons.back().x_px) < 8)
    buttons = rating_buttons(trial, font = Font::small);
  int rating = 0;
  for (int i = 0; i < highest_rating; ++i) {
    const Rect& rect = buttons.at(i);
    const bool hovered = rect.contains(stage.input.mouse);
    stage.ui.mark(fmt::format("rating/{}", i + 1), rect);
    stage.canvas().fill(rect, hovered ? look::control_hover : look::card, 6);
    stage.canvas().outline(rect, look::card_edge, 1, 6);
    if (focus == i) {
      stage.canvas().outline(rect.grown(4), look::focus_halo, 3, 9);
      stage.canvas().outline(rect.grown(5.5), look::focus, 2, 10);
    }
    const std::string text = fmt::format("{}  {}", i + 1, stage.set.study.session.rating_labels[i]);
    const Size size = stage.canvas().measure(font, text);
    stage.canvas().text(
        font,
        {rect.x_px + (rect.width_px - size.width_px) / 2, rect.y_px + (rect.height_px - size.height_px) / 2},
        text, look::ink);
    if ((stage.input.mouse_pressed && hovered) || (focus == i && uses_focus(stage))) rating = i + 1;
  }
  if (const int digit = stage.input.digit(); digit >= 1 && digit <= highest_rating) rating = digit;
  if (rating != 0) return Event(RatingGiven{rating, stage.input.now_ns});
  int again = trial.clicked() ? hovered_object : 0;
  if (focus >= first_object_place && uses_focus(stage)) again = focus - first_object_place + 1;
  if (again != 0) return Event(ObjectChosen{again, stage.input.now_ns});
  return std::nullopt;
}

/// What arrows turn a view by.
Pose step_deg(const FrameInput& input) {
  const double step = input.key && input.key->shift ? 15 : 3;
  return {step * (input.pressed(Key::right) - input.pressed(Key::left)),
          step * (input.pressed(Key::up) - input.pressed(Key::down))};
}

/// How many steps nearer + and - ask for.
int steps_nearer(const FrameInput& input) {
  int steps = 0;
  for (const char32_t typed : input.typed) steps += (typed == U'+' || typed == U'=') - (typed == U'-');
  return steps;
}

/// By how much the mouse turns the view of a panorama: what is taken hold of follows it.
Pose dragged_deg(const LookDefinition& view, const TrialPlace& place, Stage& stage) {
  constexpr double slack_px = 4;  // that a click may move
  LookDraft& looking = stage.looking;
  const FrameInput& input = stage.input;
  if (input.mouse_pressed) {
    looking.dragged = false;
    looking.grabbed.reset();
    if (place.picture.contains(input.mouse)) looking.grabbed = input.mouse;
    return {};
  }
  if (!looking.grabbed) return {};
  const double right_px = input.mouse.x_px - looking.grabbed->x_px,
               down_px = input.mouse.y_px - looking.grabbed->y_px;
  if (!looking.dragged && std::hypot(right_px, down_px) < slack_px) return {};
  looking.dragged = true;
  looking.grabbed = input.mouse;
  const double degrees = degrees_per_pixel(view) / place.scale;
  return {-right_px * degrees, down_px * degrees};
}

/// Begins the view of a trial's panorama at its start, and turns and zooms it by mouse and keys while it is
/// seen.
void take_view(const Session& session, const Trial& due, Stage& stage) {
  const LookDefinition* view = look_at(stage, due);
  if (view == nullptr) return;
  LookDraft& looking = stage.looking;
  const auto* choosing = std::get_if<Choosing>(&session.phase);
  const auto* rating = std::get_if<Rating>(&session.phase);
  if (looking.trial != due || (choosing == nullptr && rating == nullptr)) {
    const Stimulus& stimulus = stage.set.manifest.stimuli.at(due.stimulus).stimulus;
    const std::array<double, 2> start = start_deg(*view, stage.set.study, stimulus.scene);
    if (!std::holds_alternative<Storing>(session.phase))
      looking = {.trial = due,
                 .pose = drawn_start(*view, start, due.stimulus, answered_trials(session.trials))};
    return;
  }
  const std::int64_t onset_ns = choosing != nullptr ? choosing->onset_ns : rating->onset_ns;
  const double fov_deg = zoomed_fov_deg(*view, steps_nearer(stage.input));
  if (fov_deg != view->horizontal_fov_deg) {
    LookDefinition zoomed = *view;
    zoomed.horizontal_fov_deg = fov_deg;
    looking.zoomed = std::move(zoomed);
    view = &*looking.zoomed;
  }
  Pose by = dragged_deg(*view, trial_place(stage), stage);
  if (arrows(stage)) by = step_deg(stage.input);
  looking.pose = turned(*view, looking.pose, by.yaw_deg, by.pitch_deg);
  looking.poses.add(std::max(0.0, static_cast<double>(stage.input.now_ns - onset_ns) * 1e-6), looking.pose,
                    view->fov_limits_deg ? std::optional(fov_deg) : std::nullopt);
}

/// After the click that a release may be is taken.
void let_go(Stage& stage) {
  if (!stage.input.mouse_released) return;
  stage.looking.grabbed.reset();
  stage.looking.dragged = false;
}

/// The place that Enter chooses at.
void draw_middle(const TrialOnScreen& trial) {
  if (!trial.turns()) return;
  const Point middle = trial.place.picture.centre();
  const double x_px = std::round(middle.x_px), y_px = std::round(middle.y_px);
  for (const double edge_px : {1.0, 0.0})
    for (const Rect& bar : {Rect{x_px - 7, y_px - 1, 14, 2}, Rect{x_px - 1, y_px - 7, 2, 14}})
      trial.stage.canvas().fill(bar.grown(edge_px), edge_px > 0 ? look::bracket_edge : look::bracket);
}

/// A trial of practice or of the study, whatever its phase shows.
Outcome draw_trial(const Session& session, Stage& stage) {
  const std::optional<Trial> due = current_trial(session.trials);
  if (!due) return std::nullopt;
  stage.trial_drawn = due;
  if (asks_for_alternatives(stage.set, *due)) return draw_task_trial(session, stage);
  take_view(session, *due, stage);
  const TrialOnScreen trial{stage,
                            trial_place(stage),
                            stage.pictures.objects(*due),
                            look_at(stage, *due),
                            asked_by(stage, *due),
                            seen_frames(stage, *due)};
  const WindowTexture* picture = stage.pictures.find(*due);
  const auto show = [&] {
    if (picture != nullptr) show_picture(stage, *due, *picture, trial.place);
  };
  const Outcome outcome =
      std::visit(Overloaded{[&](const Grey&) -> Outcome {
                              stage.drafts.trial_focus = -1;
                              draw_fixation(stage, trial.objects.two_eyes);
                              return std::nullopt;
                            },
                            [&](const AwaitingImage&) -> Outcome {
                              stage.drafts.trial_focus = -1;
                              stage.drafts.mouse_at_onset = stage.input.mouse;
                              if (picture == nullptr) draw_fixation(stage, trial.objects.two_eyes);
                              show();
                              return std::nullopt;
                            },
                            [](const Viewing&) -> Outcome { return std::nullopt; },  // of other tasks
                            [](const Gap&) -> Outcome { return std::nullopt; },
                            [&](const Choosing& phase) -> Outcome {
                              show();
                              const std::int64_t ready_ns = phase.onset_ns + session.pace.minimum_viewing_ns;
                              if (monotonic_ns() < ready_ns) return std::nullopt;
                              draw_middle(trial);
                              return choose(trial);
                            },
                            [&](const Rating& phase) -> Outcome {
                              show();
                              draw_middle(trial);
                              return rate(trial, phase);
                            },
                            [](const Storing&) -> Outcome { return std::nullopt; },
                            [](const OnBreak&) -> Outcome { return std::nullopt; },
                            [](const Briefing&) -> Outcome { return std::nullopt; },
                            [](const Done&) -> Outcome { return std::nullopt; }},
                 session.phase);
  let_go(stage);
  return outcome;
}

}  // namespace

Outcome draw(const TrainingScreen&, const Visit& visit, Stage& stage) {
  const std::string hint = stage.phrase(
      Phrase::training_hint, {{"done", fmt::format("{}", answered_trials(visit.training.trials) + 1)},
                              {"all", fmt::format("{}", most_trials(visit.training.trials))}});
  Outcome outcome = draw_trial(visit.training, stage);
  const double margin_px = stage.ui.em();
  const double hint_px = stage.canvas().measure(Font::small, hint).width_px;
  stage.canvas().text(
      Font::small,
      {stage.canvas().right_to_left() ? stage.screen_px.width_px - hint_px - margin_px : margin_px,
       0.6 * margin_px},
      hint, look::ink_on_background);
  return outcome;
}

Outcome draw(const TrialScreen&, const Visit& visit, Stage& stage) {
  Outcome outcome = draw_trial(visit.session, stage);
  const int done = answered_trials(visit.session.trials), all = most_trials(visit.session.trials);
  draw_progress(stage, done, all);
  return outcome;
}

}  // namespace seamline::study::app
