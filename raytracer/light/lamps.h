#pragma once
#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "raytracer/tracing/mesh.h"
#include "raytracer/tracing/surface_point.h"
#include "support/arithmetic/colour.h"

namespace seamline::renderer {

struct BrightPatches;

/// A lamp without size, in the renderer's frame (metres, centred on the camera). A point lamp shines alike in
/// all directions; a spot lamp within `outer_cosine` of its axis, fully within `inner_cosine`
/// (KHR_lights_punctual: between them the square of a linear ramp in the cosine).
struct Lamp {
  Eigen::Vector3f position_m = Eigen::Vector3f::Zero();
  Rgb intensity_w_sr = Rgb::Zero();
  bool is_spot = false;
  Eigen::Vector3f axis = -Eigen::Vector3f::UnitY();  ///< unit, the way a spot lamp shines
  float inner_cosine = 1.0F, outer_cosine = 0.0F;
};

/// Intensity that a lamp sends in a unit direction away from it.
[[nodiscard]] Rgb intensity_towards(const Lamp& lamp, const Eigen::Vector3f& away);

/// One of several lamps, chosen for a surface point with a probability.
struct ChosenLamp {
  const Lamp* lamp;
  float probability;
};
/// Chooses by what each lamp would send through the point's horizon if nothing were in the way, from
/// `choice` in [0, 1); among more than 16 lamps by their intensity alone. None when no lamp reaches the
/// point.
[[nodiscard]] std::optional<ChosenLamp> choose_lamp(std::span<const Lamp> lamps, const SurfacePoint& point,
                                                    float choice);

/// The background's surfaces that emit, as lamps with size: light is sampled from their triangles in
/// proportion to area and luminance. Surfaces of virtual objects are none of them: whether they are there
/// differs between the worlds of one path, and they are found by the rays that meet them.
///
/// Beside them the spots that lamps without size light on surfaces close to them: those send light on and are
/// no light samples, but paths look for them.
class EmittingSurfaces {
 public:
  /// Of a scene's background, in the order in which its meshes are in the scene's geometry.
  explicit EmittingSurfaces(std::span<const std::shared_ptr<const SurfaceMesh>> background,
                            std::shared_ptr<const BrightPatches> patches = nullptr);

  [[nodiscard]] bool empty() const { return triangles_.empty(); }
  [[nodiscard]] std::size_t triangles() const { return triangles_.size(); }
  [[nodiscard]] const BrightPatches* patches() const { return patches_.get(); }  ///< null: none

  struct Place {
    Eigen::Vector3f position_m;
    Eigen::Vector3f normal;  ///< unit, either side: surfaces emit on both
    Rgb radiance;
    float density_m2;  ///< per square metre
  };
  /// A place on a triangle chosen by `choice`, evenly over it by `point`; all in [0, 1).
  [[nodiscard]] Place sample(float choice, const Eigen::Array2f& point) const;
  /// The density, per square metre, with which `sample` chooses the place of a hit; 0 where it never does.
  [[nodiscard]] float density_m2(const SurfacePoint& hit) const {
    return hit.object_index == 0 && hit.mesh < density_m2_.size() ? density_m2_[hit.mesh] : 0.0F;
  }

 private:
  struct EmittingTriangle {
    std::uint32_t mesh, triangle;
  };
  std::vector<std::shared_ptr<const SurfaceMesh>> meshes_;
  std::vector<EmittingTriangle> triangles_;
  std::vector<double> shares_;     ///< cumulated over the triangles, ends at 1
  std::vector<float> density_m2_;  ///< of each mesh
  std::shared_ptr<const BrightPatches> patches_;
};

}  // namespace seamline::renderer
