#pragma once
#include <optional>
#include <string>
#include <vector>

#include "analysis/log_analysis/analysis.h"

namespace seamline::analysis {

/// What was tested of a curve, without a level that stands apart.
struct TestedLevels {
  LevelAxis axis;
  double smallest = 0, largest = 0;
};
[[nodiscard]] TestedLevels tested_levels(const ArtifactScores& scores);

/// One number of Table 1: a quantity of an artifact with everything that is printed beside it. What terminal,
/// CSV, JSON and report are all written from, so that they cannot disagree.
struct ThresholdRow {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  TestedLevels tested;
  std::string quantity;         ///< "PT", "SN" or "IP"
  std::string key;              ///< "perceptual_threshold", "slightly_noticeable", "inflection"
  std::optional<double> level;  ///< of noticeability; none for IP
  ThresholdEstimate here;
  std::optional<LevelInterval> bootstrap;  ///< PT and SN: the expanded percentile interval, for comparison
  std::optional<int> paper_px;
  std::optional<double>
      planted_x;  ///< true crossing; present when all participants are `threshold` observers
  std::optional<ThresholdEstimate> limit;  ///< PlantedThresholds::limit, likewise
  std::optional<ThresholdEstimate>
      logistic;  ///< PT and SN: read off the logistic instead of the isotonic fit
  std::optional<LevelInterval> object_range;  ///< range when each object is left out; none with one object
  ThresholdEstimate corrected;                ///< the same quantity of the curve corrected for guessing
  std::optional<LevelInterval>
      corrected_bootstrap;  ///< PT and SN: expanded percentile interval, for comparison
};

[[nodiscard]] std::vector<ThresholdRow> threshold_rows(const Analysis& analysis);

/// The estimated level; none where there is none.
[[nodiscard]] std::optional<double> level_of(const ThresholdEstimate& estimate, const LevelAxis& axis);

/// The planted level; none where nothing is planted.
[[nodiscard]] std::optional<double> planted_level(const ThresholdRow& row);

/// The limit of a row's estimate less what was planted, in x; none where either is not known.
[[nodiscard]] std::optional<double> design_bias_x(const ThresholdRow& row);

/// A bound; none when it is open.
[[nodiscard]] std::optional<double> closed(double bound);

/// Whether the paper's values stand beside the study's: it measured depth widths, in one condition.
[[nodiscard]] bool beside_the_paper(const Analysis& analysis);

}  // namespace seamline::analysis
