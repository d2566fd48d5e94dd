// The whole chain as a newcomer meets it: study file -> stimuli -> sessions -> log -> thresholds -> report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The file itself, or every file in a folder and below it.
std::vector<fs::path> files_in(const fs::path& part) {
  if (!fs::is_directory(part)) return {part};
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(part))
    if (entry.is_regular_file()) files.push_back(entry.path());
  return files;
}

/// The program where a smaller quick study lies beside it, as beside one that was moved; demo_full_test.cpp
/// runs the shipped one.
fs::path program_with_a_smaller_study(const fs::path& folder) {
  fs::create_directories(folder / "stimuli");
  fs::copy_file(SEAMLINE_PROGRAM, folder / "seamline");
  test::write_cube(folder / "stimuli");
  test::write_text(folder / "stimuli" / "quick.toml",
                   test::small_study_with({{"[64, 256, 512, 1024, 2048]", "[32, 128, 512, 1024]"}}));
  return folder / "seamline";
}

TEST(Demo, WhoseOutputIsLostStillMakesEverything) {
  const fs::path folder = test::fresh_folder("demo-lost");
  const std::string program = program_with_a_smaller_study(folder / "program").string();
  for (const auto& [outputs, found] : {std::pair(">/dev/full", "No space left on device"),
                                       std::pair(">&-", "it closed"), std::pair(">&- 2>&-", "")}) {
    const fs::path out = folder / "out";
    fs::remove_all(out);
    const test::Outcome outcome =
        test::run_program("{ " + program, "demo --spp 1 --out " + out.string() + " " + outputs + "; }");
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(found));
    EXPECT_TRUE(fs::exists(out / "report" / "report.html")) << outputs;
  }
}

TEST(Demo, RunsTheWholeChainAndSaysWhereTheReportIs) {
  const fs::path folder = test::fresh_folder("demo");
  const test::Outcome outcome = test::run_program(program_with_a_smaller_study(folder / "program").string(),
                                                  "demo --spp 2 --out " + (folder / "out").string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const fs::path report = folder / "out" / "report" / "report.html";
  EXPECT_THAT(outcome.output, HasSubstr(report.string()));

  const auto thresholds =
      nlohmann::json::parse(test::read_text(folder / "out" / "report" / "thresholds.json"));
  const std::string text = thresholds.dump();
  for (const char* word : {"receiver", "shadow", "occlusion", "overlap", "perceptual_threshold_px",
                           "slightly_noticeable_px", "inflection_px", "ci95"})
    EXPECT_THAT(text, HasSubstr(word));

  const std::string html = test::read_text(report);
  EXPECT_THAT(html, HasSubstr("<svg"));
  EXPECT_THAT(html, HasSubstr("data:image/png;base64,"));
  EXPECT_THAT(html, HasSubstr("20 simulated observers"));
  // Offline: nothing is fetched from anywhere.
  EXPECT_THAT(html, testing::Not(HasSubstr("src=\"http")));
  EXPECT_THAT(html, testing::Not(HasSubstr("<link")));

  const std::string set = (folder / "out" / "set").string(), log = (folder / "out" / "log.sqlite").string();
  EXPECT_EQ(test::run_seamline("verify " + set).status, 0);
  const test::Outcome status = test::run_seamline("log status " + log);
  EXPECT_EQ(status.status, 0);
  EXPECT_THAT(status.output, HasSubstr("sim-0020"));
  // The same log again gives the same numbers.
  ASSERT_EQ(test::run_seamline("analyze " + log + " --out " + (folder / "again").string()).status, 0);
  EXPECT_EQ(test::read_text(folder / "again" / "thresholds.json"),
            test::read_text(folder / "out" / "report" / "thresholds.json"));
  // What people answered is for the owner of the study, whatever the umask.
  int files = 0;
  for (const fs::path& part : {folder / "again", folder / "out" / "report", fs::path(log)})
    for (const fs::path& file : files_in(part)) {
      EXPECT_EQ(fs::status(file).permissions(), fs::perms::owner_read | fs::perms::owner_write) << file;
      ++files;
    }
  EXPECT_GE(files, 30);
  // More observers join the same log; those who are done are left alone.
  EXPECT_EQ(test::run_seamline("study " + set + " --log " + log + " --observer threshold --count 22 --seed 1")
                .status,
            0);
  EXPECT_THAT(test::run_seamline("log status " + log).output, HasSubstr("sim-0022"));
}

}  // namespace
}  // namespace seamline
