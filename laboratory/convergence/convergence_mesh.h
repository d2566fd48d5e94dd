#pragma once
#include <optional>
#include <vector>

#include "laboratory/convergence/convergence_subject.h"

namespace seamline::renderer {

/// What one tolerance of the adaptive depth mesh costs, and what it changes against full density.
struct MeshRow {
  std::optional<double> tolerance = {};  ///< none: full density
  std::int64_t triangles = 0;
  double build_seconds = 0;  ///< mesh from the depth map; of quick builds the fastest of three
  double bvh_seconds = 0;    ///< Embree's hierarchy over it; likewise
  std::int64_t mesh_bytes = 0, embree_bytes = 0;
  double rays_per_second = 0;  ///< a camera ray and a bounce from what it meets, one thread
  double depth_error = 0;      ///< largest |t - r| / r over the dense sphere
  double rmse = 0;             ///< of the stimulus, display units; same sample points
  double changed_share = 0;    ///< of the pixels, by more than one 8-bit step
  int largest_change_steps = 0;
};

/// The rule for the default tolerance: at most one pixel in 1,000 changes by more than one 8-bit step, and
/// none by more than 8.
inline constexpr double allowed_changed_share = 1e-3;
inline constexpr int allowed_change_steps = 8;
[[nodiscard]] bool keeps_rule(const MeshRow& row);

struct MeshResult {
  std::vector<MeshRow> rows = {};  ///< coarsest first, full density last
  double default_tolerance = 0;
  bool default_keeps_rule = false;
  /// The largest tolerance that keeps the rule together with every finer one tried; none: not even the
  /// finest.
  std::optional<double> largest_that_keeps = {};
};

/// Rebuilds the stimulus' depth mesh with these tolerances, the study's and at full density, and renders the
/// stimulus with each. `truth` is the subject's with its `spp` and the study's seed.
[[nodiscard]] MeshResult measure_mesh(const ConvergenceSubject& subject, const TruthSums& truth,
                                      const std::vector<double>& tolerances);

}  // namespace seamline::renderer
