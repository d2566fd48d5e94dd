#pragma once
#include <span>
#include <vector>

#include "renderer/depth/occlusion_test.h"
#include "renderer/picture/pixel_sums.h"
#include "renderer/realtime/realtime_world.h"
#include "renderer/transport/answers.h"
#include "renderer/transport/object_light.h"
#include "renderer/transport/path_batch.h"
#include "renderer/transport/scene_geometry.h"
#include "renderer/transport/uncovered_light.h"
#include "renderer/transport/worlds.h"

namespace seamline::renderer {

class SeenEmission;

/// What the camera ray of one sample meets.
struct StimulusSample {
  int number = 0;  ///< of the pixel's samples
  int x = 0, y = 0;
  Sampler sampler;
  std::optional<SurfacePoint> real;    ///< x_T
  std::optional<SurfacePoint> object;  ///< x_O, at any depth
  std::optional<SurfacePoint> depth;   ///< x_D
  bool covered_in_truth = false;
  bool covered_in_depth = false;      ///< where the recipe asks depth who is in front
  bool is_paired_with_truth = false;  ///< see DepthLight::object_in_truth
  enum class Shows { object, uncovered, sky, from_reference } shows = Shows::uncovered;
};

/// How a sampler asks. Where bounce light on real surfaces may be filtered, the depth mesh's sky light joins
/// it, because it may be filtered too. `tail_every`: see PathRules; used only then.
struct LightSampling {
  bool may_filter = false;
  int tail_every = 1;
  const SeenEmission* seen = nullptr;  ///< in place of what single samples see of small emitters
};

/// Light that the depth mesh has a part in, of one sample.
struct DepthLight {
  Split without_object, with_object;  ///< off the object, without and with it
  Split object;                       ///< on the object
  /// With `is_paired_with_truth`, the direct part of `object` as the truth answers it for the same sample:
  /// for most it is the same.
  Rgb object_in_truth = Rgb::Zero();
  float uncovered_surfaces = 0;  ///< 1 when these two count
  /// How far the first ray for bounce light got; infinity when it is not known.
  float reach_m = std::numeric_limits<float>::infinity();
};

/// Whether the depth mesh itself has to answer anything.
[[nodiscard]] inline bool needs_mesh(const Answers& answers, const DepthWorld& depth) {
  return depth.occlusion == nullptr ? answers.needs_depth() : answers.asks_depth_for_light();
}

/// Whether an object that a ray from the camera meets is seen in the world of depth. `place`: of the ray.
[[nodiscard]] bool is_in_front(const DepthWorld& depth, const MaskPlace& place, const SurfacePoint& object,
                               const std::optional<SurfacePoint>& on_mesh);

/// What one worker needs to look at samples: its counts, and memory that is used again and again.
class SamplingWork {
 public:
  /// Of everything asked with it.
  [[nodiscard]] RayCounts counts() const { return counts_ + paths_.counts(); }

 private:
  friend class StimulusSampler;
  RayCounts counts_;
  PathBatch paths_;
  LightRays light_rays_;
  std::vector<ObjectPoint> object_points_;
  std::vector<Rgb> lit_object_;
  std::vector<UncoveredPoint> uncovered_points_;
  std::vector<RadiancePair> lit_uncovered_;
};

/// Looks at a stimulus sample by sample, and asks what the depth mesh has to answer. Shared by both
/// estimators.
class StimulusSampler {
 public:
  /// The mesh of `depth` may be null when the recipe asks nothing of it.
  StimulusSampler(const TruthScene& scene, const ObjectGeometry& geometry, const DepthWorld& depth,
                  const Recipe& recipe, std::uint64_t seed, const LightSampling& sampling = {});

  /// What the camera rays of samples meet; `out` is as long as `ids`.
  void look(std::span<const SampleId> ids, std::vector<StimulusSample>& out, SamplingWork& work) const;

  /// Everything that some geometry other than the truth alone has to answer: light off the object and on
  /// it. `lights` is as long as `samples`.
  void ask_depth(std::span<const StimulusSample> samples, std::vector<DepthLight>& lights,
                 SamplingWork& work) const;

  /// Light of a covered sample's object, and of an uncovered sample's surface, as the truth answers.
  [[nodiscard]] Split object_in_truth(const StimulusSample& sample, SamplingWork& work) const;
  [[nodiscard]] RadiancePair uncovered_in_truth(const StimulusSample& sample, SamplingWork& work) const;

  /// Radiance of the environment where a sample shows nothing else.
  [[nodiscard]] Rgb sky_behind(const StimulusSample& sample) const {
    return scene_.light.sky(camera_ray(scene_.camera, sample.x, sample.y, sample.sampler).direction);
  }

