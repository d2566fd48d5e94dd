#pragma once
#include <vector>

#include "scenes/shapes/glb_file.h"

namespace seamline::scenes {

/// A small car of the sixties, 3.6 m long, its bonnet towards +X, its wheels on y = 0: parts "car_paint",
/// "car_glass", "car_tyres", "car_chrome", "car_lights" and "car_inside", with gaps between body and wheels
/// through which one sees the floor.
[[nodiscard]] std::vector<ScenePart> make_car();

}  // namespace seamline::scenes
