#pragma once
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::renderer {

/// Of all threads since the program began: what other programs take meanwhile is not in it.
[[nodiscard]] inline double processor_seconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

/// One estimate that got so much to work with: frames, answers, replicates, a radius.
struct EstimateRow {
  std::string series;
  double amount = 0;
  double seconds = 0;  ///< processor time of one estimate
  double error = 0;    ///< root mean square against the truth
};

/// What the machine cannot do faster: the same data, touched once.
struct EstimateLimit {
  std::string what;
  double seconds_each = 0;  ///< for one of `amount`
};

/// Error of an estimator against its processor time.
struct EstimateResult {
  std::string part;          ///< the `ConvergencePart`
  std::string amount, unit;  ///< what grows, and the unit of the error
  std::string truth;         ///< what the error is against: a sentence
  std::vector<EstimateRow> rows;
  EstimateLimit limit;
  double expected = -0.5;  ///< slope of the error in the amount
  std::string why;
};

/// Frames of three kinds of depth camera before a wall, averaged (`mean_of_frames`): error of the depth.
[[nodiscard]] EstimateResult measure_sensor(std::uint64_t seed);
/// One noisy frame of two slanted walls with holes, repaired: error of the depth where it has one.
[[nodiscard]] EstimateResult measure_repair(std::uint64_t seed);
/// Psychometric functions fitted to simulated answers: error of the threshold.
[[nodiscard]] EstimateResult measure_fit(std::uint64_t seed);
/// Bootstrap intervals of one threshold: error of their ends against the same with many more replicates.
[[nodiscard]] EstimateResult measure_interval(std::uint64_t seed);
/// A bent wall brought into the camera beside the depth camera: error of the depth where it has one.
[[nodiscard]] EstimateResult measure_registration();
/// The joint model fitted to simulated answers and ratings: error of its thresholds.
[[nodiscard]] EstimateResult measure_joint(std::uint64_t seed);
/// The assurance that a plan promises for the study's own levels: error against that of many more simulated
/// studies. Throws InputError as `analysis::plan_study`.
[[nodiscard]] EstimateResult measure_plan(const std::filesystem::path& study_file, std::uint64_t seed);

}  // namespace seamline::renderer
