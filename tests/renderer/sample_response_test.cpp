// Noise that more samples lower, and noise that they do not.
#include "renderer/estimators/fast/sample_response.h"

#include <gtest/gtest.h>

#include <cmath>

namespace seamline::renderer {
namespace {

/// Noise of one block with a part that stays.
double noise_of(int spp, double falls, double stays) {
  return stays + falls * std::pow(spp, -1.1);
}

TEST(SampleResponse, TellsWhatStaysFromWhatFalls) {
  SampleResponse response;
  for (const int spp : {8, 32, 128})
    response.learn({spp, spp}, {noise_of(spp, 1e-4, 1e-4), noise_of(spp, 1e-2, 0)}, {64, 64});
  ASSERT_EQ(response.stays().size(), 2U);
  EXPECT_NEAR(response.stays()[0], 1e-4, 1e-9);
  EXPECT_EQ(response.stays()[1], 0);
}

TEST(SampleResponse, SaysNothingOfFewSamplesOrSmallSteps) {
  SampleResponse response;
  for (const int spp : {2, 8, 12, 16}) response.learn({spp}, {1e-4}, {8});
  EXPECT_EQ(response.stays()[0], 0);
  SampleResponse fewer_than_the_photograph;
  for (const int spp : {8, 32}) fewer_than_the_photograph.learn({spp}, {1e-4}, {64});
  EXPECT_EQ(fewer_than_the_photograph.stays()[0], 0);
}

TEST(SampleResponse, ForgetsABlockWhoseLightIsPutTogetherAnew) {
  SampleResponse response;
  for (const int spp : {8, 32}) response.learn({spp, spp}, {1e-4, 1e-4}, {8, 8});
  EXPECT_GT(response.stays()[0], 0);
  response.forget(0);
  EXPECT_EQ(response.stays()[0], 0);
  EXPECT_GT(response.stays()[1], 0);
}

}  // namespace
}  // namespace seamline::renderer
