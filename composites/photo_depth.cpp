#include "composites/photo_depth.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include "composites/fast_photo.h"
#include "registration/files/camera_file.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/depth_mesh.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "support/arithmetic/shortest_turn.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

registration::CameraFile cameras_of(const std::string& name, const Photograph& photograph) {
  const bool preset = registration::is_preset(name) && !fs::exists(name);
  return preset ? registration::camera_file_of_preset(name, request_name("camera"))
                : registration::read_camera_file(name, std::pair{photograph.width_px, photograph.height_px});
}

/// A pose in a world with +Y up. Where the file does not say what is up there and the camera would stand on
/// its head, that world's y points down, as cameras' does.
Eigen::Isometry3d upright_pose(const registration::CameraFile& cameras, std::vector<std::string>& notes) {
  const Eigen::Isometry3d& pose = *cameras.world_from_colour;
  const double up_y = -pose.linear()(1, 1);  // of the camera's up
  const bool turned_over = cameras.up ? cameras.up->isApprox(-Eigen::Vector3d::UnitY()) : up_y < 0;
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  if (turned_over)
    turn.linear().diagonal() = Eigen::Vector3d(1, -1, -1);
  else if (cameras.up)
    turn.linear() = shortest_turn(*cameras.up, Eigen::Vector3d::UnitY()).toRotationMatrix();
  if (turned_over && !cameras.up)
    notes.emplace_back(
        "in a world with +Y up its camera would stand on its head: its y is taken to point down (up = [0, 1, 0] "
        "says otherwise)");
  else if (!cameras.up && std::abs(up_y) < 0.2)
    notes.emplace_back(
        "its camera looks steeply up or down, or its world's up is not +Y, as up = [0, 0, 1] would say");
  const Eigen::Isometry3d out = turn * pose;
  const Eigen::Vector3d at = out.translation();
  notes.push_back(fmt::format(
      "its camera stands at {:.3f} {:.3f} {:.3f} m in the world in which positions are (right, up, back)",
      at.x(), at.y(), at.z()));
  return out;
}

/// Points of the photograph in the pixels of its depth map.
std::vector<sensors::KnownPoint> in_map(std::vector<sensors::KnownPoint> points, const sensors::RawDepth& raw,
                                        const Photograph& photograph) {
  for (sensors::KnownPoint& point : points) {
    point.x_px *= static_cast<double>(raw.width_px) / photograph.width_px;
    point.y_px *= static_cast<double>(raw.height_px) / photograph.height_px;
  }
  return points;
}

sensors::DepthFileForm form_of(const PhotoDepthRequest& request, const sensors::PinholeCamera& camera,
                               sensors::DepthConvention usual) {
  return {.camera = camera,
          .convention = request.convention.value_or(usual),
          .metres_per_step = request.metres_per_step};
}

sensors::DepthMeaning meaning_of(const PhotoDepthRequest& request, const sensors::RawDepth& raw) {
  sensors::DepthMeaning meaning{.estimate = request.estimate, .of_request = true};
  if (request.nothing)
    meaning.nothing = *request.nothing;
  else if (raw.whole && raw.bits == 16 && !request.estimate)
    meaning.nothing = {65535};
  return meaning;
}

PhotoDepth panorama_of(const PhotoDepthRequest& request, const sensors::RawDepth& raw) {
  if (request.convention == sensors::DepthConvention::planar)
    throw input_error({.field = request_name("depth_kind"),
                       .wanted = "radial: a panorama's depth is the length of its rays",
                       .found = "planar"});
  // Its values alone; the camera only says how many there are.
  const sensors::PinholeCamera any = sensors::pinhole_of_field_of_view(raw.width_px, raw.height_px, 90);
  sensors::DepthFileForm form = form_of(request, any, sensors::DepthConvention::radial);
  form.unusual_distances = !raw.whole && !request.estimate;
  sensors::DepthFromValues read = sensors::depth_of_values(raw, request.file, form, meaning_of(request, raw));
  sensors::DepthFile& file = read.file;
  PhotoDepth depth;
  depth.map = DepthMap{
      .width_px = raw.width_px, .height_px = raw.height_px, .distance_m = std::move(file.frame.depth_m)};
  depth.width_px = raw.width_px;
  depth.height_px = raw.height_px;
  depth.holes = file.holes;
  depth.notes = std::move(read.notes);
  return depth;
}

