#pragma once
#include <array>
#include <string>

#include "analysis/thresholds/guess_correction.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::test {
using namespace analysis;

/// What simulated people do when they see nothing.
struct GuessingHabits {
  std::array<double, 3> position = {0.5, 0.3, 0.2};
  std::array<double, 4> rating = {0.7, 0.2, 0.1, 0};
};

/// A simulated log of which the truth is known, trial by trial.
struct GuessingLog {
  LogContents log;
  std::vector<bool> seen;  ///< one an answer
  std::vector<ReferenceAnswer> references;
};

inline int draw(const auto& probability, Random& random) {
  double u = random.uniform();
  for (std::size_t i = 0; i + 1 < probability.size(); ++i) {
    if (u < probability[i]) return static_cast<int>(i) + 1;
    u -= probability[i];
  }
  return static_cast<int>(probability.size());
}

/// People of `population` who guess by `habits`: four artifacts x three objects x seven widths each, and
/// `references` reference trials. `object_shift_octaves` moves the threshold of the right-hand object up and
/// that of the left-hand one down.
struct GuessingStudy {
  Population population;
  GuessingHabits habits;
  int people = 20;
  int references = 0;
  double object_shift_octaves = 0;
};

inline GuessingLog simulate_guessing(const GuessingStudy& study, std::uint64_t seed) {
  GuessingLog result;
  const ObserverDefinition& observer = study.population.observer;
  for (int p = 0; p < study.people; ++p) {
    Random random(mix_bits(seed ^ 0x67756573), static_cast<std::uint64_t>(p));
    const std::string code = "p" + std::to_string(p);
    result.log.participants.push_back(person(code));
    const double shift = observer.people_sd_octaves * random.normal();
    const double rating_shift = study.population.rating_sd_octaves * random.normal();
    for (Artifact artifact : paper_artifacts)
      for (int object = 1; object <= 3; ++object)
        for (int width_px : paper_widths_px) {
          const double midpoint_px =
              observer.midpoint.at(artifact) * std::exp2((object - 2) * study.object_shift_octaves);
          const double see = detail::seeing(width_px, midpoint_px, shift, observer.scale_octaves);
          const double rate =
              detail::seeing(width_px, midpoint_px, shift + rating_shift, observer.scale_octaves);
          const bool seen = random.uniform() < see;
          const int chosen = seen ? object : draw(study.habits.position, random);
          const int rating = seen ? 1 + random.binomial(3, rate) : draw(study.habits.rating, random);
          result.log.answers.push_back(answer(code, width_px, object, chosen, rating));
          result.log.answers.back().artifact = artifact;
          result.seen.push_back(seen);
        }
    for (int i = 0; i < study.references; ++i)
      result.references.push_back({.participant = code,
                                   .chosen_index = draw(study.habits.position, random),
                                   .rating = draw(study.habits.rating, random)});
  }
  return result;
}

/// Mean noticeability that guesses would not have changed: P(saw) times the rating of those who saw, averaged
/// over people.
inline double true_noticeability(const Population& population, Artifact artifact, double width_px) {
  const ObserverDefinition& observer = population.observer;
  const double midpoint_px = observer.midpoint.at(artifact);
  double sum = 0, weights = 0;
  for (double z = -6; z <= 6; z += 0.1)
    for (double v = -6; v <= 6; v += 0.1) {
      const double weight = std::exp(-(z * z + v * v) / 2);
      const double shift = z * observer.people_sd_octaves;
      const double see = detail::seeing(width_px, midpoint_px, shift, observer.scale_octaves);
      const double rate = detail::seeing(width_px, midpoint_px, shift + v * population.rating_sd_octaves,
                                         observer.scale_octaves);
      sum += weight * see * (1 + 3 * rate);
      weights += weight;
    }
  return sum / weights;
}

inline GuessCorrection corrected(const GuessingLog& simulated,
                                 const ResamplingRequest& request = {.replicates = 0}) {
  const NoticeabilityData data = average_answers(simulated.log, select_participants(simulated.log, false));
  return correct_for_guessing(count_guess_trials(simulated.log, data, simulated.references), data, request);
}

}  // namespace seamline::test
