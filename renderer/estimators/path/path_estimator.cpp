// The unbiased estimator: every path traced to its end, nothing filtered.
#include "raytracer/error/error_estimate.h"
#include "raytracer/error/sampling_rounds.h"
#include "raytracer/scene/panorama_camera.h"
#include "renderer/estimators/estimator.h"
#include "renderer/estimators/path/path_emission.h"
#include "renderer/estimators/seen_emission.h"
#include "renderer/views/view_picture.h"

namespace seamline::renderer {
namespace {

// Numbers without gaps between them: equal sums have equal bytes.
static_assert(sizeof(TruthPixel) == 35 * sizeof(float));
static_assert(sizeof(Guide) == 4 * sizeof(float));

void write_sums(const TruthSums& sums, ByteWriter& out) {
  out.put(sums.spp);
  for (const auto& half : sums.halves) out.put_all(half);
  out.put_all(sums.guides);
  out.put_all(sums.object_ids);
  out.put(sums.rays);
}

/// Of a picture of the camera; none when the bytes are none of these.
std::optional<TruthSums> read_sums(ByteReader& in, const Camera& camera) {
  const std::size_t pixels =
      static_cast<std::size_t>(camera.width_px) * static_cast<std::size_t>(camera.height_px);
  TruthSums sums{.width_px = camera.width_px, .height_px = camera.height_px};
  in.get(sums.spp);
  for (auto& half : sums.halves) in.get_all(half, pixels);
  in.get_all(sums.guides, pixels);
  in.get_all(sums.object_ids, pixels);
  in.get(sums.rays);
  return in.is_done() ? std::optional(std::move(sums)) : std::nullopt;
}

class PathEstimator : public SceneEstimator {
 public:
  PathEstimator(const TruthScene& scene, const EstimateOptions& options)
      : choices_(
            estimator_choices(Estimator::path, light_facts(scene), scene.definition.exposure_ev, options)),
        scene_(with_chosen_light(scene, choices_)),
        seed_(options.seed),
        threads_(options.threads),
        seen_(find_seen_emission(scene_, threads_)) {}

  [[nodiscard]] const EstimatorChoices& choices() const override { return choices_; }

  SceneReference reference(const ReportProgress& progress) override {
    find_spp(progress);
    return render_reference(scene_, pass(progress), seen_.get());
  }

  void take_object(int object_index, const ReportProgress& progress) override {
    geometry_.reset();
    find_spp(progress);
    geometry_.emplace(object_geometry(scene_, object_index));
    if (given_ && given_->object == object_index) {
      truth_ = std::move(given_->truth);
      given_.reset();
      return;
    }
    truth_ = render_truth(scene_, *geometry_, pass(progress), seen_.get());
  }

  [[nodiscard]] int truth_pieces() const override { return static_cast<int>(scene_.objects.size()); }

  void write_truth(int piece, ByteWriter& out, const ReportProgress& progress) override {
    take_object(piece, progress);
    out.put(*spp_);
    write_sums(truth_, out);
  }

  [[nodiscard]] bool read_truth(int piece, ByteReader& in) override {
    int spp = 0;
    in.get(spp);
    std::optional<TruthSums> truth = read_sums(in, scene_.camera);
    if (!truth || truth->spp != spp || spp < 1) return false;
    spp_ = spp;
    given_ = Given{piece, std::move(*truth)};
    return true;
  }

  [[nodiscard]] const ObjectGeometry& geometry() const override { return *geometry_; }
  [[nodiscard]] const TruthSums& truth() const override { return truth_; }

  EstimatedStimulus stimulus(const Recipe& recipe, const DepthWorld& depth,
                             const ReportProgress& progress) override {
    EstimatedStimulus out{
        render_stimulus(scene_, *geometry_, depth, truth_, recipe, pass(progress), seen_.get()), {}, {}};
    if (out.sums.spp < 2) return out;
    HalfPictures pictures;
    for (std::size_t half = 0; half < 2; ++half)
      pictures.filtered[half] = pictures.sampled[half] =
          as_shown(compose_half(out.sums, half, threads_).picture);
    pictures.whole = as_shown(compose(out.sums, out.sums.compositing, threads_).picture);
    const ErrorEstimate error =
        estimate_error(pictures, scene_.definition.exposure_ev, threads_, wraps(scene_.camera));
    out.rmse = error.rmse();
    out.worst_tile = error.worst_tile();
    return out;
  }

 private:
  [[nodiscard]] PassOptions pass(const ReportProgress& progress) const {
    return {.spp = *spp_, .seed = seed_, .threads = threads_, .progress = progress};
  }

  /// Errors are of what people see.
  [[nodiscard]] Image as_shown(Image picture) const {
    return shown_to_each_eye(scene_.definition.view, std::move(picture));
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
      const TruthSums truth = render_truth(scene_, geometry, pass(progress), seen_.get());
      HalfPictures pictures;
      for (std::size_t half = 0; half < 2; ++half)
        pictures.filtered[half] = pictures.sampled[half] = as_shown(half_reference_image(truth, half));
      if (target.met_by(
              estimate_error(pictures, scene_.definition.exposure_ev, threads_, wraps(scene_.camera))))
        break;
    }
  }

  const EstimatorChoices choices_;
  const TruthScene scene_;  ///< with the light that is followed
  const std::uint64_t seed_;
  const int threads_;
  const std::shared_ptr<const SeenEmission> seen_;  ///< null: nothing small that emits is in view
  std::optional<int> spp_;                          ///< when it is found

  /// An object's truth that another process made.
  struct Given {
    int object = 0;
    TruthSums truth;
  };
  std::optional<Given> given_;
  std::optional<ObjectGeometry> geometry_;
  TruthSums truth_;
};

}  // namespace

std::unique_ptr<SceneEstimator> make_path_estimator(const TruthScene& scene, const EstimateOptions& options) {
  return std::make_unique<PathEstimator>(scene, options);
}

}  // namespace seamline::renderer
