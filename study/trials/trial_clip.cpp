#include "study/trials/trial_clip.h"

#include <algorithm>
#include <string>

#include "stimuli/pictures/attention_image.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/error.h"

namespace seamline::study {
namespace {

const ManifestStimulus& stimulus_of(const RenderedSet& set, const Trial& trial) {
  return set.manifest.stimuli.at(trial.stimulus);
}

/// A clip of the set, whose bytes are those that it was rendered with.
std::filesystem::path checked_clip(const RenderedSet& set, const std::vector<ClipRecord>& records,
                                   const std::string& name) {
  const auto found =
      std::find_if(records.begin(), records.end(), [&](const ClipRecord& one) { return one.name == name; });
  if (found == records.end())
    throw input_error(
        {.file = (set.folder / clip_set_file).string(), .wanted = "a clip of " + name, .found = "none"});
  std::filesystem::path path = path_in_set(set.folder, found->file);
  if (sha256_of_file(path) != found->sha256)
    throw input_error(
        {.file = path.string(), .wanted = "the clip that the set was rendered with", .found = "other bytes"});
  return path;
}

ClipSet clips_of(const RenderedSet& set) {
  std::optional<ClipSet> clips = read_clip_set(set.folder);
  if (!clips)
    throw input_error({.file = set.folder.string(), .wanted = clip_set_file, .found = "no such file"});
  return std::move(*clips);
}

/// Of the trial's pictures; an attention trial's are made of the reference's.
std::filesystem::path file_of(const RenderedSet& set, const Trial& trial) {
  const ClipSet clips = clips_of(set);
  const ManifestStimulus& stimulus = stimulus_of(set, trial);
  return trial.kind == TrialKind::stimulus ? checked_clip(set, clips.stimuli, stimulus.id)
                                           : checked_clip(set, clips.references, truth_of(stimulus.stimulus));
}

ClipReader click_maps_of(const RenderedSet& set, const Trial& trial) {
  return ClipReader(checked_clip(set, clips_of(set).click_maps, truth_of(stimulus_of(set, trial).stimulus)));
}

}  // namespace

TrialClip::TrialClip(const RenderedSet& set, const Trial& trial) : picture_(file_of(set, trial)) {
  if (trial.kind != TrialKind::attention) return;
  click_map_.emplace(click_maps_of(set, trial));
  object_ = stimulus_of(set, trial).stimulus.object_index;
}

ByteImage TrialClip::next() {
  const ByteImage& frame = picture_.decode();
  return click_map_ ? attention_image(frame, click_map_->decode(), object_) : frame;
}

bool shows_clips(const RenderedSet& set) {
  return set.study.clip != nullptr;
}

std::string clip_bytes(const RenderedSet& set, const Trial& trial) {
  if (trial.kind != TrialKind::attention) return read_file(file_of(set, trial), largest_clip_bytes);
  TrialClip clip(set, trial);
  ClipWriter writer(clip.shape());
  for (int frame = 0; frame < clip.frames(); ++frame) writer.add(clip.next());
  return writer.bytes();
}

std::vector<ObjectMap> objects_of_frames(const RenderedSet& set, const Trial& trial) {
  ClipReader reader = click_maps_of(set, trial);
  std::vector<ObjectMap> maps;
  for (int frame = 0; frame < reader.frames(); ++frame)
    maps.push_back(make_object_map(reader.decode(), usual_reach_px, false, objects_of(set.study)));
  return maps;
}

}  // namespace seamline::study