PhotoDepth frame_of(const PhotoDepthRequest& request, const sensors::PinholeCamera& camera,
                    const sensors::RawDepth& raw, bool unusual) {
  PhotoDepth depth;
  sensors::DepthFileForm form = form_of(request, camera, sensors::DepthConvention::planar);
  form.unusual_distances = unusual;
  sensors::DepthFromValues read = sensors::depth_of_values(raw, request.file, form, meaning_of(request, raw));
  sensors::DepthFile& file = read.file;
  depth.frame = sensors::in_convention(file.frame, sensors::DepthConvention::planar);
  depth.holes = file.holes;
  depth.width_px = camera.width_px;
  depth.height_px = camera.height_px;
  depth.notes = std::move(read.notes);
  return depth;
}

/// Depth in a fisheye's pixels as a panorama around the camera, the nearest pixel in each texel's direction.
PhotoDepth fisheye_depth(const PhotoDepthRequest& request, const sensors::FisheyeCamera& fisheye,
                         const sensors::RawDepth& raw, const Camera& camera) {
  sensors::PinholeCamera any = sensors::pinhole_of_field_of_view(fisheye.width_px, fisheye.height_px, 90);
  sensors::DepthFromValues read = sensors::depth_of_values(
      raw, request.file, form_of(request, any, sensors::DepthConvention::radial), meaning_of(request, raw));
  const sensors::DepthFrame& frame = read.file.frame;
  constexpr int widest_px = 8192;
  const int height_px =
      std::clamp(static_cast<int>(std::ceil(std::numbers::pi * std::max(fisheye.fx_px, fisheye.fy_px))), 2,
                 widest_px / 2);
  PhotoDepth depth;
  depth.width_px = fisheye.width_px;
  depth.height_px = fisheye.height_px;
  depth.holes = read.file.holes;
  depth.notes = std::move(read.notes);
  depth.map = DepthMap{.width_px = 2 * height_px, .height_px = height_px, .distance_m = {}};
  depth.map->distance_m.assign(2 * static_cast<std::size_t>(height_px) * static_cast<std::size_t>(height_px),
                               sensors::hole);
  const Eigen::Matrix3d camera_from_world = world_from_photograph(camera).linear().transpose();
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < 2 * height_px; ++x) {
      const Eigen::Vector3d direction =
          camera_from_world * panorama_direction(x + 0.5, y + 0.5, 2 * height_px, height_px);
      const auto place_px = sensors::project(fisheye, direction);
      if (!place_px || !sensors::is_in_picture(any, *place_px)) continue;
      const float value = frame.at(static_cast<int>(place_px->x()), static_cast<int>(place_px->y()));
      const bool planar = frame.convention == sensors::DepthConvention::planar;
      if (sensors::DepthFrame::is_hole(value) || (planar && !(direction.z() > 1e-6))) continue;
      depth.map->distance_m[static_cast<std::size_t>(y) * 2 * static_cast<std::size_t>(height_px) +
                            static_cast<std::size_t>(x)] =
          planar ? static_cast<float>(static_cast<double>(value) / direction.z()) : value;
    }
  depth.notes.push_back(
      fmt::format("depth of a fisheye: {} are looked up through a panorama of {} x {} texels",
                  request.convention == sensors::DepthConvention::planar
                      ? "distances along the axis (" + request_name("depth_kind") + " planar)"
                      : "lengths of rays (" + request_name("depth_kind") + " planar says the other)",
                  2 * height_px, height_px));
  return depth;
}

