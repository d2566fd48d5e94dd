#pragma once
#include <string>
#include <vector>

#include "tests/analysis/guessing_people.h"

namespace seamline::test {

/// A study of 20 good raters, to which `random` people are added who look at nothing.
inline LogContents with_random_raters(const GuessingStudy& study, int random_people, std::uint64_t seed) {
  LogContents log = simulate_guessing(study, seed).log;
  const std::vector<Answer> first(log.answers.begin(), log.answers.begin() + 84);
  for (int p = 0; p < random_people; ++p) {
    Random random(mix_bits(seed), 1000 + static_cast<std::uint64_t>(p));
    const std::string code = "random" + std::to_string(p);
    log.participants.push_back(person(code));
    for (Answer answer : first) {
      answer.participant = code;
      answer.chosen_index = 1 + static_cast<int>(random.below(3));
      answer.rating = 1 + static_cast<int>(random.below(4));
      log.answers.push_back(answer);
    }
  }
  return log;
}

/// Thresholds differ by 0.8 octave SD, and everybody has their own criterion for high ratings.
inline GuessingStudy people_who_differ() {
  GuessingStudy study;
  study.population.observer.people_sd_octaves = 0.8;
  study.population.rating_sd_octaves = 0.5;
  return study;
}

}  // namespace seamline::test
