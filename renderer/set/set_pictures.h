#pragma once
#include <filesystem>
#include <string>

#include "renderer/estimators/estimator.h"
#include "renderer/picture/composite.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// What one picture of a set is made from.
struct StimulusPicture {
  const EstimatedStimulus& made;
  const Composite& composite;
  double exposure_ev = 0;
};

/// Writes a stimulus' picture into a set, and returns what the manifest says of it; how it was isolated and
/// which mesh it asked the caller adds.
[[nodiscard]] ManifestStimulus write_stimulus(const std::filesystem::path& set_folder,
                                              const Stimulus& stimulus, const StimulusPicture& picture);

/// Writes a scene's reference and its click map.
[[nodiscard]] ManifestReference write_reference(const std::filesystem::path& set_folder,
                                                const std::string& truth, const SceneReference& reference,
                                                double exposure_ev);

}  // namespace seamline::renderer
