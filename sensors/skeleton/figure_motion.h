#pragma once
#include <string>
#include <vector>

#include "sensors/skeleton/figure_file.h"
#include "sensors/skeleton/recorded_motion.h"

namespace seamline::sensors {

/// A figure's joints as they have to turn so that they are where they were recorded.
struct FigureMotion {
  std::vector<MovedNode> nodes;  ///< of each recorded joint
  /// Of each joint and moment: how far it is turned from the figure's rest, against the joint that holds it,
  /// 0 to 180 degrees.
  std::vector<std::vector<double>> turned_deg;
  /// Of each moment: distance of the recorded joints that were seen and those of the figure that is written,
  /// whose bones keep their own lengths.
  std::vector<double> rms_m;
};

/// The joints by least squares (`fit_pose`, three hinges a joint, each moment from the one before), with
/// bones as long as they were recorded last. Recorded names are those of nodes, of which one holds all the
/// others. Joints do not tell what turns about a bone: a joint whose bones lie along a line makes the
/// shortest turn from the figure's rest. A joint that was not seen in a moment hangs on the others, and one
/// with nothing seen behind it keeps its turn. Throws InputError naming the joint.
[[nodiscard]] FigureMotion move_figure(const FigureFile& figure, const RecordedMotion& motion);

/// A named range of angles: as long as every joint is turned so far.
struct Gesture {
  std::string name;
  struct Range {
    std::size_t joint = 0;  ///< in `RecordedMotion::joints`
    double least_deg = 0, most_deg = 180;
  };
  std::vector<Range> ranges;
};

/// Reads a file of gestures:
///
///     format = "seamline gestures 1"
///     [[gesture]]
///     name = "greeting"
///       [gesture.turned_deg]
///       left_shoulder = [80, 180]
///
/// Throws InputError naming file and key.
[[nodiscard]] std::vector<Gesture> read_gestures(const std::filesystem::path& path,
                                                 const std::vector<std::string>& joints);

/// From the first to the last moment of each time that a gesture holds.
[[nodiscard]] std::vector<std::pair<double, double>> times_of(const Gesture& gesture,
                                                              const FigureMotion& figure,
                                                              const std::vector<double>& times_s);

}  // namespace seamline::sensors
