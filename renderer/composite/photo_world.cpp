#include "renderer/composite/photo_world.h"

#include <fmt/core.h>

#include <utility>

#include "renderer/common/stopwatch.h"
#include "renderer/composite/hidden_sky.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::renderer {

PhotoLocalScene local_scene_of(DepthMesh mesh, const KnownLight& known, double albedo, double seconds,
                               int threads) {
  PhotoLocalScene scene;
  scene.mesh = std::move(mesh);
  const Stopwatch watch;
  auto geometry = std::make_shared<Geometry>(scene.mesh, Rgb::Constant(static_cast<float>(albedo)),
                                             TreeQuality::for_light, CentreRays::by_table);
  scene.light = known.light;
  if (known.photographed) {
    scene.light.hidden_sky = fill_hidden_sky(*geometry, *scene.light.environment, threads);
    scene.sent = follow_received_light(geometry, scene.light, known.panorama_white, threads);
  }
  scene.geometry = std::move(geometry);
  scene.seconds = seconds + watch.seconds();
  return scene;
}

void read_photo_world(const CompositeRequest& request, PhotoWorld& world, Notes& notes) {
  const Stopwatch watch;
  const SeenPhoto& seen = world.seen;
  world.depth = read_photo_depth(request.depth, seen.photograph, seen.lens, seen.camera, seen.fov_deg);
  const PhotoDepth& depth = world.depth;
  for (const std::string& note : depth.notes) notes.say(printable(request.depth.file) + ": " + note);
  DepthMesh mesh = photo_mesh(depth, request.depth, seen.camera);
  if (mesh.triangles.empty())
    throw input_error({.file = request.depth.file,
                       .wanted = "a depth map in which three neighbours have a depth",
                       .found = "none"});
  const Geometry geometry(mesh, Rgb::Constant(static_cast<float>(request.albedo)));
  world.known = known_light(request, seen, geometry, notes);
  require_way_in(world.known, geometry, notes);
  world.local =
      local_scene_of(std::move(mesh), world.known, request.albedo, watch.seconds(), request.threads);
  const SentLight& sent = world.local.sent;
  if (sent.share_above_one >= 0.01)
    notes.say(
        fmt::format("{:.0f} % of what the depth map shows is brighter than white surfaces would be there, up "
                    "to {:.2g} times (light that the panorama does not show, or a tone curve): it sends the "
                    "objects what white surfaces would",
                    100 * sent.share_above_one, sent.most_albedo));
}

}  // namespace seamline::renderer
