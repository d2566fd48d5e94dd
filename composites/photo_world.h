#pragma once
#include <memory>

#include "composites/composite_light.h"
#include "composites/light/sent_light.h"
#include "composites/photo_depth.h"
#include "composites/photo_view.h"

namespace seamline::renderer {

/// The local scene in the forms that are asked of it.
struct PhotoLocalScene {
  DepthMesh mesh;
  std::shared_ptr<const Geometry> geometry;
  Light light;     ///< that falls on objects in it
  SentLight sent;  ///< of a panorama that is light itself
  double seconds = 0;
};

/// What rays meet of a mesh whose surfaces have one albedo.
[[nodiscard]] std::shared_ptr<Geometry> geometry_of(const DepthMesh& mesh, double albedo);

/// The local scene of a mesh and its `geometry_of`, which took `seconds` so far. `request`: its error and
/// threads.
[[nodiscard]] PhotoLocalScene local_scene_of(DepthMesh mesh, std::shared_ptr<Geometry> geometry,
                                             const KnownLight& known, const CompositeRequest& request,
                                             double seconds);

/// Everything of a composite that does not depend on its objects.
struct PhotoWorld {
  SeenPhoto seen;
  PhotoDepth depth;
  KnownLight known;
  PhotoLocalScene local;

  PhotoWorld() = default;
  PhotoWorld(const PhotoWorld&) = delete;
  PhotoWorld& operator=(const PhotoWorld&) = delete;
};

/// Reads depth and light of a world whose photograph is seen. `request.threads` and `request.depth.threads`
/// are set. Throws InputError as the readers do, and where the light cannot come in.
void read_photo_world(const CompositeRequest& request, PhotoWorld& world, Notes& notes);

}  // namespace seamline::renderer
