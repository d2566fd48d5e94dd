#pragma once
#include <gtest/gtest.h>

#include "scripted_person.h"
#include "study/visit/visit.h"

/// A visit of a few trials, stored nowhere.
namespace seamline::study {

inline constexpr std::int64_t second = ScriptedPerson::second;

inline VisitScript script() {
  return {.form = default_form(),
          .instruction_pages = 2,
          .training = {{TrialKind::stimulus, 3}, {TrialKind::stimulus, 5}},
          .training_right = {1, 2},
          .pace = {.break_every_trials = 3, .minimum_viewing_ns = second / 2, .inter_trial_ns = second / 2}};
}

inline std::shared_ptr<const VisitScript> shared(const VisitScript& script) {
  return std::make_shared<const VisitScript>(script);
}

inline TrialSequence trials(int count, int answered = 0) {
  ConstantProcedure procedure{.order = {}, .answered = answered};
  for (int i = 0; i < count; ++i) procedure.order.push_back(10 + i);
  return {.procedure = procedure};
}

template <class Wanted>
bool on(const Visit& visit) {
  return std::holds_alternative<Wanted>(visit.screen);
}

inline Visit after(Visit visit, const std::vector<VisitEvent>& events) {
  for (const VisitEvent& event : events) visit = next(std::move(visit), event);
  return visit;
}

/// Stores whatever is pending, without a log.
inline Visit stored(Visit visit, int trial_count = 7) {
  while (visit.pending)
    visit = std::holds_alternative<ConsentRecord>(*visit.pending)
                ? next(std::move(visit), Enrolled{trials(trial_count)})
                : next(std::move(visit), RecordStored{});
  return visit;
}

/// A sensible person until the screen is the wanted one.
template <class Wanted>
Visit until(Visit visit, ScriptedPerson person = ScriptedPerson(1)) {
  for (int i = 0; i < 10000 && !on<Wanted>(visit); ++i)
    visit = stored(next(std::move(visit), person.act(visit)));
  EXPECT_TRUE(on<Wanted>(visit));
  return visit;
}

}  // namespace seamline::study
