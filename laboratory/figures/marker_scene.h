#pragma once
#include <filesystem>

namespace seamline::renderer {

/// A marker's board: the marker itself, with a white margin of one of its squares, in squares of their own,
/// before a grey wall.
struct MarkerBoard {
  double side_m = 0.16;   ///< of the marker, with its black border
  double wall_m = 0.5;    ///< behind it
  double camera_m = 1.0;  ///< before its middle, looking at it
};
inline constexpr double marker_view_deg = 34;  ///< of its camera, as the rig of paper 002 has it

/// Writes the board as a .glb file with three diffuse meshes (white, black, wall) and a camera: the middle of
/// the marker is the origin, x to its right, y up, z out of it. Throws InputError when the path cannot be
/// written.
void write_marker_scene(const std::filesystem::path& path, const MarkerBoard& board);

}  // namespace seamline::renderer
