#include "renderer/estimators/realtime_methods.h"

#include <algorithm>
#include <array>
#include <limits>
#include <vector>

#include "renderer/realtime/median_cut.h"
#include "renderer/realtime/realtime_world.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

constexpr int receiver_step_px = 2;
constexpr float near_radii = 4;  ///< of the ball around the object, within which it takes some of the sky

std::vector<TriangleSpan> spans_of(const Geometry& geometry) {
  std::vector<TriangleSpan> spans;
  for (const auto& mesh : geometry.meshes()) spans.push_back({mesh->positions_m, mesh->triangles});
  return spans;
}

TriangleSpan span_of(const LocalScene& local) {
  return {local.triangles->vertices_m, local.triangles->triangles};
}

/// Corners of the box around an object.
std::vector<Eigen::Vector3f> box_corners(std::span<const TriangleSpan> object) {
  Eigen::Array3f least = Eigen::Array3f::Constant(std::numeric_limits<float>::infinity()), most = -least;
  for (const TriangleSpan& mesh : object)
    for (const Eigen::Vector3f& position_m : mesh.positions_m) {
      least = least.min(position_m.array());
      most = most.max(position_m.array());
    }
  std::vector<Eigen::Vector3f> corners;
  for (int i = 0; i < 8; ++i)
    corners.emplace_back((i & 1) != 0 ? most[0] : least[0], (i & 2) != 0 ? most[1] : least[1],
                         (i & 4) != 0 ? most[2] : least[2]);
  return corners;
}

/// Whether an object's map may keep light from a point: it lies in the map's picture, or beside it by no more
/// than a sun's disc makes of the distance, and not before the object.
bool may_be_shadowed(const ShadowMap& map, const Eigen::Vector3f& point_m) {
  const ViewedPoint seen = view_point(map.view, map.depth, point_m);
  if (!(seen.depth_m > map.nearest_m)) return false;
  const float texel_m = map.view.size[0] / static_cast<float>(map.depth.width_px);
  const float margin_px = 2.0F + map.tan_radius * (seen.depth_m - map.nearest_m) / texel_m;
  const auto width_px = static_cast<float>(map.depth.width_px);
  return seen.x_px > -margin_px && seen.y_px > -margin_px && seen.x_px < width_px + margin_px &&
         seen.y_px < width_px + margin_px;
}

/// The ball around an object's box.
struct Ball {
  Eigen::Vector3f centre_m;
  float radius_m;

  explicit Ball(const std::vector<Eigen::Vector3f>& corners)
      : centre_m(0.5F * (corners.front() + corners.back())),
        radius_m(0.5F * (corners.back() - corners.front()).norm()) {}
};

/// Points that the camera sees and whose light the object may change.
void add_receivers(const Camera& camera, const Geometry& local, const ShadowMaps& object, float near_m,
                   const Ball& ball, std::vector<Eigen::Vector3f>& points_m) {
  for (int y = receiver_step_px / 2; y < camera.height_px; y += receiver_step_px)
    for (int x = receiver_step_px / 2; x < camera.width_px; x += receiver_step_px) {
      const auto point = local.nearest(centre_ray(camera, x, y));
      if (!point) continue;
      const auto shadowed = [&](const ShadowMap& map) { return may_be_shadowed(map, point->position_m); };
      if ((point->position_m - ball.centre_m).norm() < near_m ||
          std::any_of(object.suns.begin(), object.suns.end(), shadowed) ||
          std::any_of(object.lamps.begin(), object.lamps.end(), shadowed))
        points_m.push_back(point->position_m);
    }
}

void add_maps(const TruthScene& scene, const ObjectGeometry& geometry, int threads, const LocalScene& local,
              RealtimeWorld& world) {
  if (world.light.suns.empty() && world.light.lamps.empty())
    throw input_error({.field = "pipeline.shadows",
                       .wanted = "a scene with a sun or a lamp, or lights = \"median_cut\" beside it",
                       .found = "neither in " + scene.definition.name});
  const int width_px = world.pipeline.shadow_map_px;
  const std::vector<TriangleSpan> object = spans_of(geometry.object);
  std::vector<Eigen::Vector3f> covered_m = box_corners(object);
  world.object = draw_shadow_maps(world.light, object, covered_m, width_px, threads);
  const Ball ball(covered_m);
  add_receivers(scene.camera, local.geometry, *world.object,
                world.light.skips_sky ? 0.0F : near_radii * ball.radius_m, ball, covered_m);
  const std::array<TriangleSpan, 1> real = {span_of(local)};
  world.real = draw_shadow_maps(world.light, real, covered_m, width_px, threads);
}

