#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "scenes/shapes/glb_file.h"
#include "support/arithmetic/random.h"

namespace seamline::scenes {

/// Scenes that differ in plan, furniture, ornament and light, but ask the same of depth: rooms for
/// `receiver`, pavilions for `shadow` and `overlap`, arcades for `occlusion`.
enum class SceneFamily { rooms, pavilions, arcades };
inline constexpr std::array every_scene_family = {SceneFamily::rooms, SceneFamily::pavilions,
                                                  SceneFamily::arcades};

[[nodiscard]] std::string_view word(SceneFamily family);  ///< "rooms", "pavilions", "arcades"
[[nodiscard]] std::optional<SceneFamily> scene_family_from_word(std::string_view text);

/// A built-in object where it stands.
struct PlacedObject {
  std::string name;  ///< within its scene
  std::string file;  ///< "builtin:statue"
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  double yaw_deg = 0, scale = 1;
  bool exempt_from_shape_rules = false;
};

struct GeneratedScene {
  SceneContents background;
  std::array<PlacedObject, 3> objects;
  std::string settings;   ///< lines of the scene's table of a study file: artifacts and light
  double bay_m = 0;       ///< of arcades, from column to column
  double stool_z_m = 0;   ///< of rooms, where the middle object stands
  bool mirrored = false;  ///< left and right are to be exchanged before anybody sees it
};

/// The scene of a stream of random numbers. Placements are near where the family's rules are kept; whether
/// they are kept, only a look from the camera tells.
[[nodiscard]] GeneratedScene generate_scene(SceneFamily family, Random& random);

/// Left and right exchanged where the scene wants it, else the scene.
[[nodiscard]] GeneratedScene as_shown(const GeneratedScene& scene);

/// Moves one object to another place of its family, on the circle of equal distance, and turns it.
void place_anew(SceneFamily family, GeneratedScene& scene, std::size_t object, Random& random);

}  // namespace seamline::scenes
