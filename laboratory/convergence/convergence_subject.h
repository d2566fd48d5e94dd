#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>

#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/estimators/path/path_depth_pass.h"
#include "renderer/transport/answers.h"
#include "stimuli/definition/stimulus.h"

namespace seamline::renderer {

/// The parts of `seamline lab convergence`, each with its own figure and table; `links` (captured depth),
/// `realtime` (methods of real time), `light` (how light is sampled), `mitigation` (masks and mattes) and
/// `filter` (of bounce light) are made where they are asked for, as are those that make no picture: depth
/// cameras, repair, registration, fits, intervals and plans.
enum class ConvergencePart {
  samples,
  mesh,
  width,
  compositing,
  links,
  realtime,
  light,
  mitigation,
  filter,
  sensor,
  repair,
  registration,
  fit,
  joint,
  interval,
  plan
};
inline constexpr std::array<ConvergencePart, 16> every_convergence_part = {
    ConvergencePart::samples,     ConvergencePart::mesh,       ConvergencePart::width,
    ConvergencePart::compositing, ConvergencePart::links,      ConvergencePart::realtime,
    ConvergencePart::light,       ConvergencePart::mitigation, ConvergencePart::filter,
    ConvergencePart::sensor,      ConvergencePart::repair,     ConvergencePart::registration,
    ConvergencePart::fit,         ConvergencePart::joint,      ConvergencePart::interval,
    ConvergencePart::plan};
[[nodiscard]] std::string_view word(ConvergencePart part);

/// What `seamline lab convergence` was asked for.
struct ConvergenceRequest {
  std::string only = {};           ///< pattern that matches one stimulus id
  std::filesystem::path out = {};  ///< folder of figures and tables
  std::set<ConvergencePart> parts = {ConvergencePart::samples, ConvergencePart::mesh, ConvergencePart::width,
                                     ConvergencePart::compositing};
  int threads = 0;              ///< 0: one for each core
  double seconds = 120;         ///< about how long `samples` may take; `compositing` half as long
  std::optional<int> spp = {};  ///< of `mesh` and `width`; none: the study's
  /// Of the adaptive depth mesh, besides the study's own.
  std::vector<double> tolerances = {1e-2, 3e-3, 1e-3, 3e-4, 1e-4, 3e-5, 1e-5, 3e-6, 1e-6};
  std::optional<int> width_px = {}, height_px = {};  ///< of the picture; none: the study's
};

/// One stimulus, loaded: what every part renders.
struct ConvergenceSubject {
  StudyDefinition study;  ///< with the picture's size as asked for
  Stimulus stimulus;
  int threads = 1;
  int spp = 64;  ///< of `mesh` and `width`
  Recipe recipe;
  TruthScene scene;
  ObjectGeometry geometry;
  DepthMap map;  ///< of the stimulus' own width

  [[nodiscard]] double exposure_ev() const { return scene.definition.exposure_ev; }
  [[nodiscard]] PassOptions pass(int samples, std::uint64_t seed) const {
    return {.spp = samples, .seed = seed, .threads = threads};
  }
};

/// Finds the stimulus and loads its scene. Throws InputError when the pattern does not match exactly one
/// stimulus that the depth mesh has a part in, or a file is wrong.
[[nodiscard]] ConvergenceSubject load_subject(StudyDefinition study, const ConvergenceRequest& request);

/// The local scene of a depth map of the subject, with `density` and `tolerance`.
[[nodiscard]] DepthMesh subject_mesh(const ConvergenceSubject& subject, const DepthMap& map,
                                     MeshDensity density, double tolerance);
/// Ready for rays.
[[nodiscard]] Geometry subject_geometry(const ConvergenceSubject& subject, const DepthMesh& mesh);

}  // namespace seamline::renderer
