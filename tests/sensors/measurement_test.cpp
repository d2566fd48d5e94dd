// Whole frames: no noise is no change, the same bytes in any order, nothing known of neighbours, nothing
// stiff becomes a number that is no depth.
#include "sensors/noise/measurement.h"

#include <cstring>
#include <functional>
#include <numeric>

#include "tests/complaint.h"
#include "tests/sensors/noise_samples.h"

namespace seamline::sensors {
namespace {

using namespace testing;

SeenFrame some_scene(int width_px, int height_px) {
  SeenFrame seen;
  seen.camera = pinhole_of_field_of_view(width_px, height_px, 60);
  seen.camera.distortion.k1 = -0.05;
  Random random(9);
  seen.sub_rays_per_pixel = 4;
  for (int i = 0; i < width_px * height_px; ++i) {
    const double distance_m = 0.5 + 5 * random.uniform();
    seen.radial_m.push_back(i % 11 == 0 ? hole : static_cast<float>(distance_m));
    seen.albedo.push_back(static_cast<float>(random.uniform()));
    seen.cosine.push_back(static_cast<float>(random.uniform()));
    seen.lit_by_projector.push_back(i % 13 != 0);
    for (int k = 0; k < 4; ++k)
      seen.sub_rays.push_back({.radial_m = distance_m + 0.1 * k, .albedo = 0.5, .cosine = 0.5});
  }
  return seen;
}

std::vector<NoiseModel> every_model() {
  GenericNoise generic;
  generic.relative_sigma = 0.02;
  generic.step_m = 0.001;
  generic.dropout_share = 0.05;
  generic.outliers.share = 0.01;
  TimeOfFlightNoise flight;
  flight.outliers.share = 0.01;
  flight.weakest_amplitude_e = 400;
  StructuredLightNoise light;
  light.grazing_sigma_m = 0.0001;
  light.sure_signal = 0.02;
  light.outliers.share = 0.01;
  return {generic, flight, light};
}

bool same_bytes(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

// Whoever compares noise with none compares one camera with itself: what it cannot see stays a hole.
TEST(Measurement, ScaleZeroIsTheLimitOfSmallScales) {
  const SeenFrame seen = some_scene(40, 30);
  for (const NoiseModel& model : every_model()) {
    const Measurement none = measure(seen, model, {1, 2}, 0), little = measure(seen, model, {1, 2}, 1e-9);
    EXPECT_EQ(none.frame.convention, convention_of(model));
    EXPECT_EQ(none.states, little.states);
    EXPECT_EQ(none.counts, little.counts);
    EXPECT_EQ(none.count(PixelState::outlier) + none.count(PixelState::dropped), 0);
    for (std::size_t i = 0; i < none.states.size(); ++i)
      if (none.states[i] == PixelState::measured) {
        EXPECT_NEAR(none.frame.depth_m[i], little.frame.depth_m[i], 1e-6F * none.frame.depth_m[i]);
      }
  }
  EXPECT_GT(measure(seen, every_model()[1], {1, 2}, 0).count(PixelState::too_weak), 0);
  EXPECT_GT(measure(seen, every_model()[2], {1, 2}, 0).count(PixelState::shadowed), 0);
}

TEST(Measurement, WithoutNoiseWhatTheInstrumentSeesIsTheTruth) {
  SeenFrame seen = some_scene(40, 30);
  seen.sub_rays_per_pixel = 0;  // nothing mixes
  seen.sub_rays.clear();
  for (const NoiseModel& model : every_model()) {
    const DepthFrame truth = true_depth(seen, convention_of(model));
    const Measurement found = measure(seen, model, {1, 2}, 0);
    for (std::size_t i = 0; i < truth.depth_m.size(); ++i)
      if (found.states[i] == PixelState::measured) {
        EXPECT_FLOAT_EQ(found.frame.depth_m[i], truth.depth_m[i]);
      }
  }
}

TEST(Measurement, AModelWithoutErrorsChangesNothing) {
  const SeenFrame seen = some_scene(40, 30);
  const Measurement found = measure(seen, GenericNoise{}, {1, 2});
  EXPECT_TRUE(same_bytes(found.frame.depth_m, true_depth(seen, DepthConvention::planar).depth_m));
}

TEST(Measurement, TheNoiseDwindlesWithItsScale) {
  SeenFrame seen = some_scene(40, 30);
  seen.sub_rays_per_pixel = 0;
  seen.sub_rays.clear();
  for (const NoiseModel& model : every_model()) {
    const DepthFrame truth = true_depth(seen, convention_of(model));
    const Measurement found = measure(seen, model, {1, 2}, 1e-9);
    for (std::size_t i = 0; i < truth.depth_m.size(); ++i)
      if (found.states[i] == PixelState::measured) {
        EXPECT_NEAR(found.frame.depth_m[i], truth.depth_m[i], 1e-6F * truth.depth_m[i]);
      }
  }
}

TEST(Measurement, TheSameBytesForAnyNumberOfThreadsAndAnyOrder) {
  const SeenFrame seen = some_scene(64, 48);
  for (const NoiseModel& model : every_model()) {
    const Measurement one = measure(seen, model, {7, 8}, 1.5, 1);
    for (const int threads : {2, 5}) {
      const Measurement many = measure(seen, model, {7, 8}, 1.5, threads);
      EXPECT_TRUE(same_bytes(one.frame.depth_m, many.frame.depth_m));
      EXPECT_TRUE(same_bytes(one.frame.amplitude, many.frame.amplitude));
      EXPECT_TRUE(same_bytes(one.frame.confidence, many.frame.confidence));
      EXPECT_EQ(one.states, many.states);
    }
    for (int row = 47; row >= 0; --row)  // backwards, pixel by pixel
      for (int column = 63; column >= 0; --column) {
        const std::size_t at = one.frame.index(column, row);
        const MeasuredPixel pixel = std::visit(
            [&](const auto& m) {
              return measure_pixel(m, seen_pixel(seen, column, row), NoiseStream({7, 8}, at), 1.5);
            },
            model);
        ASSERT_EQ(pixel.depth_m, one.frame.depth_m[at]);
        ASSERT_EQ(pixel.state, one.states[at]);
      }
  }
}

TEST(Measurement, CountsEveryPixelOnceAndOnlyMeasuredOnesHaveDepth) {
  const SeenFrame seen = some_scene(64, 48);
  for (const NoiseModel& model : every_model()) {
    const Measurement found = measure(seen, model, {1, 1}, 3);
    EXPECT_EQ(std::accumulate(found.counts.begin(), found.counts.end(), std::int64_t{0}), 64 * 48);
    for (std::size_t i = 0; i < found.states.size(); ++i) {
      const bool has = found.states[i] == PixelState::measured || found.states[i] == PixelState::outlier;
      EXPECT_NE(DepthFrame::is_hole(found.frame.depth_m[i]), has);
    }
  }
  EXPECT_GT(measure(seen, every_model()[2], {1, 1}).count(PixelState::shadowed), 0);
  EXPECT_EQ(measure(seen, every_model()[1], {1, 1}).count(PixelState::shadowed), 0);
}

TEST(Measurement, PixelsFramesAndSeedsKnowNothingOfEachOther) {
  GenericNoise model;
  model.relative_sigma = 0.01;
  const auto errors = [&](const NoiseKey& key) {
    return depths_of(measure_many(model, head_on(1), 1, million, key));
  };
  const std::vector<double> first = errors({1, 1});
  const double bound = 4.0 / 1000;
  EXPECT_LT(std::abs(correlation(first, errors({1, 2}))), bound);
  EXPECT_LT(std::abs(correlation(first, errors({2, 1}))), bound);
  EXPECT_LT(std::abs(correlation(first, errors({0, 0}))), bound);
  for (const std::size_t lag : {std::size_t{1}, std::size_t{2}, std::size_t{640}}) {
    const auto end = first.end() - static_cast<std::ptrdiff_t>(lag);
    const std::vector<double> a(first.begin(), end),
        b(first.begin() + static_cast<std::ptrdiff_t>(lag), first.end());
    EXPECT_LT(std::abs(correlation(a, b)), bound) << lag;
  }
}

/// How far two numbers of streams, looked at for a million pixels, are from independent and uniform.
double dependence(const std::function<double(std::uint64_t)>& a,
                  const std::function<double(std::uint64_t)>& b) {
  constexpr std::size_t side = 16;
  std::vector<double> found(side * side), expected(side * side, double{million} / (side * side));
  for (std::uint64_t pixel = 0; pixel < million; ++pixel)
    found[static_cast<std::size_t>(a(pixel) * side) * side + static_cast<std::size_t>(b(pixel) * side)] += 1;
  return chi_squared_ratio(found, expected);
}

TEST(Measurement, NumbersOfStreamsAreUniformAndIndependentOfEachOther) {
  const auto number = [](NoiseKey key, std::uint64_t step, std::uint64_t k) {
    return [=](std::uint64_t pixel) { return NoiseStream(key, pixel + step).uniform(k); };
  };
  for (std::uint64_t k = 0; k < 3; ++k)
    for (std::uint64_t other = 0; other < 3; ++other) {
      if (k != other) {
        EXPECT_LT(dependence(number({3, 4}, 0, k), number({3, 4}, 0, other)), 1);
      }
      EXPECT_LT(dependence(number({3, 4}, 0, k), number({3, 4}, 1, other)), 1);  // the next pixel
      EXPECT_LT(dependence(number({3, 4}, 0, k), number({3, 5}, 0, other)), 1);  // the next frame
      EXPECT_LT(dependence(number({3, 4}, 1, k), number({3, 5}, 0, other)), 1);  // one right, one later
      EXPECT_LT(dependence(number({3, 4}, 0, k), number({4, 3}, 0, other)), 1);  // seed and frame exchanged
    }
}

TEST(Measurement, NothingStiffBecomesANumberThatIsNoDepth) {
  const float values[] = {
      0, 1e-30F, 0.01F, 1, 1e4F, 3e38F, hole, -1, std::numeric_limits<float>::quiet_NaN()};
  SeenFrame seen;
  seen.camera = pinhole_of_field_of_view(36, 36, 120);
  seen.camera.width_px = 9 * 4;
  for (int i = 0; i < 36 * 36; ++i) {
    seen.radial_m.push_back(values[i % 9]);
    seen.albedo.push_back(std::array{0.0F, 1e-30F, 0.5F, 1.0F}[static_cast<std::size_t>(i / 9 % 4)]);
    seen.cosine.push_back(std::array{0.0F, 1e-30F, 1e-3F, 1.0F}[static_cast<std::size_t>(i / 36 % 4)]);
    seen.lit_by_projector.push_back(1);
  }
  for (NoiseModel model : every_model()) {
    if (auto* flight = std::get_if<TimeOfFlightNoise>(&model)) flight->weakest_amplitude_e = 0;
    for (const double scale : {0.0, 1e-12, 1.0, 1e3, 1e9})
      for (const bool wraps : {false, true}) {
        if (auto* flight = std::get_if<TimeOfFlightNoise>(&model)) flight->wraps = wraps;
        const Measurement found = measure(seen, model, {1, 1}, scale);
        std::int64_t holes = 0;
        for (std::size_t i = 0; i < found.states.size(); ++i) {
          const float depth_m = found.frame.depth_m[i];
          ASSERT_TRUE(depth_m > 0) << depth_m;  // false of NaN
          holes += DepthFrame::is_hole(depth_m) ? 1 : 0;
          if (!found.frame.amplitude.empty()) {
            ASSERT_TRUE(found.frame.amplitude[i] >= 0);
            ASSERT_TRUE(found.frame.confidence[i] >= 0 && found.frame.confidence[i] <= 1);
          }
        }
        EXPECT_EQ(holes, 1296 - found.count(PixelState::measured) - found.count(PixelState::outlier));
        EXPECT_GE(holes, 432);  // hole, -1 and NaN at least
      }
  }
}

TEST(Measurement, HugeNoiseGivesHolesThatAreCounted) {
  GenericNoise model;
  model.relative_sigma = 1e6;
  const auto pixels = measure_many(model, head_on(2), 1, 100000);
  EXPECT_NEAR(share_of(pixels, PixelState::out_of_range), 0.5, four_sigma_of_share(0.5, 100000));
}

TEST(Measurement, ImpossibleModelsAndFramesAreRefused) {
  const auto sentence = [](const SeenFrame& seen, const NoiseModel& model, double scale) {
    return test::complaint_of([&] { (void)measure(seen, model, {1, 1}, scale); });
  };
  SeenFrame seen = some_scene(4, 3);
  EXPECT_EQ(sentence(seen, GenericNoise{}, -1),
            "depth noise scale: wanted a number from 0 to 1e+09, found -1");
  EXPECT_EQ(sentence(seen, TimeOfFlightNoise{.modulation_hz = 0}, 1),
            "noise: modulation_hz: wanted a number from 1000 to 1e+12, found 0");
  EXPECT_EQ(sentence(seen, StructuredLightNoise{.baseline_m = std::nan("")}, 1),
            "noise: baseline_m: wanted a number from 1e-06 to 1e+06, found nan");
  EXPECT_EQ(sentence(seen, GenericNoise{.dropout_share = 1.5}, 1),
            "noise: dropout_share: wanted a number from 0 to 1, found 1.5");
  seen.albedo.pop_back();
  EXPECT_EQ(sentence(seen, GenericNoise{}, 1), "seen frame: albedo: wanted 12 values, found 11");
}

}  // namespace
}  // namespace seamline::sensors
