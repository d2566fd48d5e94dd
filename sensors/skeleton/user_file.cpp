#include "sensors/skeleton/user_file.h"

#include <fmt/core.h>

#include <algorithm>

#include "support/files/toml_table.h"
#include "support/text/limits.h"

namespace seamline::sensors {
namespace {

constexpr const char* format_text = "seamline user 1";
constexpr NumberRange any_place_m{-limits::farthest_place_m, limits::farthest_place_m, "m"};

struct Bone {
  Eigen::Vector3d from_m, to_m;
};

double distance_m(const Bone& bone, const Eigen::Vector3d& point_m) {
  const Eigen::Vector3d along_m = bone.to_m - bone.from_m;
  const double length2 = along_m.squaredNorm();
  const double share = length2 > 0 ? std::clamp(along_m.dot(point_m - bone.from_m) / length2, 0.0, 1.0) : 0;
  return (point_m - bone.from_m - share * along_m).norm();
}

std::vector<Bone> bones_of(const RecordedUser& user) {
  const Skeleton skeleton = standing_person();
  std::vector<Bone> bones;
  for (std::size_t i = 1; i < skeleton.joints.size(); ++i) {
    const auto& from_m = user.joints_m[skeleton.joints[i].parent];
    const auto& to_m = user.joints_m[i];
    if (from_m && to_m) bones.push_back({*from_m, *to_m});
  }
  return bones;
}

}  // namespace

RecordedUser read_user_file(const std::filesystem::path& path) {
  const TomlTable table = TomlTable::read(path);
  const std::string format = table.text("format");
  if (format != format_text)
    throw table.complaint("format", fmt::format("\"{}\"", format_text), "\"" + format + "\"");
  RecordedUser user;
  user.id = table.integer("id", user.id, {1, 1'000'000});
  user.reach_m = table.number("reach_m", user.reach_m, {0.001, 10, "m"});
  const auto joints = table.table("joints_m");
  if (!joints) throw table.complaint("joints_m", "a table of joints", "nothing");
  for (const Joint& joint : standing_person().joints) {
    user.joints_m.emplace_back();
    if (!joints->has(joint.name)) continue;
    const std::array<double, 3> place = joints->triple(joint.name, {0, 0, 0}, any_place_m);
    user.joints_m.back() = Eigen::Vector3d(place[0], place[1], place[2]);
  }
  if (!user.joints_m.front()) throw joints->complaint("torso", "three numbers", "nothing");
  joints->finish();
  table.finish();
  return user;
}

std::string user_file_text(const RecordedUser& user) {
  std::string text = fmt::format("format = \"{}\"\nid = {}\nreach_m = {}\n\n[joints_m]\n", format_text,
                                 user.id, user.reach_m);
  const Skeleton skeleton = standing_person();
  for (std::size_t i = 0; i < skeleton.joints.size(); ++i)
    if (const auto& place_m = user.joints_m[i])
      text += fmt::format("{} = [{}, {}, {}]\n", skeleton.joints[i].name, place_m->x(), place_m->y(),
                          place_m->z());
  return text;
}

std::vector<std::uint8_t> mask_of_user(const DepthFrame& frame, const Eigen::Isometry3d& world_from_frame,
                                       const RecordedUser& user) {
  const std::vector<Bone> bones = bones_of(user);
  std::vector<std::uint8_t> mask(frame.depth_m.size(), 0);
  for (int row = 0; row < frame.camera.height_px; ++row)
    for (int column = 0; column < frame.camera.width_px; ++column) {
      const auto point_m = point_of_pixel(frame, column, row);
      if (!point_m) continue;
      const Eigen::Vector3d world_m = world_from_frame * *point_m;
      if (std::any_of(bones.begin(), bones.end(),
                      [&](const Bone& bone) { return distance_m(bone, world_m) < user.reach_m; }))
        mask[frame.index(column, row)] = 1;
    }
  return mask;
}

}  // namespace seamline::sensors
