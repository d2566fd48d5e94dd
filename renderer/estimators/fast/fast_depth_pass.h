#pragma once
#include "renderer/estimators/stimulus_sampler.h"
#include "renderer/picture/scene_sums.h"

namespace seamline::renderer {

/// What the depth mesh answered in one pixel, summed over the samples of one half.
struct DepthPixel {
  Unmirrored without_object, with_object;  ///< light off the object as far as the depth mesh has a part in
                                           ///< it; its sky is in `bounce`, with what may be filtered
  Unmirrored object;                       ///< light on the object, as far as the depth mesh answers it
  float uncovered_surfaces = 0;            ///< samples in these two
  float depth_sky = 0;  ///< uncovered samples where the truth has a surface and the depth mesh sky
  float covered = 0;    ///< samples in `object`
};

/// What is mirrored of it.
struct DepthMirrored {
  Rgb without_object = Rgb::Zero(), with_object = Rgb::Zero(), object = Rgb::Zero();
};

/// How many samples each block has, even numbers. A ratio is content with few of them, and so is what the
/// depth mesh adds to the truth's light on the object: with fewer than the photograph has, the truth is asked
/// beside it. Where light on the object is not the truth's in so many ways, as many are needed as the
/// photograph has, because noise must not give the object away.
struct DepthSamples {
  std::vector<int> uncovered;   ///< that ask for light off the object
  std::vector<int> object;      ///< that ask for light on the object, in pixels that show it
  std::vector<int> photograph;  ///< that the photograph has
};

/// The answers of one stimulus, with as many samples in each block as were asked.
struct DepthAnswers {
  TileGrid grid;
  std::array<std::vector<DepthPixel>, 2> halves;
  std::array<std::vector<DepthMirrored>, 2> mirrored;  ///< empty where nothing is glossy
  std::array<std::vector<Rgb>, 2> object_in_truth;     ///< see DepthLight; empty when it is never asked for
  std::vector<SeenSurface> guides;  ///< of the surfaces that light is asked for; empty when none is
  DepthSamples spp;
  RayCounts counts;

  [[nodiscard]] BlockGrid blocks() const { return {grid.width_px, grid.height_px, grid.wraps}; }
};
/// `photograph_spp`: samples of each block; `mirrors`: whether anything is glossy.
[[nodiscard]] DepthAnswers empty_answers(const Camera& camera, const Answers& answers,
                                         const std::vector<int>& photograph_spp, bool mirrors);

/// Asks the depth mesh until each block has the samples wanted. `shows_object` has a flag a pixel.
void ask_depth(const StimulusSampler& sampler, const DepthSamples& wanted,
               const std::vector<char>& shows_object, int threads,
               const std::function<void(double share_done)>& progress, DepthAnswers& answers);

/// Who is in front, truth against depth mesh, in one pixel and half: numbers of samples that one of them
/// covers with the object and the other does not.
struct OrderPixel {
  float truth_only = 0;  ///< covered in the truth, uncovered in the depth mesh
  float depth_only = 0;  ///< the other way round
};

/// For the tiles an object has (null: the same order everywhere). A ray to the object, and one into the depth
/// mesh where it decides, for each sample that meets the object; what the truth shows there was kept by its
/// own pass.
using ObjectOrder = std::vector<std::array<std::vector<OrderPixel>, 2>>;
[[nodiscard]] ObjectOrder ask_order(const TruthScene& scene, const SceneSums& sums, int object_index,
                                    const Geometry& object, const DepthWorld& depth, std::uint64_t seed,
                                    int threads);

}  // namespace seamline::renderer
