#pragma once
#include <filesystem>
#include <string>

/// What cameras saw, for pages that begin with photographs and depth of one's own.
namespace seamline::page_commands {

/// A street as KITTI has it: photograph (JPEG), depth (PNG of 1/256 m), camera; and what MiDaS would say of
/// it.
[[nodiscard]] std::string street_photograph();
[[nodiscard]] std::string street_depth();
[[nodiscard]] std::string street_inverse_depth();
[[nodiscard]] std::string street_camera();

/// A floor and a wall before a depth camera: a map in millimetres (PGM) and the camera's file.
[[nodiscard]] std::string desk_depth();
[[nodiscard]] std::string desk_camera();

/// Three frames of that map, each a millimetre farther: frame0.png, ...
void make_depth_frames(const std::filesystem::path& folder);

/// What a depth camera and a colour camera see of a board of 9 x 6 corners, 30 mm apart, at eight places:
/// ir0.png, rgb0.png, ...
void make_board_pictures(const std::filesystem::path& folder);

/// A reference and two pictures of it, one of which differs strongly.
void make_pairs(const std::filesystem::path& folder);

}  // namespace seamline::page_commands
