#pragma once
#include <map>
#include <string>

#include "raytracer/light/light.h"
#include "raytracer/scene/camera.h"
#include "raytracer/tracing/geometry.h"
#include "sensors/frame/depth_frame.h"
#include "stimuli/definition/depth_chain.h"
#include "support/files/image.h"

namespace seamline::renderer {

/// What two cameras of a stereo source see, sRGB codes as a camera delivers them.
struct StereoPictures {
  ByteImage left, right;
};

/// A scene that is photographed, in the renderer's frame.
struct StereoScene {
  const Geometry& geometry;
  const Light& light;
  Camera camera;  ///< the photograph's, by which sensors are placed
  double exposure_ev = 0;
};

/// Every path traced to its end, by the source's samples a pixel. The eyes' noise is independent.
[[nodiscard]] StereoPictures stereo_pictures(const StereoScene& scene, const StereoSource& source,
                                             std::uint64_t seed, int threads);

/// Planar depth of the left camera: fx b / disparity; holes where nothing was found. Throws InputError as
/// `registration::match_stereo` does.
[[nodiscard]] sensors::DepthFrame stereo_depth(const StereoPictures& pictures, const StereoSource& source);

/// Depth of the stereo sources of chains, each matched once while the scene stays.
class StereoMemory {
 public:
  /// By the place of the source in the chain; empty where there is no stereo.
  [[nodiscard]] std::map<std::size_t, sensors::DepthFrame> frames(const StereoScene& scene,
                                                                  const DepthChain& chain, int threads);
  /// Another scene, or another object left out.
  void forget() { matched_.clear(); }

 private:
  std::map<std::string, sensors::DepthFrame> matched_;  ///< by source and seed
};

}  // namespace seamline::renderer
