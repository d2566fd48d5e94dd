#pragma once
#include <optional>
#include <string>
#include <vector>

#include "stimuli/set/clip_file.h"
#include "study/placement/trial.h"
#include "study/trials/object_map.h"
#include "study/trials/rendered_set.h"

namespace seamline::study {

/// The frames of a trial of a set of clips, in order and without end: those of the stimulus, of the
/// reference, or of the reference with the object marked (attention). Reads files and nothing else.
class TrialClip {
 public:
  /// Throws InputError when a clip is missing or has other bytes than the set was rendered with.
  TrialClip(const RenderedSet& set, const Trial& trial);
  [[nodiscard]] int frames() const { return picture_.frames(); }
  [[nodiscard]] double frames_per_s() const { return picture_.shape().frames_per_s; }
  [[nodiscard]] const ClipShape& shape() const { return picture_.shape(); }
  [[nodiscard]] ByteImage next();

 private:
  ClipReader picture_;
  std::optional<ClipReader> click_map_;  ///< of attention trials
  int object_ = 0;
};

/// Whether trials of this set are clips.
[[nodiscard]] bool shows_clips(const RenderedSet& set);

/// The file of the clip that a trial shows, three channels; made where the set has none (attention). Throws
/// as TrialClip.
[[nodiscard]] std::string clip_bytes(const RenderedSet& set, const Trial& trial);

/// Where the objects of a trial's scene are in each frame. A second a hundred million pixels.
[[nodiscard]] std::vector<ObjectMap> objects_of_frames(const RenderedSet& set, const Trial& trial);

}  // namespace seamline::study
