#include "sets/photographs/study_photographs.h"

#include <fmt/core.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "raytracer/scene/eyes.h"
#include "raytracer/scene/panorama_camera.h"
#include "raytracer/scene/truth_scene.h"
#include "registration/files/camera_file.h"
#include "renderer/depth/capture.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/depth/sensor/sensor_view.h"
#include "renderer/estimators/rig_photograph.h"
#include "renderer/estimators/stereo_depth.h"
#include "stimuli/definition/stimulus.h"
#include "support/files/atomic_file.h"
#include "support/files/image.h"
#include "support/running/parallel.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/request_name.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

/// A depth camera of the study; panoramas have only a width.
struct PhotographedMesh {
  DepthSource source;
  int panorama_width_px = 0;
  std::string suffix;  ///< of names
};

/// Where and how it looks: two of one text take the same photograph.
std::string look_text(const DepthSource& source, int panorama_width_px) {
  const auto* camera = camera_of(source);
  if (camera == nullptr) return fmt::format("panorama {}", panorama_width_px);
  PinholeSource place;
  place.camera = *camera;
  place.pose = pose_of(source);
  DepthChain chain;
  chain.sources = {place};
  const auto* stereo = std::get_if<StereoSource>(&source);
  return canonical_text(chain) + (stereo != nullptr ? fmt::format(" and {}", stereo->baseline_m) : "");
}

std::vector<PhotographedMesh> depth_views(const StudyDefinition& study) {
  std::vector<PhotographedMesh> views;
  std::vector<std::string> looks;
  const std::vector<int> widths = depth_widths_px(study);
  for (const ConditionDefinition& condition : list_conditions(study)) {
    const std::vector<DepthSource> sources =
        condition.depth.chain ? condition.depth.chain->sources : std::vector<DepthSource>{PanoramaSource{}};
    for (std::size_t i = 0; i < sources.size(); ++i) {
      const int width_px = condition.depth.width_px > 0 ? condition.depth.width_px : widths.back();
      const std::string look = look_text(sources[i], width_px);
      if (std::find(looks.begin(), looks.end(), look) != looks.end()) continue;
      looks.push_back(look);
      views.push_back({.source = sources[i],
                       .panorama_width_px = width_px,
                       .suffix = (condition.name.empty() ? std::string() : "-" + condition.name) +
                                 (sources.size() > 1 ? fmt::format("-{}", i + 1) : std::string())});
    }
  }
  if (views.size() == 1) views.front().suffix.clear();
  return views;
}

/// The format that estimators of depth read and write: little-endian floats, rows from the bottom.
void write_pfm(const fs::path& path, int width_px, const std::vector<float>& values) {
  static_assert(std::endian::native == std::endian::little);
  const std::size_t width = width_px;
  const std::size_t height = values.size() / width;
  std::string bytes = fmt::format("Pf\n{} {}\n-1.0\n", width, height);
  for (std::size_t row = height; row > 0; --row)
    bytes.append(reinterpret_cast<const char*>(&values[(row - 1) * width]), width * sizeof(float));
  write_file_atomically(path, bytes);
}

/// Photographs of one scene without one object.
class Photographer {
 public:
  Photographer(const StereoScene& scene, const PhotographOptions& options, fs::path folder)
      : scene_(scene), options_(options), folder_(std::move(folder)) {}

  void take(const PhotographedMesh& view, const std::string& name) const {
    if (camera_of(view.source) == nullptr)
      take_panorama(view.panorama_width_px, name);
    else
      take_pinhole(view.source, name);
  }

 private:
  void take_panorama(int width_px, const std::string& name) const {
    write(name + ".png",
          photograph_scene(scene_.geometry, scene_.light, panorama_camera(width_px, width_px / 2), options_));
    write_pfm(folder_ / (name + "-depth.pfm"), width_px,
              capture_depth(scene_.geometry, width_px, 0, options_.threads).distance_m);
  }

