#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/artifact.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::analysis {

/// What `seamline plan STUDY.toml` asks for.
struct PlanRequest {
  std::filesystem::path study_file;
  double wanted_octaves = 1;                            ///< width of the 95 % interval of PT and SN
  std::vector<int> participants = {5, 10, 20, 40, 80};  ///< rising, each at least 2
  int studies = 200;                                    ///< simulated for each set of widths
  std::uint64_t seed = 1;                               ///< same seed, same table, for any number of threads
  int threads = 0;                                      ///< 0: as many as the machine has
};

/// A choice of depth widths, px, rising.
struct WidthSet {
  std::string name;
  std::vector<int> width_px;
};

/// How well one threshold would be known.
struct PlannedInterval {
  bool planted = false;  ///< the observer's threshold lies within the widths; else nothing can be known
  /// Of the 95 % interval's length over simulated studies, an open one being longer than any; none when half
  /// of them are open.
  std::optional<double> median_octaves = {};
  double open_share = 0;  ///< share of studies whose interval is open on a side
};

struct PlanRow {
  Artifact artifact = Artifact::none;
  std::size_t width_set = 0;  ///< of StudyPlan::width_sets
  int participants = 0;
  PlannedInterval perceptual, slightly_noticeable;
};

struct StudyPlan {
  std::vector<WidthSet> width_sets;
  std::vector<PlanRow> rows;  ///< by artifact, width set, participants
  int stimuli_a_width = 0;    ///< objects of all artifacts: trials a participant and width
  double wanted_octaves = 1;
  int studies = 0;
};

/// Simulates studies of the `threshold` observers that the study file describes (constant stimuli), and
/// computes their intervals as `analyze` does. Throws InputError when the study cannot be read, is adaptive,
/// or has no seam or only one width.
[[nodiscard]] StudyPlan plan_study(const PlanRequest& request);

/// The study's widths; every second of them, the finest kept; and half octaves from half an octave below the
/// smallest to half an octave above the largest threshold of the study's observers, with the study's first
/// and last width around them.
[[nodiscard]] std::vector<WidthSet> width_sets_to_try(const StudyDefinition& study);

}  // namespace seamline::analysis
