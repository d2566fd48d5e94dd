#include "study/trials/trial_picture.h"

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/pictures/attention_image.h"
#include "stimuli/pictures/mask_image.h"
#include "stimuli/set/manifest_pictures.h"
#include "study/trials/right_rule.h"
#include "study/trials/trial_clip.h"
#include "support/text/error.h"

namespace seamline::study {
namespace {

const ManifestStimulus& record_of(const RenderedSet& set, const Trial& trial) {
  return set.manifest.stimuli.at(trial.stimulus);
}

const ManifestReference& scene_reference(const RenderedSet& set, const Trial& trial) {
  return reference_of(set.folder, set.manifest, record_of(set, trial).stimulus);
}

ByteImage load_reference(const RenderedSet& set, const Trial& trial) {
  return read_manifest_picture(set.folder, reference_picture(set.manifest, scene_reference(set, trial)));
}

/// One a scene, whatever stimulus it follows: its place among the references is its stream.
ByteImage load_mask(const RenderedSet& set, const Trial& trial) {
  const ManifestReference& own = scene_reference(set, trial);
  std::uint64_t stream = 0;
  for (const ManifestReference& one : set.manifest.references) {
    if (one.truth == own.truth) break;
    ++stream;
  }
  return mask_image(load_reference(set, trial), task_of(set, trial)->mask, set.study.seed, stream);
}

}  // namespace

ByteImage load_object_ids(const RenderedSet& set, const Trial& trial) {
  return read_manifest_picture(set.folder, click_map_picture(set.manifest, scene_reference(set, trial)));
}

ByteImage load_trial_picture(const RenderedSet& set, const Trial& trial) {
  if (shows_clips(set)) return TrialClip(set, trial).next();
  switch (trial.kind) {
    case TrialKind::stimulus:
      return read_manifest_picture(set.folder, stimulus_picture(set.manifest, record_of(set, trial)));
    case TrialKind::attention:
      return attention_image(load_reference(set, trial), load_object_ids(set, trial),
                             record_of(set, trial).stimulus.object_index);
    case TrialKind::reference:
      return load_reference(set, trial);
    case TrialKind::mask:
      return load_mask(set, trial);
  }
  return {};
}

ByteImage load_all_eyes(const RenderedSet& set, const Trial& trial) {
  const ManifestStimulus& record = record_of(set, trial);
  if (trial.kind == TrialKind::stimulus)
    return read_all_eyes(set.folder, stimulus_picture(set.manifest, record), record.more_eyes);
  const ManifestReference& reference = scene_reference(set, trial);
  const ByteImage picture =
      read_all_eyes(set.folder, reference_picture(set.manifest, reference), reference.more_eyes);
  if (trial.kind == TrialKind::reference) return picture;
  if (reference.more_object_ids.size() != reference.more_eyes.size())
    throw input_error({.file = (set.folder / "manifest.json").string(),
                       .field = "references.more_object_ids",
                       .wanted = "a click map for each eye, which this program writes: render the set again",
                       .found = "that of the left eye alone"});
  return attention_image(
      picture,
      read_all_eyes(set.folder, click_map_picture(set.manifest, reference), reference.more_object_ids),
      record.stimulus.object_index);
}

bool has_more_eyes(const RenderedSet& set, const Trial& trial) {
  return !record_of(set, trial).more_eyes.empty();
}

std::array<int, 2> shown_size_px(const RenderedSet& set) {
  bool pair = false;
  for (const TaskGroup& group : task_groups(set.study))
    pair = pair || facts_of(group.task.get()).kind == TaskKind::pair;
  return shown_size_px(set, pair ? TaskKind::pair : TaskKind::object);
}

std::array<int, 2> shown_size_px(const RenderedSet& set, TaskKind kind) {
  const int width_px = set.manifest.width_px;
  return {kind == TaskKind::pair ? 2 * width_px + pair_gap_px : width_px, set.manifest.height_px};
}

int right_object(const RenderedSet& set, const Trial& trial) {
  if (trial.right_index != 0) return trial.right_index;
  return trial.kind == TrialKind::reference ? 0 : record_of(set, trial).stimulus.object_index;
}

}  // namespace seamline::study
