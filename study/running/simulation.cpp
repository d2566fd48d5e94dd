#include "study/running/simulation.h"

#include <fmt/core.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <memory>

#include "study/log/log_writer.h"
#include "study/running/participant_session.h"
#include "study/trials/level_ladders.h"
#include "study/trials/rendered_set.h"
#include "study/trials/stimulus_order.h"
#include "study/visit/session.h"
#include "support/arithmetic/random.h"
#include "support/running/interrupt.h"

namespace seamline::study {
namespace {

constexpr std::uint64_t person_salt =
    0x70656f706c65;  // "people": apart from the order's and the renderer's numbers
constexpr int participants_a_transaction = 25;

/// Seed of one simulated person. Stream 0 makes the person, stream t + 1 answers trial t, so that an answer
/// does not depend on how the participant's trials were spread over sessions.
std::uint64_t person_seed(std::uint64_t simulation_seed, int number) {
  return mix_bits(mix_bits(simulation_seed ^ person_salt) + number);
}

struct SimulatedPerson {
  std::uint64_t seed = 0;
  Observer observer;
};

using SharedDifferences = std::shared_ptr<const VisibleDifferences>;

/// What `image` observers look at, once for all of them; none for the other kinds.
SharedDifferences look_at_pictures(const SimulationRequest& request, const RenderedSet& set) {
  if (request.observer != ObserverKind::image) return nullptr;
  require_image_gain(set.study.observer);
  return std::make_shared<const VisibleDifferences>(
      visible_differences(set.folder, set.manifest, set.study.observer.pixels_per_degree));
}

SimulatedPerson make_person(const SimulationRequest& request, const RenderedSet& set,
                            const SharedDifferences& differences, int number) {
  const std::uint64_t seed = person_seed(request.seed, number);
  Random random(seed, 0);
  return {.seed = seed, .observer = make_observer(request.observer, set.study.observer, random, differences)};
}

Response answer_of(const SimulatedPerson& person, const RenderedSet& set, const Session& session) {
  const Trial trial = current_trial(session.trials).value();
  Random random(person.seed, 1 + static_cast<std::uint64_t>(answered_trials(session.trials)));
  const Stimulus& stimulus = set.manifest.stimuli[trial.stimulus].stimulus;
  const Alternatives alternatives =
      alternatives_of(facts_of(task_of(set, trial).get()), trial, stimulus.object_index);
  switch (trial.kind) {
    case TrialKind::stimulus:
      return respond(person.observer, stimulus, alternatives, random);
    case TrialKind::attention:
      return respond_to_attention(person.observer, alternatives, random);
    case TrialKind::reference:
      return respond_to_reference(alternatives, random);
    case TrialKind::mask:
      break;  // no trial
  }
  return {};
}

/// Steps to the level at which the person stops, in as many presses as there are levels between.
Session run_match(Session session, const SimulatedPerson& person, const RenderedSet& set) {
  const Trial trial = current_trial(session.trials).value();
  Random random(person.seed, 1 + static_cast<std::uint64_t>(answered_trials(session.trials)));
  const LevelLadders& ladders = *session.pace.task.ladders;
  std::vector<Stimulus> ladder;
  for (const Trial& picture : pictures_of_ladder(ladders, trial))
    ladder.push_back(set.manifest.stimuli[picture.stimulus].stimulus);
  const int stop = static_cast<int>(matched_rung(person.observer, ladder, random));
  const int start = ladders.places[trial.stimulus].rung;
  const MatchStep step = stop < start ? MatchStep::clearer : MatchStep::fainter;
  session = next(std::move(session), ImageShown{});
  for (int moved = 0; moved < std::abs(stop - start); ++moved)
    session = next(std::move(session), ObjectChosen{.index = static_cast<int>(step)});
  return next(std::move(session), ObjectChosen{.index = static_cast<int>(MatchStep::just_seen)});
}

/// Where a slider stops in the fifth of a rating: anywhere in it, by numbers of its own.
int place_in_fifth(const SimulatedPerson& person, const Session& session, int rating) {
  constexpr std::uint64_t slider_salt = 0x736c69646572;  // "slider"
  Random random(mix_bits(person.seed ^ slider_salt),
                static_cast<std::uint64_t>(answered_trials(session.trials)));
  constexpr int fifth = slider_end / 5;
  return rating * fifth + static_cast<int>(random.below(rating == highest_rating ? fifth + 1 : fifth));
}

/// One picture or several, from the first onset to the answer.
Session run_choice(Session session, const SimulatedPerson& person, const RenderedSet& set) {
  const Response response = answer_of(person, set, session);
  const TaskFacts task = task_due(session).facts;
  for (int picture = 0; picture < task.pictures; ++picture) {
    session = next(std::move(session), ImageShown{});
    for (int ticks = 0; ticks < 2; ++ticks) session = next(std::move(session), Tick{});  // viewing, gap
  }
  if (task.chooses) session = next(std::move(session), ObjectChosen{.index = response.chosen_index});
  const bool nothing_seen = !task.chooses && response.chosen_index != 1;
  const int rating = nothing_seen ? 0 : response.rating;
  return next(
      std::move(session),
      RatingGiven{.rating = rating, .position = task.slides ? place_in_fifth(person, session, rating) : -1});
}

/// One trial from the first image to the stored answer, in no time at all.
Session run_trial(Session session, const SimulatedPerson& person, const RenderedSet& set,
                  const std::function<void(const TrialAnswer&)>& store) {
  session = session.pace.task.facts.adjusts() ? run_match(std::move(session), person, set)
                                              : run_choice(std::move(session), person, set);
  store(std::get<Storing>(session.phase).answer);
  session = next(std::move(session), AnswerStored{});
  return next(std::move(session), BreakEnded{});
}

/// Without exposures: nobody waits for them.
OwnSessionTasks own_session_tasks(const TrialRules& rules) {
  if (!rules.own_tasks) return nullptr;
  std::vector<SessionTask> tasks;
  for (const TaskFacts& facts : *rules.own_tasks) tasks.push_back({.facts = facts});
  return std::make_shared<const std::vector<SessionTask>>(std::move(tasks));
}

/// Runs a participant to the end; returns how many tracks lean on the edge of their grid.
int run_participant(LogWriter& log, OpenSession& place, const RenderedSet& set, const TrialRules& rules,
                    const SimulatedPerson& person) {
  Session session = begin_session(open_trials(rules, log, place),
                                  {.break_every_trials = set.study.session.break_every_trials,
                                   .task = {.facts = rules.task, .ladders = rules.ladders},
                                   .own_tasks = own_session_tasks(rules)});
  while (!std::holds_alternative<Done>(session.phase)) {
    store_due_trial(session.trials, log, place);
    session = run_trial(std::move(session), person, set,
                        [&](const TrialAnswer& answer) { log.append_answer(place, answer); });
  }
  const int tracks_on_edge = store_edge_alarms(session.trials.procedure, log, place, 0);
  log.complete(place);
  return tracks_on_edge;
}

/// What all simulated people of a run share.
struct StudyOfObservers {
  const SimulationRequest& request;
  RenderedSet set;
  TrialRules rules;
  SharedDifferences differences;
};

/// What the log keeps of the gain: that of the observers that have one, wherever it comes from.
std::optional<double> gain_of(const StudyOfObservers& study) {
  return study.request.observer == ObserverKind::image ? study.set.study.observer.image_gain : std::nullopt;
}

void simulate(LogWriter& log, const StudyOfObservers& study, int number, SimulationSummary& summary) {
  const SimulationRequest& request = study.request;
  OpenSession place =
      log.open_session({.code = fmt::format("sim-{:04}", number),
                        .simulated = Simulated{request.observer, request.seed, gain_of(study)},
                        .slot = slot_in_turn(study.set.study.session.orders, number - 1)});
  const bool complete = place.completed || place.excluded;
  ++(complete ? summary.participants_complete : summary.participants_run);
  if (complete) return;
  const int before = place.answered;
  summary.tracks_on_edge += run_participant(log, place, study.set, study.rules,
                                            make_person(request, study.set, study.differences, number));
  summary.answers_added += place.answered - before;
}

}  // namespace

SimulationSummary run_simulated_study(const SimulationRequest& request) {
  assert(request.count >= 1);
  StudyOfObservers study{
      .request = request, .set = load_rendered_set(request.set_folder), .rules = {}, .differences = {}};
  study.rules = make_trial_rules(study.set);
  if (request.image_gain) study.set.study.observer.image_gain = request.image_gain;
  study.differences = look_at_pictures(request, study.set);
  LogWriter log(request.log, study.set);
  log.take_observer(study.set);
  SimulationSummary summary;
  for (int first = 1; first <= request.count; first += participants_a_transaction) {
    if (interrupted()) throw Interrupted{};
    const int last = std::min(request.count, first + participants_a_transaction - 1);
    log.transaction([&] {
      for (int number = first; number <= last; ++number) simulate(log, study, number, summary);
    });
  }
  return summary;
}

}  // namespace seamline::study
