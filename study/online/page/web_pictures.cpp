#include "study/online/page/web_pictures.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "stimuli/definition/looks/condition_tasks.h"
#include "stimuli/definition/looks/study_look.h"
#include "stimuli/set/manifest_pictures.h"
#include "study/trials/right_rule.h"
#include "study/trials/trial_clip.h"
#include "study/trials/trial_picture.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/running/interrupt.h"
#include "support/text/limits.h"

namespace seamline::study::online {
namespace {

const ManifestStimulus& record_at(const RenderedSet& set, int stimulus) {
  return set.manifest.stimuli.at(stimulus);
}

std::string checked_bytes(const RenderedSet& set, const ManifestPicture& picture) {
  check_manifest_picture(set.folder, picture);
  return read_file(path_in_set(set.folder, picture.file), limits::largest_picture_file_bytes);
}

/// Of a picture that no file of the set holds.
std::string png_bytes(const ByteImage& picture) {
  const TemporaryFolder folder;
  write_png(folder / "picture.png", picture);
  return read_file(folder / "picture.png", limits::largest_picture_file_bytes);
}

std::string picture_bytes(const RenderedSet& set, const Trial& trial) {
  if (shows_clips(set)) return clip_bytes(set, trial);
  const ManifestStimulus& record = record_at(set, trial.stimulus);
  if (has_more_eyes(set, trial)) return png_bytes(load_all_eyes(set, trial));
  switch (trial.kind) {
    case TrialKind::stimulus:
      return checked_bytes(set, stimulus_picture(set.manifest, record));
    case TrialKind::attention:
      return png_bytes(load_trial_picture(set, trial));  // as the window makes it
    case TrialKind::reference:
      return checked_bytes(
          set, reference_picture(set.manifest, reference_of(set.folder, set.manifest, record.stimulus)));
    case TrialKind::mask:
      return png_bytes(load_trial_picture(set, trial));
  }
  return {};
}

/// What must be added to each code of `base`, modulo 256.
ByteImage difference_from(const ByteImage& base, ByteImage picture) {
  for (std::size_t i = 0; i < picture.values.size(); ++i)
    picture.values[i] = static_cast<std::uint8_t>(picture.values[i] - base.values[i]);
  return picture;
}

ByteImage whole_panorama(const RenderedSet& set, const Trial& trial) {
  return has_more_eyes(set, trial) ? load_all_eyes(set, trial) : load_trial_picture(set, trial);
}

/// Adds a panorama as its difference from the scene's reference where that file is smaller.
std::string add_panorama(const RenderedSet& set, const Trial& trial, WebFiles& files, WebPictures& pictures) {
  const std::string whole = picture_bytes(set, trial);
  const Trial reference{.kind = TrialKind::reference, .stimulus = trial.stimulus};
  if (trial.kind != TrialKind::reference) {
    const std::string apart =
        png_bytes(difference_from(whole_panorama(set, reference), whole_panorama(set, trial)));
    if (apart.size() < whole.size()) {
      const std::string base = files.add_by_content("pictures", picture_bytes(set, reference), ".png");
      const std::string file = files.add_by_content("pictures", apart, ".png");
      pictures.base[file] = base;
      return file;
    }
  }
  return files.add_by_content("pictures", whole, ".png");
}

/// Trials that show the same picture have the same key.
std::string subject_of(const RenderedSet& set, const Trial& trial) {
  const ManifestStimulus& record = record_at(set, trial.stimulus);
  switch (trial.kind) {
    case TrialKind::stimulus:
      return "stimulus " + record.id;
    case TrialKind::attention:
      return "attention " + truth_of(record.stimulus) + " " + std::to_string(record.stimulus.object_index);
    case TrialKind::reference:
      return "reference " + truth_of(record.stimulus);
    case TrialKind::mask:
      return "mask " + truth_of(record.stimulus) + " " + word(task_of(set, trial)->mask);
  }
  return {};
}

/// Stimuli, and catch trials of every stimulus where the study has any, in the order of their shown names:
/// files are made in it, and a host may say which was made first.
std::vector<Trial> every_trial(const RenderedSet& set, const ShownNames& names) {
  std::vector<Trial> trials;
  for (const TrialKind kind : every_trial_kind) {
    if (kind == TrialKind::attention && set.study.catches.attention == 0) continue;
    bool beside = false;  // the reference is shown with each
    for (const TaskGroup& group : task_groups(set.study))
      beside = beside || shows_references(facts_of(group.task.get()));
    if (kind == TrialKind::reference && set.study.catches.reference == 0 && !beside) continue;
    for (int i = 0; i < std::ssize(set.manifest.stimuli); ++i)
      trials.push_back({.kind = kind, .stimulus = i});
  }
  for (int i = 0; i < std::ssize(set.manifest.stimuli); ++i)
    if (const Trial mask{.kind = TrialKind::mask, .stimulus = i}; is_masked(set, mask))
      trials.push_back(mask);
  std::sort(trials.begin(), trials.end(),
            [&](const Trial& a, const Trial& b) { return names.name_of(a) < names.name_of(b); });
  return trials;
}

/// The map of a trial's picture, or of each frame of its clip.
std::string maps_text(const RenderedSet& set, const Trial& trial) {
  const int objects = objects_of(set.study);
  if (is_panorama(set.study))
    return packed_map(make_panorama_map(load_object_ids(set, trial), usual_reach_px, objects));
  if (!shows_clips(set))
    return packed_map(make_object_map(load_object_ids(set, trial), usual_reach_px, false, objects));
  std::string text;
  for (const ObjectMap& map : objects_of_frames(set, trial))
    text += (text.empty() ? "[" : ",") + packed_map(map);
  return text + "]\n";
}

/// Trials with the same name have the same maps. The click map in the manifest is a clip's middle frame's.
std::string name_of_maps(const RenderedSet& set, const Trial& trial) {
  const Stimulus& stimulus = record_at(set, trial.stimulus).stimulus;
  return shows_clips(set) ? truth_of(stimulus)
                          : reference_of(set.folder, set.manifest, stimulus).object_ids_sha256;
}

}  // namespace

std::string packed_map(const ObjectMap& map) {
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();
  for (const PictureFrame& frame : map.frames)
    frames.push_back({{"x_px", static_cast<int>(frame.x_px)},
                      {"y_px", static_cast<int>(frame.y_px)},
                      {"width_px", static_cast<int>(frame.width_px)},
                      {"height_px", static_cast<int>(frame.height_px)}});
  nlohmann::ordered_json runs = nlohmann::ordered_json::array();
  for (std::size_t at = 0; at < map.nearest.size();) {
    std::size_t end = at;
    while (end < map.nearest.size() && map.nearest[end] == map.nearest[at]) ++end;
    runs.push_back(end - at);
    runs.push_back(map.nearest[at]);
    at = end;
  }
  return nlohmann::ordered_json{
             {"width_px", map.width_px}, {"height_px", map.height_px}, {"frames", frames}, {"runs", runs}}
             .dump() +
         "\n";
}

WebPictures add_pictures(const RenderedSet& set, const ShownNames& names, WebFiles& files) {
  WebPictures pictures;
  const char* const folder = shows_clips(set) ? "clips" : "pictures";
  const char* const ending = shows_clips(set) ? ".clip" : ".png";
  std::map<std::string, std::string> of_subject, map_of_name;
  for (const Trial& trial : every_trial(set, names)) {
    stop_if_interrupted();
    std::string& file = of_subject[subject_of(set, trial)];
    if (file.empty())
      file = is_panorama(set.study) ? add_panorama(set, trial, files, pictures)
                                    : files.add_by_content(folder, picture_bytes(set, trial), ending);
    pictures.file[{trial.kind, trial.stimulus}] = file;
    if (pictures.map.contains(file)) continue;
    std::string& map = map_of_name[name_of_maps(set, trial)];
    if (map.empty()) map = files.add_by_content("maps", maps_text(set, trial), ".json");
    pictures.map[file] = map;
    if (pictures.base.contains(file)) pictures.map[pictures.base.at(file)] = map;
  }
  return pictures;
}

}  // namespace seamline::study::online