  /// Whether sun and sky off the object are the truth's own.
  [[nodiscard]] bool direct_from_truth() const {
    return answers_.receiver == Who::truth && answers_.real_lit == Who::truth;
  }
  /// The surface off the object whose light is asked for; null when the sample shows none.
  [[nodiscard]] const SurfacePoint* receiver(const StimulusSample& sample) const {
    if (sample.shows != StimulusSample::Shows::uncovered) return nullptr;
    return answers_.receiver == Who::depth || answers_.bounce == Who::depth ? &*sample.depth : &*sample.real;
  }
  /// Whether the object's shadow is a dark layer, which has no other light in it.
  [[nodiscard]] bool is_dark_layer() const {
    return realtime_ != nullptr && realtime_->is_dark_layer() && !direct_from_truth();
  }
  /// How the picture is put together.
  [[nodiscard]] Compositing compositing() const {
    return realtime_ != nullptr && realtime_->pipeline.compositing == PipelineCompositing::additive
               ? Compositing::additive
               : Compositing::ratio;
  }
  [[nodiscard]] const Recipe& recipe() const { return recipe_; }
  [[nodiscard]] const TruthScene& scene() const { return scene_; }

 private:
  [[nodiscard]] Sampler sampler_of(const SampleId& id) const { return {seed_, id.x, id.y, id.number}; }
  [[nodiscard]] StimulusSample::Shows shown(const StimulusSample& sample) const;
  /// Where a sample lies in the photograph; 0 where no mask is looked up so.
  [[nodiscard]] Eigen::Array2f place_of(const StimulusSample& sample) const {
    return looks_in_photograph_ ? camera_place(scene_.camera, sample.x, sample.y, sample.sampler)
                                : Eigen::Array2f::Zero();
  }
  [[nodiscard]] RealQuestion ask(Who who, const StimulusSample& sample, const SurfacePoint& point) const;
  [[nodiscard]] Split object_light(const StimulusSample& sample, const Answers& answers,
                                   SamplingWork& work) const;
  /// Whether the depth mesh says what is mirrored in the object, and the object mirrors.
  [[nodiscard]] bool asks_for_mirror() const {
    return answers_.mirrored == Who::depth && geometry_.object.is_glossy();
  }
  /// Whether one path through the depth mesh answers everything off the object.
  [[nodiscard]] bool uncovered_is_one_path() const {
    return !methods_light() && answers_.bounce == Who::depth && answers_.receiver == Who::depth &&
           answers_.real_lit == Who::depth && (matte_ == nullptr || sampling_.may_filter);
  }
  /// Whether what suns do at that path's first surface is the matte's to say.
  [[nodiscard]] bool path_leaves_suns_to_matte() const {
    return matte_ != nullptr && uncovered_is_one_path();
  }
  /// Whether methods of real time, and not rays, find direct light past the depth mesh.
  [[nodiscard]] bool methods_light() const { return realtime_ != nullptr && realtime_->changes_light(); }
  [[nodiscard]] bool methods_light_object() const {
    return methods_light() && answers_.object_lit == Who::depth;
  }
  void even_out(StimulusSample& sample) const;
  void override_normals(StimulusSample& sample) const;
  void add_direct_on_object(std::span<const StimulusSample> samples, std::span<DepthLight> lights,
                            SamplingWork& work) const;
  void add_direct_on_uncovered(std::span<const StimulusSample> samples, std::span<DepthLight> lights,
                               SamplingWork& work) const;
  /// Whether the path of a sample through the depth mesh is followed together with others.
  [[nodiscard]] PathRules uncovered_rules(const Sampler& sampler) const;
  [[nodiscard]] bool is_batched(const StimulusSample& sample) const;
  void follow_paths(std::span<const StimulusSample> samples, std::span<DepthLight> lights,
                    SamplingWork& work) const;
  void add_one_path(const StimulusSample& sample, DepthLight& out, SamplingWork& work) const;

  const TruthScene& scene_;
  const ObjectGeometry& geometry_;
  const Geometry* depth_;           ///< the mesh; null where nothing is asked of it
  const OcclusionTest* occlusion_;  ///< null: the mesh decides
  bool looks_in_photograph_;        ///< some mask may be of the photograph's shape
  const ShadowMatte* matte_;        ///< null: the mesh decides, or nobody asks
  const RealtimeWorld* realtime_;   ///< null: everything is traced
  const Recipe& recipe_;
  const Answers& answers_;
  Worlds depth_worlds_;
  std::uint64_t seed_;
  LightSampling sampling_;
};

}  // namespace seamline::renderer
