#include "raytracer/tracing/search_tree.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <new>
#include <utility>

#include "raytracer/tracing/ray_device.h"
#include "raytracer/tracing/surface_point.h"
#include "support/running/interrupt.h"

namespace seamline::renderer {
namespace {

RTCDevice embree_device() {
  return static_cast<RTCDevice>(RayDevice::instance().handle());
}

/// Called by Embree for hits of meshes with an alpha mask: those in a hole are none.
void leave_out_holes(const RTCFilterFunctionNArguments* arguments) {
  const auto& mesh = *static_cast<const SurfaceMesh*>(arguments->geometryUserPtr);
  for (unsigned lane = 0; lane < arguments->N; ++lane) {
    if (arguments->valid[lane] == 0) continue;
    const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, lane);
    const float u = RTCHitN_u(arguments->hit, arguments->N, lane);
    const float v = RTCHitN_v(arguments->hit, arguments->N, lane);
    if (cut_away(*mesh.material, texture_coordinates(mesh, triangle, u, v))) arguments->valid[lane] = 0;
  }
}

/// Adds a mesh of triangles or of quads to a scene, which copies it. `masked`: a mesh with holes, which stays
/// where it is.
template <std::size_t corners>
void attach(RTCScene scene, const std::vector<Eigen::Vector3f>& positions,
            const std::vector<std::array<std::uint32_t, corners>>& faces, RTCBuildQuality quality,
            const SurfaceMesh* masked = nullptr) {
  static_assert(corners == 3 || corners == 4);
  RTCGeometry geometry =
      rtcNewGeometry(embree_device(), corners == 3 ? RTC_GEOMETRY_TYPE_TRIANGLE : RTC_GEOMETRY_TYPE_QUAD);
  rtcSetGeometryBuildQuality(geometry, quality);
  const auto copy = [geometry](RTCBufferType type, RTCFormat format, const auto& values) {
    using Value = std::decay_t<decltype(values.front())>;
    void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Value), values.size());
    std::copy(values.begin(), values.end(), static_cast<Value*>(buffer));
  };
  copy(RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, positions);
  copy(RTC_BUFFER_TYPE_INDEX, corners == 3 ? RTC_FORMAT_UINT3 : RTC_FORMAT_UINT4, faces);
  if (masked != nullptr) {
    rtcSetGeometryUserData(geometry, const_cast<SurfaceMesh*>(masked));  // NOLINT: only read
    rtcSetGeometryIntersectFilterFunction(geometry, leave_out_holes);
    rtcSetGeometryOccludedFilterFunction(geometry, leave_out_holes);
  }
  rtcCommitGeometry(geometry);
  rtcAttachGeometry(scene, geometry);
  rtcReleaseGeometry(geometry);
}

/// Embree keeps its errors to itself until asked: a scene that could not be built would be an empty one.
void commit(RTCScene scene) {
  rtcSetSceneProgressMonitorFunction(
      scene, [](void*, double) { return !interrupted(); }, nullptr);
  rtcCommitScene(scene);
  stop_if_interrupted();
  if (rtcGetDeviceError(embree_device()) != RTC_ERROR_NONE) throw std::bad_alloc();
}

/// A scene that is released where it cannot be built.
class NewScene {
 public:
  explicit NewScene(RTCBuildQuality quality) : scene_(rtcNewScene(embree_device())) {
    rtcSetSceneBuildQuality(scene_, quality);
  }
  ~NewScene() {
    if (scene_ != nullptr) rtcReleaseScene(scene_);
  }
  NewScene(const NewScene&) = delete;
  NewScene& operator=(const NewScene&) = delete;
  [[nodiscard]] RTCScene get() const { return scene_; }
  RTCScene committed() {
    commit(scene_);
    return std::exchange(scene_, nullptr);
  }

 private:
  RTCScene scene_;
};

RTCBuildQuality build_quality(TreeQuality quality) {
  return quality == TreeQuality::for_light ? RTC_BUILD_QUALITY_HIGH : RTC_BUILD_QUALITY_MEDIUM;
}

template <std::size_t corners>
RTCScene scene_of(const std::vector<Eigen::Vector3f>& positions_m,
                  const std::vector<std::array<std::uint32_t, corners>>& faces, RTCBuildQuality quality) {
  NewScene scene(quality);
  attach(scene.get(), positions_m, faces, quality);
  return scene.committed();
}

RTCScene scene_of(std::span<const std::shared_ptr<const SurfaceMesh>> meshes, Edges edges,
                  RTCBuildQuality quality) {
  NewScene scene(quality);
  if (edges == Edges::tight) rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  for (const auto& mesh : meshes)
    attach(scene.get(), mesh->positions_m, mesh->triangles, quality,
           mesh->material && mesh->material->alpha_cutoff ? mesh.get() : nullptr);
  return scene.committed();
}

}  // namespace

SearchTree::SearchTree(std::span<const std::shared_ptr<const SurfaceMesh>> meshes, Edges edges,
                       TreeQuality quality)
    : scene_(scene_of(meshes, edges, build_quality(quality))), boxes_(meshes) {}

SearchTree::SearchTree(const std::vector<Eigen::Vector3f>& positions_m,
                       const std::vector<Triangle>& triangles, TreeQuality quality)
    : scene_(scene_of(positions_m, triangles, build_quality(quality))) {}

SearchTree::SearchTree(const std::vector<Eigen::Vector3f>& positions_m,
                       const std::vector<std::array<std::uint32_t, 4>>& quads, TreeQuality quality)
    : scene_(scene_of(positions_m, quads, build_quality(quality))) {}

SearchTree::~SearchTree() {
  rtcReleaseScene(static_cast<RTCScene>(scene_));
}

}  // namespace seamline::renderer
