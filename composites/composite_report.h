#pragma once
#include <optional>
#include <string>
#include <vector>

#include "composites/composite_request.h"
#include "composites/seamless_width.h"
#include "raytracer/error/samples_taken.h"
#include "renderer/picture/composite.h"

namespace seamline::renderer {

/// A composite and what is known of it.
struct MadeComposite {
  const Image* photograph = nullptr;
  Image local_scene;  ///< shaded, as the camera sees it
  Composite picture;
  std::string estimator;
  SamplesTaken taken;
  std::optional<double> error, worst_tile;  ///< display units
  std::size_t triangles = 0;
  std::size_t changed_pixels = 0;  ///< of other 8-bit codes than the photograph's
  double mesh_seconds = 0, picture_seconds = 0;
  std::string depth_text;              ///< which depth, and how wide
  std::optional<SeamlessWidth> width;  ///< where thresholds chose it
  std::vector<std::string> light, notes, objects;
  std::vector<std::string> answers;  ///< who answers in place of the local scene
};

/// The same through the full depth map, where the composite has less.
struct FullDepth {
  Composite picture;
  std::size_t triangles = 0;
  double seconds = 0;
};

/// "64 samples a pixel", or "8 to 512 samples a pixel, 23.4 in the mean".
[[nodiscard]] std::string samples_text(const SamplesTaken& taken);

/// Writes a self-contained page: pictures, depth used, triangles, seconds, and FLIP against full depth as a
/// map.
void write_composite_report(const CompositeRequest& request, const MadeComposite& made,
                            const std::optional<FullDepth>& full);

}  // namespace seamline::renderer
