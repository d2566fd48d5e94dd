#pragma once
#include <string_view>

#include "support/files/image.h"

namespace seamline::scenes {

/// What a patterned surface looks like, in square pictures that join at their edges.
struct PatternPictures {
  double side_m = 1;  ///< of the square that a picture covers
  ByteImage colour;   ///< sRGB codes, 3 channels
  ByteImage normal;   ///< of tangent space, as in glTF: green is up
  ByteImage gloss;    ///< green: roughness, as in glTF's metallic-roughness textures; blue: no metal
};

/// "planks", "weave", "plaster" or "concrete". The same bytes everywhere. Throws std::invalid_argument for
/// any other name.
[[nodiscard]] PatternPictures make_pattern(std::string_view name);

}  // namespace seamline::scenes
