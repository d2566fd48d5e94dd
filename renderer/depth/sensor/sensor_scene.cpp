#include "renderer/depth/sensor/sensor_scene.h"

#include <algorithm>
#include <cmath>

#include "registration/mesh/register_by_mesh.h"
#include "registration/pictures/photograph.h"
#include "registration/points/register_by_points.h"
#include "renderer/depth/sensor/estimated_map.h"
#include "renderer/depth/sensor/pixel_mesh.h"
#include "renderer/depth/sensor/second_layer.h"
#include "renderer/depth/sensor/sensor_pose.h"

namespace seamline::renderer {
namespace {

using sensors::PixelState;
using sensors::SeenFrame;

/// What one source delivers.
struct Captured {
  sensors::DepthFrame frame;
  std::int64_t measured = 0, outliers = 0;
  double relative_sigma = 0;        ///< of its noise, the median over what was seen
  std::optional<Image> guide = {};  ///< of a joint bilateral repair
  std::optional<sensors::DepthError> error = {};
};

/// The model as this camera has it.
sensors::NoiseModel model_of(const PinholeSource& source) {
  sensors::NoiseModel model = source.noise->model;
  std::visit([&](auto& one) { one.range = source.range; }, model);
  if (auto* light = std::get_if<sensors::StructuredLightNoise>(&model)) light->focal_px = source.camera.fx_px;
  return model;
}

SensorSight sight_of(const PinholeSource& source, bool guided) {
  if (!source.noise) return {.surfaces = guided};
  std::optional<Eigen::Vector3d> projector_m;
  if (const auto& p = source.projector_m) projector_m = Eigen::Vector3d((*p)[0], (*p)[1], (*p)[2]);
  return sight_for(source.noise->model, projector_m);
}

double median_relative_sigma(const SeenFrame& seen, const sensors::NoiseModel& model, double scale) {
  const bool radial = sensors::convention_of(model) == sensors::DepthConvention::radial;
  std::vector<double> shares;
  for (int row = 0; row < seen.camera.height_px; ++row)
    for (int column = 0; column < seen.camera.width_px; ++column) {
      const sensors::SeenPixel pixel = sensors::seen_pixel(seen, column, row);
      const double share =
          sensors::noise_sigma_m(model, pixel, scale) / (radial ? pixel.centre.radial_m : pixel.planar_m);
      if (std::isfinite(share)) shares.push_back(share);
    }
  if (shares.empty()) return 0;
  const auto middle = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
  std::nth_element(shares.begin(), middle, shares.end());
  return *middle;
}

std::int64_t count_depths(const sensors::DepthFrame& frame) {
  return std::count_if(frame.depth_m.begin(), frame.depth_m.end(),
                       [](float depth_m) { return !sensors::DepthFrame::is_hole(depth_m); });
}

bool is_guided(const DepthChain& chain) {
  return std::holds_alternative<sensors::JointBilateralRepair>(chain.repair);
}

/// Asked for one source of a chain; `frame` tells the noises of several apart.
struct Capture {
  const Geometry& truth;
  const DepthChain& chain;
  const Eigen::Isometry3d& world_from_photograph;
  std::uint64_t frame;
  int threads;
  const std::map<std::size_t, sensors::DepthFrame>* stereo = nullptr;

  /// By what the sensor itself sees.
  [[nodiscard]] bool guided() const { return is_guided(chain) && !guided_by_photograph(chain); }

  Captured operator()(const PanoramaSource&) const { return {}; }  // made by capture_panorama

  Captured operator()(const PinholeSource& source) const {
    const SeenFrame seen =
        see_truth(truth, source.camera, world_from_photograph * photograph_from_sensor(source.pose),
                  sight_of(source, guided()), threads);
    Captured captured;
    if (guided()) captured.guide = headlight_picture(seen);
    if (!source.noise) {
      captured.frame = sensors::true_depth(seen, source.convention);
      sensors::clean_holes(captured.frame, source.range.nearest_m, source.range.farthest_m);
      captured.measured = count_depths(captured.frame);
      return captured;
    }
    const sensors::NoiseModel model = model_of(source);
    sensors::Measurement measured =
        sensors::measure(seen, model, {.seed = chain.seed, .frame = frame}, source.noise->scale, threads);
    captured.frame = std::move(measured.frame);
    captured.measured = measured.count(PixelState::measured);
    captured.outliers = measured.count(PixelState::outlier);
    captured.relative_sigma = median_relative_sigma(seen, model, source.noise->scale);
    return captured;
  }

