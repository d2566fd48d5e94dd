#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "renderer/transport/scene_geometry.h"

namespace seamline::renderer {

/// What small emitters in view send straight to the camera, as means over pixels. A lamp that covers a
/// twentieth of a pixel is missed by all samples of many pixels: they are dark, and because neither half of
/// the samples met it, their difference says that nothing is wrong. Where emitters are is known. So each
/// pixel that one may cover is searched: the squares of the pixel that an emitter's triangles reach are
/// halved until they are small, and a ray through each finds what is seen there. Every sample then shows the
/// mean in place of what it met.
///
/// An emitter is small where it is less than two pixels wide, or has a texture. The emission of larger ones
/// stays as it was sampled.
class SeenEmission {
 public:
  /// Gives a surface that a camera ray of pixel (x, y) met the mean emission of its class: `front` is the
  /// object that the ray meets first (0: none), `point` that surface or the first one behind it.
  void even_out(int x, int y, int front, SurfacePoint& point) const {
    const std::uint32_t found = found_[index(x, y)];
    if (found == 0) return;
    const auto f = static_cast<std::size_t>(front), s = static_cast<std::size_t>(point.object_index);
    point.emission = means_[((found - 1) * classes_ + f) * classes_ + s];
  }
  /// Number of pixels that small emitters may cover.
  [[nodiscard]] std::size_t pixels() const { return means_.size() / (classes_ * classes_); }

 private:
  friend std::shared_ptr<const SeenEmission> find_seen_emission(const TruthScene& scene, int threads);

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_px_) + static_cast<std::size_t>(x);
  }

  int width_px_ = 0;
  std::size_t classes_ = 1;           ///< the room and each object
  std::vector<std::uint32_t> found_;  ///< of each pixel: 0, or 1 more than its place in `means_`
  std::vector<Rgb> means_;            ///< [pixel found][front][surface]: over its part of the pixel
};

/// Null where no small emitter is in view, which costs nothing but a look at the emitting triangles.
[[nodiscard]] std::shared_ptr<const SeenEmission> find_seen_emission(const TruthScene& scene, int threads);

}  // namespace seamline::renderer
