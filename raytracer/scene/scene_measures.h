#pragma once
#include <map>
#include <string>
#include <vector>

#include "raytracer/scene/truth_scene.h"

namespace seamline::renderer {

/// What one object looks like from the study's camera. Areas are counts of pixel centres.
struct ObjectMeasures {
  std::string name;
  double distance_m = 0;             ///< camera to the centre of the object's bounding box
  double unoccluded_px = 0;          ///< area if nothing stood before it
  double visible_px = 0;             ///< area in the reference
  double silhouette_complexity = 0;  ///< perimeter^2 / (4 pi area) of the unoccluded silhouette; 1 for a disc
  double shadow_px = 0;              ///< real surface that the sun reaches but for this object
  double shadow_on_shadow_px =
      0;  ///< real surface that the object hides from the sun where the background does too
  std::map<std::string, double> shadow_px_by_surface;
  double sun_facing_px = 0;      ///< visible, turned to the sun
  double in_real_shadow_px = 0;  ///< of those, what the background shadows
};

/// Measures all objects of a scene by one ray a pixel (two for shadows).
[[nodiscard]] std::vector<ObjectMeasures> measure_objects(const TruthScene& scene);

/// perimeter^2 / (4 pi area) of a mask, row by row. The perimeter is Crofton's: boundary edges of the pixel
/// grid times pi / 4, right on average over directions.
[[nodiscard]] double silhouette_complexity(const std::vector<bool>& mask, int width_px, int height_px);

}  // namespace seamline::renderer
