#pragma once
#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "raytracer/material/mask.h"
#include "renderer/depth/depth_map.h"
#include "renderer/realtime/depth_picture.h"
#include "sensors/frame/depth_frame.h"
#include "sensors/frame/depth_test.h"

namespace seamline::renderer {

class Geometry;
struct RealtimeWorld;

/// Captured depth that a direction from the photograph's place is looked up in. Panoramas are radial.
struct PanoramaSight {
  DepthMap map;
  double yaw_texels = 0;  ///< see MeshOptions
};
/// A frame is planar, and its camera stands in the photograph's place.
struct FrameSight {
  sensors::DepthFrame frame;
  Eigen::Matrix3d frame_from_world = Eigen::Matrix3d::Identity();
};
/// A depth buffer of the photograph's own pixels, in which something invisible was drawn: one depth a pixel.
struct PictureSight {
  DepthPicture picture;
  DrawView view;
};
using DepthSight = std::variant<PanoramaSight, FrameSight, PictureSight>;

/// Who is in front without a mesh, as paper 002 (section 5) decides it: the depth that was measured in a
/// direction, linear between pixels, against the virtual thing's. Frames compare planar distances from their
/// camera; panoramas compare lengths of the ray, or, in a buffer, both times the ray's cosine with `forward`.
/// What one of several sights hides is hidden. A hole, and what no sight sees, hides nothing.
struct OcclusionTest {
  std::vector<DepthSight> sights;
  Eigen::Vector3f forward = {0, 0, -1};             ///< unit; the photograph's axis in the world
  std::optional<sensors::DepthBuffer> buffer = {};  ///< none: metres
  std::optional<Mask> mask = {};                    ///< decides alone, whatever the distance
};

/// Whether the real world hides a virtual point at this distance in this direction (unit, in the world).
[[nodiscard]] bool hides(const OcclusionTest& test, const MaskPlace& place, float distance_m);

/// What answers in place of the truth: the depth mesh, and who is in front and which real surface the suns
/// light where something else decides that.
struct DepthWorld {
  const Geometry* mesh = nullptr;            ///< null where nothing is asked of it
  const OcclusionTest* occlusion = nullptr;  ///< null: the mesh decides
  const ShadowMatte* matte = nullptr;       ///< which real surfaces suns do not reach; null: the mesh decides
  const RealtimeWorld* realtime = nullptr;  ///< methods in place of rays; null: everything is traced

  // A mesh alone is a world of depth.
  DepthWorld(const Geometry* depth_mesh, const OcclusionTest* test = nullptr,
             const ShadowMatte* shadow_matte = nullptr, const RealtimeWorld* methods = nullptr)
      : mesh(depth_mesh), occlusion(test), matte(shadow_matte), realtime(methods) {}
  DepthWorld(std::nullptr_t) {}
};

}  // namespace seamline::renderer
