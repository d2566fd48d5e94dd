#pragma once
#include <functional>
#include <memory>
#include <optional>

#include "raytracer/common/byte_stream.h"
#include "raytracer/error/change_error.h"
#include "renderer/depth/occlusion_test.h"
#include "renderer/estimators/estimator_choices.h"
#include "renderer/estimators/sample_decision.h"
#include "renderer/picture/composite.h"
#include "renderer/transport/omissions.h"
#include "renderer/transport/scene_geometry.h"
#include "support/files/image.h"

namespace seamline::renderer {

struct FrameBase;

/// How a pass over all pixels runs.
struct PassOptions {
  int spp = 64;
  std::uint64_t seed = 1;
  int threads = 1;
  std::function<void(double share_done)> progress = {};  ///< called on the calling thread
};

/// The reference of a whole scene, all objects in place, and its click map (0 background, objects from 1 on
/// the left).
struct SceneReference {
  Image radiance;
  ByteImage object_ids;
  std::int64_t rays = 0;
};

/// The click map alone.
[[nodiscard]] ByteImage click_map(const TruthScene& scene);

/// What an estimator made of one stimulus.
struct EstimatedStimulus {
  StimulusSums sums;
  std::optional<double> rmse;        ///< estimated error, noise and bias, display units; none: not known
  std::optional<double> worst_tile;  ///< the same in the worst 32 x 32 tile
  std::optional<StimulusDecision> decision = {};  ///< how it was sampled; none: as often everywhere
  std::optional<ErrorMap> error_map = {};         ///< where it was asked for (`keeps_error_maps`)
};

using ReportProgress = std::function<void(double share_done)>;

/// Computes the light of one scene's reference and stimuli. `path` is unbiased, the reference; `fast` shares
/// and filters (documentation/developers/design.md). The same input gives the same bytes for any number of
/// threads.
class SceneEstimator {
 public:
  SceneEstimator() = default;
  SceneEstimator(const SceneEstimator&) = delete;
  SceneEstimator& operator=(const SceneEstimator&) = delete;
  virtual ~SceneEstimator() = default;

  /// What it holds to.
  [[nodiscard]] virtual const EstimatorChoices& choices() const = 0;
  [[nodiscard]] virtual SceneReference reference(const ReportProgress& progress) = 0;
  /// Turns to one virtual object (from 1): what its stimuli share.
  virtual void take_object(int object_index, const ReportProgress& progress) = 0;
  [[nodiscard]] virtual const ObjectGeometry& geometry() const = 0;
  [[nodiscard]] virtual const TruthSums& truth() const = 0;
  /// A stimulus of the object taken. The mesh of `depth` may be null when the recipe asks nothing of it.
  [[nodiscard]] virtual EstimatedStimulus stimulus(const Recipe& recipe, const DepthWorld& depth,
                                                   const ReportProgress& progress) = 0;
  /// How the photograph is sampled, decided by this scene alone.
  [[nodiscard]] virtual PhotographDecision photograph_decision(const ReportProgress& progress);
  /// From now on the photograph is sampled as was decided for several scenes, this one among them. Before
  /// anything else is asked, or after `photograph_decision`, whose samples are kept.
  virtual void hold_to(const PhotographDecision& decision);
  /// A stimulus that is sampled as was decided.
  [[nodiscard]] virtual EstimatedStimulus decided_stimulus(const Recipe& recipe, const DepthWorld& depth,
                                                           const StimulusDecision& decision,
                                                           const ReportProgress& progress);
  /// Into how many pieces its truth is written: one for all objects, or one for each.
  [[nodiscard]] virtual int truth_pieces() const = 0;
  /// What was made of the truth, so that other processes need not make it again; piece 1 to `truth_pieces`.
  /// Makes it where it is not there yet.
  virtual void write_truth(int piece, ByteWriter& out, const ReportProgress& progress) = 0;
  /// Takes a piece that was written of the same inputs, before anything else is asked. Stimuli have the same
  /// bytes as if it had been made here. False, with nothing changed, when it is not whole.
  [[nodiscard]] virtual bool read_truth(int piece, ByteReader& in) = 0;
  /// What was left out so far; nothing by an estimator that leaves nothing out.
  [[nodiscard]] virtual Savings savings() const { return {}; }
  /// The photograph of this scene, sampled as it holds to, by which other frames of its clip need fewer
  /// samples. Null: this estimator has none.
  [[nodiscard]] virtual std::shared_ptr<const FrameBase> frame_base(const ReportProgress& progress);
  /// From now on the photograph is what few samples change in that of a base, as far as these suffice.
  /// `base` is called when it is sampled, and may return null. After `hold_to`.
  virtual void sample_beside(std::function<std::shared_ptr<const FrameBase>()> base);
};

[[nodiscard]] std::unique_ptr<SceneEstimator> make_estimator(Estimator kind, const TruthScene& scene,
                                                             const EstimateOptions& options);
[[nodiscard]] std::unique_ptr<SceneEstimator> make_path_estimator(const TruthScene& scene,
                                                                  const EstimateOptions& options);
[[nodiscard]] std::unique_ptr<SceneEstimator> make_fast_estimator(const TruthScene& scene,
                                                                  const EstimateOptions& options);

}  // namespace seamline::renderer
