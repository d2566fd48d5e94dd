// A set says which of its pictures did not reach the error that was asked for.
#include "sets/set_errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace seamline::renderer {
namespace {

SetErrors errors_of(const std::vector<std::pair<double, double>>& of_picture_and_worst_tile) {
  SetErrors errors;
  for (const auto& [reached, worst_tile] : of_picture_and_worst_tile) {
    StimulusErrorRow& row = errors.rows.emplace_back();
    row.id = "stimulus-" + std::to_string(errors.rows.size());
    row.estimated = reached;
    row.estimated_worst_tile = worst_tile;
  }
  return errors;
}

TEST(SetErrors, NothingIsSaidWhereEveryPictureReachedTheError) {
  EXPECT_TRUE(sentences_on_missed(errors_of({{0.01, 0.02}, {0.009, 0.0299}}), 0.01).empty());
  EXPECT_TRUE(sentences_on_missed({}, 0.01).empty());
}

TEST(SetErrors, PicturesAboveTheErrorAreNamedWithWhatTheyReached) {
  const std::vector<std::string> said =
      sentences_on_missed(errors_of({{0.01, 0.02}, {0.0122, 0.02}, {0.009, 0.0312}}), 0.01);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0], testing::HasSubstr("0.01 (worst tile 0.03), was not reached by 2 of 3 stimuli"));
  EXPECT_THAT(said[0], testing::HasSubstr("stimulus-2 (0.0122, worst tile 0.0200; more samples"));
  EXPECT_THAT(said[0], testing::Not(testing::HasSubstr("stimulus-1")));
}

TEST(SetErrors, AnErrorThatHangsOnAFewPixelsIsSaidToBeAGuess) {
  SetErrors errors = errors_of({{0.01, 0.02}, {0.01, 0.02}});
  EXPECT_TRUE(sentences_on_rare_light(errors).empty());
  errors.rows[0].rare_light = 0.15;
  errors.rows[1].rare_light = 0.81;
  const std::vector<std::string> said = sentences_on_rare_light(errors);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0], testing::HasSubstr("of 1 of 2 stimuli is in one pixel of 500: stimulus-2 (81 %)"));
}

TEST(SetErrors, ATrueErrorThatIsTheReferencesOwnAsksForMoreSamples) {
  SetErrors errors = errors_of({{0.01, 0.02}, {0.01, 0.02}});
  errors.rows[0].measured.emplace().rmse = 0.01;
  EXPECT_TRUE(sentences_on_noisy_references(errors).empty());
  TrueErrorRecord& noisy = errors.rows[1].measured.emplace();
  noisy.noisy_reference = true;
  noisy.reference_spp = 64;
  const std::vector<std::string> said = sentences_on_noisy_references(errors);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_THAT(said[0],
              testing::HasSubstr("of 1 of 2 measured stimuli are more the references' own: stimulus-2."));
  EXPECT_THAT(said[0], testing::EndsWith(" 256."));
}

}  // namespace
}  // namespace seamline::renderer
