#pragma once
#include <array>

#include "window/geometry.h"
#include "window/window_texture.h"

namespace seamline::inline window {

/// A perspective view of a panorama.
struct PanoramaPose {
  std::array<double, 9> axes = {1, 0, 0, 0, 1, 0, 0, 0, 1};  ///< right, up, back of the view
  std::array<double, 2> half_tangents = {1, 1};              ///< of half its angles, across and down
};

/// Draws views of panoramas into the framebuffer: each pixel gets the bilinear mean of four codes, and
/// nothing else changes them. The page in a browser draws by the same shader. Needs the window's context.
class PanoramaView {
 public:
  PanoramaView() = default;
  ~PanoramaView();
  PanoramaView(const PanoramaView&) = delete;
  PanoramaView& operator=(const PanoramaView&) = delete;

  /// `rect` has integer corners. Throws InputError where the graphics cannot.
  void draw(const WindowTexture& panorama, const Rect& rect, Size framebuffer_px, const PanoramaPose& pose);

 private:
  void prepare();

  unsigned program_ = 0, corners_ = 0;
};

}  // namespace seamline::inline window
