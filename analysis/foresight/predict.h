#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "analysis/foresight/planned_task.h"
#include "analysis/scores/level_axis.h"
#include "analysis/thresholds/thresholds.h"
#include "stimuli/definition/study_definition.h"
#include "stimuli/pictures/visible_difference.h"
#include "stimuli/set/depth_errors.h"
#include "stimuli/set/manifest.h"

namespace seamline::analysis {

/// What `seamline predict SET` asks for.
struct PredictionRequest {
  std::filesystem::path set_folder;
  std::filesystem::path none_set_folder;  ///< empty: floors come from the set's own `none` stimuli, or are 0
  std::optional<double> gain;  ///< none: the study's `observer.image_gain`, else that of published thresholds
  bool calibrate = false;      ///< fixes the gain on this set
  std::optional<double> pixels_per_degree;  ///< none: the study's `observer.pixels_per_degree`
  int threads = 0;
  bool finest_is_floor = false;  ///< see `take_finest_for_floor`
};

/// One artifact at one level: what the `image` observer is expected to answer on average.
struct PredictedCell {
  double level = 0;
  double visible_difference = 0;  ///< above the floor, mean over scenes and objects
  /// 0 to 4, mean over scenes and objects, guessing included; of tasks without ratings the share of people
  /// who see it, 0 to 1.
  double expected_noticeability = 0;
};

struct PredictedArtifact {
  Artifact artifact = Artifact::none;
  std::vector<PredictedCell> cells;  ///< along the axis, what stands apart last
  /// Without intervals. Of tasks without ratings `perceptual` is detection: half see it; the others mean
  /// nothing.
  CurveThresholds thresholds;
};

/// How a predicted threshold differs between the scenes of a set: each scene's own, from its own objects.
struct SceneSpread {
  Artifact artifact = Artifact::none;
  std::string quantity;  ///< "PT", "SN" or "detection"
  int scenes = 0;        ///< of the artifact, at least two
  int with_value = 0;    ///< of those, whose threshold lies within the levels
  double mean_x = 0;     ///< of those, mean x of LevelAxis: of widths their log2
  double sd_x = 0;       ///< their standard deviation, in the same; 0 of fewer than two
};

/// On whose eyes a prediction rests.
enum class GainSource {
  given,      ///< with the request
  study,      ///< `observer.image_gain`
  detection,  ///< ModelFest's 16 people (analysis/detection)
  paper       ///< fixed on this set so that the receiver's PT is the paper's
};

struct Prediction {
  ObserverDefinition observer;  ///< with the gain that was used
  GainSource gain_source = GainSource::detection;
  LevelAxis axis = {};
  PlannedTask task = {};
  bool finest_is_floor = false;
  bool floor_known = false;  ///< some stimulus without a seam told what rendering noise looks like
  double highest_floor = 0;
  std::vector<PredictedArtifact> artifacts;        ///< in the order of `every_artifact`, without `none`
  std::vector<SceneSpread> spreads = {};           ///< of artifacts with two scenes or more
  std::vector<LevelDepthError> depth_errors = {};  ///< where depth is estimated
};

/// Thresholds predicted from the pictures of a set alone, before anyone is asked: the functionals of
/// `thresholds_of_means` on the expected means of the `image` observer. Throws InputError when the set cannot
/// be read, holds no seam, has several conditions, asks for a match, or no gain gives the wanted receiver
/// threshold; that is
/// asked of widths of depth maps only.
[[nodiscard]] Prediction predict_thresholds(const PredictionRequest& request);

/// Takes what an object still shows at the last level of the axis (of widths the finest) for the grain of
/// rendering: each of its stimuli with that artifact has only what exceeds it, (F^p - F_last^p)^(1/p).
/// Returns the largest of these floors. A difference that is truly seen at the last level is lost with it.
double take_finest_for_floor(const Manifest& manifest, VisibleDifferences& differences,
                             const LevelAxis& axis = {});

/// The same from visible differences that are at hand.
[[nodiscard]] std::vector<PredictedArtifact> predict_artifacts(const Manifest& manifest,
                                                               const VisibleDifferences& differences,
                                                               const ObserverDefinition& observer,
                                                               const LevelAxis& axis = {},
                                                               const PlannedTask& task = {});

/// How thresholds differ between scenes, for each artifact with two scenes or more.
[[nodiscard]] std::vector<SceneSpread> scene_spreads(const Manifest& manifest,
                                                     const VisibleDifferences& differences,
                                                     const ObserverDefinition& observer,
                                                     const LevelAxis& axis = {},
                                                     const PlannedTask& task = {});

/// The gain with which the receiver artifact's perceptual threshold is `receiver_px`, by bisection to 1e-9
/// octaves (a larger gain never lowers a threshold). Throws InputError when there is none.
[[nodiscard]] double calibrated_gain(const Manifest& manifest, const VisibleDifferences& differences,
                                     ObserverDefinition observer, double receiver_px);

/// The artifacts from the most to the least demanding, by PT, then SN; those of curves above it at every
/// width come first. Among those that are alike in both, by the mean visible difference over widths.
[[nodiscard]] std::vector<Artifact> demanding_order(const std::vector<PredictedArtifact>& artifacts);

}  // namespace seamline::analysis
