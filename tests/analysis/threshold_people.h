#pragma once
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "analysis/scores/cells.h"
#include "analysis/thresholds/thresholds.h"
#include "study/log/log.h"
#include "study/observers/observer.h"

namespace seamline::test {
using namespace study;
using namespace analysis;

inline constexpr std::array<int, 7> paper_widths_px = {64, 128, 256, 512, 1024, 2048, 4096};

/// How simulated people answer. With `rating_sd_octaves` 0 they are the `threshold` observers of a study.
struct Population {
  ObserverDefinition observer;
  double rating_sd_octaves = 0;  ///< people differ in where they begin to rate high
};

namespace detail {

inline double seeing(double width_px, double midpoint_px, double shift, double scale) {
  return 1 / (1 + std::exp((std::log2(width_px) - std::log2(midpoint_px) - shift) / scale));
}

inline int noticeability(double see, double rate, Random& random) {
  if (random.uniform() < see) return 1 + random.binomial(3, rate);
  return random.below(3) == 0 ? 1 : 0;
}

/// E over shift and rating shift, by the midpoint rule on normal densities.
inline double expected(const Population& population, Artifact artifact, double width_px) {
  const ObserverDefinition& observer = population.observer;
  if (population.rating_sd_octaves == 0) return expected_noticeability(observer, artifact, width_px);
  const double midpoint_px = observer.midpoint.at(artifact);
  double sum = 0, weights = 0;
  for (double z = -6; z <= 6; z += 0.1)
    for (double v = -6; v <= 6; v += 0.1) {
      const double weight = std::exp(-(z * z + v * v) / 2);
      const double shift = z * observer.people_sd_octaves;
      const double see = seeing(width_px, midpoint_px, shift, observer.scale_octaves);
      const double rate =
          seeing(width_px, midpoint_px, shift + v * population.rating_sd_octaves, observer.scale_octaves);
      sum += weight * (see * (1 + 3 * rate) + (1 - see) / 3);
      weights += weight;
    }
  return sum / weights;
}

}  // namespace detail

/// Scores of `people` simulated participants: three objects at the seven widths of the paper, in memory.
inline ArtifactScores simulate_scores(const Population& population, Artifact artifact, int people,
                                      std::uint64_t seed) {
  const ObserverDefinition& observer = population.observer;
  ArtifactScores scores;
  scores.artifact = artifact;
  scores.level.assign(paper_widths_px.begin(), paper_widths_px.end());
  scores.noticeability.resize(people, static_cast<Eigen::Index>(paper_widths_px.size()));
  for (int p = 0; p < people; ++p) {
    Random random(mix_bits(seed) + static_cast<std::uint64_t>(artifact), static_cast<std::uint64_t>(p));
    const double shift = observer.people_sd_octaves * random.normal();
    const double rating_shift = population.rating_sd_octaves * random.normal();
    for (std::size_t w = 0; w < paper_widths_px.size(); ++w) {
      const double midpoint_px = observer.midpoint.at(artifact);
      const double see = detail::seeing(paper_widths_px[w], midpoint_px, shift, observer.scale_octaves);
      const double rate =
          detail::seeing(paper_widths_px[w], midpoint_px, shift + rating_shift, observer.scale_octaves);
      double sum = 0;
      for (int object = 0; object < 3; ++object) sum += detail::noticeability(see, rate, random);
      scores.noticeability(p, static_cast<Eigen::Index>(w)) = sum / 3;
    }
    scores.people.push_back("p" + std::to_string(p));
  }
  for (std::size_t w = 0; w < paper_widths_px.size(); ++w) {
    const Eigen::VectorXd column = scores.noticeability.col(static_cast<Eigen::Index>(w));
    scores.cells.push_back(mean_over_participants({column.begin(), column.end()}));
    scores.cells.back().level = paper_widths_px[w];
  }
  return scores;
}

/// The thresholds of the expected means.
inline CurveThresholds thresholds_of_expected_means(const Population& population, Artifact artifact) {
  std::vector<double> means;
  for (int width_px : paper_widths_px) means.push_back(detail::expected(population, artifact, width_px));
  return thresholds_of_means(log2_widths({paper_widths_px.begin(), paper_widths_px.end()}), means);
}

/// One answer, for hand-made logs.
inline Answer answer(const std::string& participant, int width_px, int object_index, int chosen_index,
                     int rating) {
  Answer result;
  result.participant = participant;
  result.scene = "scene";
  result.artifact = Artifact::receiver;
  result.object = "object" + std::to_string(object_index);
  result.object_index = object_index;
  result.depth_width_px = width_px;
  result.level = width_px;
  result.chosen_index = chosen_index;
  result.rating = rating;
  return result;
}

inline ParticipantRecord person(const std::string& code) {
  ParticipantRecord record;
  record.code = code;
  record.completed = true;
  return record;
}

/// A log of `threshold` observers, four artifacts x three objects x seven widths.
inline LogContents simulate_log(int people, std::uint64_t seed) {
  LogContents log;
  log.file = "simulated.sqlite";
  log.study_name = "simulated study";
  log.study_hash = "study";
  log.set_hash = "set";
  for (int p = 0; p < people; ++p) {
    Random random(seed, static_cast<std::uint64_t>(p));
    const Observer observer = make_observer(ObserverKind::threshold, {}, random);
    const std::string code = "sim-" + std::to_string(p);
    ParticipantRecord record = person(code);
    record.simulated = true;
    record.observer = word(ObserverKind::threshold);
    log.participants.push_back(record);
    for (Artifact artifact : paper_artifacts)
      for (int object = 1; object <= 3; ++object)
        for (int width_px : paper_widths_px) {
          Stimulus stimulus;
          stimulus.artifact = artifact;
          stimulus.object_index = object;
          stimulus.depth.width_px = width_px;
          stimulus.level = width_px;
          const Response response = respond(observer, stimulus, random);
          log.answers.push_back(answer(code, width_px, object, response.chosen_index, response.rating));
          log.answers.back().artifact = artifact;
        }
  }
  return log;
}

}  // namespace seamline::test
