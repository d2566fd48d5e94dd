#include "x3d/x3d_export.h"

#include <fmt/core.h>

#include <algorithm>

#include "composites/photo_composite.h"
#include "raytracer/common/parallel.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/picture/composite.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/request_name.h"
#include "x3d/x3d_openness.h"
#include "x3d/x3d_page.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

constexpr std::size_t most_triangles = 1'000'000;  ///< of the objects: their text takes 100 bytes each

/// What is the same for every page.
constexpr std::initializer_list<const char*> carried = {"x3dom.js", "x3dom.css", "x3dom-licence.txt",
                                                        "page.js", "page.css"};

/// Beside the page for browsers, installed or where it was built.
fs::path page_folder() {
  const fs::path folder = web_page_folder().parent_path() / "x3d";
  std::error_code error;
  for (const char* name : carried)
    if (!fs::is_regular_file(folder / name, error))
      throw input_error({.field = "seamline export x3d",
                         .wanted = "a seamline that was built with X3DOM (SEAMLINE_X3D)",
                         .found = "one without"});
  return folder;
}

fs::path free_place(const fs::path& folder) {
  const fs::path target = fs::absolute(folder).lexically_normal();
  const fs::path out = target.has_filename() ? target : target.parent_path();  // "dir/" is dir
  std::error_code error;
  const bool is_free = !fs::exists(fs::symlink_status(out, error)) ||
                       (fs::is_directory(out, error) && fs::is_empty(out, error));
  if (!is_free)
    throw input_error({.file = out.string(),
                       .wanted = "a folder that is empty or not there yet",
                       .found = "something of that name"});
  return out;
}

void require_size(const X3dSubject& subject) {
  std::size_t triangles = 0;
  for (const auto& mesh : subject.objects) triangles += mesh->triangles.size();
  if (triangles > most_triangles)
    throw input_error({.file = subject.title,
                       .wanted = fmt::format("an object of at most {} triangles", most_triangles),
                       .found = fmt::format("{}", triangles)});
}

/// The same traced: light from the local scene, which also says who is in front.
Image traced_picture(const X3dSubject& subject, const X3dRequest& request, int threads) {
  const Geometry objects(subject.objects);
  Progress progress("picture", 1.0);
  const PhotoEstimate traced = photo_by_path({.photograph = subject.photograph,
                                              .camera = subject.camera,
                                              .depth = *subject.depth,
                                              .objects = objects,
                                              .light = subject.light},
                                             std::nullopt, subject.exposure_ev,
                                             {.spp = request.spp,
                                              .seed = request.seed,
                                              .threads = threads,
                                              .progress = [&, last = 0.0](double share) mutable {
                                                progress.advance(share - last, "");
                                                last = share;
                                              }});
  return compose(traced.sums, Compositing::ratio, threads).picture;
}

ByteImage in_front_picture(const X3dFrame& frame) {
  ByteImage picture{.width_px = frame.depth.camera.width_px,
                    .height_px = frame.depth.camera.height_px,
                    .channels = 1,
                    .values = {}};
  for (const InFront one : frame.in_front)
    picture.values.push_back(one == InFront::nothing_virtual ? 0 : one == InFront::real ? 128 : 255);
  return picture;
}

std::optional<X3dUser> user_of(const X3dRequest& request, const X3dSubject& subject, const X3dFrame& frame) {
  if (request.user.empty()) return std::nullopt;
  Eigen::Isometry3d world_from_frame = world_from_photograph(subject.camera);
  world_from_frame.pretranslate(subject.camera_position_m);
  Eigen::Isometry3d x3d_from_world = Eigen::Isometry3d::Identity();
  x3d_from_world.linear() = subject.camera.axes.transpose().cast<double>();
  x3d_from_world.translation() = -(x3d_from_world.linear() * subject.camera_position_m);
  X3dUser user =
      x3d_user(sensors::read_user_file(request.user), frame.depth, world_from_frame, x3d_from_world);
  if (std::none_of(user.mask.begin(), user.mask.end(), [](std::uint8_t one) { return one != 0; }))
    throw input_error({.file = request.user,
                       .field = "joints_m",
                       .wanted = "a person whom the camera sees",
                       .found = "no pixel within reach_m of a bone"});
  return user;
}

}  // namespace

X3dSummary export_x3d(const X3dRequest& request) {
  const fs::path carried_from = page_folder(), out = free_place(request.out_folder);
  std::error_code error;
  const X3dSubject subject =
      fs::is_directory(request.source, error) ? subject_of_set(request) : subject_of_scene(request);
  require_size(subject);
  const int threads = request.threads > 0 ? request.threads : default_thread_count();
  const X3dFrame frame = frame_of(subject, threads);
  const std::optional<X3dUser> user = user_of(request, subject, frame);
  const std::optional<X3dSun> sun = x3d_sun(subject, frame, threads);
  const std::vector<std::vector<float>> openness = x3d_openness(subject, threads);
  const ByteImage photograph = display_image(subject.photograph, subject.exposure_ev);

  X3dSummary summary{.notes = subject.notes};
  for (const InFront one : frame.in_front) {
    summary.object_pixels += one != InFront::nothing_virtual ? 1 : 0;
    summary.hidden_pixels += one == InFront::real ? 1 : 0;
  }
  if (summary.object_pixels == 0)
    throw input_error({.field = fs::is_directory(request.source, error) ? request_name("stimulus")
                                                                        : request_name("position"),
                       .wanted = "an object in the picture",
                       .found = "none"});

  fs::create_directories(out.parent_path());
  const TemporaryFolder work(out);
  const fs::path folder = work / "x3d";
  fs::create_directory(folder);
  for (const char* name : carried) write_file_atomically(folder / name, read_file(carried_from / name));
  if (subject.figure) write_file_atomically(folder / "humanoid.js", read_file(carried_from / "humanoid.js"));
  write_file_atomically(folder / "index.html", x3d_page_text({.subject = subject,
                                                              .frame = frame,
                                                              .photograph = photograph,
                                                              .openness = openness,
                                                              .sun = sun ? &*sun : nullptr,
                                                              .user = user ? &*user : nullptr},
                                                             carried_from));
  write_png(folder / "program.png",
            display_image(traced_picture(subject, request, threads), subject.exposure_ev));
  write_png(folder / "in_front.png", in_front_picture(frame));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    ++summary.files;
    summary.bytes += static_cast<std::int64_t>(entry.file_size());
  }
  publish_folder(folder, out);
  return summary;
}

}  // namespace seamline::renderer
