#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "composites/photograph.h"
#include "raytracer/tracing/mesh.h"
#include "renderer/depth/depth_map.h"
#include "renderer/depth/occlusion_test.h"
#include "sensors/camera/fisheye_camera.h"
#include "sensors/files/depth_values.h"
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
  std::string channel;                             ///< of a file of several; empty: by its name
  std::optional<std::vector<double>> nothing;      ///< codes; none: 65535 of 16 bits
  std::string reference;                           ///< a measured map; empty: none
  std::optional<sensors::DepthEstimate> estimate;  ///< its points in the photograph's pixels
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
  std::vector<std::string> notes;  ///< to be said of the file
};

/// The photograph's camera as a file or a preset states it.
struct PhotoLens {
  std::variant<sensors::PinholeCamera, sensors::FisheyeCamera> camera;
  std::optional<Eigen::Isometry3d> world_from_camera;  ///< in a world with +Y up; none: by options
  std::optional<double> metres_per_step;               ///< of its whole numbers
  std::optional<std::vector<double>> nothing;          ///< values of depth that stand for none
  bool unusual_distances = false;
  std::vector<std::string> notes;  ///< to be said of the file
};

/// None: no file and no preset. Throws InputError where the camera is of another size than the photograph.
[[nodiscard]] std::optional<PhotoLens> photograph_lens(const PhotoDepthRequest& request,
                                                       const Photograph& photograph,
                                                       const std::string& photograph_file);

/// The composite's camera that looks through it, whither `view` looks.
[[nodiscard]] Camera camera_of_lens(const PhotoLens& lens, const Camera& view);

/// Reads depth: with a camera file its colour camera's, a fisheye's through a panorama of as many texels as
/// it has pixels along its axis; else a picture twice as wide as high is a panorama, and one of the
/// photograph's shape has the photograph's own view, `fov_deg` wide. What the file may be:
/// `sensors::read_depth_file`. Throws InputError as that does.
[[nodiscard]] PhotoDepth read_photo_depth(const PhotoDepthRequest& request, const Photograph& photograph,
                                          const std::optional<PhotoLens>& lens, const Camera& camera,
                                          double fov_deg);

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
