#pragma once
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "raytracer/error/change_error.h"
#include "stimuli/definition/clip_frames.h"

namespace seamline::renderer {

/// Whether the errors of a frame are estimated, by the name of its truth: two neighbours of every eight,
/// which is what the error of a clip and that of its changes are known from; all of a clip of 16 frames or
/// fewer.
[[nodiscard]] bool is_judged(const std::string& truth, int frames);

/// The error of the change from each frame of a clip to the next, as frames are rendered one after another:
/// the last frame's map of each clip is kept until the next is there.
class FrameChanges {
 public:
  /// Nothing is kept for a study without clips.
  explicit FrameChanges(const StudyDefinition& shown);

  /// The squared error (`change_error`) of the change from each frame that one just rendered follows in some
  /// clip, by that frame's id; those that this process did not render just before are left out.
  [[nodiscard]] std::map<std::string, double> add(const std::string& frame, ErrorMap map);

 private:
  struct Place {
    std::size_t clip = 0;
    std::string before = {};  ///< id of the frame before; empty: it is the first
    bool is_last = false;
  };
  struct Last {
    std::string frame;
    std::shared_ptr<const ErrorMap> map;
  };
  std::map<std::string, std::vector<Place>> places_;  ///< by frame: where it is shown first in each clip
  std::map<std::size_t, Last> last_;
};

/// The error over the changes of a clip, of the ids of its frames; a change to the same picture has none.
/// `errors`: squared, by frame and the frame before it. `known` counts the changes of which it is known.
struct ClipChangeError {
  double squared = 0;  ///< mean over the known changes
  int known = 0, changes = 0;
};
using FrameChangeErrors = std::map<std::pair<std::string, std::string>, double>;
[[nodiscard]] ClipChangeError clip_change_error(const std::vector<std::string>& frames,
                                                const FrameChangeErrors& errors);

}  // namespace seamline::renderer
