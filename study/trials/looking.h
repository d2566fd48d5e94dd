#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/looks/study_look.h"
#include "study/trials/object_map.h"

namespace seamline::study {

// Looking round a panorama, as the page does it (study/online/page/web/core/looking.js). A direction has x to
// the right of the panorama's middle column, y up and z backwards. Places of a view and of a panorama are in
// their pixels from the upper left corner.

struct Pose {
  double yaw_deg = 0, pitch_deg = 0;  ///< to the right of the middle column, up from the horizon
  bool operator==(const Pose&) const = default;
};
using Direction3 = std::array<double, 3>;
struct ViewPlace {
  double x_px = 0, y_px = 0;
};

/// Tangents of half the view's angles, across and down.
[[nodiscard]] std::array<double, 2> half_tangents(const LookDefinition& look);
/// Right, up and back of a view at a pose, one after another.
[[nodiscard]] std::array<double, 9> axes_of(const Pose& pose);
[[nodiscard]] Direction3 direction_at(const LookDefinition& look, const Pose& pose, const ViewPlace& at);
[[nodiscard]] ViewPlace place_of(int width_px, int height_px, const Direction3& direction);
[[nodiscard]] Direction3 direction_of(int width_px, int height_px, const ViewPlace& at);
/// None behind the view.
[[nodiscard]] std::optional<ViewPlace> place_in_view(const LookDefinition& look, const Pose& pose,
                                                     const Direction3& direction);

/// The objects as a view shows them: frames of those that less than half is seen of are empty. `nearest` is
/// left out.
[[nodiscard]] std::vector<PictureFrame> frames_in_view(const LookDefinition& look, const Pose& pose,
                                                       const ObjectMap& map);
/// The object at a place of the view, from 1, or 0.
[[nodiscard]] int object_in_view(const LookDefinition& look, const Pose& pose, const ObjectMap& map,
                                 const ViewPlace& at);

/// Where a trial begins whose picture begins at a start: beside it by `start_spread_deg` at most, as drawn
/// from the stimulus and the trial's place in its order, within the limits.
[[nodiscard]] Pose drawn_start(const LookDefinition& look, const std::array<double, 2>& start_deg,
                               int stimulus, int trial_index);

/// Turned by so many degrees, within the look's limits; a view that does not turn stays.
[[nodiscard]] Pose turned(const LookDefinition& look, const Pose& pose, double right_deg, double up_deg);
/// The field after so many steps nearer, of 5 degrees each, within the look's limits; its own where it has
/// none.
[[nodiscard]] double zoomed_fov_deg(const LookDefinition& look, int steps_nearer);
/// The pose whose middle is a frame's.
[[nodiscard]] Pose pose_towards(const ObjectMap& map, const PictureFrame& frame);
/// Degrees that one pixel of the view's middle spans.
[[nodiscard]] double degrees_per_pixel(const LookDefinition& look);

/// The poses of a trial as the details of events of kind `look`: "MS YAW PITCH;...", degrees with a decimal,
/// milliseconds from the picture's onset; at most 30 a second, and only what changed. Where the field of view
/// can change, "MS YAW PITCH FIELD;...".
class PoseRecorder {
 public:
  void add(double ms, const Pose& pose, std::optional<double> fov_deg = {});
  /// All there are, in texts of at most 4000 bytes; empty again.
  [[nodiscard]] std::vector<std::string> take();

 private:
  struct Moment {
    double ms = 0;
    Pose pose;
    std::optional<double> fov_deg = {};
  };
  void write(const Moment& moment);
  void write_waiting();

  std::vector<std::string> texts_;
  double last_ms_ = 0;
  std::optional<std::string> last_;
  std::optional<Moment> waiting_;
};

/// Poses read from such a text. None where it is another text.
struct PoseAt {
  double ms = 0;
  Pose pose;
  std::optional<double> fov_deg = {};  ///< of a view whose field can change
};
[[nodiscard]] std::optional<std::vector<PoseAt>> poses_of(const std::string& text);

}  // namespace seamline::study
