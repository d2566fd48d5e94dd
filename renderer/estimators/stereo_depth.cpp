#include "renderer/estimators/stereo_depth.h"

#include "registration/stereo/semi_global.h"
#include "renderer/depth/sensor/sensor_pose.h"
#include "renderer/estimators/rig_photograph.h"

namespace seamline::renderer {
namespace {

constexpr std::uint64_t right_eyes_seed = 0x9e3779b97f4a7c15;  ///< away from the left one's

/// Whatever share of it is taken, the source is matched once.
std::string matching_text(StereoSource source, std::uint64_t seed) {
  source.share = 1;
  DepthChain chain;
  chain.sources = {source};
  chain.seed = seed;
  return canonical_text(chain);
}

}  // namespace

StereoPictures stereo_pictures(const StereoScene& scene, const StereoSource& source, std::uint64_t seed,
                               int threads) {
  const Eigen::Isometry3d left = world_from_photograph(scene.camera) * photograph_from_sensor(source.pose);
  const Eigen::Isometry3d right = left * Eigen::Translation3d(source.baseline_m, 0, 0);
  const auto picture = [&](const Eigen::Isometry3d& place, std::uint64_t eyes_seed) {
    return display_image(
        photograph_scene(scene.geometry, scene.light, source.camera, place,
                         {.spp = source.samples_per_pixel, .seed = eyes_seed, .threads = threads}),
        scene.exposure_ev);
  };
  return {.left = picture(left, seed), .right = picture(right, seed ^ right_eyes_seed)};
}

sensors::DepthFrame stereo_depth(const StereoPictures& pictures, const StereoSource& source) {
  sensors::DepthFrame frame;
  frame.camera = source.camera;
  frame.convention = sensors::DepthConvention::planar;
  frame.depth_m = registration::match_stereo(
      pictures.left, pictures.right, {.disparities_px = source.disparities_px, .block_px = source.block_px});
  for (float& value : frame.depth_m)
    value = value > 0
                ? static_cast<float>(source.camera.fx_px * source.baseline_m / static_cast<double>(value))
                : sensors::hole;
  return frame;
}

std::map<std::size_t, sensors::DepthFrame> StereoMemory::frames(const StereoScene& scene,
                                                                const DepthChain& chain, int threads) {
  std::map<std::size_t, sensors::DepthFrame> frames;
  for (std::size_t i = 0; i < chain.sources.size(); ++i) {
    const auto* source = std::get_if<StereoSource>(&chain.sources[i]);
    if (source == nullptr) continue;
    const auto [found, added] = matched_.emplace(matching_text(*source, chain.seed), sensors::DepthFrame{});
    if (added) found->second = stereo_depth(stereo_pictures(scene, *source, chain.seed, threads), *source);
    frames.emplace(i, found->second);
  }
  return frames;
}

}  // namespace seamline::renderer
