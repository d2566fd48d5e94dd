// A preregistration as people type it: frozen, analysed as promised, and otherwise.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "refusal.h"
#include "run_program.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

using test::expect_refused;
using test::fresh_folder;
using test::Outcome;
using test::read_text;
using test::run_seamline;
using test::write_text;
using testing::HasSubstr;
using testing::Not;

TEST(Freeze, AnAnalysisIsComparedWithWhatWasFrozen) {
  const auto folder = fresh_folder("freeze");
  (void)test::write_picture_set(folder / "set", {.width_px = 64, .height_px = 48, .widths = "64, 128, 256"});
  const std::string set = (folder / "set").string(), log = (folder / "log.sqlite").string(),
                    archive = (folder / "frozen.json").string(), study = set + "/study.toml";
  const std::string freeze = "freeze " + study + " " + set + " --participants 6 --why 'six can come'";
  const Outcome frozen = run_seamline(freeze + " --bootstrap 100 --out " + archive);
  ASSERT_EQ(frozen.status, 0) << frozen.output;
  EXPECT_THAT(frozen.output, HasSubstr("1 stimulus set, 6 participants\nSHA-256 "));
  EXPECT_THAT(read_text(archive), HasSubstr("six can come"));
  ASSERT_EQ(run_seamline("study " + set + " --observer threshold --count 6 --log " + log).status, 0);

  const std::string analyze = "analyze " + log + " --bootstrap 100 --frozen " + archive + " --out ";
  const Outcome same = run_seamline(analyze + (folder / "same").string());
  EXPECT_EQ(same.status, 0) << same.output;
  EXPECT_THAT(same.output, HasSubstr("data and analysis are those that were frozen"));
  EXPECT_EQ(read_text(folder / "same" / "deviations.csv"), "what,frozen,found\n");
  const std::string stricter = (folder / "stricter.json").string();
  ASSERT_EQ(run_seamline(freeze + " --bootstrap 100 --exclude-screened --out " + stricter).status, 0);
  const Outcome other = run_seamline("analyze " + log + " --bootstrap 100 --frozen " + stricter + " --out " +
                                     (folder / "other").string());
  EXPECT_EQ(other.status, 0) << other.output;
  EXPECT_THAT(other.output,
              HasSubstr("1 deviation from what was frozen. Confirmatory: PT, SN; all else explores.\n"
                        "  exclusion rule: whom a screen names: frozen left out, found named and used\n"));
  EXPECT_THAT(read_text(folder / "other" / "report.html"), HasSubstr("exclusion rule: whom a screen names"));
  EXPECT_THAT(read_text(folder / "other" / "report.json"), HasSubstr("\"deviations\""));

  const Outcome without =
      run_seamline("analyze " + log + " --bootstrap 100 --out " + (folder / "none").string());
  EXPECT_EQ(without.status, 0);
  EXPECT_THAT(read_text(folder / "none" / "report.html"), Not(HasSubstr("Preregistration")));
  EXPECT_FALSE(std::filesystem::exists(folder / "none" / "deviations.csv"));

  const std::string attentive = (folder / "attentive.json").string();
  expect_refused(freeze + " --exclude-inattentive --out " + attentive,
                 "wanted attention trials, for --exclude-inattentive");
  EXPECT_EQ(run_seamline(freeze + " --exclude-uncorrected --out " + attentive).status, 0);
  EXPECT_THAT(
      run_seamline("analyze " + log + " --bootstrap 100 --frozen " + attentive + " --out " +
                   (folder / "none").string())
          .output,
      HasSubstr(
          "exclusion rule: vision neither normal nor corrected: frozen left out, found named and used\n"));

  expect_refused(freeze + " --out " + archive, "wanted a file that is not there yet");
  std::string changed = read_text(archive);
  changed.replace(changed.find("six"), 3, "ten");
  write_text(archive, changed);
  expect_refused(analyze + (folder / "changed").string(), "found others: it was changed afterwards");
  EXPECT_FALSE(std::filesystem::exists(folder / "changed"));
}

