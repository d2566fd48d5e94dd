#include "live/running/poses_table.h"

#include "raytracer/scene/resting_object.h"
#include "support/files/atomic_file.h"

namespace seamline::live {

CsvTable PosesTable::empty_table() {
  return {.name = "poses",
          .columns = {{"shown", "", "number of the frame as it was shown, from 0"},
                      {"frame", "", "number in the recording, from 0"},
                      {"time_s", "s", "of the recording"},
                      {"simulated_s", "s", "for which things have been falling"},
                      {"object", "", "number of the object as it was asked for, from 0"},
                      {"file", "", "of the object"},
                      {"x_m", "m",
                       "where the point is now that was asked for (position_m of a study); world with +Y up"},
                      {"y_m", "m", "likewise, upwards"},
                      {"z_m", "m", "likewise"},
                      {"pitch_deg", "degrees", "rotation about X, as rotation_deg of a study"},
                      {"yaw_deg", "degrees", "about Y"},
                      {"roll_deg", "degrees", "about Z"},
                      {"speed_m_s", "m/s", "of its centre of mass"},
                      {"held", "", "1: it waits, because the frame shows no surface below it"},
                      {"let_go", "", "how often it has been let go"}},
          .rows = {}};
}

void PosesTable::add(std::size_t frame_index, double time_s, const FallingBodies& bodies) {
  for (std::size_t i = 0; i < bodies.poses().size(); ++i) {
    const BodyPose& pose = bodies.poses()[i];
    const Eigen::Vector3d at_m = pose.world_from_body.translation(),
                          turn_deg = renderer::rotation_deg_of(pose.world_from_body.linear());
    table_.rows.push_back({shown_, static_cast<std::int64_t>(frame_index), time_s, bodies.simulated_s(),
                           static_cast<std::int64_t>(i), bodies.bodies()[i].name, at_m.x(), at_m.y(),
                           at_m.z(), turn_deg.x(), turn_deg.y(), turn_deg.z(), pose.speed_m_s,
                           std::int64_t{pose.is_held ? 1 : 0}, std::int64_t{pose.times_let_go}});
  }
  ++shown_;
}

void write_tables(const LiveRequest& request, const std::vector<TimedFrame>& timed, const PosesTable& poses) {
  if (request.csv.empty()) return;
  write_file_atomically(request.csv, csv_text(times_table(timed, request.physics)));
  if (request.physics) write_file_atomically(poses_file(request.csv), csv_text(poses.table()));
}

std::filesystem::path poses_file(const std::filesystem::path& times_file) {
  std::filesystem::path file = times_file;
  file.replace_filename(times_file.stem().string() + "_poses" + times_file.extension().string());
  return file;
}

}  // namespace seamline::live
