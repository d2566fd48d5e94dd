#include "study/visit/session.h"

#include "study/trials/level_ladders.h"
#include "support/running/overloaded.h"

namespace seamline::study {
namespace {

/// Where the next picture begins.
Phase before_image(const SessionPace& pace) {
  return pace.inter_trial_ns > 0 ? Phase(Grey{}) : Phase(AwaitingImage{});
}

/// -1: its block has no words of its own.
int briefed_block(const SessionPace& pace, const std::optional<Trial>& trial) {
  return pace.briefed && trial ? pace.briefed->at(trial->stimulus) : -1;
}

Phase after_grey(const Grey& phase, const Event& event, const SessionPace& pace) {
  if (std::holds_alternative<PictureTaken>(event)) return Grey{};
  const auto* tick = std::get_if<Tick>(&event);
  if (tick == nullptr) return phase;
  if (!phase.since_ns) return Grey{.since_ns = tick->now_ns};
  if (tick->now_ns - *phase.since_ns < pace.inter_trial_ns) return phase;
  return AwaitingImage{};
}

Phase after_shown(const AwaitingImage& phase, const Event& event, const SessionTask& task) {
  const auto* shown = std::get_if<ImageShown>(&event);
  if (shown == nullptr) return phase;
  if (task.facts.pictures > 1) return Viewing{.onset_ns = shown->now_ns, .picture = phase.picture};
  if (!task.facts.chooses) return Rating{.onset_ns = shown->now_ns};
  return Choosing{.onset_ns = shown->now_ns};
}

Phase after_viewing(const Viewing& phase, const Event& event, const Session& session) {
  if (std::holds_alternative<PictureTaken>(event)) return before_image(session.pace);
  const SessionTask& task = task_due(session);
  const auto* tick = std::get_if<Tick>(&event);
  if (tick == nullptr || tick->now_ns - phase.onset_ns < task.exposure_ns) return phase;
  if (phase.picture + 1 == task.facts.pictures) return Choosing{.onset_ns = phase.onset_ns};
  return Gap{.since_ns = phase.onset_ns + task.exposure_ns, .next_picture = phase.picture + 1};
}

Phase after_gap(const Gap& phase, const Event& event, const Session& session) {
  if (std::holds_alternative<PictureTaken>(event)) return before_image(session.pace);
  const auto* tick = std::get_if<Tick>(&event);
  if (tick == nullptr || tick->now_ns - phase.since_ns < task_due(session).gap_ns) return phase;
  return AwaitingImage{.picture = phase.next_picture};
}

bool is_choice(const ObjectChosen& chosen, std::int64_t onset_ns, const Session& session) {
  return chosen.index >= 1 && chosen.index <= task_due(session).facts.alternatives &&
         chosen.now_ns >= onset_ns && chosen.now_ns - onset_ns >= session.pace.minimum_viewing_ns;
}

/// A step along the ladder of levels, or the end of a match.
Phase after_step(const Choosing& phase, const ObjectChosen& chosen, const Session& session) {
  const int at = picture_on_screen(session).value().stimulus;
  const auto step = static_cast<MatchStep>(chosen.index);
  const std::int64_t choice_ns = chosen.now_ns - phase.onset_ns;
  if (step == MatchStep::just_seen)
    return Storing{{.trial_index = answered_trials(session.trials),
                    .chosen_index = chosen.index,
                    .rating = 1,
                    .matched = at,
                    .choice_ns = choice_ns,
                    .rating_ns = choice_ns}};
  const std::optional<int> moved_to =
      next_rung(*session.pace.task.ladders, at, step == MatchStep::clearer ? -1 : 1);
  return Choosing{.onset_ns = phase.onset_ns, .moved_to = moved_to.value_or(at)};
}

Phase after_choice(const Choosing& phase, const Event& event, const Session& session) {
  if (std::holds_alternative<PictureTaken>(event)) return before_image(session.pace);
  const auto* chosen = std::get_if<ObjectChosen>(&event);
  if (chosen == nullptr || !is_choice(*chosen, phase.onset_ns, session)) return phase;
  const TaskFacts& task = task_due(session).facts;
  if (task.adjusts()) return after_step(phase, *chosen, session);
  const std::int64_t choice_ns = chosen->now_ns - phase.onset_ns;
  if (task.rates)
    return Rating{.onset_ns = phase.onset_ns, .chosen_index = chosen->index, .choice_ns = choice_ns};
  return Storing{{.trial_index = answered_trials(session.trials),
                  .chosen_index = chosen->index,
                  .rating = 1,
                  .choice_ns = choice_ns,
                  .rating_ns = choice_ns}};
}

/// The answer of a task without a choice: whether anything was seen is the rating's to say.
Phase after_only_rating(const Rating& phase, const Event& event, const Session& session) {
  const auto* given = std::get_if<RatingGiven>(&event);
  if (given == nullptr) return phase;
  const bool slides = task_due(session).facts.slides;
  const int rating = slides ? rating_at(given->position) : given->rating;
  if (slides ? given->position < 0 || given->position > slider_end : rating < 0 || rating > highest_rating)
    return phase;
  const std::int64_t rating_ns = given->now_ns - phase.onset_ns;
  if (rating_ns < session.pace.minimum_viewing_ns) return phase;
  const bool seen = rating > 0;
  return Storing{{.trial_index = answered_trials(session.trials),
                  .chosen_index = seen ? 1 : 2,
                  .rating = seen ? rating : 1,
                  .position = slides ? given->position : -1,
                  .choice_ns = rating_ns,
                  .rating_ns = rating_ns}};
}

Phase after_rating(const Rating& phase, const Event& event, const Session& session) {
  if (std::holds_alternative<PictureTaken>(event)) return before_image(session.pace);
  if (!task_due(session).facts.chooses) return after_only_rating(phase, event, session);
  if (std::holds_alternative<ObjectChosen>(event)) {
    const Phase again = after_choice(Choosing{.onset_ns = phase.onset_ns}, event, session);
    return std::holds_alternative<Rating>(again) ? again : phase;
  }
  const auto* given = std::get_if<RatingGiven>(&event);
  if (given == nullptr || given->rating < 1 || given->rating > highest_rating) return phase;
  const std::int64_t rating_ns = given->now_ns - phase.onset_ns;
  if (rating_ns < phase.choice_ns) return phase;
  return Storing{{.trial_index = answered_trials(session.trials),
                  .chosen_index = phase.chosen_index,
                  .rating = given->rating,
                  .choice_ns = phase.choice_ns,
                  .rating_ns = rating_ns}};
}

Phase next_trial(const Session& session, const std::optional<Trial>& before) {
  const std::optional<Trial> due = current_trial(session.trials);
  if (!due) return Done{};
  const int block = briefed_block(session.pace, due);
  const bool briefs = block >= 0 && block != briefed_block(session.pace, before);
  const int answered = answered_trials(session.trials);
  const int every = session.pace.break_every_trials;
  if (every > 0 && before && answered % every == 0) return OnBreak{.briefing_next = briefs};
  return briefs ? Phase(Briefing{}) : before_image(session.pace);
}

Session after_storing(Session session, const TrialAnswer& answer, const Event& event) {
  if (!std::holds_alternative<AnswerStored>(event)) return session;
  const std::optional<Trial> before = current_trial(session.trials);
  session.trials = after_answer(std::move(session.trials), answer);
  session.phase = next_trial(session, before);
  return session;
}

}  // namespace

Session begin_session(TrialSequence trials, const SessionPace& pace) {
  Session session{.trials = std::move(trials), .pace = pace, .phase = Done{}};
  session.phase = next_trial(session, std::nullopt);
  return session;
}

Session next(Session session, const Event& event) {
  const Phase phase = session.phase;
  const auto with = [&](const Phase& changed) {
    session.phase = changed;
    return std::move(session);
  };
  return std::visit(
      Overloaded{
          [&](const Grey& now) { return with(after_grey(now, event, session.pace)); },
          [&](const AwaitingImage& now) { return with(after_shown(now, event, task_due(session))); },
          [&](const Viewing& now) { return with(after_viewing(now, event, session)); },
          [&](const Gap& now) { return with(after_gap(now, event, session)); },
          [&](const Choosing& now) { return with(after_choice(now, event, session)); },
          [&](const Rating& now) { return with(after_rating(now, event, session)); },
          [&](const Storing& now) { return after_storing(std::move(session), now.answer, event); },
          [&](const OnBreak& now) {
            if (!std::holds_alternative<BreakEnded>(event)) return with(now);
            return with(now.briefing_next ? Phase(Briefing{}) : before_image(session.pace));
          },
          [&](const Briefing& now) {
            return with(std::holds_alternative<BreakEnded>(event) ? before_image(session.pace) : Phase(now));
          },
          [&](const Done& now) { return with(now); },
      },
      phase);
}

const SessionTask& task_due(const Session& session) {
  if (!session.pace.own_tasks) return session.pace.task;
  const std::optional<Trial> due = current_trial(session.trials);
  return due ? session.pace.own_tasks->at(due->stimulus) : session.pace.task;
}

std::optional<Trial> picture_on_screen(const Session& session) {
  std::optional<Trial> due = current_trial(session.trials);
  const auto* choosing = std::get_if<Choosing>(&session.phase);
  if (due && choosing != nullptr && choosing->moved_to >= 0) due->stimulus = choosing->moved_to;
  return due;
}

bool is_picture_seen(const SessionTask& task, std::int64_t onset_ns, std::int64_t now_ns) {
  return task.facts.pictures == 1 && (task.exposure_ns == 0 || now_ns - onset_ns < task.exposure_ns);
}

bool is_mask_seen(const SessionTask& task, std::int64_t onset_ns, std::int64_t now_ns) {
  const std::int64_t since_ns = now_ns - onset_ns - task.exposure_ns;
  return task.exposure_ns > 0 && since_ns >= 0 && since_ns < task.mask_ns;
}

}  // namespace seamline::study
