#include "renderer/estimators/fast/object_noise.h"

#include "raytracer/common/parallel.h"

namespace seamline::renderer {

std::vector<int> samples_on_object(const ObjectTruth& truth, const StimulusSums& stimulus,
                                   const std::vector<int>& asked_spp, double most_variance, int threads) {
  std::vector<int> wanted = asked_spp;
  const BlockGrid blocks = truth.scene_sums.blocks();
  parallel_for(blocks.count(), threads, [&](int block) {
    int& spp = wanted[block];
    const int all = truth.scene_sums.spp[block];
    if (spp == 0 || spp >= all) return;
    double in_photograph = 0, in_stimulus = 0;
    const BlockGrid::Rectangle r = blocks.rectangle(block);
    for (int y = r.top; y < r.bottom; ++y)
      for (int x = r.left; x < r.right; ++x) {
        const std::size_t i = truth.truth_sums.index(x, y);
        const auto& photograph = truth.truth_sums.halves;
        const Rgb of_photograph = photograph[0][i].object.total() - photograph[1][i].object.total();
        const Rgb of_stimulus = stimulus.halves[0][i].object - stimulus.halves[1][i].object;
        in_photograph += double{of_photograph.square().sum()};
        in_stimulus += double{of_stimulus.square().sum()};
      }
    const double may_be_added = (most_variance - 1) * in_photograph;
    // What was added falls as samples grow.
    double added = in_stimulus - in_photograph;
    while (added > may_be_added && spp < all) {
      spp = std::min(2 * spp, all);
      added *= 0.5;
    }
  });
  return wanted;
}

}  // namespace seamline::renderer
