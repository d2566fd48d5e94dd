#include "study/trial_picture.h"

#include <fmt/core.h>

#include "stimuli/attention_image.h"
#include "stimuli/set_files.h"
#include "stimuli/support/error.h"

namespace seamline::study {
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

/// Only what the set was rendered with is shown to anybody.
ByteImage load(const StudySet& set, const SetFile& file, int channels) {
  check_set_file(set.folder, file);
  const fs::path path = set_file_path(set.folder, file.file);
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

ByteImage load_reference(const StudySet& set, const PlannedTrial& trial) {
  const ManifestReference& reference = reference_of(set, trial);
  return load(set, {reference.image, reference.image_sha256}, 3);
}

}  // namespace

ByteImage load_object_ids(const StudySet& set, const PlannedTrial& trial) {
  const ManifestReference& reference = reference_of(set, trial);
  return load(set, {reference.object_ids, reference.object_ids_sha256}, 1);
}

ByteImage load_trial_picture(const StudySet& set, const PlannedTrial& trial) {
  switch (trial.kind) {
    case TrialKind::stimulus:
      return load(set, {record_of(set, trial).image, record_of(set, trial).sha256}, 3);
    case TrialKind::attention:
      return attention_image(load_reference(set, trial), load_object_ids(set, trial),
                             record_of(set, trial).stimulus.object_index);
    case TrialKind::reference:
      return load_reference(set, trial);
  }
  return {};
}

int right_object(const StudySet& set, const PlannedTrial& trial) {
  return trial.kind == TrialKind::reference ? 0 : record_of(set, trial).stimulus.object_index;
}

}  // namespace seamline::study