  /// An estimate, and what it is compared with; `depth_of` the truth in the source's convention.
  template <class Source, class DepthOf>
  [[nodiscard]] Captured estimated(const Source& source, sensors::DepthConvention convention, double share,
                                   const DepthOf& depth_of) const {
    const SeenFrame seen =
        see_truth(truth, source.camera, world_from_photograph * photograph_from_sensor(source.pose),
                  {.surfaces = guided()}, threads);
    Captured captured{.frame = sensors::true_depth(seen, convention)};
    if (guided()) captured.guide = headlight_picture(seen);
    const std::vector<float> true_m = captured.frame.depth_m;
    captured.frame.depth_m = depth_of(true_m);
    sensors::mix_with_truth(true_m, share, captured.frame.depth_m);
    sensors::clean_holes(captured.frame, source.range.nearest_m, source.range.farthest_m);
    captured.measured = count_depths(captured.frame);
    captured.error = sensors::depth_error(captured.frame.depth_m, true_m);
    return captured;
  }

  Captured operator()(const StereoSource& source) const {
    return estimated(source, sensors::DepthConvention::planar, source.share,
                     [&](const std::vector<float>& /*true_m*/) { return stereo->at(frame).depth_m; });
  }

  Captured operator()(const FileSource& source) const {
    if (source.estimate)
      return estimated(
          source, source.convention, source.estimate->share, [&](const std::vector<float>& true_m) {
            return depth_of_estimate({source.path, *source.estimate, source.metres_per_step, source.packing},
                                     source.camera, source.convention, true_m);
          });
    sensors::DepthFileForm form{.camera = source.camera,
                                .convention = source.convention,
                                .metres_per_step = source.metres_per_step,
                                .packing = source.packing,
                                .nearest_m = source.range.nearest_m,
                                .farthest_m = source.range.farthest_m};
    Captured captured{.frame = sensors::read_depth_file(source.path, form).frame};
    captured.measured = count_depths(captured.frame);
    if (guided())
      captured.guide = headlight_picture(
          see_truth(truth, source.camera, world_from_photograph * photograph_from_sensor(source.pose),
                    {.surfaces = true}, threads));
    return captured;
  }
};

void count(const Captured& captured, SensorCounts& counts) {
  counts.measured += captured.measured;
  counts.outliers += captured.outliers;
  counts.holes += std::ssize(captured.frame.depth_m) - captured.measured - captured.outliers;
}

registration::MeshRegistration mesh_registration(const DepthChain& chain, int threads) {
  return {.jumps = chain.jumps,
          .jump_ratio = chain.jump_ratio,
          .border_extrusion_px = chain.border_extrusion_px,
          .threads = threads};
}

/// A frame where the chain believes it to be: at the sensor, or brought into the photograph's camera, which
/// then is where it was seen from.
struct Registered {
  PlacedFrame placed;
  Eigen::Isometry3d seen_from;  ///< truly
};

Registered register_frame(const sensors::DepthFrame& frame, const SensorPose& pose, const DepthChain& chain,
                          const Camera& photograph, int threads) {
  const Eigen::Isometry3d world = world_from_photograph(photograph);
  const Eigen::Isometry3d believed = believed_photograph_from_sensor(pose, chain);
  // Of more texels per degree than the sensor has, the photograph's grid would be a sieve.
  const sensors::PinholeCamera colour = pinhole_of(photograph, frame.camera.fx_px);
  switch (chain.registration) {
    case Registration::none:
      break;
    case Registration::points:
      return {{registration::register_by_points(frame, believed, colour, {}, threads).frame, world}, world};
    case Registration::mesh:
      return {
          {registration::register_by_mesh(frame, believed, colour, mesh_registration(chain, threads)).frame,
           world},
          world};
  }
  return {{frame, world * believed}, world * photograph_from_sensor(pose)};
}

}  // namespace

namespace {

/// What the photograph shows in the sensor's pixels, as far as the chain believes to know; nothing where the
/// repair is not guided by it.
std::optional<Image> photograph_guide(const sensors::DepthFrame& frame, const SensorPose& pose,
                                      const DepthChain& chain, const SeenPhotograph& photograph,
                                      int threads) {
  if (!guided_by_photograph(chain)) return std::nullopt;
  return registration::photograph_in_depth_pixels(*photograph.picture, frame,
                                                  believed_photograph_from_sensor(pose, chain),
                                                  pinhole_of(photograph.camera), threads);
}

/// The same in the pixels of registered depth; in the sensor's own light it is seen from the photograph.
std::optional<Image> guide_in_photograph(const Geometry& truth, const PlacedFrame& placed,
                                         const DepthChain& chain, const SeenPhotograph& photograph,
                                         int threads) {
  if (!is_guided(chain)) return std::nullopt;
  if (guided_by_photograph(chain))
    return registration::photograph_in_depth_pixels(*photograph.picture, placed.frame,
                                                    Eigen::Isometry3d::Identity(),
                                                    pinhole_of(photograph.camera), threads);
  return headlight_picture(
      see_truth(truth, placed.frame.camera, placed.world_from_frame, {.surfaces = true}, threads));
}

}  // namespace

bool is_seen_from_its_place(const DepthChain& chain) {
  if (is_panorama(chain)) return !has_boxes(chain);
  const bool in_place = chain.registration != Registration::none ||
                        (pose_of(chain.sources.front()).position_m == std::array<double, 3>{0, 0, 0} &&
                         chain.calibration_error_m == 0 && chain.delay_ms == 0);
  return chain.sources.size() == 1 && chain.jumps != Jumps::layer && in_place;
}

SensorCounts sensor_counts(const Geometry& truth, const DepthChain& chain, const Camera& photograph,
                           int threads) {
  const Eigen::Isometry3d world = world_from_photograph(photograph);
  SensorCounts counts;
  for (std::size_t i = 0; i < chain.sources.size(); ++i)
    if (!std::holds_alternative<StereoSource>(chain.sources[i]))
      count(std::visit(Capture{truth, chain, world, i, threads}, chain.sources[i]), counts);
  return counts;
}

MeasuredMesh sensor_mesh(const Geometry& truth, const DepthSettings& settings,
                         const SeenPhotograph& photograph, int threads) {
  const DepthChain& chain = *settings.chain;
  const Eigen::Isometry3d world = world_from_photograph(photograph.camera);
  MeasuredMesh made;
  for (std::size_t i = 0; i < chain.sources.size(); ++i) {
    const DepthSource& source = chain.sources[i];
    const Captured captured = std::visit(Capture{truth, chain, world, i, threads, photograph.stereo}, source);
    count(captured, made.counts);
    if (captured.error) add_depth_error(*captured.error, made.depth_error);
    const auto mended = [&](const sensors::DepthFrame& frame, const std::optional<Image>& guide) {
      sensors::Repaired repaired = sensors::repair(frame, chain.repair, guide ? &*guide : nullptr, threads);
      made.counts.invented += repaired.count(sensors::RepairMark::invented);
      return std::move(repaired.frame);
    };
    sensors::DepthFrame frame = captured.frame;
    if (!chain.repair_after)
      frame = mended(frame, captured.guide
                                ? captured.guide
                                : photograph_guide(frame, pose_of(source), chain, photograph, threads));
    auto [placed, truly] = register_frame(frame, pose_of(source), chain, photograph.camera, threads);
    if (chain.repair_after)
      placed.frame = mended(placed.frame, guide_in_photograph(truth, placed, chain, photograph, threads));
    const double tolerance = std::max(settings.mesh_tolerance, chain.noise_sigmas * captured.relative_sigma);
    const std::optional<double> cut_ratio =
        chain.jumps == Jumps::stretch ? std::nullopt : std::optional(chain.jump_ratio);
    append(made.mesh, build_pixel_mesh(pixel_grid(placed, threads), {.density = settings.mesh,
                                                                     .tolerance = tolerance,
                                                                     .cut_ratio = cut_ratio,
                                                                     .threads = threads}));
    if (chain.jumps == Jumps::layer)
      append(made.mesh, second_layer_mesh(placed, {truth, truly, chain.jump_ratio, chain.layer_px}, threads));
    made.frames.push_back(std::move(placed));
  }
  return made;
}

}  // namespace seamline::renderer
