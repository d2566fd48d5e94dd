#pragma once
#include <optional>
#include <string>
#include <vector>

#include "composites/composite_request.h"
#include "raytracer/scene/scene_file.h"

namespace seamline::renderer {

/// What is said while a composite is made; its notes again in its report.
class Notes {
 public:
  Notes() = default;
  explicit Notes(CompositeListener listener) : listener_(std::move(listener)) {}
  void say(const std::string& note);
  void tell(const std::string& line) const;
  std::vector<std::string> said;

 private:
  CompositeListener listener_;
};

/// The photograph as its camera sees it, and the panorama that it may be a view of.
struct SeenPhoto {
  Photograph photograph;
  Image panorama;  ///< empty where there is none
  Camera camera;
  Eigen::Vector3d centre_m = Eigen::Vector3d::Zero();  ///< the camera's place in the composite's world
  std::optional<PhotoLens> lens;
  SceneFile scene;      ///< empty where none was given
  double fov_deg = 60;  ///< horizontal, of a pinhole
};

/// Reads the photograph, and finds its camera. Throws InputError where options and photograph do not go
/// together.
[[nodiscard]] SeenPhoto see(const CompositeRequest& request, Notes& notes);

}  // namespace seamline::renderer
