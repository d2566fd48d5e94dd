#include "renderer/estimators/estimator.h"

#include <stdexcept>

namespace seamline::renderer {

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
