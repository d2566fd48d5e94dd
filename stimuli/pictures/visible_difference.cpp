#include "stimuli/pictures/visible_difference.h"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "stimuli/definition/looks/study_look.h"
#include "stimuli/pictures/flip.h"
#include "stimuli/pictures/panorama_view.h"
#include "stimuli/set/clip_file.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/manifest_pictures.h"
#include "stimuli/set/set_study.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace {

namespace fs = std::filesystem;

std::string size_of(int width_px, int height_px) {
  return fmt::format("{} x {} px", width_px, height_px);
}

ByteImage read_picture(const fs::path& path, const Manifest& manifest) {
  ByteImage image = read_bytes_image(path);
  if (image.width_px != manifest.width_px || image.height_px != manifest.height_px)
    throw input_error({.file = path.string(),
                       .wanted = size_of(manifest.width_px, manifest.height_px) + ", as in the manifest",
                       .found = size_of(image.width_px, image.height_px)});
  if (image.channels != 1 && image.channels != 3)
    throw input_error(
        {.file = path.string(), .wanted = "1 or 3 channels", .found = std::to_string(image.channels)});
  return image;
}

/// What people see of the pictures of a set: the pictures, or of panoramas the view of the study's (or the
/// condition's) field towards the object.
class SeenPictures {
 public:
  SeenPictures(const fs::path& folder, const Manifest& manifest) : folder_(folder), manifest_(manifest) {
    // Most sets have no panoramas: their study is not asked for.
    if (manifest.width_px != 2 * manifest.height_px) return;
    if (!fs::exists(study_file_of_set(folder, manifest))) return;
    study_ = study_of_set(folder, manifest);
    if (!is_panorama(study_)) return;
    has_panoramas_ = true;
    for (const ManifestStimulus& stimulus : manifest.stimuli)
      if (!poses_deg_.contains(pose_key(stimulus)))
        poses_deg_[pose_key(stimulus)] = object_pose_deg(
            read_picture(path_in_set(folder, stimulus.object_ids), manifest), stimulus.stimulus.object_index);
  }

  [[nodiscard]] ByteImage seen(const std::string& file, const ManifestStimulus& stimulus) const {
    ByteImage picture = read_picture(path_in_set(folder_, file), manifest_);
    if (!has_panoramas_) return picture;
    return panorama_view(picture, *look_of(study_, stimulus.stimulus.condition),
                         poses_deg_.at(pose_key(stimulus)));
  }
  /// What tells one view of a reference from another.
  [[nodiscard]] std::string reference_key(const ManifestStimulus& stimulus) const {
    return has_panoramas_ ? pose_key(stimulus) + "/" + stimulus.stimulus.condition : stimulus.reference;
  }

 private:
  [[nodiscard]] static std::string pose_key(const ManifestStimulus& stimulus) {
    return fmt::format("{}/{}", stimulus.reference, stimulus.stimulus.object_index);
  }

  const fs::path& folder_;
  const Manifest& manifest_;
  StudyDefinition study_;
  bool has_panoramas_ = false;
  std::map<std::string, std::array<double, 2>> poses_deg_;
};

/// Every reference of the set, looked at once.
std::map<std::string, FlipPicture> read_references(const SeenPictures& pictures, const Manifest& manifest,
                                                   double ppd) {
  std::map<std::string, FlipPicture> references;
  for (const ManifestStimulus& stimulus : manifest.stimuli)
    if (const std::string key = pictures.reference_key(stimulus); !references.contains(key))
      references[key] = flip_picture(pictures.seen(stimulus.reference, stimulus), ppd);
  return references;
}

/// The clips of a set by name, each one's file.
std::map<std::string, fs::path> clip_paths(const fs::path& folder, const std::vector<ClipRecord>& records) {
  std::map<std::string, fs::path> paths;
  for (const ClipRecord& one : records) paths[one.name] = path_in_set(folder, one.file);
  return paths;
}

