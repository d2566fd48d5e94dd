#pragma once
#include <filesystem>
#include <string>

#include "sensors/frame/depth_frame.h"
#include "sensors/skeleton/cyclic_descent.h"

namespace seamline::sensors {

/// What tracking says of one person in one moment: the recorded values of paper 001's UserSensor.
struct RecordedUser {
  int id = 1;
  MeasuredJoints joints_m;  ///< of `standing_person`, in the scene's world
  double reach_m = 0.16;    ///< the person's surface lies within it of the bones
};

/// Reads a file of a recorded user:
///
///     format = "seamline user 1"
///     id = 1
///     reach_m = 0.16
///     [joints_m]
///     torso = [0, 1.1, -3]       # of the fifteen joints those that were seen, among them the torso
///
/// Throws InputError naming file and key for what is no TOML, another format, an unknown joint, or no torso.
[[nodiscard]] RecordedUser read_user_file(const std::filesystem::path& path);

/// The file's text; reading it gives the same values.
[[nodiscard]] std::string user_file_text(const RecordedUser& user);

/// The person's pixels (1; 0 elsewhere) where no mask was recorded: those whose measured point lies within
/// the reach of a bone both of whose ends were seen. `world_from_frame`: where the frame's camera stands.
[[nodiscard]] std::vector<std::uint8_t> mask_of_user(const DepthFrame& frame,
                                                     const Eigen::Isometry3d& world_from_frame,
                                                     const RecordedUser& user);

}  // namespace seamline::sensors
