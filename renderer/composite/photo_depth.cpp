#include "renderer/composite/photo_depth.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "registration/files/camera_file.h"
#include "renderer/composite/fast_photo.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "sensors/files/pgm.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

registration::CameraFile cameras_of(const std::string& name) {
  const bool preset = registration::is_preset(name) && !fs::exists(name);
  return preset ? registration::camera_file_of_preset(name, "--camera")
                : registration::read_camera_file(name);
}

/// Width and height of a file of depth, by its header.
PictureShape depth_shape(const fs::path& path) {
  const std::string ending = lower_case_ending(path);
  if (ending != ".pgm") return picture_shape(path);
  const sensors::Pgm pgm = sensors::read_pgm(path);
  return {pgm.width_px, pgm.height_px, 1};
}

sensors::DepthFileForm form_of(const PhotoDepthRequest& request, const sensors::PinholeCamera& camera,
                               sensors::DepthConvention usual) {
  return {.camera = camera,
          .convention = request.convention.value_or(usual),
          .metres_per_step = request.metres_per_step};
}

void require_some(const PhotoDepth& depth, const std::string& file) {
  if (depth.holes >= std::int64_t{depth.width_px} * depth.height_px)
    throw input_error({.file = file,
                       .wanted = "a depth map with at least one depth",
                       .found = "nothing but holes (0, negative, infinite or no number)"});
}

PhotoDepth panorama_of(const PhotoDepthRequest& request, const PictureShape& shape) {
  if (request.convention == sensors::DepthConvention::planar)
    throw input_error({.field = "--depth-kind",
                       .wanted = "radial: a panorama's depth is the length of its rays",
                       .found = "planar"});
  PhotoDepth depth;
  if (lower_case_ending(request.file) == ".exr") {
    depth.map = read_depth_map(request.file);
    for (float& distance_m : depth.map->distance_m)
      distance_m = static_cast<float>(static_cast<double>(distance_m) * request.metres_per_step.value_or(1));
  } else {
    // Its values alone; the camera only says how many there are.
    const sensors::PinholeCamera any = sensors::pinhole_of_field_of_view(shape.width_px, shape.height_px, 90);
    sensors::DepthFrame frame =
        sensors::read_depth_file(request.file, form_of(request, any, sensors::DepthConvention::radial)).frame;
    depth.map = DepthMap{
        .width_px = shape.width_px, .height_px = shape.height_px, .distance_m = std::move(frame.depth_m)};
  }
  clean_holes(*depth.map);
  depth.width_px = depth.map->width_px;
  depth.height_px = depth.map->height_px;
  depth.holes = std::count_if(depth.map->distance_m.begin(), depth.map->distance_m.end(),
                              [](float distance_m) { return !std::isfinite(distance_m); });
  return depth;
}

PhotoDepth frame_of(const PhotoDepthRequest& request, const sensors::PinholeCamera& camera, bool unusual) {
  PhotoDepth depth;
  sensors::DepthFileForm form = form_of(request, camera, sensors::DepthConvention::planar);
  form.unusual_distances = unusual;
  sensors::DepthFile file = sensors::read_depth_file(request.file, form);
  depth.frame = sensors::in_convention(file.frame, sensors::DepthConvention::planar);
  depth.holes = file.holes;
  depth.width_px = camera.width_px;
  depth.height_px = camera.height_px;
  return depth;
}

}  // namespace

std::optional<sensors::PinholeCamera> photograph_lens(const PhotoDepthRequest& request,
                                                      const Photograph& photograph,
                                                      const std::string& photograph_file) {
  if (request.camera.empty()) return std::nullopt;
  const registration::CameraFile cameras = cameras_of(request.camera);
  const sensors::PinholeCamera colour = registration::registration_rig(cameras, request.camera).colour;
  if (colour.width_px != photograph.radiance.width_px || colour.height_px != photograph.radiance.height_px)
    throw input_error(
        {.file = photograph_file,
         .wanted = fmt::format("{} x {} pixels, as the colour camera of {} has", colour.width_px,
                               colour.height_px, request.camera),
         .found = fmt::format("{} x {}", photograph.radiance.width_px, photograph.radiance.height_px)});
  return colour;
}

PhotoDepth read_photo_depth(const PhotoDepthRequest& request, const Photograph& photograph,
                            const std::optional<sensors::PinholeCamera>& lens, double fov_deg) {
  if (lens) {
    PhotoDepth depth = frame_of(request, *lens, cameras_of(request.camera).unusual_distances);
    require_some(depth, request.file);
    return depth;
  }
  const PictureShape shape = depth_shape(request.file);
  if (lower_case_ending(request.file) != ".exr" && !request.metres_per_step)
    throw input_error({.file = request.file,
                       .field = "--metres-per-step",
                       .wanted = "how many metres a step of its whole numbers is (0.001: millimetres)",
                       .found = "nothing"});
  const Image& picture = photograph.radiance;
  const bool is_panorama = shape.width_px == 2 * shape.height_px && request.view != DepthView::photograph;
  const double ratio = shape.height_px > 0 ? static_cast<double>(shape.width_px) / shape.height_px : 0;
  const bool as_photograph = photograph.projection == Projection::perspective &&
                             request.view != DepthView::panorama &&
                             std::abs(ratio * picture.height_px / picture.width_px - 1) < 0.01;
  if (!as_photograph && !is_panorama)
    throw input_error(
        {.file = request.file,
         .wanted =
             photograph.projection == Projection::panorama
                 ? std::string("a panoramic depth map, twice as wide as high")
                 : fmt::format(
                       "a panoramic depth map, twice as wide as high, or one of the photograph's shape, "
                       "{} x {}{}",
                       picture.width_px, picture.height_px,
                       photograph.orientation == 1
                           ? ""
                           : " since it was turned upright, as its EXIF orientation says"),
         .found = fmt::format("{} x {}", shape.width_px, shape.height_px)});
  PhotoDepth depth =
      is_panorama
          ? panorama_of(request, shape)
          : frame_of(request, sensors::pinhole_of_field_of_view(shape.width_px, shape.height_px, fov_deg),
                     false);
  require_some(depth, request.file);
  return depth;
}

DepthMesh photo_mesh(const PhotoDepth& depth, const PhotoDepthRequest& request, const Camera& camera) {
  if (depth.map)
    return build_depth_mesh(*depth.map, {.density = request.density,
                                         .tolerance = request.tolerance,
                                         .yaw_texels = request.yaw_texels,
                                         .threads = request.threads});
  return build_pixel_mesh(pixel_grid({*depth.frame, world_from_photograph(camera)}, request.threads),
                          {.density = request.density,
                           .tolerance = request.tolerance,
                           .cut_ratio = request.cut_ratio,
                           .threads = request.threads});
}

DepthMesh reduced_photo_mesh(const DepthMesh& full, int width_px, const PhotoDepthRequest& request) {
  const auto surface = surface_of_depth(full, 0.5);
  return build_depth_mesh(
      capture_depth(Geometry(std::span(&surface, 1)), width_px, 0, request.threads),
      {.density = request.density, .tolerance = request.tolerance, .threads = request.threads});
}

DepthSight photo_sight(const PhotoDepth& depth, const PhotoDepthRequest& request, const Camera& camera) {
  if (depth.map) return PanoramaSight{*depth.map, request.yaw_texels};
  return FrameSight{*depth.frame, world_from_photograph(camera).linear().transpose()};
}

}  // namespace seamline::renderer
