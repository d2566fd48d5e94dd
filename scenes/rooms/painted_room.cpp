#include <Eigen/Geometry>
#include <array>
#include <utility>

#include "scenes/rooms/backgrounds.h"
#include "scenes/shapes/solids.h"

namespace seamline::scenes {
namespace painted_room_parts {
namespace {

using Vector3d = Eigen::Vector3d;
using Colour = std::array<double, 3>;

constexpr Colour white = {0.75, 0.75, 0.73};
constexpr Colour red = {0.63, 0.06, 0.05};
constexpr Colour green = {0.12, 0.45, 0.09};
constexpr Colour blue = {0.08, 0.16, 0.55};

TriangleMesh block(double x_m, double z_m, const Vector3d& size_m) {
  const Vector3d half(size_m.x() / 2, 0, size_m.z() / 2);
  const Vector3d base(x_m, 0, z_m);
  return box(base - half, base + half + Vector3d(0, size_m.y(), 0));
}

}  // namespace
}  // namespace painted_room_parts

SceneContents make_painted_room() {
  using namespace painted_room_parts;
  SceneContents room;
  const auto add = [&](const char* name, TriangleMesh mesh, const Colour& albedo) {
    room.parts.push_back({.name = name, .mesh = std::move(mesh), .albedo = albedo});
  };
  // Open to the left, where the sun comes in.
  add("floor", box({-3.4, -0.1, -5.6}, {3.4, 0, 2.2}), white);
  add("wall_back", box({-3.4, 0, -5.7}, {3.4, 3, -5.6}), white);
  add("wall_left", box({-3.5, 0, -5.6}, {-3.4, 3, -5.2}), white);
  add("wall_right", box({3.4, 0, -5.6}, {3.5, 3, 2.2}), white);
  // A bay of its own for each object: a mat, and a screen on the side that the sun does not reach.
  const std::array<std::pair<double, Colour>, 3> bays = {{{-1.5, red}, {0.0, green}, {1.5, blue}}};
  const std::array<std::array<const char*, 2>, 3> names = {
      {{"mat_red", "screen_red"}, {"mat_green", "screen_green"}, {"mat_blue", "screen_blue"}}};
  for (std::size_t i = 0; i < bays.size(); ++i) {
    const auto& [x_m, colour] = bays[i];
    add(names[i][0], block(x_m + 0.02, -4.45, {0.96, 0.02, 1.15}), colour);
    add(names[i][1], block(x_m + 0.53, -4.45, {0.06, 0.95, 1.15}), colour);
  }
  room.camera =
      SceneCamera{.position_m = {0, 1.6, 0.7}, .look_at_m = {0, 0.42, -4.5}, .vertical_fov_rad = 0.47};
  room.sun = SceneSun{.to_sun = Vector3d(-0.60, 0.72, 0.32).normalized(), .irradiance_w_m2 = 3.2};
  return room;
}

}  // namespace seamline::scenes
