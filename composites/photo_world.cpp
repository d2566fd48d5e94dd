#include "composites/photo_world.h"

#include <fmt/core.h>

#include <cmath>
#include <utility>
#include <variant>

#include "composites/light/hidden_sky.h"
#include "raytracer/common/stopwatch.h"
#include "renderer/depth/depth_map.h"
#include "sensors/repair/named_repair.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::renderer {

namespace {

/// Mends depth of the photograph's own view, whose noise would otherwise be shaded.
void repair_depth(const CompositeRequest& request, const SeenPhoto& seen, PhotoDepth& depth, Notes& notes) {
  const auto wanted = [&](const std::string& what, const std::string& found) {
    return input_error({.field = request_name("repair"), .wanted = what, .found = found});
  };
  if (!depth.frame) throw wanted("depth of the photograph's own view", "a panorama");
  const sensors::RepairMethod method = sensors::named_repair(request.repair);
  const Image& photograph = seen.photograph.radiance;
  if (std::holds_alternative<sensors::JointBilateralRepair>(method) &&
      (photograph.width_px != depth.width_px || photograph.height_px != depth.height_px))
    throw wanted("depth with as many pixels as the photograph beside joint_bilateral (or register " +
                     request_name("repair") + ")",
                 fmt::format("{} x {}", depth.width_px, depth.height_px));
  sensors::Repaired mended = sensors::repair(*depth.frame, method, &photograph, request.threads);
  notes.say(fmt::format("{} {} changed {} of the depth map and gave {} a depth", request_name("repair"),
                        request.repair, counted(mended.count(sensors::RepairMark::changed), "pixel"),
                        counted(mended.count(sensors::RepairMark::invented), "hole")));
  depth.holes = mended.count(sensors::RepairMark::empty);
  depth.frame = std::move(mended.frame);
}

/// Says where much depth is missing that is no sky: in a panorama below the horizon, by solid angle.
void note_holes(const PhotoDepth& depth, Notes& notes) {
  constexpr double worth_a_note = 0.3;
  double share = static_cast<double>(depth.holes) / (double{1} * depth.width_px * depth.height_px);
  if (depth.map) {
    double empty_sr = 0, all_sr = 0;
    for (int row = depth.height_px / 2; row < depth.height_px; ++row) {
      const double texel_sr = texel_solid_angle_sr(row, depth.width_px, depth.height_px);
      all_sr += depth.width_px * texel_sr;
      for (int column = 0; column < depth.width_px; ++column)
        empty_sr += std::isfinite(depth.map->at(column, row)) ? 0 : texel_sr;
    }
    share = empty_sr / all_sr;
  }
  if (share <= worth_a_note) return;
  notes.say(fmt::format(
      "{:.0f} % of the depth map{} are holes: nothing is hidden and no shadow falls there, and light comes in "
      "(register {} fills holes)",
      100 * share, depth.map ? " below the horizon" : "", request_name("repair")));
}

}  // namespace

std::shared_ptr<Geometry> geometry_of(const DepthMesh& mesh, double albedo) {
  return std::make_shared<Geometry>(mesh, Rgb::Constant(static_cast<float>(albedo)), TreeQuality::for_light,
                                    CentreRays::by_table);
}

PhotoLocalScene local_scene_of(DepthMesh mesh, std::shared_ptr<Geometry> geometry, const KnownLight& known,
                               const CompositeRequest& request, double seconds) {
  PhotoLocalScene scene;
  scene.mesh = std::move(mesh);
  const Stopwatch watch;
  scene.light = known.light;
  if (known.photographed) {
    scene.light.hidden_sky = fill_hidden_sky(*geometry, *scene.light.environment, request.threads);
    scene.sent = follow_received_light(geometry, scene.light, known.panorama_white,
                                       implied_albedo_columns(request.error), request.threads);
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
  if (!request.repair.empty()) repair_depth(request, seen, world.depth, notes);
  note_holes(depth, notes);
  DepthMesh mesh = photo_mesh(depth, request.depth, seen.camera);
  if (mesh.triangles.empty())
    throw input_error({.file = request.depth.file,
                       .wanted = "a depth map in which three neighbours have a depth",
                       .found = "none"});
  const std::shared_ptr<Geometry> geometry = geometry_of(mesh, request.albedo);
  world.known = known_light(request, seen, *geometry, notes);
  require_way_in(world.known, *geometry, notes);
  world.local = local_scene_of(std::move(mesh), geometry, world.known, request, watch.seconds());
  const SentLight& sent = world.local.sent;
  if (sent.share_above_one >= 0.01)
    notes.say(
        fmt::format("{:.0f} % of what the depth map shows is brighter than white surfaces would be there, up "
                    "to {:.2g} times (light that the panorama does not show, or a tone curve): it sends the "
                    "objects what white surfaces would",
                    100 * sent.share_above_one, sent.most_albedo));
}

}  // namespace seamline::renderer
