#pragma once
#include <cmath>
#include <filesystem>
#include <fstream>
#include <vector>

#include "analysis/log_analysis/session_order.h"
#include "tests/analysis/true_joint.h"

namespace seamline::test {

/// Each person's first or second half of a session.
inline TrueStudy half_of(const TrueStudy& study, int half) {
  TrueStudy part{.width_px = study.width_px, .people = {}};
  for (const std::vector<TrueTrial>& trials : study.people) {
    const auto middle = trials.begin() + std::ssize(trials) / 2;
    part.people.push_back(half == 0 ? std::vector<TrueTrial>(trials.begin(), middle)
                                    : std::vector<TrueTrial>(middle, trials.end()));
  }
  return part;
}

inline SessionHalves halves_of(const TrueStudy& study) {
  const JointData data = joint_data_of(study);
  std::vector<Eigen::MatrixXd> answers;
  for (int half = 0; half < 2; ++half) answers.push_back(joint_data_of(half_of(study, half)).answers);
  return contrast_halves(data, answers, fit_shared(data, {}, true).fit.model.sharing, {}, 1);
}

/// What is said of many studies of one population.
struct HalvesTally {
  int studies = 0, said = 0, held = 0, without = 0;  ///< held: the change of all curves together
  double sum = 0;                                    ///< of its estimates, octaves

  void add(const SessionHalves& halves, double true_octaves) {
    ++studies;
    if (halves.shifts.rows.empty()) {
      ++without;
      return;
    }
    bool any = false;
    for (const ContrastRow& row : halves.shifts.rows) any = any || row.verdict == ContrastVerdict::differs;
    said += any ? 1 : 0;
    const ContrastRow& all = halves.shifts.rows.front();
    held += all.ci95_low <= true_octaves && true_octaves <= all.ci95_high ? 1 : 0;
    sum += all.estimate;
  }
};

/// Studies of people whose thresholds rise by `octaves` from the first trial to the last, so by half of that
/// from half to half. Without a change their trials are in random order all the same.
inline HalvesTally tally_halves(TruePeople people, double octaves, int size, int studies) {
  constexpr double in_random_order = 1e-12;  // `answer_as_person` keeps the order of those who do not learn
  people.learning_octaves = octaves == 0 ? in_random_order : octaves;
  const TrueWidths widths = true_widths().front();
  const std::vector<double> level_x = log2_widths(widths.width_px);
  std::vector<SessionHalves> found(static_cast<std::size_t>(studies));
  run_parallel(studies, 0, [&](int index) {
    found[static_cast<std::size_t>(index)] = halves_of(
        {.width_px = widths.width_px,
         .people = answer_as_people(people, size, level_x, 7000 + static_cast<std::uint64_t>(index))});
  });
  HalvesTally tally;
  for (const SessionHalves& halves : found) tally.add(halves, octaves / 2);
  return tally;
}

/// Every population, with no change and with one of 0.8 octave.
inline void write_halves(const std::filesystem::path& file, int studies) {
  std::ofstream out(file);
  out << "population,people,studies,change_octaves,said_percent,held_percent,mean_octaves,without_percent\n";
  for (const int size : {10, 20})
    for (const TruePeople& people : true_populations())
      for (const double octaves : {0.0, 0.8}) {
        const HalvesTally tally = tally_halves(people, octaves, size, studies);
        const double with = std::max(1, tally.studies - tally.without);
        out << people.name << "," << size << "," << studies << "," << octaves / 2 << ","
            << 100.0 * tally.said / with << "," << 100.0 * tally.held / with << "," << tally.sum / with << ","
            << 100.0 * tally.without / studies << "\n";
        out.flush();
      }
}

}  // namespace seamline::test
