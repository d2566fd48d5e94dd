#include <array>
#include <cmath>
#include <span>

#include "laboratory/convergence/estimates/estimates.h"
#include "sensors/noise/measurement.h"
#include "sensors/repair/repair.h"
#include "sensors/repair/several_frames.h"
#include "support/running/progress.h"

namespace seamline::renderer {
namespace {

constexpr int depth_width_px = 160, depth_height_px = 120;

/// A wall 2 m away whose left half comes nearer towards the edge, seen head on by light of its own.
sensors::SeenFrame two_walls() {
  sensors::SeenFrame seen{.camera = sensors::pinhole_of_field_of_view(depth_width_px, depth_height_px, 60),
                          .radial_m = {},
                          .albedo = {},
                          .cosine = {},
                          .lit_by_projector = {},
                          .sub_rays_per_pixel = 0,
                          .sub_rays = {}};
  for (int row = 0; row < depth_height_px; ++row)
    for (int column = 0; column < depth_width_px; ++column) {
      const double x = (column + 0.5 - seen.camera.cx_px) / seen.camera.fx_px;
      const double y = (row + 0.5 - seen.camera.cy_px) / seen.camera.fy_px;
      const double planar_m = x < 0 ? 2 / (1 - 0.5 * x) : 2;
      seen.radial_m.push_back(static_cast<float>(planar_m * std::sqrt(1 + x * x + y * y)));
    }
  return seen;
}

/// Over the pixels that have a depth.
double depth_rms_m(const sensors::DepthFrame& frame, const sensors::DepthFrame& truth) {
  double sum = 0, pixels = 0;
  for (std::size_t i = 0; i < frame.depth_m.size(); ++i) {
    if (sensors::DepthFrame::is_hole(frame.depth_m[i])) continue;
    const double error_m = static_cast<double>(frame.depth_m[i]) - static_cast<double>(truth.depth_m[i]);
    sum += error_m * error_m;
    ++pixels;
  }
  return pixels > 0 ? std::sqrt(sum / pixels) : 0;
}

/// Seconds for reading and writing a frame once: the fastest of many.
double copy_seconds(const sensors::DepthFrame& frame) {
  constexpr int copies = 2000;
  std::vector<float> to(frame.depth_m.size());
  const double before = processor_seconds();
  float kept = 0;
  for (int i = 0; i < copies; ++i) {
    std::copy(frame.depth_m.begin(), frame.depth_m.end(), to.begin());
    kept += to[i];
  }
  return (processor_seconds() - before + (std::isnan(kept) ? 1 : 0)) / copies;
}

struct NamedNoise {
  const char* name;
  sensors::NoiseModel model;
};

}  // namespace

EstimateResult measure_sensor(std::uint64_t seed) {
  const std::array<NamedNoise, 3> models = {
      NamedNoise{"one per cent, no steps", sensors::GenericNoise{.relative_sigma = 0.01}},
      NamedNoise{"time of flight", sensors::TimeOfFlightNoise{}},
      NamedNoise{"structured light, in steps", sensors::StructuredLightNoise{}}};
  const sensors::SeenFrame seen = two_walls();
  EstimateResult result{
      .part = "sensor",
      .amount = "frames",
      .unit = "m",
      .truth = "the distances that the frames were made of",
      .rows = {},
      .limit = {.what = "one pass over memory", .seconds_each = 0},
      .expected = -0.5,
      .why = "frames of independent noise; steps wider than the noise leave an error that no mean takes off"};
  Progress progress("sensor", models.size());
  for (const auto& [name, model] : models) {
    const sensors::DepthFrame truth = sensors::true_depth(seen, sensors::convention_of(model));
    result.limit.seconds_each = copy_seconds(truth);
    for (int frames = 1; frames <= 256; frames *= 4) {
      const double before = processor_seconds();
      std::vector<sensors::DepthFrame> taken;
      for (int frame = 0; frame < frames; ++frame)
        taken.push_back(
            sensors::measure(seen, model, {.seed = seed, .frame = static_cast<std::uint64_t>(frame)}, 1, 1)
                .frame);
      const sensors::DepthFrame mean = sensors::mean_of_frames(taken, "sensor", 1);
      result.rows.push_back(
          {name, static_cast<double>(frames), processor_seconds() - before, depth_rms_m(mean, truth)});
    }
    progress.advance(1, name);
  }
  return result;
}

EstimateResult measure_repair(std::uint64_t seed) {
  const sensors::SeenFrame seen = two_walls();
  const sensors::NoiseModel noise = sensors::GenericNoise{.relative_sigma = 0.01, .dropout_share = 0.05};
  const sensors::DepthFrame truth = sensors::true_depth(seen, sensors::convention_of(noise));
  const sensors::DepthFrame measured = sensors::measure(seen, noise, {.seed = seed, .frame = 0}, 1, 1).frame;
  Image photograph(depth_width_px, depth_height_px, 3);
  for (std::size_t i = 0; i < truth.depth_m.size(); ++i)
    for (std::size_t c = 0; c < 3; ++c)
      photograph.values[3 * i + c] = i % depth_width_px < depth_width_px / 2 ? 0.2F : 0.8F;
  EstimateResult result{.part = "repair",
                        .amount = "radius_or_draws",
                        .unit = "m",
                        .truth =
                            "the distances of two walls, of which the frame was made with one per cent of "
                            "noise and a twentieth of holes",
                        .rows = {},
                        .limit = {.what = "one pass over memory", .seconds_each = copy_seconds(truth)},
                        .expected = -1,
                        .why =
                            "a window of radius r has r^2 independent values, until it is wider than "
                            "what is flat"};
  const auto add = [&](const std::string& name, double amount, const sensors::RepairMethod& method) {
    constexpr int repeats = 3;
    const double before = processor_seconds();
    sensors::Repaired repaired;
    for (int i = 0; i < repeats; ++i) repaired = sensors::repair(measured, method, &photograph, 1);
    result.rows.push_back(
        {name, amount, (processor_seconds() - before) / repeats, depth_rms_m(repaired.frame, truth)});
  };
  add("none", 1, sensors::NoRepair{});
  add("nearest, holes filled", 1, sensors::NearestRepair{});
  for (const int radius : {1, 2, 4, 8, 16})
    add("median", radius, sensors::MedianRepair{.radius_px = radius, .fills = true});
  for (const int radius : {1, 2, 4, 8, 16})
    add("joint bilateral", radius,
        sensors::JointBilateralRepair{.radius_px = radius, .sigma_px = radius / 2.0});
  for (const int draws : {3, 10, 30, 100, 300})
    add("planes", draws, sensors::PlaneRepair{.tolerance_m = 0.06, .draws = draws, .seed = seed});
  return result;
}

}  // namespace seamline::renderer
