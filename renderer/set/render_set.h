#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "renderer/set/set_records.h"

namespace seamline::renderer {

/// What `seamline render` was asked for.
struct RenderRequest {
  std::filesystem::path set_folder;
  std::string only = {};             ///< pattern of stimulus ids, `*` stands for any text; empty: all
  int threads = 0;                   ///< 0: one for each core
  std::optional<int> spp = {};       ///< overrides the study's samples_per_pixel
  std::optional<double> error = {};  ///< instead: sample until the estimated error is below (display units)
  Estimator estimator = Estimator::fast;
  Omissions omit = {};                   ///< what the fast estimator leaves out
  std::optional<MeshDensity> mesh = {};  ///< overrides the study's mesh
  int shard = 1, shard_count = 1;        ///< this process renders every shard_count-th object of a scene
  bool layers = false;                   ///< also write the float EXR layers of every stimulus
  bool contact_sheet = false;            ///< also write one contact sheet for each artifact
};

struct RenderSummary {
  int rendered = 0;
  int already_finished = 0;
  double seconds = 0;
  std::vector<std::pair<std::string, Savings>> savings;  ///< of each scene rendered
};

/// The study's own settings with what was asked for.
[[nodiscard]] RenderSettings render_settings(const StudyDefinition& study, const RenderRequest& request);

/// Renders a study into a set: references, stimuli, manifest. Stimuli that are finished already are kept.
/// Throws InputError for wrong input and Interrupted when the person stopped it; what was finished stays and
/// a rerun continues.
RenderSummary render_set(const StudyDefinition& study, const RenderRequest& request);

}  // namespace seamline::renderer
