#pragma once
#include "study/running/simulation.h"
#include "tests/analysis/threshold_people.h"
#include "tests/study/temporary_set.h"

namespace seamline::test {
using namespace study;

/// The same answers as if people had given them: nobody is simulated, and a choice takes between 1 and 4 s,
/// the rating 1 s more.
inline LogContents people_log(int people, std::uint64_t seed) {
  LogContents log = simulate_log(people, seed);
  for (ParticipantRecord& record : log.participants) {
    record.simulated = false;
    record.observer.clear();
    record.stimulus_trials = 84;
  }
  Random random(seed, 1000);
  for (Answer& answer : log.answers) {
    answer.choice_ns = 1'000'000'000 + static_cast<std::int64_t>(random.below(3'000'000'000));
    answer.rating_ns = answer.choice_ns + 1'000'000'000;
  }
  return log;
}

/// The log of three simulated observers of an adaptive study of one scene.
inline LogContents adaptive_log() {
  const TemporaryFolder folder;
  std::string text = study_text("adaptive", "64, 128, 256, 512, 1024");
  text.insert(text.find("seed ="), "procedure = \"quest_plus\"\n");
  text.insert(text.find("[session]"), "[quest_plus]\nmax_shows_per_image = 20\nmax_trials = 90\n");
  (void)write_set_of_text(folder / "set", text);
  run_simulated_study({.set_folder = folder / "set", .log = folder / "log", .count = 3});
  return read_log(folder / "log");
}

}  // namespace seamline::test
