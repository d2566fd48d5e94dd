#include "renderer/estimators/estimator.h"

#include <stdexcept>

namespace seamline::renderer {

ByteImage click_map(const TruthScene& scene) {
  const Camera& camera = scene.camera;
  const Geometry everything = scene.geometry(true, scene.object_indices());
  ByteImage ids{camera.width_px, camera.height_px, 1, {}};
  for (int y = 0; y < camera.height_px; ++y)
    for (int x = 0; x < camera.width_px; ++x) {
      const std::optional<SurfacePoint> centre = everything.nearest(centre_ray(camera, x, y));
      ids.values.push_back(static_cast<std::uint8_t>(centre ? centre->object_index : 0));
    }
  return ids;
}

namespace {

std::logic_error decides_nothing() {
  return std::logic_error("an estimator that samples all blocks alike was asked for a decision");
}

}  // namespace

PhotographDecision SceneEstimator::photograph_decision(const ReportProgress&) {
  throw decides_nothing();
}

void SceneEstimator::hold_to(const PhotographDecision&) {
  throw decides_nothing();
}

std::shared_ptr<const FrameBase> SceneEstimator::frame_base(const ReportProgress&) {
  return nullptr;
}

void SceneEstimator::sample_beside(std::function<std::shared_ptr<const FrameBase>()>) {
  throw decides_nothing();
}

EstimatedStimulus SceneEstimator::decided_stimulus(const Recipe&, const DepthWorld&, const StimulusDecision&,
                                                   const ReportProgress&) {
  throw decides_nothing();
}

std::unique_ptr<SceneEstimator> make_estimator(Estimator kind, const TruthScene& scene,
                                               const EstimateOptions& options) {
  switch (kind) {
    case Estimator::path:
      return make_path_estimator(scene, options);
    case Estimator::fast:
      return make_fast_estimator(scene, options);
  }
  throw std::logic_error("an estimator that is neither path nor fast");
}

}  // namespace seamline::renderer
