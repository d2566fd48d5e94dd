#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "analysis/thresholds/condition_differences.h"
#include "analysis/thresholds/planted_noticeability.h"
#include "stimuli/study_file/study_file.h"
#include "study/placement/sigmoid_shape.h"
#include "tests/analysis/coverage_tally.h"
#include "tests/analysis/threshold_people.h"

namespace seamline::test {

/// People with midpoints planted by artifact and condition. Nothing is rendered.
struct PlantedStudy {
  Quantity quantity = Quantity::depth_width_px;
  Direction noticeability = Direction::decreasing;
  std::vector<std::string> conditions = {};
  std::vector<Artifact> artifacts = {};
  std::vector<double> levels;
  ObserverDefinition observer = {};
};

/// What a study of the repository (the name of a file in stimuli/) varies, and the people it plants.
inline PlantedStudy planted_study(const std::string& name) {
  const StudyDefinition study =
      read_study(std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli" / name, AssetCheck::not_needed);
  PlantedStudy people{.quantity = study.level.quantity,
                      .noticeability = study.level.noticeability,
                      .levels = study.level.values,
                      .observer = study.observer};
  for (const ConditionDefinition& condition : list_conditions(study))
    people.conditions.push_back(condition.name);
  for (const SceneDefinition& scene : study.scenes)
    people.artifacts.insert(people.artifacts.end(), scene.artifacts.begin(), scene.artifacts.end());
  return people;
}

inline PlantedStudy soft_light_people() {
  return planted_study("soft_light.toml");
}

inline PlantedStudy mesh_tolerance_people() {
  return planted_study("mesh_tolerance.toml");
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

/// Of one threshold of an artifact in a condition.
struct CellCoverage {
  Artifact artifact = Artifact::none;
  std::string condition, quantity;
  CoverageTally tally = {};
};

struct Coverage {
  std::vector<CellCoverage> cells;
  CoverageTally differences;  ///< of PT and SN between conditions

  [[nodiscard]] double share_held() const {
    int held = differences.held, studies = differences.studies;
    for (const CellCoverage& cell : cells) {
      held += cell.tally.held;
      studies += cell.tally.studies;
    }
    return static_cast<double>(held) / studies;
  }
};

/// The thresholds of what the planted people are expected to answer.
inline CurveThresholds thresholds_of_expected_means(const PlantedStudy& people,
                                                    const ArtifactScores& scores) {
  const double midpoint = *planted_midpoint(people.observer, scores.artifact, scores.condition);
  std::vector<double> expected;
  for (const double level : scores.level)
    if (!stands_apart(scores.axis, level))
      expected.push_back(planted_noticeability(people.observer, scores.axis, midpoint, level));
  return thresholds_of_means(levels_on_axis(scores), expected, scores.axis);
}

/// How often the planted PT and SN lie within their intervals; IP, and differences between conditions, too
/// when `replicates` are asked for.
inline Coverage coverage_of(const PlantedStudy& people, int count, int studies, int replicates) {
  Coverage coverage;
  for (int study = 0; study < studies; ++study) {
    const LogContents log = condition_log(people, count, 1000 + static_cast<std::uint64_t>(study));
    const NoticeabilityData data = average_answers(log, select_participants(log, false), people.conditions);
    std::size_t cell = 0;
    const auto count_in = [&](const ArtifactScores& scores, const char* quantity,
                              const ThresholdEstimate& found, const ThresholdEstimate& truth) {
      if (cell == coverage.cells.size())
        coverage.cells.push_back(
            {.artifact = scores.artifact, .condition = scores.condition, .quantity = quantity});
      coverage.cells[cell++].tally.add(found, truth);
    };
    const ResamplingRequest request{.replicates = replicates, .seed = 1, .threads = 1};
    for (const ArtifactScores& scores : data.artifacts) {
      const CurveThresholds truth = thresholds_of_expected_means(people, scores);
      const CurveThresholds found = estimate_thresholds(scores, request).estimates;
      count_in(scores, "PT", found.perceptual, truth.perceptual);
      count_in(scores, "SN", found.slightly_noticeable, truth.slightly_noticeable);
      if (replicates > 0) count_in(scores, "IP", found.inflection, truth.inflection);
    }
    if (replicates == 0) continue;
    for (const ThresholdDifference& found : threshold_differences(data, request)) {
      if (found.quantity == "IP") continue;
      std::optional<double> of_condition, of_first;
      for (const ArtifactScores& scores : data.artifacts) {
        if (scores.artifact != found.artifact) continue;
        const CurveThresholds truth = thresholds_of_expected_means(people, scores);
        const ThresholdEstimate& at = found.quantity == "PT" ? truth.perceptual : truth.slightly_noticeable;
        if (scores.condition == found.condition) of_condition = at.level_x;
        if (scores.condition == found.to) of_first = at.level_x;
      }
      if (of_condition && of_first)
        coverage.differences.add({.low_x = found.ci95.low, .high_x = found.ci95.high},
                                 difference_at(data.axis, *of_condition - *of_first));
    }
  }
  return coverage;
}

}  // namespace seamline::test
