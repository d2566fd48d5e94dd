#pragma once
#include <optional>
#include <string>
#include <vector>

#include "renderer/composite/photograph.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/occlusion_test.h"
#include "renderer/tracing/mesh.h"
#include "sensors/files/depth_file.h"
#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// Which directions a depth map has.
enum class DepthView { by_shape, panorama, photograph };

/// How a file of depth is to be understood, and the mesh of it.
struct PhotoDepthRequest {
  std::string file;
  std::string camera;  ///< the photograph's camera, a file or preset; empty: none
  DepthView view = DepthView::by_shape;
  std::optional<double> metres_per_step;
  std::optional<sensors::DepthConvention> convention;
  MeshDensity density = MeshDensity::adaptive;
  double tolerance = 1e-4;
  double yaw_texels = 0;
  std::optional<double> cut_ratio;  ///< of a camera's depth: cells that jump by more are left out
  int threads = 0;
};

/// Depth as it was read: a panorama, or in the pixels of the photograph's camera.
struct PhotoDepth {
  std::optional<DepthMap> map;
  std::optional<sensors::DepthFrame> frame;  ///< planar
  std::int64_t holes = 0;                    ///< texels or pixels without a depth
  int width_px = 0, height_px = 0;
};

/// The camera of the photograph where a file or a preset says it. Throws InputError where it is of another
/// size.
[[nodiscard]] std::optional<sensors::PinholeCamera> photograph_lens(const PhotoDepthRequest& request,
                                                                    const Photograph& photograph,
                                                                    const std::string& photograph_file);

/// Reads depth: with a camera file its colour camera's; else a picture twice as wide as high is a panorama,
/// and one of the photograph's shape has the photograph's own view, `fov_deg` wide. EXR in metres, or PNG and
/// PGM of 16 bits with `metres_per_step`. Throws InputError as the readers do, and where there is nothing but
/// holes.
[[nodiscard]] PhotoDepth read_photo_depth(const PhotoDepthRequest& request, const Photograph& photograph,
                                          const std::optional<sensors::PinholeCamera>& lens, double fov_deg);

/// The local scene of it, around the camera.
[[nodiscard]] DepthMesh photo_mesh(const PhotoDepth& depth, const PhotoDepthRequest& request,
                                   const Camera& camera);

/// The same through a panorama of `width_px`, captured from the full local scene as studies capture theirs
/// from the truth: one ray through the centre of each texel.
[[nodiscard]] DepthMesh reduced_photo_mesh(const DepthMesh& full, int width_px,
                                           const PhotoDepthRequest& request);

/// What a test a pixel looks depth up in, linear between the centres of texels or pixels.
[[nodiscard]] DepthSight photo_sight(const PhotoDepth& depth, const PhotoDepthRequest& request,
                                     const Camera& camera);

}  // namespace seamline::renderer
