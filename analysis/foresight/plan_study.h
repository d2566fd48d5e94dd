#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/foresight/plan_estimators.h"
#include "analysis/foresight/plan_targets.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/study_file/study_file.h"

namespace seamline::analysis {

/// "No seam is seen": mean noticeability at a level, corrected for guessing, lies within a margin of 0.
struct NoSeamClaim {
  double level = 0;   ///< one of the study's
  double margin = 0;  ///< noticeability, over 0
};

/// What `seamline plan STUDY.toml` asks for.
struct PlanRequest {
  std::filesystem::path study_file;
  IdleSettings idle = IdleSettings::refused;  ///< kept where sets of the study are there
  WantedTargets wanted = {};
  AssumedPeople assumed = {};
  PlanEstimator estimator = PlanEstimator::joint;
  double wanted_length = 1;  ///< of every 95 % interval: octaves, or the level's unit on linear axes
  double assurance = 0.8;    ///< chance that all of them are at most so long
  std::optional<double> equal_within = {};  ///< a difference counts as none within so much, in the same unit
  std::optional<NoSeamClaim> no_seam = {};
  double between_scenes = 0;  ///< assumed: standard deviation of thresholds, same unit; 0: nothing is said
  std::vector<int> participants = {5, 10, 20, 40, 80};  ///< rising, each at least 2
  bool sequential = false;                              ///< also: to ask until the intervals are short enough
  int studies = 200;                                    ///< simulated for each set of levels
  std::uint64_t seed = 1;                               ///< same seed, same table, for any number of threads
  int threads = 0;                                      ///< 0: as many as the machine has
};

/// A choice of levels.
struct LevelSet {
  std::string name;
  std::vector<double> levels;  ///< rising
};

/// How well one target would be known.
struct PlannedInterval {
  bool within = false;  ///< the true value lies within the levels; else nothing can be known
  /// Of the 95 % interval's length over simulated studies, an open one being longer than any; none when half
  /// of them are open.
  std::optional<double> median_length = {};
  double open_share = 0;   ///< share of studies whose interval is open on a side
  double holds_share = 0;  ///< share of studies whose interval holds the true value
  double power = 0;  ///< of a difference: share whose interval lies on the true side of 0; of none, on any
  double equal_share = 0;  ///< of a difference: share whose interval lies within `equal_within` of 0
};

/// Of a target, at a number of participants.
struct PlanRow {
  std::size_t target = 0, level_set = 0;  ///< of StudyPlan::targets and level_sets
  int participants = 0;
  PlannedInterval interval;
};

/// Of all targets within the levels together.
struct DesignRow {
  std::size_t level_set = 0;
  int participants = 0;
  double assurance = 0;  ///< share of studies in which every interval is at most as long as wanted
  double all_hold = 0;   ///< share of studies in which every interval holds its true value
  std::vector<double> no_seam = {};  ///< power of the claim, one a curve; empty where none is made
};

/// Asking until every interval is short enough, looking after each number of participants.
struct SequentialRow {
  std::size_t level_set = 0;
  double mean_participants = 0;
  double stopped_share = 0;  ///< of studies that were short enough at a look
  double holds = 0;          ///< mean share of intervals that hold, when asking stopped
  double fixed_holds = 0;    ///< the same with the same numbers of participants, fixed beforehand
};

struct StudyPlan {
  PlanRequest request;
  LevelAxis axis;
  std::vector<PlannedCurve> curves;
  std::vector<PlanTarget> targets;
  std::vector<LevelSet> level_sets;
  std::vector<std::vector<std::optional<double>>>
      bias_x;                             ///< of the design: [target][level set]; none: unknown
  std::vector<PlanRow> rows;              ///< by target, level set, participants
  std::vector<DesignRow> designs;         ///< by level set, participants
  std::vector<SequentialRow> sequential;  ///< by level set; empty where not asked for
  std::vector<double> seam_truth;         ///< corrected noticeability at the claim's level, one a curve
  std::string assumptions;
  int trials_a_level = 0;  ///< of a participant, of all artifacts and conditions
  int references = 0;      ///< reference trials of a participant, where chance is taken from them
};

/// Simulates studies of the people whom the study file's [observer] and `assumed` describe (constant
/// stimuli), and computes their intervals. Throws InputError when the study cannot be read, is adaptive, asks
/// for a match, has no seam or only one level, or something is asked for that it does not have.
[[nodiscard]] StudyPlan plan_study(const PlanRequest& request);

/// The study's levels; every second of them, the finest kept; and, of depth widths, half octaves from half an
/// octave below the smallest to half an octave above the largest true threshold within the widths, with the
/// study's first and last width around them.
[[nodiscard]] std::vector<LevelSet> level_sets_to_try(const std::vector<double>& levels,
                                                      const LevelAxis& axis,
                                                      const std::vector<PlanTarget>& targets);

}  // namespace seamline::analysis
