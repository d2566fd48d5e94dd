#include "laboratory/person/skeleton_picture.h"
#include "support/arithmetic/grid_index.h"

#include <algorithm>
#include <cmath>

namespace seamline::renderer {
namespace {

using Colour = std::array<std::uint8_t, 3>;

constexpr Colour bone_colour = {255, 255, 255}, joint_colour = {230, 40, 30};

void fill_disc(ByteImage& picture, const Eigen::Vector2d& centre_px, double radius_px, const Colour& colour) {
  const auto first = [&](double at) { return static_cast<int>(std::floor(at - radius_px)); };
  const auto last = [&](double at, int most) {
    return std::min(static_cast<int>(std::ceil(at + radius_px)), most - 1);
  };
  for (int y = std::max(first(centre_px.y()), 0); y <= last(centre_px.y(), picture.height_px); ++y)
    for (int x = std::max(first(centre_px.x()), 0); x <= last(centre_px.x(), picture.width_px); ++x) {
      if ((Eigen::Vector2d(x + 0.5, y + 0.5) - centre_px).norm() > radius_px) continue;
      const std::size_t at = 3 * grid_index(y, x, picture.width_px);
      std::copy(colour.begin(), colour.end(), picture.values.begin() + at);
    }
}

/// Steps of half a pixel, within the picture.
void draw_line(ByteImage& picture, const Eigen::Vector2d& from_px, const Eigen::Vector2d& to_px,
               double half_width_px, const Colour& colour) {
  const double length_px = (to_px - from_px).norm();
  const int steps = static_cast<int>(std::min(2 * length_px, 20000.0)) + 1;
  for (int i = 0; i <= steps; ++i)
    fill_disc(picture, from_px + (to_px - from_px) * i / steps, half_width_px, colour);
}

}  // namespace

ByteImage skeleton_over_depth(const ByteImage& depth, const sensors::DepthFrame& frame,
                              const sensors::RecordedUser& user, const Eigen::Isometry3d& frame_from_world) {
  const std::vector<std::uint8_t> mask = sensors::mask_of_user(frame, frame_from_world.inverse(), user);
  ByteImage picture{.width_px = depth.width_px, .height_px = depth.height_px, .channels = 3, .values = {}};
  picture.values.reserve(3 * depth.values.size());
  for (std::size_t i = 0; i < depth.values.size(); ++i) {
    const int code = depth.values[i];
    const auto tinted = static_cast<std::uint8_t>(mask[i] != 0 ? code * 2 / 3 : code);
    picture.values.push_back(tinted);
    picture.values.push_back(tinted);
    picture.values.push_back(static_cast<std::uint8_t>(code));
  }
  const sensors::Skeleton skeleton = sensors::standing_person();
  std::vector<std::optional<Eigen::Vector2d>> places_px;
  for (const auto& joint_m : user.joints_m)
    places_px.push_back(joint_m ? sensors::project(frame.camera, frame_from_world * *joint_m) : std::nullopt);
  const double thick_px = std::max(1.0, frame.camera.width_px / 320.0);
  for (std::size_t i = 1; i < skeleton.joints.size(); ++i) {
    const auto& start_px = places_px[skeleton.joints[i].parent];
    if (start_px && places_px[i]) draw_line(picture, *start_px, *places_px[i], thick_px, bone_colour);
  }
  for (const auto& place_px : places_px)
    if (place_px) fill_disc(picture, *place_px, 3 * thick_px, joint_colour);
  return picture;
}

}  // namespace seamline::renderer