/// Pooled over a clip's frames as over places, of which each second has as many whatever its frames:
/// (mean of F^p)^(1/p).
double pooled_over_frames(const fs::path& shown, const fs::path& reference, double ppd) {
  ClipReader frames(shown), references(reference);
  double sum = 0;
  for (int frame = 0; frame < frames.frames(); ++frame) {
    const Image flip =
        flip_difference(flip_picture(references.decode(), ppd), flip_picture(frames.decode(), ppd));
    sum += std::pow(pooled_difference(flip, ppd), pooling_exponent);
  }
  return std::pow(sum / frames.frames(), 1 / pooling_exponent);
}

std::vector<double> pooled_of_clips(const fs::path& folder, const Manifest& manifest, const ClipSet& clips,
                                    double ppd, int threads) {
  const std::map<std::string, fs::path> shown = clip_paths(folder, clips.stimuli),
                                        references = clip_paths(folder, clips.references);
  std::vector<double> pooled(manifest.stimuli.size());
  run_parallel(static_cast<int>(pooled.size()), threads, [&](int index) {
    const ManifestStimulus& stimulus = manifest.stimuli[index];
    pooled[index] =
        pooled_over_frames(shown.at(stimulus.id), references.at(truth_of(stimulus.stimulus)), ppd);
  });
  return pooled;
}

std::vector<double> pooled_of_stills(const fs::path& folder, const Manifest& manifest, double ppd,
                                     int threads) {
  const SeenPictures pictures(folder, manifest);
  const std::map<std::string, FlipPicture> references = read_references(pictures, manifest, ppd);
  std::vector<double> pooled(manifest.stimuli.size());
  run_parallel(static_cast<int>(pooled.size()), threads, [&](int index) {
    const ManifestStimulus& stimulus = manifest.stimuli[index];
    const Image flip = flip_difference(references.at(pictures.reference_key(stimulus)),
                                       flip_picture(pictures.seen(stimulus.image, stimulus), ppd));
    pooled[index] = pooled_difference(flip, ppd);
  });
  return pooled;
}

}  // namespace

double pooled_difference(const Image& flip, double pixels_per_degree) {
  double sum = 0;
  for (const float value : flip.values)
    if (value > 0) sum += std::pow(double{value}, pooling_exponent);
  return std::pow(sum / (pixels_per_degree * pixels_per_degree), 1 / pooling_exponent);
}

double above_floor(double pooled, double floor) {
  if (pooled <= floor) return 0;
  if (floor <= 0) return pooled;
  return std::pow(std::pow(pooled, pooling_exponent) - std::pow(floor, pooling_exponent),
                  1 / pooling_exponent);
}

VisibleDifferences visible_differences(const fs::path& set_folder, const Manifest& manifest,
                                       double pixels_per_degree, const DifferenceFloors& floors,
                                       int threads) {
  const std::optional<ClipSet> clips = read_clip_set(set_folder);
  const std::vector<double> pooled =
      clips ? pooled_of_clips(set_folder, manifest, *clips, pixels_per_degree, threads)
            : pooled_of_stills(set_folder, manifest, pixels_per_degree, threads);
  VisibleDifferences differences;
  for (std::size_t i = 0; i < pooled.size(); ++i) differences[manifest.stimuli[i].id].pooled = pooled[i];
  DifferenceFloors known = difference_floors(manifest, differences);
  known.insert(floors.begin(), floors.end());
  for (const ManifestStimulus& record : manifest.stimuli) {
    VisibleDifference& difference = differences[record.id];
    const auto floor = known.find(floor_key(record.stimulus));
    difference.above_floor = above_floor(difference.pooled, floor == known.end() ? 0 : floor->second);
  }
  return differences;
}

DifferenceFloors difference_floors(const Manifest& manifest, const VisibleDifferences& differences) {
  DifferenceFloors sums;
  std::map<std::string, int> counts;
  for (const ManifestStimulus& record : manifest.stimuli) {
    if (record.stimulus.artifact != Artifact::none) continue;
    sums[floor_key(record.stimulus)] += differences.at(record.id).pooled;
    ++counts[floor_key(record.stimulus)];
  }
  for (auto& [key, sum] : sums) sum /= counts[key];
  return sums;
}

std::string floor_key(const Stimulus& stimulus) {
  return truth_of(stimulus) + "/" + stimulus.object;
}

}  // namespace seamline::inline stimuli
