#pragma once
#include <array>
#include <string>
#include <string_view>

#include "scenes/shapes/glb_file.h"

namespace seamline::scenes {

inline constexpr std::array<std::string_view, 7> builtin_scene_names = {
    "bedroom", "gazebo", "atrium", "furnished_room", "painted_room", "loft", "loft_open"};
inline constexpr std::array<std::string_view, 6> builtin_object_names = {"statue", "teapot", "creature",
                                                                         "beast",  "lion",   "dragon"};
inline constexpr std::array<std::string_view, 1> builtin_furniture_names = {"chair"};

/// How finely objects are made.
struct ModelOptions {
  double coarseness = 1.0;  ///< multiplies the polygoniser's cell; tests of laws may use coarser objects
  int threads = 2;          ///< the result does not depend on it
};

/// A background. Metres, its camera at eye height looking roughly along -Z; all but atrium and lofts have a
/// sun.
[[nodiscard]] SceneContents builtin_scene(std::string_view name);

/// An object, standing on y = 0 and centred on x = z = 0. Statue and creature face +Z; beast, lion and dragon
/// are long in x with the head towards +X; the teapot's spout points to +X; the chair, a piece of furniture
/// of few triangles, faces +Z. Throws std::invalid_argument for any other name.
[[nodiscard]] TriangleMesh builtin_object(std::string_view name, const ModelOptions& options = {});

/// A piece of furniture as an object, of few triangles: the white chair, which faces +Z. Throws
/// std::invalid_argument for any other name.
[[nodiscard]] ScenePart builtin_furniture(std::string_view name);

}  // namespace seamline::scenes
