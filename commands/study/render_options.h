#pragma once
#include <optional>
#include <string>
#include <vector>

#include "sets/render_set.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace seamline::renderer {

/// What `seamline render` and `seamline job` are told of a set.
struct RenderOptions {
  std::string study, asset_root, set, only;
  std::optional<MeshDensity> mesh;
  Estimator estimator = Estimator::fast;
  double error = 0;
  int threads = 0, spp = 0;
  std::vector<std::string> no_omit;
  bool layers = false;
};

/// Adds the study, the folder of the set and what decides its pictures. Returns the option --error, beside
/// which others may have no meaning.
void add_render_options(CLI::App& command, RenderOptions& options);

/// The study file of these options; its files must exist.
[[nodiscard]] StudyDefinition study_of(const RenderOptions& options);

/// What they ask for. Throws InputError naming an unknown omission.
[[nodiscard]] RenderRequest request_of(const RenderOptions& options);

/// The options that decide what is rendered, as they were given: for the pieces of a job.
[[nodiscard]] std::vector<std::string> options_for_pieces(const RenderOptions& options);

}  // namespace seamline::renderer
