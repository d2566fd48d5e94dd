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
  const View& view;
  Image planar_m = {};  ///< depth beside it, of a depth image
};

/// Writes a stimulus' picture into a set, and returns what the manifest says of it; how it was isolated and
/// which mesh it asked the caller adds.
[[nodiscard]] ManifestStimulus write_stimulus(const std::filesystem::path& set_folder,
                                              const Stimulus& stimulus, const StimulusPicture& picture);

/// What a reference picture is made from: the camera's picture of it, which the view composes.
struct ReferencePicture {
  const SceneReference& made;
  double exposure_ev = 0;
  const View& view;
  Image planar_m = {};  ///< depth beside it, of a depth image
};

/// Writes a scene's reference and its click map.
[[nodiscard]] ManifestReference write_reference(const std::filesystem::path& set_folder,
                                                const std::string& truth, const ReferencePicture& picture);

}  // namespace seamline::renderer
