#include "sensors/skeleton/recorded_motion.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "support/files/atomic_file.h"
#include "support/text/csv_read.h"
#include "support/text/limits.h"
#include "support/text/printable.h"

namespace seamline::sensors {
namespace {

const std::array<std::string, 5> motion_columns = {"time_s", "joint", "x_m", "y_m", "z_m"};
constexpr std::size_t most_joints = 200, most_moments = 100'000;
constexpr double longest_s = 3.2e8;  // ten years

Eigen::Vector3d place_at(const CsvRow& row) {
  Eigen::Vector3d place_m;
  for (std::size_t c = 0; c < 3; ++c) {
    place_m[static_cast<Eigen::Index>(c)] = number_at(row, 2 + c);
    if (!(std::abs(place_m[static_cast<Eigen::Index>(c)]) <= limits::farthest_place_m))
      throw complaint_about(row, 2 + c, fmt::format("at most {} m", limits::farthest_place_m),
                            row.values[2 + c]);
  }
  return place_m;
}

}  // namespace

RecordedMotion read_recorded_motion(const std::filesystem::path& path) {
  RecordedMotion motion;
  const std::string file = path.string();
  double first_s = 0, last_s = 0;
  read_csv(file, read_file(path, limits::largest_csv_bytes), motion_columns, [&](const CsvRow& row) {
    const double now_s = number_at(row, 0);
    if (motion.times_s.empty()) first_s = now_s;
    const double time_s = now_s - first_s;
    if (!(time_s <= longest_s)) throw complaint_about(row, 0, "at most ten years", row.values[0]);
    if (motion.times_s.empty() || now_s > last_s) {
      if (motion.times_s.size() == most_moments)
        throw complaint_about(row, 0, fmt::format("at most {} moments", most_moments), "more");
      if (!motion.times_s.empty() && static_cast<float>(time_s) <= static_cast<float>(motion.times_s.back()))
        throw complaint_about(
            row, 0, fmt::format("a time that 32 bits, counted from {} s, tell from {} s", first_s, last_s),
            row.values[0]);
      motion.times_s.push_back(time_s);
      motion.places_m.emplace_back(motion.joints.size());
    } else if (now_s < last_s) {
      throw complaint_about(row, 0, fmt::format("no time before {} s, that of the row before", last_s),
                            row.values[0]);
    }
    last_s = now_s;
    const auto found = std::find(motion.joints.begin(), motion.joints.end(), row.values[1]);
    const std::size_t joint = found - motion.joints.begin();
    if (found == motion.joints.end()) {
      if (joint == most_joints || row.values[1].empty())
        throw complaint_about(row, 1, fmt::format("names of at most {} joints", most_joints),
                              joint == most_joints ? "more" : "nothing");
      motion.joints.push_back(row.values[1]);
      for (MeasuredJoints& places_m : motion.places_m) places_m.resize(joint + 1);
    }
    auto& place_m = motion.places_m.back()[joint];
    if (place_m) throw complaint_about(row, 1, "a joint once in a moment", printable(row.values[1]));
    place_m = place_at(row);
  });
  if (motion.times_s.empty())
    throw input_error({.file = file, .wanted = "a row for each joint and moment", .found = "none"});
  return motion;
}

}  // namespace seamline::sensors
