#include "study/app/application.h"

#include <fmt/core.h>

#include <algorithm>

#include "study/app/screens/instruction_pictures.h"
#include "study/app/screens/screen_names.h"
#include "study/app/screens/screen_task.h"
#include "support/running/interrupt.h"
#include "support/text/error.h"
#include "window/look.h"

namespace seamline::study::app {
namespace {

constexpr double longest_wait_s = 0.25;             ///< after which Ctrl-C in the terminal is seen
constexpr std::int64_t decoding_wait_ns = 2000000;  ///< between looks at a picture that is being decoded
constexpr int most_layouts = 4;
constexpr std::int64_t longest_clip_ns = 3'600'000'000'000;  ///< after which nothing changes by itself

bool is_awaiting(const Session* session) {
  return session != nullptr && std::holds_alternative<AwaitingImage>(session->phase);
}

/// When the picture came that people look at; none where none is on the screen.
std::optional<std::int64_t> onset_of(const Session* session) {
  if (session == nullptr) return std::nullopt;
  if (const auto* choosing = std::get_if<Choosing>(&session->phase)) return choosing->onset_ns;
  if (const auto* rating = std::get_if<Rating>(&session->phase)) return rating->onset_ns;
  return std::nullopt;
}

/// Trials of the practice or the study that is on the screen; -1: neither is.
int answered_on_screen(const Visit& visit) {
  const Session* session = session_on_screen(visit);
  return session == nullptr ? -1 : answered_trials(session->trials);
}

bool is_timed(const Session& session) {
  return std::holds_alternative<Viewing>(session.phase) || std::holds_alternative<Gap>(session.phase);
}

/// When the picture, or the mask after it, that is on the screen while the answer is awaited is taken away;
/// 0: it is not.
std::int64_t exposure_end_ns(const Session& session, const Stage& stage) {
  const SessionTask& task = task_due(session);
  const std::optional<std::int64_t> onset_ns = onset_of(&session);
  if (task.exposure_ns == 0 || !onset_ns) return 0;
  return *onset_ns + task.exposure_ns + (stage.mask_seen ? task.mask_ns : 0);
}

}  // namespace

void Application::run() {
  visit_ = store_.begin();
  try {
    while (!stage_.leave && !stage_.close) run_frame();
  } catch (const Interrupted&) {
    visit_ = store_.flush(std::move(visit_));
    throw;
  }
  visit_ = store_.flush(std::move(visit_));
  if (const auto* stopped = std::get_if<StoppedScreen>(&visit_.screen)) throw InputError(stopped->message);
}

void Application::run_frame() {
  wait_for_input();
  stop_if_interrupted();
  const std::int64_t begun_ns = monotonic_ns();
  if (!frame_is_due(begun_ns)) return;
  due_ns_.reset();
  note_window_events();
  if (const Session* session = session_on_screen(visit_); session != nullptr)
    if (const auto* grey = std::get_if<Grey>(&session->phase); grey != nullptr && grey->since_ns)
      step(Event(Tick{begun_ns}));
  if (handle_pause()) return;
  if (std::holds_alternative<DisplayScreen>(visit_.screen))
    if (const std::optional<DisplayProfile> known = known_display())
      return step(DisplayConfirmed{display_facts(stage_, *known)});
  if (stage_.text_scale != type_scale_) set_type();
  prepare_pictures(begun_ns);

  stage_.panorama.reset();
  stage_.picture_seen.reset();
  stage_.mask_seen.reset();
  ui_.begin(stage_.input, stage_.screen_px);
  const Outcome outcome =
      std::visit([&](const auto& screen) { return draw(screen, visit_, stage_); }, visit_.screen);
  ui_.end();
  const bool lay_out_again = ui_.changed() && ++layouts_ < most_layouts;
  if (outcome || lay_out_again || stage_.text_scale != type_scale_) {
    canvas_.discard();
    if (outcome) step(*outcome);
    due_ns_ = 0;
    return;
  }
  layouts_ = 0;
  show_frame(begun_ns);
}

void Application::wait_for_input() {
  double wait_s = longest_wait_s;
  if (due_ns_)
    wait_s = std::clamp(static_cast<double>(*due_ns_ - monotonic_ns()) * 1e-9, 0.0, longest_wait_s);
  stage_.input = window_.next_input(wait_s);
}

bool Application::frame_is_due(std::int64_t now_ns) const {
  return stage_.input.anything || (due_ns_ && now_ns >= *due_ns_);
}

void Application::note(const char* kind, std::int64_t now_ns, std::string detail) {
  RawEvent event{.monotonic_ns = now_ns, .kind = kind, .detail = std::move(detail), .swap = swap_};
  if (std::holds_alternative<TrialScreen>(visit_.screen))
    event.trial_index = answered_trials(visit_.session.trials);
  store_.note(std::move(event));
}

void Application::note_window_events() {
  const FrameInput& input = stage_.input;
  if (input.focus) note(input.focus->focused ? "focus_gained" : "focus_lost", input.focus->now_ns);
  if (!input.resized) return;
  display_ = window_.display();
  stage_.screen_px = window_.framebuffer_px();
  note("resize", input.now_ns,
       fmt::format("{}x{}", display_.framebuffer_width_px, display_.framebuffer_height_px));
  try {
    check_screen();
  } catch (const InputError& error) {
    step(StoreFailed{error.what()});
  }
}

/// What was pressed, when the visit took it.
void Application::note_answer(const VisitEvent& event) {
  const auto* inner = std::get_if<Event>(&event);
  if (inner == nullptr) return;
  const std::string practice = std::holds_alternative<TrainingScreen>(visit_.screen) ? "practice " : "";
  if (const auto* chosen = std::get_if<ObjectChosen>(inner))
    note("choice", chosen->now_ns, fmt::format("{}{}", practice, chosen->index));
  const Session* session = session_on_screen(visit_);
  const bool ends =
      std::holds_alternative<RatingGiven>(*inner) ||
      (std::holds_alternative<ObjectChosen>(*inner) && session != nullptr && !task_due(*session).facts.rates);
  if (ends) note_poses(monotonic_ns());
  if (const auto* given = std::get_if<RatingGiven>(inner))
    note("rating", given->now_ns,
         fmt::format("{}{}", practice, given->position >= 0 ? given->position : given->rating));
  if (const ClipPlayer* clip = pictures_.clip(); clip != nullptr && ends)
    note("clip", monotonic_ns(),
         fmt::format("{}shown {} late {} dropped {}", practice, clip->showing().shown, clip->showing().late,
                     clip->showing().dropped));
}

/// Where the person looked in the trial that is answered; stored before its answer.
void Application::note_poses(std::int64_t now_ns) {
  for (std::string& poses : stage_.looking.poses.take())
    if (std::holds_alternative<TrialScreen>(visit_.screen)) note("look", now_ns, std::move(poses));
}

void Application::step(const VisitEvent& event) {
  if (stage_.comfort)
    note("comfort", monotonic_ns(),
         fmt::format("{} {}", *stage_.comfort, answered_trials(visit_.session.trials)));
  stage_.comfort.reset();
  note_answer(event);
  if (const auto* confirmed = std::get_if<DisplayConfirmed>(&event)) keep_display(confirmed->facts);
  const std::string before = screen_name(visit_.screen);
  const bool awaited = is_awaiting(session_on_screen(visit_));
  const int page = std::holds_alternative<InstructionScreen>(visit_.screen)
                       ? std::get<InstructionScreen>(visit_.screen).page
                       : -1;
  const int answered = answered_on_screen(visit_);
  visit_ = store_.step(std::move(visit_), event);
  if (answered_on_screen(visit_) != answered) {
    exposures_.forget();
    masks_.forget();
  }
  const auto* instructions = std::get_if<InstructionScreen>(&visit_.screen);
  if (screen_name(visit_.screen) != before || (instructions != nullptr && instructions->page != page))
    ui_.reset();
  if (!awaited && is_awaiting(session_on_screen(visit_))) turn_ns_ = monotonic_ns();
  due_ns_ = 0;
}

/// Esc, and closing the window, ask for a pause where there can be one. Returns whether the frame is over.
bool Application::handle_pause() {
  const FrameInput& input = stage_.input;
  const bool asked = input.close || input.pressed(Key::escape);
  if (!asked) return false;
  if (is_pausable(visit_.screen)) {
    note("pause", input.now_ns);
    step(PauseBegun{});
    return true;
  }
  if (input.close) stage_.leave = true;
  return input.close;
}

void Application::prepare_pictures(std::int64_t now_ns) {
  const std::optional<Trial> due = trial_on_screen(visit_);
  if (!due) return;
  const Session* session = session_on_screen(visit_);
  const std::optional<std::int64_t> onset_ns = onset_of(session);
  if (!onset_ns) pictures_.end_clip();
  try {
    pictures_.prepare(*due, session == nullptr ? std::nullopt : trial_after_current(session->trials));
    if (onset_ns) pictures_.play(*due, now_ns - *onset_ns);
  } catch (const InputError& error) {
    step(StoreFailed{error.what()});
  }
}

void Application::show_frame(std::int64_t begun_ns) {
  const Session* session = session_on_screen(visit_);
  const bool first_of_picture =
      is_awaiting(session) && pictures_are_ready(stage_, current_trial(session->trials).value());
  window_.clear(look::background);
  if (const auto& shown = stage_.panorama)
    panorama_view_.draw(*shown->panorama, shown->rect, stage_.screen_px, shown->pose);
  canvas_.end();
  const std::int64_t shown_ns = window_.show();
  const double period_ns = 1e9 / (display_.refresh_hz > 0 ? display_.refresh_hz : 60);
  const bool late = shown_ns - begun_ns > 1.5 * period_ns;
  store_.count_frames({.shown = 1, .late = late ? 1 : 0});
  std::string screen = screen_name(visit_.screen);
  if (session != nullptr) screen += "/" + phase_name(session->phase);
  frame_times_.add({.swap = swap_,
                    .screen = std::move(screen),
                    .begun_ns = begun_ns,
                    .shown_ns = shown_ns,
                    .late = late,
                    .turn_ns = first_of_picture ? turn_ns_ : std::nullopt});
  if (ClipPlayer* clip = pictures_.clip(); clip != nullptr)
    if (const auto onset_ns = onset_of(session))
      clip->note_shown(shown_ns - *onset_ns, static_cast<std::int64_t>(period_ns));
  trace_.shown(visit_, stage_);
  note_exposure(session, shown_ns, static_cast<std::int64_t>(period_ns));
  if (first_of_picture) {
    note("shown", shown_ns, std::holds_alternative<TrainingScreen>(visit_.screen) ? "practice" : "");
    step(Event(ImageShown{shown_ns}));
  } else if (session != nullptr && is_timed(*session)) {
    step(Event(Tick{shown_ns + next_frame_ns(display_)}));
  } else if (session != nullptr && std::holds_alternative<Grey>(session->phase)) {
    step(Event(Tick{shown_ns}));
  }
  ++swap_;
  plan_next_frame(begun_ns, shown_ns);
}

/// Of a task that limits exposures: how long a picture stood that this frame took away.
void Application::note_exposure(const Session* session, std::int64_t shown_ns, std::int64_t period_ns) {
  if (session == nullptr || std::holds_alternative<Grey>(session->phase)) {
    exposures_.forget();
    return masks_.forget();
  }
  const SessionTask& task = task_due(*session);
  if (task.exposure_ns == 0) return;
  const std::string practice = std::holds_alternative<TrainingScreen>(visit_.screen) ? "practice " : "";
  if (const auto ended = exposures_.note_shown(stage_.picture_seen, shown_ns, task.exposure_ns, period_ns))
    note("exposure", shown_ns, practice + text_of(*ended));
  if (task.mask_ns == 0) return;
  if (const auto ended = masks_.note_shown(stage_.mask_seen, shown_ns, task.mask_ns, period_ns))
    note("mask", shown_ns, practice + text_of(*ended));
}

/// When something changes by itself: after what a frame that began at `begun_ns` could know.
void Application::plan_next_frame(std::int64_t begun_ns, std::int64_t shown_ns) {
  const Session* session = session_on_screen(visit_);
  if (session == nullptr) return;
  if (const auto* grey = std::get_if<Grey>(&session->phase); grey != nullptr && grey->since_ns)
    due_ns_ = *grey->since_ns + session->pace.inter_trial_ns;
  if (is_awaiting(session)) due_ns_ = shown_ns + decoding_wait_ns;
  if (is_timed(*session)) due_ns_ = shown_ns;  // every frame, so that exposures are whole numbers of them
  if (const auto* choosing = std::get_if<Choosing>(&session->phase)) {
    const std::int64_t open_ns = choosing->onset_ns + session->pace.minimum_viewing_ns;
    if (open_ns > begun_ns) due_ns_ = open_ns;
  }
  const std::int64_t end_ns = exposure_end_ns(*session, stage_);
  if (end_ns > shown_ns && (!due_ns_ || *due_ns_ > end_ns)) due_ns_ = end_ns - next_frame_ns(display_);
  const ClipPlayer* clip = pictures_.clip();
  const std::optional<std::int64_t> onset_ns = onset_of(session);
  if (!onset_ns || !set_.study.clip) return;
  const std::int64_t frame_ns =
      *onset_ns + (clip != nullptr ? clip->next_due_ns().value_or(longest_clip_ns) : 0);
  due_ns_ = std::min(due_ns_.value_or(frame_ns), frame_ns);
}

}  // namespace seamline::study::app
