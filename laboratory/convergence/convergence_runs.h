#pragma once
#include <map>

#include "laboratory/convergence/convergence_subject.h"
#include "renderer/picture/composite.h"

namespace seamline::renderer {

/// One rendering of the subject by the `path` estimator, and what it cost.
struct PathRun {
  StimulusSums sums;
  Image reference, matte;  ///< of the truth pass
  double truth_seconds = 0, stimulus_seconds = 0;
  std::int64_t rays = 0;

  [[nodiscard]] double seconds() const { return truth_seconds + stimulus_seconds; }
};

/// Truth pass and stimulus pass. `geometry` is the subject's, or `without_object`'s.
[[nodiscard]] PathRun render_path(const ConvergenceSubject& subject, const Recipe& recipe,
                                  const ObjectGeometry& geometry, const Geometry& depth,
                                  const PassOptions& options);

/// The subject's truth with no virtual object in it.
[[nodiscard]] ObjectGeometry without_object(const ConvergenceSubject& subject);

/// The runs at one number of samples, each rendered once however many series ask for it. Memory is that of
/// one number of samples: asking for another forgets the earlier one's.
class PathRuns {
 public:
  PathRuns(const ConvergenceSubject& subject, const Geometry& depth);

  /// With and without object coupled: what a set is rendered with.
  const PathRun& coupled(int spp, std::uint64_t seed);
  /// The same passes through a world that lacks the object: what a rendering of its own without the object
  /// costs.
  const PathRun& without(int spp, std::uint64_t seed);

 private:
  const PathRun& find_or_render(const ObjectGeometry& geometry, int spp, std::uint64_t seed);

  const ConvergenceSubject& subject_;
  const Geometry& depth_;
  ObjectGeometry no_object_;
  int spp_ = 0;
  std::map<std::pair<const ObjectGeometry*, std::uint64_t>, PathRun> runs_;
};

/// What two renderings make that share no random numbers: background and light without the object from the
/// first, coverage, object and light with it from the second, as means over each one's own samples of a
/// pixel. All samples are in the first half.
[[nodiscard]] StimulusSums join_independent(const StimulusSums& without, const StimulusSums& with);

/// The same layers on a given photograph: the background's sums become those of a long rendering (means over
/// its uncovered samples), whose noise both pictures of a comparison then share.
[[nodiscard]] StimulusSums onto_given_background(const StimulusSums& sums, const StimulusSums& photograph);

/// One half of the samples as layers of their own.
[[nodiscard]] StimulusSums half_of(const StimulusSums& sums, std::size_t half);

/// 1 where the object covers no sample of a pixel, else 0.
[[nodiscard]] Image off_object_mask(const PathRun& run);

}  // namespace seamline::renderer
