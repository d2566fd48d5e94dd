#include "study/simulation.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>

#include "stimuli/support/interrupt.h"
#include "stimuli/support/random.h"
#include "study/log_writer.h"
#include "study/plan.h"
#include "study/session.h"
#include "study/study_set.h"

namespace seamline {
namespace {

constexpr std::uint64_t person_salt =
    0x70656f706c65;  // "people": apart from the plan's and the renderer's numbers
constexpr int participants_a_transaction = 25;

/// Seed of one simulated person. Stream 0 makes the person, stream t + 1 answers trial t, so that an answer
/// does not depend on how the participant's trials were spread over sessions.
std::uint64_t person_seed(std::uint64_t simulation_seed, int number) {
  return mix_bits(mix_bits(simulation_seed ^ person_salt) + static_cast<std::uint64_t>(number));
}

struct SimulatedPerson {
  std::uint64_t seed = 0;
  Observer observer;
};

SimulatedPerson make_person(const SimulationRequest& request, const StudySet& set, int number) {
  const std::uint64_t seed = person_seed(request.seed, number);
  Random random(seed, 0);
  return {.seed = seed, .observer = make_observer(request.observer, set.study.observer, random)};
}

Response answer_of(const SimulatedPerson& person, const StudySet& set, const Session& session) {
  const int stimulus = current_stimulus(session.procedure).value();
  Random random(person.seed, 1 + static_cast<std::uint64_t>(answered_trials(session.procedure)));
  return respond(person.observer, set.manifest.stimuli[static_cast<std::size_t>(stimulus)].stimulus, random);
}

/// One trial from the image to the stored answer, all at time 0.
Session run_trial(Session session, const SimulatedPerson& person, const StudySet& set,
                  const std::function<void(const TrialAnswer&)>& store) {
  const Response response = answer_of(person, set, session);
  session = next(std::move(session), ImageShown{});
  session = next(std::move(session), ObjectChosen{.index = response.chosen_index});
  session = next(std::move(session), RatingGiven{.rating = response.rating});
  store(std::get<Storing>(session.phase).answer);
  session = next(std::move(session), AnswerStored{});
  return next(std::move(session), BreakEnded{});
}

void run_participant(LogWriter& log, OpenSession& place, const StudySet& set, const SimulatedPerson& person) {
  if (place.planned.empty())
    log.plan_trials(place, plan_order(static_cast<int>(set.manifest.stimuli.size()),
                                      {.study_seed = set.study.seed, .slot = place.slot}));
  Session session = begin_session(ConstantProcedure{.order = place.planned, .answered = place.answered},
                                  set.study.session.break_every_trials);
  while (!std::holds_alternative<Done>(session.phase))
    session = run_trial(std::move(session), person, set,
                        [&](const TrialAnswer& answer) { log.append_answer(place, answer); });
  log.complete(place);
}

/// Answers added; none when the participant had already finished.
std::optional<int> simulate(LogWriter& log, const SimulationRequest& request, const StudySet& set,
                            int number) {
  OpenSession place = log.open_session({.code = fmt::format("sim-{:04}", number),
                                        .simulated = Simulated{request.observer, request.seed},
                                        .slot = number - 1});
  if (place.completed || place.excluded) return std::nullopt;
  const int before = place.answered;
  run_participant(log, place, set, make_person(request, set, number));
  return place.answered - before;
}

}  // namespace

SimulationSummary run_simulated_study(const SimulationRequest& request) {
  assert(request.count >= 1);
  const StudySet set = load_study_set(request.set_folder);
  LogWriter log(request.log, set);
  SimulationSummary summary;
  for (int first = 1; first <= request.count; first += participants_a_transaction) {
    if (interrupted()) throw Interrupted{};
    const int last = std::min(request.count, first + participants_a_transaction - 1);
    log.transaction([&] {
      for (int number = first; number <= last; ++number) {
        const std::optional<int> added = simulate(log, request, set, number);
        ++(added ? summary.participants_run : summary.participants_complete);
        summary.answers_added += added.value_or(0);
      }
    });
  }
  return summary;
}

}  // namespace seamline
