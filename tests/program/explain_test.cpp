// `render --explain` and `--no-omit`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "run_program.h"

namespace seamline {
namespace {

using test::fresh_folder;
using test::Outcome;
using test::read_text;
using test::run_seamline;
using test::studies;
using testing::HasSubstr;
using testing::Not;

std::string quick_study() {
  return (studies() / "quick.toml").string();
}

TEST(Explain, WithoutOutPrintsThePlanAndStops) {
  const Outcome outcome = run_seamline("render " + quick_study() + " --explain --error 0.02");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* part : {"Who answers", "receiver", "path_tails", "How it is sampled", "16 a pixel first",
                           "shared_truth", "error below 0.02"})
    EXPECT_THAT(outcome.output, HasSubstr(part));
  EXPECT_THAT(outcome.output, Not(HasSubstr(" \n")));
}

TEST(Explain, WithOutAlsoPrintsWhatWasSavedAndTheManifestKeepsThePlan) {
  const auto folder = fresh_folder("explain"), set = folder / "set";
  test::write_small_study(folder, test::small_study_with({}));
  const std::string command = "render " + (folder / "study.toml").string() +
                              " --only 'bedroom-*-0064' --spp 4 --explain --out " + set.string();
  const Outcome outcome = run_seamline(command + " --no-omit bounce_filter");
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  for (const char* part : {"turned off", "rays traced, about", "tails at"})
    EXPECT_THAT(outcome.output, HasSubstr(part));
  const std::string manifest = read_text(set / "manifest.json");
  EXPECT_THAT(manifest, HasSubstr("path_tails"));
  EXPECT_THAT(manifest, Not(HasSubstr("bounce_filter")));
  // An omission is part of what a picture depends on: nothing is kept from before.
  EXPECT_THAT(run_seamline(command).output, HasSubstr(" 0 kept from before"));
}

TEST(Explain, SaysWhyTheSunsOfAFileAreLeftOut) {
  const auto folder = fresh_folder("explain-suns");
  test::write_text(folder / "study.toml",
                   test::quick_study_with({{"bounces = 4", "ambient_occlusion = true"}}));
  EXPECT_THAT(run_seamline("render " + (folder / "study.toml").string() + " --explain").output,
              HasSubstr("left out: its suns (ambient_occlusion has none)"));
}

TEST(Explain, AnUnknownOmissionListsTheNames) {
  const Outcome outcome = run_seamline("render " + quick_study() + " --explain --no-omit tails");
  EXPECT_EQ(outcome.status, 1);
  for (const char* part : {"--no-omit", "path_tails", "late_bounces", "dark_sky", "\"tails\""})
    EXPECT_THAT(outcome.output, HasSubstr(part));
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
}

}  // namespace
}  // namespace seamline
