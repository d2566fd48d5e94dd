#include "study/app/screens/screen_task.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "stimuli/definition/looks/condition_tasks.h"
#include "study/app/pictures/picture_store.h"
#include "study/app/screens/answer_row.h"
#include "study/app/screens/trial_view.h"
#include "study/trials/right_rule.h"
#include "support/running/overloaded.h"

namespace seamline::study::app {
namespace {

/// A trial while it is on the screen.
struct TaskTrial {
  Stage& stage;
  TrialPlace place;
  std::shared_ptr<const TaskDefinition> task;
  AskedTexts texts;
};

/// Where the pictures that are seen at the same time stand: the whole picture, or both halves of a pair.
std::vector<Rect> trial_pictures(const Stage& stage, const TrialPlace& place, TaskKind kind) {
  if (kind != TaskKind::pair) return {place.picture};
  const Rect& all = place.picture;
  const double width_px = std::round(stage.set.manifest.width_px * place.scale);
  return {{all.x_px, all.y_px, width_px, all.height_px},
          {all.right_px() - width_px, all.y_px, width_px, all.height_px}};
}

/// Draws what a trial shows; of pictures one after another, number `picture` from 0.
void show_pictures(Stage& stage, const TrialPlace& place, const Trial& trial, int picture) {
  stage.picture_seen = picture;
  const TaskFacts task = facts_of(task_of(stage.set, trial).get());
  const std::vector<Trial> shown = shown_pictures(task, trial);
  const std::vector<Rect> places = trial_pictures(stage, place, task.kind);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const std::size_t which = places.size() > 1 ? i : static_cast<std::size_t>(picture);
    if (const WindowTexture* texture = stage.pictures.find(shown.at(which)))
      stage.canvas().picture(*texture, places[i]);
  }
}

/// Draws the mask of picture number `after`, from 0.
void show_mask(Stage& stage, const TrialPlace& place, const Trial& trial, int after) {
  stage.mask_seen = after;
  const TaskKind kind = facts_of(task_of(stage.set, trial).get()).kind;
  const WindowTexture* mask = stage.pictures.find({.kind = TrialKind::mask, .stimulus = trial.stimulus});
  for (const Rect& rect : trial_pictures(stage, place, kind))
    if (mask != nullptr) stage.canvas().picture(*mask, rect);
}

/// What was begun of the answer before.
void forget_answer(Stage& stage) {
  stage.drafts.trial_focus = stage.drafts.slider = -1;
  stage.drafts.slider_held = false;
}

/// A question with a row of numbered answers below it.
struct AskedRow {
  const char* id = "";
  std::string question, hint;
  std::vector<std::string> labels;
};

/// Draws it; which answer was clicked or pressed, from 0, or -1.
int ask_row(const TaskTrial& trial, const AskedRow& row) {
  Stage& stage = trial.stage;
  const int count = static_cast<int>(row.labels.size());
  draw_question(stage, trial.place, Font::body, row.question, 0.9);
  draw_question(stage, trial.place, Font::small, row.hint, 4.85);
  move_focus(stage, 0, count - 1);
  const int taken = draw_answer_row(stage, trial.place.questions,
                                    {.id = row.id, .labels = row.labels, .focus = stage.drafts.trial_focus});
  const int digit = stage.input.digit();
  return digit >= 1 && digit <= count ? digit - 1 : taken;
}

/// A choice among the task's alternatives, by their names, or by the picture itself in a pair.
Outcome choose_answer(const TaskTrial& trial) {
  Stage& stage = trial.stage;
  int chosen = 1 + ask_row(trial, {.id = "answer",
                                   .question = trial.texts.question,
                                   .hint = trial.texts.hint,
                                   .labels = trial.task->answers});
  const std::vector<Rect> sides = trial_pictures(stage, trial.place, trial.task->kind);
  const bool by_picture = sides.size() > 1 && !trial.task->same;
  for (std::size_t i = 0; by_picture && stage.input.mouse_pressed && i < sides.size(); ++i)
    if (sides[i].contains(stage.input.mouse)) chosen = static_cast<int>(i) + 1;
  if (chosen == 0) return std::nullopt;
  stage.drafts.trial_focus = -1;
  return Event(ObjectChosen{chosen, stage.input.now_ns});
}

/// What the keyboard or the wheel asks of a match. Arrows step also while they are held down; Enter and Space
/// use the button that Tab has put the keyboard on, else they end the match.
std::optional<MatchStep> step_of_input(const Stage& stage) {
  const FrameInput& input = stage.input;
  if (input.pressed(Key::left) || input.pressed(Key::up) || input.scrolled_lines > 0)
    return MatchStep::clearer;
  if (input.pressed(Key::right) || input.pressed(Key::down) || input.scrolled_lines < 0)
    return MatchStep::fainter;
  if (uses_focus(stage) && stage.drafts.trial_focus < 0) return MatchStep::just_seen;
  return std::nullopt;
}

/// A step of a match, or its end. The arrows are the steps here: Tab alone moves the keyboard's place.
Outcome adjust(const TaskTrial& trial) {
  Stage& stage = trial.stage;
  std::optional<MatchStep> step = step_of_input(stage);
  const int focus = stage.drafts.trial_focus;
  int chosen = 1 + ask_row(trial, {.id = "answer",
                                   .question = trial.texts.question,
                                   .hint = trial.texts.hint,
                                   .labels = trial.task->answers});
  if (step) {
    chosen = static_cast<int>(*step);
    stage.drafts.trial_focus = focus;
  }
  if (chosen == 0) return std::nullopt;
  return Event(ObjectChosen{chosen, stage.input.now_ns});
}

/// A place on a line, in a task with nothing to choose.
Outcome slide(const TaskTrial& trial) {
  Stage& stage = trial.stage;
  draw_question(stage, trial.place, Font::body, trial.texts.question, 0.4);
  draw_question(stage, trial.place, Font::small, trial.texts.hint, 5.2);
  const std::optional<int> position = draw_slider(stage, trial.place.questions, trial.task->labels);
  if (!position) return std::nullopt;
  return Event(RatingGiven{.now_ns = stage.input.now_ns, .position = *position});
}

/// The labels of a task with nothing to choose: rating 0 is the first. After a choice, which stands, how
/// noticeable was it? The first is then rating 1.
Outcome rate(const TaskTrial& trial, bool after_choice) {
  const Stage& stage = trial.stage;
  const SessionDefinition& session = stage.set.study.session;
  const int taken =
      ask_row(trial, {.id = "rating",
                      .question = after_choice ? session.rating_question : trial.texts.question,
                      .hint = after_choice ? trial.texts.rating_hint : trial.texts.hint,
                      .labels = after_choice ? std::vector<std::string>{session.rating_labels.begin(),
                                                                        session.rating_labels.end()}
                                             : trial.task->labels});
  if (taken < 0) return std::nullopt;
  return Event(RatingGiven{after_choice ? taken + 1 : taken, stage.input.now_ns});
}

/// Draws the picture while it is seen, and asks once the question is open.
Outcome ask(const Session& session, const TaskTrial& trial, const Trial& due, std::int64_t onset_ns) {
  Stage& stage = trial.stage;
  const std::int64_t now_ns = monotonic_ns();
  const SessionTask& task = task_due(session);
  const std::int64_t seen_ns = now_ns + next_frame_ns(stage.display);
  if (is_picture_seen(task, onset_ns, seen_ns))
    show_pictures(stage, trial.place, picture_on_screen(session).value_or(due), 0);
  if (is_mask_seen(task, onset_ns, seen_ns)) show_mask(stage, trial.place, due, task.facts.pictures - 1);
  if (now_ns < onset_ns + session.pace.minimum_viewing_ns) return std::nullopt;
  if (task.facts.adjusts()) return adjust(trial);
  if (std::holds_alternative<Choosing>(session.phase)) return choose_answer(trial);
  if (task.facts.slides) return slide(trial);
  return rate(trial, task.facts.chooses);
}

}  // namespace

