#include "sets/clips/set_clips.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "stimuli/definition/clip_frames.h"
#include "stimuli/set/clip_file.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/files/image.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

/// Writes a clip of these pictures of the set.
ClipRecord write_clip(const fs::path& set_folder, const std::string& name, const std::string& file,
                      const std::vector<std::string>& pictures, double frames_per_s) {
  std::optional<ClipWriter> writer;
  for (const std::string& picture : pictures) {
    const ByteImage frame = read_bytes_image(path_in_set(set_folder, picture));
    if (!writer)
      writer.emplace(ClipShape{.width_px = frame.width_px,
                               .height_px = frame.height_px,
                               .channels = frame.channels,
                               .frames_per_s = frames_per_s});
    writer->add(frame);
  }
  const std::string bytes = writer->bytes();
  write_file_atomically(set_folder / file, bytes);
  return {.name = name, .file = file, .sha256 = sha256(bytes)};
}

/// What the manifest says of a clip: its middle frame, the rays of all, the error over those that
/// were judged, and the worst
/// else that any has.
ManifestStimulus record_of_clip(const Clip& clip, const std::vector<const ManifestStimulus*>& frames) {
  ManifestStimulus record = *frames[frames.size() / 2];
  record.id = stimulus_id(clip.shown);
  record.stimulus = clip.shown;
  record.rays = 0;
  record.tiny_denominators = {};
  double square = 0;
  int judged = 0;
  for (const ManifestStimulus* frame : frames)
    if (frame->rmse) square += *frame->rmse * *frame->rmse, ++judged;
  record.rmse.reset();
  if (judged > 0) record.rmse = std::sqrt(square / judged);
  std::set<const ManifestStimulus*> counted;
  for (const ManifestStimulus* frame : frames) {
    if (!counted.insert(frame).second) continue;
    record.rays += frame->rays;
    record.clipped_share = std::max(record.clipped_share, frame->clipped_share);
    record.tiny_denominators.floored_pixels += frame->tiny_denominators.floored_pixels;
    record.tiny_denominators.clamped_pixels += frame->tiny_denominators.clamped_pixels;
    record.tiny_denominators.sealed_pixels += frame->tiny_denominators.sealed_pixels;
    record.tiny_denominators.not_finite_pixels += frame->tiny_denominators.not_finite_pixels;
  }
  return record;
}

}  // namespace

Manifest assemble_clips(const StudyDefinition& study, const fs::path& set_folder, const Manifest& of_frames) {
  prepare_output_folder(set_folder / "clips");
  std::map<std::string, const ManifestStimulus*> by_id;
  for (const ManifestStimulus& frame : of_frames.stimuli) by_id[frame.id] = &frame;
  std::map<std::string, const ManifestReference*> by_truth;
  for (const ManifestReference& reference : of_frames.references) by_truth[reference.truth] = &reference;
  const double frames_per_s = study.clip->frames_per_s;
  ClipSet clips{.frames = study.clip->frames, .frames_per_s = frames_per_s, .loops = study.clip->loops};
  Manifest out = of_frames;
  out.stimuli.clear();
  out.references.clear();
  std::set<std::string> truths;
  for (const Clip& clip : list_clips(study)) {
    std::vector<const ManifestStimulus*> frames;
    std::vector<std::string> pictures, references, click_maps;
    for (const Stimulus& frame : clip.frames)
      if (const auto found = by_id.find(stimulus_id(frame)); found != by_id.end()) {
        frames.push_back(found->second);
        pictures.push_back(found->second->image);
        references.push_back(found->second->reference);
        click_maps.push_back(found->second->object_ids);
      }
    if (frames.size() < clip.frames.size()) continue;
    out.stimuli.push_back(record_of_clip(clip, frames));
    const std::string& id = out.stimuli.back().id;
    clips.stimuli.push_back(write_clip(set_folder, id, "clips/" + id + ".clip", pictures, frames_per_s));
    const std::string& truth = truth_of(clip.shown);
    if (!truths.insert(truth).second) continue;
    ManifestReference middle = *by_truth.at(truth_of(frames[frames.size() / 2]->stimulus));
    middle.truth = truth;
    out.references.push_back(middle);
    const std::string name = "clips/reference-" + truth;
    clips.references.push_back(write_clip(set_folder, truth, name + ".clip", references, frames_per_s));
    clips.click_maps.push_back(write_clip(set_folder, truth, name + "-ids.clip", click_maps, frames_per_s));
  }
  std::erase_if(out.left_out, [](const std::string& sentence) {
    const std::size_t mark = sentence.find('@');
    return mark != std::string::npos && sentence.compare(mark, 4, "@000") != 0;
  });
  write_clip_set(set_folder, clips);
  return out;
}

}  // namespace seamline::renderer