TEST(Freeze, AKitHoldsAllThatALaboratoryNeedsThatRepeatsTheStudy) {
  const auto folder = fresh_folder("freeze-kit");
  (void)test::write_picture_set(folder / "set", {.width_px = 64, .height_px = 48, .widths = "64, 128, 256"});
  const std::string set = (folder / "set").string(), log = (folder / "log.sqlite").string(),
                    kit = (folder / "kit").string(), study = set + "/study.toml";
  const std::string freeze =
      "freeze " + study + " " + set + " --participants 12 --why 'as before' --bootstrap 100";
  const std::string archive = " --out " + (folder / "frozen.json").string();
  expect_refused("freeze " + study + " --participants 12 --why 'as before'" + archive + " --kit " + kit,
                 "wanted a set beside the study");
  const Outcome frozen =
      run_seamline(freeze + archive + " --published paper --published-margin 1 --kit " + kit);
  ASSERT_EQ(frozen.status, 0) << frozen.output;
  const std::string steps = read_text(folder / "kit" / "README.md");
  EXPECT_THAT(steps, HasSubstr("| people | 12 |"));
  EXPECT_THAT(steps, HasSubstr("| trials of a participant | "));
  EXPECT_THAT(steps, HasSubstr("--published published.csv --published-margin 1"));
  EXPECT_EQ(read_text(folder / "kit" / "study.toml"), read_text(study));
  EXPECT_EQ(read_text(folder / "kit" / "frozen.json"), read_text(folder / "frozen.json"));
  EXPECT_THAT(read_text(folder / "kit" / "published.csv"), HasSubstr("receiver,,PT,426"));
  expect_refused(freeze + " --kit " + kit + " --out " + (folder / "again.json").string(),
                 "wanted a folder that is not there yet");
  EXPECT_FALSE(std::filesystem::exists(folder / "again.json"));

  ASSERT_EQ(run_seamline("study " + set + " --observer threshold --count 12 --log " + log).status, 0);
  const std::string analyze = "analyze " + log + " --bootstrap 100 --frozen " + kit + "/frozen.json --out " +
                              (folder / "report").string();
  const Outcome same = run_seamline(analyze + " --published " + kit + "/published.csv --published-margin 1");
  EXPECT_THAT(same.output, HasSubstr("data and analysis are those that were frozen")) << same.output;
  for (const char* otherwise : {"", " --published paper --published-margin 0.5"})
    EXPECT_THAT(run_seamline(analyze + otherwise).output,
                HasSubstr("rule of the program: frozen laid beside published thresholds: receiver PT 426"));
}

TEST(Freeze, WhatCannotBeFrozenIsSaidInOneSentence) {
  const auto folder = fresh_folder("freeze-wrong");
  (void)test::write_picture_set(folder / "set", {.width_px = 64, .height_px = 48});
  const std::string set = (folder / "set").string(), study = set + "/study.toml",
                    out = " --out " + (folder / "frozen.json").string(),
                    quick = (test::studies() / "quick.toml").string();
  expect_refused("freeze " + quick + " " + set + out, "wanted a set of the study that is frozen");
  expect_refused("freeze " + study + " " + set + " " + set + out, "wanted each set once");
  expect_refused("freeze " + study + " --participants 5" + out, "--participants: wanted --why TEXT");
  expect_refused("freeze " + study + " --thresholds PT,P2" + out, "found P2");
  const Outcome too_fine =
      run_seamline("freeze " + quick + " --wanted-octaves 0.01 --studies 2 --estimator straight-lines" + out);
  EXPECT_EQ(too_fine.status, 1);
  EXPECT_THAT(too_fine.output, HasSubstr("or --participants N --why TEXT"));
  EXPECT_FALSE(std::filesystem::exists(folder / "frozen.json"));
  const Outcome planned =
      run_seamline("freeze " + quick + " --studies 2 --wanted-octaves 3 --lapses 0.01" + out);
  EXPECT_EQ(planned.status, 0) << planned.output;
  EXPECT_THAT(read_text(folder / "frozen.json"), HasSubstr("2 simulated studies for each set of widths"));
  EXPECT_THAT(read_text(folder / "frozen.json"), HasSubstr("In 1 % of the trials a person does not look."));
}

}  // namespace
}  // namespace seamline
