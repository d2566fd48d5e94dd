#include "study/trials/trial_clip.h"

#include <algorithm>
#include <string>

#include "stimuli/pictures/attention_image.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/hash.h"
#include "support/text/error.h"

namespace seamline::study {
namespace {

const ManifestStimulus& stimulus_of(const RenderedSet& set, const Trial& trial) {
  return set.manifest.stimuli.at(static_cast<std::size_t>(trial.stimulus));
}

ClipReader open_clip(const RenderedSet& set, const std::vector<ClipRecord>& records,
                     const std::string& name) {
  const auto found =
      std::find_if(records.begin(), records.end(), [&](const ClipRecord& one) { return one.name == name; });
  if (found == records.end())
    throw input_error(
        {.file = (set.folder / clip_set_file).string(), .wanted = "a clip of " + name, .found = "none"});
  const std::filesystem::path path = path_in_set(set.folder, found->file);
  if (sha256_of_file(path) != found->sha256)
    throw input_error(
        {.file = path.string(), .wanted = "the clip that the set was rendered with", .found = "other bytes"});
  return ClipReader(path);
}

ClipReader picture_of(const RenderedSet& set, const ClipSet& clips, const Trial& trial) {
  const ManifestStimulus& stimulus = stimulus_of(set, trial);
  return trial.kind == TrialKind::stimulus ? open_clip(set, clips.stimuli, stimulus.id)
                                           : open_clip(set, clips.references, truth_of(stimulus.stimulus));
}

ClipSet clips_of(const RenderedSet& set) {
  std::optional<ClipSet> clips = read_clip_set(set.folder);
  if (!clips)
    throw input_error({.file = set.folder.string(), .wanted = clip_set_file, .found = "no such file"});
  return std::move(*clips);
}

}  // namespace

TrialClip::TrialClip(const RenderedSet& set, const Trial& trial)
    : picture_(picture_of(set, clips_of(set), trial)) {
  if (trial.kind != TrialKind::attention) return;
  const Stimulus& stimulus = stimulus_of(set, trial).stimulus;
  click_map_.emplace(open_clip(set, clips_of(set).click_maps, truth_of(stimulus)));
  object_ = stimulus.object_index;
}

ByteImage TrialClip::next() {
  const ByteImage& frame = picture_.decode();
  return click_map_ ? attention_image(frame, click_map_->decode(), object_) : frame;
}

bool shows_clips(const RenderedSet& set) {
  return set.study.clip != nullptr;
}

std::vector<ObjectMap> objects_of_frames(const RenderedSet& set, const Trial& trial) {
  ClipReader reader = open_clip(set, clips_of(set).click_maps, truth_of(stimulus_of(set, trial).stimulus));
  std::vector<ObjectMap> maps;
  for (int frame = 0; frame < reader.frames(); ++frame) maps.push_back(make_object_map(reader.decode()));
  return maps;
}

}  // namespace seamline::study