void require_unit(const PhotoDepthRequest& request, const sensors::RawDepth& raw) {
  if (!raw.whole || request.metres_per_step || request.estimate) return;
  throw input_error({.file = request.file,
                     .field = request_name("metres_per_step"),
                     .wanted = "how many metres a step of its whole numbers is (0.001: millimetres), " +
                               request_name("depth_unit") + " NAME, or " + request_name("depth_value") +
                               " where it is an estimate",
                     .found = "nothing"});
}

}  // namespace

std::optional<PhotoLens> photograph_lens(const PhotoDepthRequest& request, const Photograph& photograph,
                                         const std::string& photograph_file) {
  if (request.camera.empty()) return std::nullopt;
  registration::CameraFile cameras = cameras_of(request.camera, photograph);
  PhotoLens lens;
  lens.notes = std::move(cameras.notes);
  lens.metres_per_step = cameras.metres_per_step;
  lens.nothing = cameras.nothing;
  lens.unusual_distances = cameras.unusual_distances;
  if (cameras.fisheye)
    lens.camera = *cameras.fisheye;
  else if (cameras.colour)
    lens.camera = *cameras.colour;
  else
    throw input_error({.file = request.camera,
                       .field = "colour",
                       .wanted = "a table [colour], the photograph's camera, or a preset",
                       .found = "nothing"});
  if (cameras.world_from_colour) lens.world_from_camera = upright_pose(cameras, lens.notes);
  const auto [width_px, height_px] = std::visit(
      [](const auto& camera) {
        return std::pair{camera.width_px, camera.height_px};
      },
      lens.camera);
  if (width_px != photograph.width_px || height_px != photograph.height_px)
    throw input_error({.file = photograph_file,
                       .wanted = fmt::format("{} x {} pixels, as the colour camera of {} has", width_px,
                                             height_px, request.camera),
                       .found = fmt::format("{} x {}", photograph.width_px, photograph.height_px)});
  return lens;
}

Camera camera_of_lens(const PhotoLens& lens, const Camera& view) {
  Camera turned = view;
  if (lens.world_from_camera) {
    const Eigen::Matrix3d axes = lens.world_from_camera->linear();  // right, down, forward
    turned.axes.col(0) = axes.col(0).cast<float>();
    turned.axes.col(1) = -axes.col(1).cast<float>();
    turned.axes.col(2) = -axes.col(2).cast<float>();
  }
  return std::visit([&](const auto& camera) { return lens_camera(camera, turned); }, lens.camera);
}

PhotoDepth read_photo_depth(const PhotoDepthRequest& asked, const Photograph& photograph,
                            const std::optional<PhotoLens>& lens, const Camera& camera, double fov_deg) {
  const sensors::RawDepth raw = sensors::read_raw_depth(
      asked.file, {.channel = asked.channel, .eight_bits = asked.estimate.has_value()});
  const Image& picture = photograph.radiance;
  PhotoDepthRequest request = asked;
  if (request.estimate) request.estimate->points = in_map(request.estimate->points, raw, photograph);
  if (lens) {
    if (raw.whole && !request.metres_per_step && !request.estimate)
      request.metres_per_step = lens->metres_per_step;
    if (!request.nothing) request.nothing = lens->nothing;
    require_unit(request, raw);
    if (const auto* fisheye = std::get_if<sensors::FisheyeCamera>(&lens->camera))
      return fisheye_depth(request, *fisheye, raw, camera);
    return frame_of(request, std::get<sensors::PinholeCamera>(lens->camera), raw, lens->unusual_distances);
  }
  require_unit(request, raw);
  const PictureShape shape{raw.width_px, raw.height_px, 1};
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
  if (is_panorama && photograph.projection == Projection::perspective && request.estimate &&
      !request.estimate->points.empty())
    throw input_error({.field = request_name("depth_point"),
                       .wanted = "depth of the photograph's own view, in whose pixels the points are",
                       .found = "a panorama of depth"});
  if (is_panorama) return panorama_of(request, raw);
  return frame_of(request, sensors::pinhole_of_field_of_view(shape.width_px, shape.height_px, fov_deg), raw,
                  false);
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