/// Fields around the object and in its place, and the object's own transfers.
FieldLight field_light(const TruthScene& scene, const ObjectGeometry& geometry, const Light& light,
                       const Pipeline& pipeline, int threads, const LocalScene& local) {
  if (!light.lamps.empty())
    throw input_error({.field = "pipeline.shadows",
                       .wanted = "light from infinity for \"occlusion_field\"",
                       .found = "lamps in " + scene.definition.name});
  constexpr int rays = 1024, rays_of_vertex = 256;
  const std::vector<TriangleSpan> object = spans_of(geometry.object);
  const std::vector<Eigen::Vector3f> corners = box_corners(object);
  const auto [centre_m, radius_m] = Ball(corners);
  const auto asking = [](const Geometry& of) {
    return [&of](std::span<const Ray> asked, std::span<std::uint8_t> blocked) {
      of.occluded(asked, blocked, Coherence::scattered);
    };
  };
  FieldShape around{.centre_m = centre_m,
                    .radii_m = shell_radii(0.3F * radius_m, 4 * radius_m, pipeline.field_shells),
                    .bands = pipeline.field_bands};
  FieldShape inside = around;
  inside.radii_m = shell_radii(0.2F * radius_m, radius_m, pipeline.field_shells);
  return {.light = light_harmonics(light, pipeline.field_bands),
          .object = sample_field(around, asking(geometry.object), radius_m, rays, threads),
          .real = sample_field(inside, asking(local.geometry), 0, rays, threads),
          .self = sample_transfers(object, asking(geometry.object), pipeline.field_bands, rays_of_vertex,
                                   threads),
          .unhidden = TransferCache(pipeline.field_bands)};
}

/// A picture of the local scene's depth, in the photograph's pixels.
DepthPicture drawn_depth(const Camera& camera, const LocalScene& local, int threads) {
  DepthPicture picture = empty_picture(camera.width_px, camera.height_px);
  const std::array<TriangleSpan, 1> real = {span_of(local)};
  draw_depth(camera_view(camera), real, threads, picture);
  return picture;
}

}  // namespace

bool looks_at_triangles(const Pipeline& pipeline) {
  return pipeline.occlusion == Occlusion::ghosts || pipeline.shadows == PipelineShadows::shadow_map ||
         pipeline.normals == PipelineNormals::cross_products ||
         pipeline.normals == PipelineNormals::triangle_mean;
}

DrawView camera_view(const Camera& camera) {
  DrawView view;
  view.axes.row(0) = camera.axes.col(0).transpose();
  view.axes.row(1) = -camera.axes.col(1).transpose();
  view.axes.row(2) = -camera.axes.col(2).transpose();
  view.from_point = true;
  const float down =
      camera.tan_half_horizontal * static_cast<float>(camera.height_px) / static_cast<float>(camera.width_px);
  view.corner = {-camera.tan_half_horizontal, -down};
  view.size = {2.0F * camera.tan_half_horizontal, 2.0F * down};
  return view;
}

void add_realtime_methods(const TruthScene& scene, const ObjectGeometry& geometry, const Pipeline& pipeline,
                          int threads, LocalScene& local) {
  auto world = std::make_shared<RealtimeWorld>();
  world->pipeline = pipeline;
  world->light = pipeline.lights == PipelineLights::median_cut
                     ? with_cut_environment(scene.light, pipeline.light_count,
                                            pipeline.shadow_filter == ShadowFilter::pcss)
                     : scene.light;
  if (world->changes_light())
    for (const Lamp& lamp : world->light.lamps) world->each_lamp.push_back({.lamps = {lamp}});
  if (pipeline.shadows == PipelineShadows::shadow_map) add_maps(scene, geometry, threads, local, *world);
  if (pipeline.shadows == PipelineShadows::occlusion_field)
    world->fields = field_light(scene, geometry, world->light, pipeline, threads, local);
  const DrawView view = camera_view(scene.camera);
  if (pipeline.normals == PipelineNormals::cross_products)
    world->normals = cross_product_normals(drawn_depth(scene.camera, local, threads), view, threads);
  if (pipeline.normals == PipelineNormals::triangle_mean) {
    const std::vector<Eigen::Vector3f> of_vertices = triangle_mean_normals(span_of(local));
    world->normals =
        draw_normals(view, span_of(local), of_vertices, drawn_depth(scene.camera, local, threads));
  }
  if (pipeline.occlusion == Occlusion::ghosts)
    local.realtime_occlusion =
        OcclusionTest{.sights = {PictureSight{drawn_depth(scene.camera, local, threads), view}}};
  local.realtime = std::move(world);
}

}  // namespace seamline::renderer
