#include "study/trial_picture.h"

#include <fmt/core.h>

#include "stimuli/attention_image.h"
#include "stimuli/support/confined_path.h"
#include "stimuli/support/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

const ManifestStimulus& record_of(const StudySet& set, const PlannedTrial& trial) {
  return set.manifest.stimuli.at(static_cast<std::size_t>(trial.stimulus));
}

const ManifestReference& reference_of(const StudySet& set, const PlannedTrial& trial) {
  const std::string& scene = record_of(set, trial).stimulus.scene;
  for (const ManifestReference& reference : set.manifest.references)
    if (reference.scene == scene) return reference;
  throw input_error({.file = (set.folder / "manifest.json").string(),
                     .field = "references",
                     .wanted = "a reference of the scene " + scene,
                     .found = "none"});
}

ByteImage load(const StudySet& set, const std::string& name, int channels) {
  const fs::path path =
      path_below(set.folder, name, {.file = (set.folder / "manifest.json").string(), .field = "image"});
  ByteImage image = read_bytes_image(path);
  const auto shape = [](int width, int height, int depth) {
    return fmt::format("{} x {} pixels with {} channels", width, height, depth);
  };
  if (image.width_px != set.manifest.width_px || image.height_px != set.manifest.height_px ||
      image.channels != channels)
    throw input_error({.file = path.string(),
                       .wanted = shape(set.manifest.width_px, set.manifest.height_px, channels),
                       .found = shape(image.width_px, image.height_px, image.channels)});
  return image;
}

}  // namespace

ByteImage load_object_ids(const StudySet& set, const PlannedTrial& trial) {
  return load(set, reference_of(set, trial).object_ids, 1);
}

ByteImage load_trial_picture(const StudySet& set, const PlannedTrial& trial) {
  switch (trial.kind) {
    case TrialKind::stimulus:
      return load(set, record_of(set, trial).image, 3);
    case TrialKind::attention:
      return attention_image(load(set, reference_of(set, trial).image, 3), load_object_ids(set, trial),
                             record_of(set, trial).stimulus.object_index);
    case TrialKind::reference:
      return load(set, reference_of(set, trial).image, 3);
  }
  return {};
}

int right_object(const StudySet& set, const PlannedTrial& trial) {
  return trial.kind == TrialKind::reference ? 0 : record_of(set, trial).stimulus.object_index;
}

}  // namespace seamline