  void take_pinhole(const DepthSource& source, const std::string& name) const {
    const sensors::PinholeCamera& camera = *camera_of(source);
    const Eigen::Isometry3d place =
        world_from_photograph(scene_.camera) * photograph_from_sensor(pose_of(source));
    const auto* stereo = std::get_if<StereoSource>(&source);
    if (stereo != nullptr) {
      const StereoPictures pictures = stereo_pictures(scene_, *stereo, options_.seed, options_.threads);
      write_png(folder_ / (name + ".png"), pictures.left);
      write_png(folder_ / (name + "-right.png"), pictures.right);
    } else {
      write(name + ".png", photograph_scene(scene_.geometry, scene_.light, camera, place, options_));
    }
    registration::CameraFile file;
    file.colour = camera;
    write_file_atomically(
        folder_ / (name + ".toml"),
        registration::camera_file_text(
            file, stereo == nullptr ? "the depth camera of " + name
                                    : fmt::format("the left camera of {}; the right one stands {} m to "
                                                  "its right",
                                                  name, stereo->baseline_m)));
    const auto* of_file = std::get_if<FileSource>(&source);
    const auto* pinhole = std::get_if<PinholeSource>(&source);
    const sensors::DepthFrame depth =
        sensors::true_depth(see_truth(scene_.geometry, camera, place, {}, options_.threads),
                            of_file != nullptr   ? of_file->convention
                            : pinhole != nullptr ? pinhole->convention
                                                 : sensors::DepthConvention::planar);
    write_pfm(folder_ / (name + "-depth.pfm"), camera.width_px, depth.depth_m);
  }

  void write(const std::string& name, const Image& radiance) const {
    write_png(folder_ / name, display_image(radiance, scene_.exposure_ev));
  }

  const StereoScene& scene_;
  PhotographOptions options_;
  fs::path folder_;
};

}  // namespace

int write_photographs(const StudyDefinition& study, const PhotographsRequest& request) {
  struct Wanted {
    std::size_t truth;
    int object;
    std::size_t view;
    std::string name;
  };
  const std::vector<SceneDefinition> truths = list_truths(study);
  const std::vector<PhotographedMesh> views = depth_views(study);
  std::vector<Wanted> wanted;
  for (std::size_t t = 0; t < truths.size(); ++t)
    for (int object = 1; object <= std::ssize(truths[t].objects); ++object)
      for (std::size_t v = 0; v < views.size(); ++v) {
        const std::string name = truths[t].truth + "-" + truths[t].objects[object - 1].name + views[v].suffix;
        if (matches_pattern(name, request.only)) wanted.push_back({t, object, v, name});
      }
  if (wanted.empty())
    throw input_error({.file = study.file.string(),
                       .field = request_name("only"),
                       .wanted = "a pattern that matches a photograph's name, SCENE-OBJECT",
                       .found = "\"" + request.only + "\""});
  prepare_output_folder(request.folder);
  const int threads = request.threads > 0 ? request.threads : default_thread_count();
  Progress progress("photographs of " + study.name, wanted.size());
  std::optional<TruthScene> scene;
  std::size_t loaded = truths.size();
  for (const Wanted& one : wanted) {
    if (loaded != one.truth)
      scene.emplace(load_truth_scene(truths[one.truth], study.width_px, study.height_px));
    loaded = one.truth;
    const Geometry geometry = scene->geometry_without(one.object);
    const StereoScene seen{geometry, scene->light, centre_camera(scene->camera),
                           scene->definition.exposure_ev};
    const Photographer photographer(
        seen, {.spp = request.spp.value_or(study.samples_per_pixel), .seed = study.seed, .threads = threads},
        request.folder);
    photographer.take(views[one.view], one.name);
    progress.advance(1, one.name);
  }
  return static_cast<int>(wanted.size());
}

}  // namespace seamline::renderer
