// The unbiased estimator: every path traced to its end, nothing filtered.
#include "renderer/error/error_estimate.h"
#include "renderer/error/sampling_rounds.h"
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/path/path_depth_pass.h"

namespace seamline::renderer {
namespace {

class PathEstimator : public SceneEstimator {
 public:
  PathEstimator(const TruthScene& scene, const EstimateOptions& options)
      : choices_(
            estimator_choices(Estimator::path, light_facts(scene), scene.definition.exposure_ev, options)),
        scene_(with_chosen_light(scene, choices_)),
        seed_(options.seed),
        threads_(options.threads) {}

  [[nodiscard]] const EstimatorChoices& choices() const override { return choices_; }

  SceneReference reference(const ReportProgress& progress) override {
    find_spp(progress);
    return render_reference(scene_, pass(progress));
  }

  void take_object(int object_index, const ReportProgress& progress) override {
    geometry_.reset();
    find_spp(progress);
    geometry_.emplace(object_geometry(scene_, object_index));
    truth_ = render_truth(scene_, *geometry_, pass(progress));
  }

  [[nodiscard]] const ObjectGeometry& geometry() const override { return *geometry_; }
  [[nodiscard]] const TruthSums& truth() const override { return truth_; }

  EstimatedStimulus stimulus(const Recipe& recipe, const DepthWorld& depth,
                             const ReportProgress& progress) override {
    EstimatedStimulus out{render_stimulus(scene_, *geometry_, depth, truth_, recipe, pass(progress)), {}, {}};
    if (out.sums.spp < 2) return out;
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half)
      pictures.filtered[half] = pictures.sampled[half] = compose_half(out.sums, half, threads_).picture;
    const ErrorEstimate error = estimate_error(pictures, scene_.definition.exposure_ev, threads_);
    out.rmse = error.rmse();
    out.worst_tile = error.worst_tile();
    return out;
  }

 private:
  [[nodiscard]] PassOptions pass(const ReportProgress& progress) const {
    return {.spp = *spp_, .seed = seed_, .threads = threads_, .progress = progress};
  }

  /// With an error to reach, doubles the samples of the first object's truth until its picture is good
  /// enough; all pictures of the scene are then rendered with as many. Once.
  void find_spp(const ReportProgress& progress) {
    if (spp_) return;
    spp_ = choices_.first_spp;
    if (!choices_.error) return;
    const ErrorTarget target{*choices_.error * choices_.photograph_share};
    const ObjectGeometry geometry = object_geometry(scene_, 1);
    for (; *spp_ < choices_.most_spp; *spp_ *= 2) {
      const TruthSums truth = render_truth(scene_, geometry, pass(progress));
      HalfPictures pictures;
      for (std::size_t half = 0; half < 2; ++half)
        pictures.filtered[half] = pictures.sampled[half] = half_reference_image(truth, half);
      if (target.met_by(estimate_error(pictures, scene_.definition.exposure_ev, threads_))) break;
    }
  }

  const EstimatorChoices choices_;
  const TruthScene scene_;  ///< with the light that is followed
  const std::uint64_t seed_;
  const int threads_;
  std::optional<int> spp_;  ///< when it is found
  std::optional<ObjectGeometry> geometry_;
  TruthSums truth_;
};

}  // namespace

std::unique_ptr<SceneEstimator> make_path_estimator(const TruthScene& scene, const EstimateOptions& options) {
  return std::make_unique<PathEstimator>(scene, options);
}

}  // namespace seamline::renderer
