#include "sensors/noise/measurement.h"

#include <fmt/core.h>

#include "support/arithmetic/grid_index.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::sensors {
namespace {

void require_size(std::size_t found, std::size_t wanted, bool may_be_empty, const char* field) {
  if (found == wanted || (may_be_empty && found == 0)) return;
  throw InputError(fmt::format("seen frame: {}: wanted {} values, found {}", field, wanted, found));
}

void require_valid(const SeenFrame& seen) {
  require_valid(seen.camera, "seen frame: ");
  const std::size_t pixels =
      static_cast<std::size_t>(seen.camera.width_px) * static_cast<std::size_t>(seen.camera.height_px);
  if (seen.sub_rays_per_pixel < 0)
    throw InputError(
        fmt::format("seen frame: sub_rays_per_pixel: wanted 0 or more, found {}", seen.sub_rays_per_pixel));
  require_size(seen.radial_m.size(), pixels, false, "radial_m");
  require_size(seen.albedo.size(), pixels, true, "albedo");
  require_size(seen.cosine.size(), pixels, true, "cosine");
  require_size(seen.lit_by_projector.size(), pixels, true, "lit_by_projector");
  require_size(seen.sub_rays.size(), pixels * static_cast<std::size_t>(seen.sub_rays_per_pixel), false,
               "sub_rays");
}

std::size_t pixel_index(const PinholeCamera& camera, int column, int row) {
  return grid_index(row, column, camera.width_px);
}

void count_states(Measurement& measurement) {
  for (const PixelState state : measurement.states) ++measurement.counts[static_cast<std::size_t>(state)];
}

}  // namespace

DepthConvention convention_of(const NoiseModel& model) {
  struct Ask {
    DepthConvention operator()(const GenericNoise& generic) const { return generic.convention; }
    DepthConvention operator()(const TimeOfFlightNoise&) const { return DepthConvention::radial; }
    DepthConvention operator()(const StructuredLightNoise&) const { return DepthConvention::planar; }
  };
  return std::visit(Ask{}, model);
}

double noise_sigma_m(const NoiseModel& model, const SeenPixel& seen, double scale) {
  return std::visit([&](const auto& one) { return noise_sigma_m(one, seen, scale); }, model);
}

SeenPixel seen_pixel(const SeenFrame& seen, int column, int row) {
  const std::size_t at = pixel_index(seen.camera, column, row);
  SeenPixel pixel;
  pixel.centre.radial_m = seen.radial_m[at];
  pixel.centre.albedo = seen.albedo.empty() ? 1 : static_cast<double>(seen.albedo[at]);
  pixel.centre.cosine = seen.cosine.empty() ? 1 : static_cast<double>(seen.cosine[at]);
  pixel.lit_by_projector = seen.lit_by_projector.empty() || seen.lit_by_projector[at] != 0;
  if (std::isfinite(pixel.centre.radial_m))
    if (const auto direction = direction_through(seen.camera, {column + 0.5, row + 0.5}))
      pixel.planar_m = pixel.centre.radial_m / direction->norm();
  const std::size_t each = seen.sub_rays_per_pixel;
  pixel.sub_rays = std::span(seen.sub_rays).subspan(at * each, each);
  return pixel;
}

DepthFrame true_depth(const SeenFrame& seen, DepthConvention convention) {
  DepthFrame frame{.camera = seen.camera,
                   .convention = DepthConvention::radial,
                   .depth_m = seen.radial_m,
                   .amplitude = {},
                   .confidence = {}};
  clean_holes(frame);
  return in_convention(frame, convention);
}

Measurement measure(const SeenFrame& seen, const NoiseModel& model, const NoiseKey& key, double scale,
                    int threads) {
  require_valid(seen);
  require_within(scale, 0, 1e9, "depth noise scale");
  std::visit([](const auto& one) { require_valid(one, "noise: "); }, model);

  const std::size_t pixels = seen.radial_m.size();
  const bool has_amplitude = std::holds_alternative<TimeOfFlightNoise>(model);
  Measurement measurement;
  DepthFrame& frame = measurement.frame;
  frame.camera = seen.camera;
  frame.convention = convention_of(model);
  frame.depth_m.resize(pixels);
  if (has_amplitude) {
    frame.amplitude.resize(pixels);
    frame.confidence.resize(pixels);
  }
  measurement.states.resize(pixels);
  const auto row_of = [&](int row) {
    for (int column = 0; column < seen.camera.width_px; ++column) {
      const std::size_t at = pixel_index(seen.camera, column, row);
      const SeenPixel what = seen_pixel(seen, column, row);
      const NoiseStream stream(key, at);
      const MeasuredPixel pixel =
          std::visit([&](const auto& one) { return measure_pixel(one, what, stream, scale); }, model);
      frame.depth_m[at] = pixel.depth_m;
      if (has_amplitude) {
        frame.amplitude[at] = pixel.amplitude;
        frame.confidence[at] = pixel.confidence;
      }
      measurement.states[at] = pixel.state;
    }
  };
  run_parallel(seen.camera.height_px, threads, row_of);
  count_states(measurement);
  return measurement;
}

}  // namespace seamline::sensors
