#include "study/session.h"

#include "study/overloaded.h"

namespace seamline {
namespace {

Phase after_shown(const AwaitingImage& phase, const Event& event) {
  if (const auto* shown = std::get_if<ImageShown>(&event)) return Choosing{.onset_ns = shown->now_ns};
  return phase;
}

bool is_choice(const ObjectChosen& chosen, std::int64_t onset_ns) {
  return chosen.index >= 1 && chosen.index <= objects_per_stimulus && chosen.now_ns >= onset_ns;
}

Phase after_choice(const Choosing& phase, const Event& event) {
  const auto* chosen = std::get_if<ObjectChosen>(&event);
  if (chosen == nullptr || !is_choice(*chosen, phase.onset_ns)) return phase;
  return Rating{.onset_ns = phase.onset_ns,
                .chosen_index = chosen->index,
                .choice_ns = chosen->now_ns - phase.onset_ns};
}

Phase after_rating(const Rating& phase, const Event& event, int trial_index) {
  if (std::holds_alternative<ObjectChosen>(event)) {
    const Phase again = after_choice(Choosing{.onset_ns = phase.onset_ns}, event);
    return std::holds_alternative<Rating>(again) ? again : phase;
  }
  const auto* given = std::get_if<RatingGiven>(&event);
  if (given == nullptr || given->rating < 1 || given->rating > highest_rating) return phase;
  const std::int64_t rating_ns = given->now_ns - phase.onset_ns;
  if (rating_ns < phase.choice_ns) return phase;
  return Storing{{.trial_index = trial_index,
                  .chosen_index = phase.chosen_index,
                  .rating = given->rating,
                  .choice_ns = phase.choice_ns,
                  .rating_ns = rating_ns}};
}

Phase next_trial(const Session& session) {
  if (!current_stimulus(session.procedure)) return Done{};
  const int answered = answered_trials(session.procedure);
  if (session.break_every_trials > 0 && answered % session.break_every_trials == 0) return OnBreak{};
  return AwaitingImage{};
}

Session after_storing(Session session, const TrialAnswer& answer, const Event& event) {
  if (!std::holds_alternative<AnswerStored>(event)) return session;
  session.procedure = after_answer(std::move(session.procedure), answer);
  session.phase = next_trial(session);
  return session;
}

}  // namespace

Session begin_session(Procedure procedure, int break_every_trials) {
  const bool over = !current_stimulus(procedure);
  return {.procedure = std::move(procedure),
          .break_every_trials = break_every_trials,
          .phase = over ? Phase(Done{}) : Phase(AwaitingImage{})};
}

Session next(Session session, const Event& event) {
  const Phase phase = session.phase;
  const auto with = [&](const Phase& changed) {
    session.phase = changed;
    return std::move(session);
  };
  return std::visit(
      Overloaded{
          [&](const AwaitingImage& now) { return with(after_shown(now, event)); },
          [&](const Choosing& now) { return with(after_choice(now, event)); },
          [&](const Rating& now) {
            return with(after_rating(now, event, answered_trials(session.procedure)));
          },
          [&](const Storing& now) { return after_storing(std::move(session), now.answer, event); },
          [&](const OnBreak& now) {
            return with(std::holds_alternative<BreakEnded>(event) ? Phase(AwaitingImage{}) : Phase(now));
          },
          [&](const Done& now) { return with(now); },
      },
      phase);
}

}  // namespace seamline
