#pragma once
#include <string>
#include <vector>

#include "analysis/thresholds/condition_differences.h"
#include "analysis/thresholds/planted_noticeability.h"
#include "study/placement/sigmoid_shape.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::test {

/// People with midpoints planted by artifact and condition. Nothing is rendered.
struct PlantedStudy {
  Quantity quantity = Quantity::depth_width_px;
  Direction noticeability = Direction::decreasing;
  std::vector<std::string> conditions;
  std::vector<Artifact> artifacts;
  std::vector<double> levels;
  ObserverDefinition observer = {};
};

/// As stimuli/soft_light.toml: three conditions over depth widths.
inline PlantedStudy soft_light_people() {
  PlantedStudy people{.conditions = {"hard", "soft", "softer"},
                      .artifacts = {Artifact::shadow, Artifact::receiver},
                      .levels = {64, 128, 256, 512, 1024, 2048, 4096}};
  people.observer.condition_midpoint = {{"hard", {{Artifact::shadow, 700}, {Artifact::receiver, 500}}},
                                        {"soft", {{Artifact::shadow, 400}, {Artifact::receiver, 300}}},
                                        {"softer", {{Artifact::shadow, 200}, {Artifact::receiver, 180}}}};
  return people;
}

/// As stimuli/mesh_tolerance.toml: tolerances that rise in noticeability, and an exact mesh.
inline PlantedStudy mesh_tolerance_people() {
  PlantedStudy people{.quantity = Quantity::mesh_tolerance,
                      .noticeability = Direction::increasing,
                      .conditions = {""},
                      .artifacts = {Artifact::shadow, Artifact::overlap},
                      .levels = {0, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2, 3e-2, 1e-1}};
  people.observer.midpoint = {{Artifact::shadow, 6e-3}, {Artifact::overlap, 3e-3}};
  people.observer.direction = Direction::increasing;
  return people;
}

inline LogContents condition_log(const PlantedStudy& people, int count, std::uint64_t seed) {
  LogContents log;
  log.file = "planted.sqlite";
  log.study_name = "planted study";
  log.study_hash = "study";
  log.set_hash = "set";
  log.quantity = people.quantity;
  log.noticeability = people.noticeability;
  const LevelAxis axis{.quantity = people.quantity, .noticeability = people.noticeability};
  for (int p = 0; p < count; ++p) {
    Random random(mix_bits(seed), static_cast<std::uint64_t>(p));
    const double shift = people.observer.people_sd_octaves * random.normal();
    const std::string code = "p" + std::to_string(p);
    log.participants.push_back(person(code));
    for (const Artifact artifact : people.artifacts)
      for (const std::string& condition : people.conditions)
        for (const double level : people.levels)
          for (int object = 1; object <= 3; ++object) {
            const double midpoint = *planted_midpoint(people.observer, artifact, condition);
            const double see = stands_apart(axis, level)
                                   ? 0
                                   : 1 / (1 + std::exp((x_of(axis, level) - x_of(axis, midpoint) - shift) /
                                                       people.observer.scale_octaves));
            const bool seen = random.uniform() < see;
            const int chosen = seen ? object : 1 + static_cast<int>(random.below(3));
            const int rating = seen ? 1 + random.binomial(3, see) : 1;
            log.answers.push_back(answer(code, 0, object, chosen, rating));
            log.answers.back().artifact = artifact;
            log.answers.back().condition = condition;
            log.answers.back().level = level;
          }
  }
  return log;
}

struct Coverage {
  int inside = 0, tried = 0;
};

/// How often the planted PT and SN lie within their intervals; differences between conditions too when
/// `replicates` are asked for.
inline Coverage coverage_of(const PlantedStudy& people, int count, int studies, int replicates) {
  Coverage coverage;
  for (int study = 0; study < studies; ++study) {
    const LogContents log = condition_log(people, count, 1000 + static_cast<std::uint64_t>(study));
    const NoticeabilityData data = average_answers(log, select_participants(log, false), people.conditions);
    const auto planted = [&](const ArtifactScores& scores) {
      std::vector<double> expected;
      for (const double level : scores.level)
        if (!stands_apart(scores.axis, level))
          expected.push_back(planted_noticeability(
              people.observer, scores.axis,
              *planted_midpoint(people.observer, scores.artifact, scores.condition), level));
      return thresholds_of_means(levels_on_axis(scores), expected, scores.axis);
    };
    const auto count_in = [&](const std::optional<double>& truth, double low, double high) {
      if (!truth) return;
      ++coverage.tried;
      coverage.inside += low <= *truth && *truth <= high ? 1 : 0;
    };
    for (const ArtifactScores& scores : data.artifacts) {
      const CurveThresholds truth = planted(scores);
      const CurveThresholds found = estimate_thresholds(scores, {.replicates = 0}).estimates;
      for (const auto part : {&CurveThresholds::perceptual, &CurveThresholds::slightly_noticeable})
        count_in((truth.*part).level_x, (found.*part).ci95.low_x, (found.*part).ci95.high_x);
    }
    if (replicates == 0) continue;
    for (const ThresholdDifference& found :
         threshold_differences(data, {.replicates = replicates, .seed = 1, .threads = 1})) {
      if (found.quantity == "IP") continue;
      std::optional<double> of_condition, of_first;
      for (const ArtifactScores& scores : data.artifacts) {
        if (scores.artifact != found.artifact) continue;
        const CurveThresholds truth = planted(scores);
        const ThresholdEstimate& at = found.quantity == "PT" ? truth.perceptual : truth.slightly_noticeable;
        if (scores.condition == found.condition) of_condition = at.level_x;
        if (scores.condition == found.to) of_first = at.level_x;
      }
      if (of_condition && of_first)
        count_in(difference_at(data.axis, *of_condition - *of_first), found.ci95.low, found.ci95.high);
    }
  }
  return coverage;
}

}  // namespace seamline::test
