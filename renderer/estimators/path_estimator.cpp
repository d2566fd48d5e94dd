// The unbiased estimator: every path traced to its end, nothing filtered.
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/stimulus_pass.h"
#include "renderer/picture/error_estimate.h"
#include "renderer/picture/sampling_rounds.h"

namespace seamline::renderer {
namespace {

constexpr int first_spp = 16, most_spp = 1 << 16;
constexpr double truth_share = 0.85;  // of the error that the photograph may have

class PathEstimator : public SceneEstimator {
 public:
  PathEstimator(const TruthScene& scene, const EstimateOptions& options)
      : scene_(scene), options_(options), spp_(options.spp) {}

  SceneReference reference(const ReportProgress& progress) override {
    if (options_.error) find_spp(progress);
    return render_reference(scene_, pass(progress));
  }

  void take_object(int object_index, const ReportProgress& progress) override {
    geometry_.reset();
    if (options_.error && !found_spp_) find_spp(progress);
    geometry_.emplace(object_geometry(scene_, object_index));
    truth_ = render_truth(scene_, *geometry_, pass(progress));
  }

  [[nodiscard]] const ObjectGeometry& geometry() const override { return *geometry_; }
  [[nodiscard]] const TruthLayers& truth() const override { return truth_; }

  EstimatedStimulus stimulus(const Recipe& recipe, const Geometry* depth,
                             const ReportProgress& progress) override {
    EstimatedStimulus out{render_stimulus(scene_, *geometry_, depth, truth_, recipe, pass(progress)), {}, {}};
    if (out.layers.spp < 2) return out;
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half)
      pictures.filtered[half] = pictures.sampled[half] =
          compose_half(out.layers, half, options_.threads).picture;
    const ErrorEstimate error = estimate_error(pictures, scene_.definition.exposure_ev, options_.threads);
    out.rmse = error.rmse();
    out.worst_tile = error.worst_tile();
    return out;
  }

 private:
  PassOptions pass(const ReportProgress& progress) const {
    return {.spp = spp_, .seed = options_.seed, .threads = options_.threads, .progress = progress};
  }

  /// Doubles the samples of the first object's truth until its picture is good enough; all pictures of the
  /// scene are then rendered with as many.
  void find_spp(const ReportProgress& progress) {
    const ErrorTarget target{*options_.error * truth_share};
    const ObjectGeometry geometry = object_geometry(scene_, 1);
    for (spp_ = first_spp; spp_ < most_spp; spp_ *= 2) {
      const TruthLayers truth = render_truth(scene_, geometry, pass(progress));
      HalfPictures pictures;
      for (std::size_t half = 0; half < 2; ++half)
        pictures.filtered[half] = pictures.sampled[half] = half_reference_image(truth, half);
      if (target.met_by(estimate_error(pictures, scene_.definition.exposure_ev, options_.threads))) break;
    }
    found_spp_ = true;
  }

  const TruthScene& scene_;
  EstimateOptions options_;
  int spp_;
  bool found_spp_ = false;
  std::optional<ObjectGeometry> geometry_;
  TruthLayers truth_;
};

}  // namespace

std::unique_ptr<SceneEstimator> make_path_estimator(const TruthScene& scene, const EstimateOptions& options) {
  return std::make_unique<PathEstimator>(scene, options);
}

}  // namespace seamline::renderer
