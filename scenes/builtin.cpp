#include "scenes/builtin.h"

#include <stdexcept>

#include "scenes/objects/objects.h"
#include "scenes/rooms/backgrounds.h"
#include "scenes/rooms/furniture.h"
#include "scenes/rooms/plans.h"
#include "scenes/shapes/polygonise.h"

namespace seamline::scenes {
namespace {

std::invalid_argument unknown(std::string_view name) {
  return std::invalid_argument("no built-in scene or object is called " + std::string(name));
}

/// Every sculpture is sampled at a hundredth of a metre or so and brought down to this many triangles.
constexpr double sculpture_triangles = 60000;

TriangleMesh cast_in_triangles(const Sculpture& sculpture, double cell_m, const ModelOptions& options) {
  const double coarseness = options.coarseness;
  return stood_on_ground(polygonise(
      sculpture, {.cell_m = cell_m * coarseness,
                  .threads = options.threads,
                  .triangles = static_cast<std::size_t>(sculpture_triangles / (coarseness * coarseness))}));
}

}  // namespace

SceneContents builtin_scene(std::string_view name) {
  if (name == "bedroom") return make_room({});
  if (name == "gazebo") return make_pavilion({});
  if (name == "atrium") return make_arcade({});
  if (name == "painted_room") return make_painted_room();
  if (name == "furnished_room") return make_furnished_room();
  if (name == "loft") return make_loft(LoftWindows::glowing);
  if (name == "loft_open") return make_loft(LoftWindows::open);
  throw unknown(name);
}

TriangleMesh builtin_object(std::string_view name, const ModelOptions& options) {
  if (name == "teapot") return make_teapot(22);
  if (name == "statue") return cast_in_triangles(sculpt_statue(), 0.011, options);
  if (name == "creature") return cast_in_triangles(sculpt_creature(), 0.011, options);
  if (name == "beast") return cast_in_triangles(sculpt_beast(), 0.011, options);
  if (name == "lion") return cast_in_triangles(sculpt_lion(), 0.011, options);
  if (name == "dragon") return cast_in_triangles(sculpt_dragon(), 0.011, options);
  throw unknown(name);
}

ScenePart builtin_furniture(std::string_view name) {
  if (name != "chair") throw unknown(name);
  return {"chair", stood_on_ground(make_chair()), {0.8, 0.8, 0.8}};
}

}  // namespace seamline::scenes
