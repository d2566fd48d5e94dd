#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace seamline::inline stimuli {

/// A clip file of a set, relative to its folder.
struct ClipRecord {
  std::string name;    ///< the stimulus' id, or the truth's name
  std::string file;    ///< `clip_file.h`
  std::string sha256;  ///< of the file
};

/// What a set of clips holds beside its manifest, whose pictures are the clips' middle frames: `clips.json`,
/// which the manifest names with its hash.
struct ClipSet {
  int frames = 0;
  double frames_per_s = 0;
  bool loops = true;
  std::vector<ClipRecord> stimuli = {};     ///< as in the manifest
  std::vector<ClipRecord> references = {};  ///< by truth
  std::vector<ClipRecord> click_maps = {};  ///< by truth, of one channel
};

inline constexpr const char* clip_set_file = "clips.json";
/// Of the manifest beside it: an older program would show the middle frames as stills.
inline constexpr int manifest_version_with_clips = 3;

/// What a set says of its clips; nothing of a set of stills. Throws InputError when it is damaged.
[[nodiscard]] std::optional<ClipSet> read_clip_set(const std::filesystem::path& set_folder);
void write_clip_set(const std::filesystem::path& set_folder, const ClipSet& clips);

/// Throws InputError when a clip of the set is not there or has other bytes; nothing of a set of stills.
void check_clips(const std::filesystem::path& set_folder);

/// Throws InputError where the set is one of clips, which `what` cannot take.
void refuse_clips(const std::filesystem::path& set_folder, const std::string& what);

}  // namespace seamline::inline stimuli
