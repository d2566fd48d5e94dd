#pragma once
#include <filesystem>

#include "sensors/skeleton/user_file.h"

namespace seamline::renderer {

/// A stand-in for a person before a depth camera: a figure of round limbs over a skeleton, in a room.
struct PersonScene {
  sensors::Skeleton skeleton = sensors::standing_person();
  sensors::SkeletonPose pose;
};

/// Somebody who stands 2.6 m before the camera, greets with one hand and has the other on the hip.
[[nodiscard]] PersonScene greeting_person();

/// Joints of the figure in the scene's world, as tracking without errors would have them.
[[nodiscard]] sensors::RecordedUser user_of(const PersonScene& person);

/// Writes the room (floor, walls, a table beside the person), the figure ("person"), a camera at the
/// origin 1.3 m above the floor, looking along -z, and a sun, as a .glb file. Throws InputError when the path
/// cannot be written.
void write_person_scene(const std::filesystem::path& path, const PersonScene& person);

}  // namespace seamline::renderer
