#include "composites/photo_view.h"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "raytracer/scene/truth_scene.h"
#include "support/files/assets.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

constexpr double usual_photograph_fov_deg = 60;

void require_view(const CompositeRequest& request) {
  if (!request.look_at_m) return;
  const Eigen::Vector3d& view = *request.look_at_m;
  if (!(view.cross(Eigen::Vector3d::UnitY()).norm() > 1e-9 * view.norm()))
    throw input_error({.field = request_name("look_at"),
                       .wanted = "a point that is not straight above, below or at the centre",
                       .found = "one that is"});
}

/// A pinhole of the photograph's or the view's size: the scene file's camera, or what the options say.
Camera pinhole_camera(const CompositeRequest& request, SeenPhoto& seen, int width_px, int height_px) {
  SceneDefinition scene;
  scene.path = request.scene_file;
  if (request.scene_file.empty())
    scene.camera = CameraDefinition{Eigen::Vector3d::Zero(),
                                    request.look_at_m.value_or(Eigen::Vector3d(-Eigen::Vector3d::UnitZ())),
                                    request.fov_deg.value_or(usual_photograph_fov_deg)};
  Camera camera = scene_camera(scene, seen.scene, width_px, height_px, seen.centre_m);
  if (request.roll_deg != 0) {
    const auto roll_rad = static_cast<float>(-request.roll_deg * std::numbers::pi / 180);
    camera.axes = camera.axes * Eigen::AngleAxisf(roll_rad, Eigen::Vector3f::UnitZ()).toRotationMatrix();
  }
  seen.fov_deg = 2 * std::atan(double{camera.tan_half_horizontal}) * 180 / std::numbers::pi;
  return camera;
}

void refuse_view_of_whole(const CompositeRequest& request) {
  const auto refuse = [&](const std::string& option) {
    throw input_error({.field = option,
                       .wanted = request_name("view") +
                                 " WxH beside it, which makes a view of the panorama; or " +
                                 request_name("projection") + " perspective, where the photograph is none",
                       .found = "a panorama as a whole, which looks everywhere"});
  };
  if (request.look_at_m) refuse(request_name("look_at"));
  if (request.fov_deg) refuse(request_name("fov"));
  if (request.roll_deg != 0) refuse(request_name("roll"));
}

void require_one_pose(const CompositeRequest& request) {
  const auto refuse = [](const std::string& option) {
    throw input_error(
        {.field = option,
         .wanted = "a " + request_name("camera") + " without a pose beside it ([world_from_colour])",
         .found = "one that says where the camera stands and looks"});
  };
  if (request.look_at_m) refuse(request_name("look_at"));
  if (!request.scene_file.empty()) refuse(request_name("scene"));
}

}  // namespace

void Notes::say(const std::string& note) {
  if (listener_.note) listener_.note(note);
  said.push_back(note);
}

void Notes::tell(const std::string& line) const {
  if (listener_.line) listener_.line(line);
}

SeenPhoto see(const CompositeRequest& request, Notes& notes) {
  require_view(request);
  SeenPhoto seen;
  seen.photograph = read_photograph(request.photograph, request.projection, request.layer);
  for (const std::string& note : seen.photograph.notes)
    notes.say(printable(request.photograph) + ": " + note);
  if (const std::string warning = codes_warning(seen.photograph, request.photograph); !warning.empty())
    notes.say(warning);
  Image& picture = seen.photograph.radiance;
  if (!request.scene_file.empty()) {
    seen.scene = read_scene_file(resolve_named_file(request.scene_file, request_name("scene")),
                                 MaterialModel::diffuse);
    if (!seen.scene.camera)
      throw input_error(
          {.file = request.scene_file, .wanted = "a camera, which is the photograph's", .found = "none"});
    seen.centre_m = seen.scene.camera->position_m;
  }
  seen.lens = photograph_lens(request.depth, seen.photograph, request.photograph);
  const bool is_panorama = seen.photograph.projection == Projection::panorama;
  if (is_panorama && seen.lens)
    throw input_error({.field = request_name("camera"),
                       .wanted = "a perspective photograph (" + request_name("projection") + " perspective)",
                       .found = "a panorama, which has no lens"});
  if (request.view_px && !is_panorama)
    throw input_error({.field = request_name("view"),
                       .wanted = "a panorama to make a view of",
                       .found = "a perspective photograph"});
  if (is_panorama && !request.view_px) {
    refuse_view_of_whole(request);
    seen.panorama = picture;
    seen.camera = panorama_camera(picture.width_px, picture.height_px);
    return seen;
  }
  if (is_panorama) {
    seen.camera = pinhole_camera(request, seen, request.view_px->first, request.view_px->second);
    seen.panorama = std::move(picture);
    picture = view_of_panorama(seen.panorama, seen.camera, request.threads);
    return seen;
  }
  seen.camera = pinhole_camera(request, seen, picture.width_px, picture.height_px);
  if (!seen.lens) return seen;
  seen.camera = camera_of_lens(*seen.lens, seen.camera);
  if (seen.lens->world_from_camera) {
    require_one_pose(request);
    seen.centre_m = seen.lens->world_from_camera->translation();
  }
  for (const std::string& note : seen.lens->notes) notes.say(printable(request.depth.camera) + ": " + note);
  return seen;
}

}  // namespace seamline::renderer
