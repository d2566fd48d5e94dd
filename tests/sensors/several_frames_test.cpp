// Several depth frames of a scene where nothing moves become one.
#include "sensors/repair/several_frames.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/arithmetic/random.h"
#include "tests/complaint.h"

namespace seamline::sensors {
namespace {

DepthFrame flat(float depth_m) {
  DepthFrame frame;
  frame.camera = pinhole_of_field_of_view(40, 30, 60);
  frame.depth_m.assign(1200, depth_m);
  return frame;
}

TEST(SeveralFrames, NoiseFallsWithTheRootOfTheirNumberAndWildValuesDoNotCount) {
  Random random(5);
  for (const int count : {4, 16, 64}) {
    std::vector<DepthFrame> frames(static_cast<std::size_t>(count), flat(2));
    for (DepthFrame& frame : frames)
      for (float& depth_m : frame.depth_m) depth_m += 0.1F * static_cast<float>(random.normal());
    for (std::size_t i = 0; i < 1200; ++i) frames[i % frames.size()].depth_m[i] = 50;  // one of each pixel
    const DepthFrame mean = mean_of_frames(frames, "test");
    double square = 0;
    for (const float depth_m : mean.depth_m) square += std::pow(static_cast<double>(depth_m) - 2, 2);
    const double sigma = std::sqrt(square / 1200);
    // The mean of the middle half of normal values has 1.09 times the deviation of the whole mean.
    EXPECT_GT(sigma, 0.9 * 0.1 / std::sqrt(count));
    EXPECT_LT(sigma, 1.45 * 0.1 / std::sqrt(count));
  }
}

TEST(SeveralFrames, OneStaysAsItIsAndTheOrderDoesNotMatter) {
  Random random(6);
  std::vector<DepthFrame> frames;
  for (int i = 0; i < 5; ++i) {
    frames.push_back(flat(1));
    for (float& depth_m : frames.back().depth_m)
      depth_m = random.uniform() < 0.3 ? hole : static_cast<float>(1 + random.uniform());
  }
  EXPECT_EQ(mean_of_frames(std::span(frames).first(1), "test").depth_m, frames[0].depth_m);
  const std::vector<float> mean = mean_of_frames(frames, "test", 1).depth_m;
  std::reverse(frames.begin(), frames.end());
  EXPECT_EQ(mean_of_frames(frames, "test", 3).depth_m, mean);
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const auto measured = std::count_if(frames.begin(), frames.end(), [&](const DepthFrame& frame) {
      return !DepthFrame::is_hole(frame.depth_m[i]);
    });
    EXPECT_EQ(DepthFrame::is_hole(mean[i]), measured < 3) << measured << " of five";
  }
}

TEST(SeveralFrames, NoneAndDifferentCamerasAreRefused) {
  using seamline::test::complaint_of;
  EXPECT_EQ(complaint_of([] { (void)mean_of_frames({}, "--depth"); }),
            "--depth: wanted at least one frame, found none");
  std::vector<DepthFrame> frames = {flat(1), flat(1)};
  frames[1].convention = DepthConvention::radial;
  EXPECT_EQ(complaint_of([&] { (void)mean_of_frames(frames, "--depth"); }),
            "--depth: wanted frames of one camera, found different ones");
}

}  // namespace
}  // namespace seamline::sensors
