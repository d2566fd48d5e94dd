#pragma once
#include "scenes/families/scene_family.h"

namespace seamline::scenes {

// The three families; `generate_scene` and `place_anew` choose among them.

[[nodiscard]] GeneratedScene generate_room(Random& random);
[[nodiscard]] GeneratedScene generate_pavilion(Random& random);
[[nodiscard]] GeneratedScene generate_arcade(Random& random);

void place_in_room(GeneratedScene& scene, std::size_t object, Random& random);
void place_by_pavilion(GeneratedScene& scene, std::size_t object, Random& random);
void place_in_arcade(GeneratedScene& scene, std::size_t object, Random& random);

/// Uniform from low to high.
[[nodiscard]] inline double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

}  // namespace seamline::scenes