bool asks_for_alternatives(const RenderedSet& set, const Trial& trial) {
  return facts_of(task_of(set, trial).get()).kind != TaskKind::object;
}

AskedTexts asked_by(const Stage& stage, const Trial& trial) {
  return asked_texts(stage.set.study, task_of(stage.set, trial).get());
}

bool pictures_are_ready(const Stage& stage, const Trial& trial) {
  const std::vector<Trial> shown = stage.pictures.pictures_of(trial);
  return std::all_of(shown.begin(), shown.end(),
                     [&](const Trial& one) { return stage.pictures.find(one) != nullptr; });
}

std::int64_t next_frame_ns(const DisplayInfo& display) {
  return static_cast<std::int64_t>(1.5e9 / (display.refresh_hz > 0 ? display.refresh_hz : 60));
}

Outcome draw_task_trial(const Session& session, Stage& stage) {
  const std::optional<Trial> due = current_trial(session.trials);
  if (!due) return std::nullopt;
  const TaskTrial trial{stage, trial_place(stage), task_of(stage.set, *due), asked_by(stage, *due)};
  const bool two_eyes = stage.pictures.objects(*due).two_eyes;
  const auto grey = [&]() -> Outcome {
    forget_answer(stage);
    draw_fixation(stage, two_eyes);
    return std::nullopt;
  };
  return std::visit(
      Overloaded{[&](const Grey&) -> Outcome { return grey(); },
                 [&](const Gap& phase) -> Outcome {
                   const std::int64_t since_ns =
                       monotonic_ns() + next_frame_ns(stage.display) - phase.since_ns;
                   if (since_ns >= task_due(session).mask_ns) return grey();
                   show_mask(stage, trial.place, *due, phase.next_picture - 1);
                   return std::nullopt;
                 },
                 [&](const AwaitingImage& phase) -> Outcome {
                   if (!pictures_are_ready(stage, *due)) return grey();
                   forget_answer(stage);
                   show_pictures(stage, trial.place, *due, phase.picture);
                   return std::nullopt;
                 },
                 [&](const Viewing& phase) -> Outcome {
                   show_pictures(stage, trial.place, *due, phase.picture);
                   return std::nullopt;
                 },
                 [&](const Choosing& phase) { return ask(session, trial, *due, phase.onset_ns); },
                 [&](const Rating& phase) { return ask(session, trial, *due, phase.onset_ns); },
                 [](const Storing&) -> Outcome { return std::nullopt; },
                 [](const OnBreak&) -> Outcome { return std::nullopt; },
                 [](const Briefing&) -> Outcome { return std::nullopt; },
                 [](const Done&) -> Outcome { return std::nullopt; }},
      session.phase);
}

void draw_task_feedback(Stage& stage, const TrialPlace& place, const Trial& trial) {
  const int right = std::max(0, trial.right_index - 1);
  show_pictures(stage, place, trial, facts_of(task_of(stage.set, trial).get()).pictures > 1 ? right : 0);
}

std::string name_of_right(const Stage& stage, const Trial& trial, int right_index) {
  constexpr std::array<Phrase, 3> sides = {Phrase::left_object, Phrase::middle_object, Phrase::right_object};
  const std::size_t at = right_index - 1;
  const std::shared_ptr<const TaskDefinition> task = task_of(stage.set, trial);
  return task != nullptr && at < task->answers.size() ? task->answers[at] : stage.phrase(sides.at(at));
}

}  // namespace seamline::study::app
