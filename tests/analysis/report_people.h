#pragma once
#include "tests/analysis/threshold_people.h"

namespace seamline::testing {

/// The same answers as if people had given them: nobody is simulated, and a choice takes between 1 and 4 s,
/// the rating 1 s more.
inline LogContents people_log(int people, std::uint64_t seed) {
  LogContents log = simulate_log(people, seed);
  for (ParticipantRecord& record : log.participants) {
    record.simulated = false;
    record.observer.clear();
    record.planned_trials = 84;
  }
  Random random(seed, 1000);
  for (Answer& answer : log.answers) {
    answer.choice_ns = 1'000'000'000 + static_cast<std::int64_t>(random.below(3'000'000'000));
    answer.rating_ns = answer.choice_ns + 1'000'000'000;
  }
  return log;
}

}  // namespace seamline::testing
