// A log of an older schema, as people meet it: read as it is, upgraded by `log upgrade`, or refused with
// one sentence. Kills and full disks are tried in tests/faults.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "study/running/simulation.h"
#include "tests/study/schema_2_log.h"
#include "tests/study/temporary_set.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::Outcome;
using test::read_text;
using test::run_seamline;
using testing::HasSubstr;

class Upgrade : public testing::Test {
 protected:
  fs::path folder = fresh_folder(std::string("upgrade-") +
                                 testing::UnitTest::GetInstance()->current_test_info()->name()),
           today = folder / "today.sqlite", old = folder / "old.sqlite", upgraded = folder / "new.sqlite";

  /// 20 people, simulated as the last program of schema 2 simulated them, at the widths that it had.
  void SetUp() override {
    (void)study::write_set_of_text(folder / "set", test::quick_study_with({{"1024, 2048]", "1024, 4096]"}}));
    (void)study::run_simulated_study({.set_folder = folder / "set", .log = today, .count = 20, .seed = 7});
    study::write_schema_2(today, old);
  }

  [[nodiscard]] std::string thresholds_of(const fs::path& log) const {
    const fs::path report = folder / "report";
    fs::remove_all(report);
    const Outcome analysed = run_seamline("analyze " + log.string() + " --out " + report.string());
    EXPECT_EQ(analysed.status, 0) << analysed.output;
    return read_text(report / "thresholds.json");
  }

  [[nodiscard]] std::vector<fs::path> files() const {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(folder)) found.push_back(entry.path());
    std::sort(found.begin(), found.end());
    return found;
  }

  /// Status 1, one sentence, the old log as it was, and nothing new.
  void expect_refused(const fs::path& from, const std::string& options, const std::string& part) const {
    const std::string before = fs::is_regular_file(from) ? read_text(from) : "";
    const std::vector<fs::path> files_before = files();
    const Outcome outcome = run_seamline("log upgrade " + from.string() + " " + options);
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(part));
    EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
    if (fs::is_regular_file(from)) {
      EXPECT_EQ(read_text(from), before);
    }
    EXPECT_EQ(files(), files_before) << outcome.output;
  }
};

TEST_F(Upgrade, ThresholdsAreThoseOfTheProgramThatWroteTheLog) {
  const std::string thresholds = thresholds_of(old);
  EXPECT_EQ(thresholds, thresholds_of(today));
  const Outcome upgrade = run_seamline("log upgrade " + old.string() + " " + upgraded.string());
  ASSERT_EQ(upgrade.status, 0) << upgrade.output;
  EXPECT_EQ(thresholds, thresholds_of(upgraded));

  // What the last program of schema 2 printed, to the last digit; an estimate (805.121 of the first) stands
  // no more beside an interval that is open.
  const nlohmann::json receiver = nlohmann::json::parse(thresholds).at("artifacts").at(0);
  const auto expect = [&](const char* name, const nlohmann::json& estimate, double low,
                          const nlohmann::json& high) {
    EXPECT_EQ(receiver.at(name).at("estimate"), estimate);
    EXPECT_EQ(receiver.at(name).at("ci95"), nlohmann::json::array({low, high})) << name;
  };
  expect("perceptual_threshold_px", nullptr, 528.304, nullptr);
  expect("slightly_noticeable_px", 456.761, 391.981, 653.782);
  expect("inflection_px", 256.644, 185.54, 324.901);
}

TEST_F(Upgrade, RefusesInOneSentenceAndTouchesNothing) {
  const std::string into = upgraded.string();
  expect_refused(old, today.string(), "does not exist yet");
  expect_refused(old, old.string(), "does not exist yet");
  expect_refused(old, folder.string(), "does not exist yet");
  expect_refused(old, (folder / "none" / "new.sqlite").string(), "a folder that can be written");
  expect_refused(folder / "none.sqlite", into, "no such file");
  expect_refused(folder, into, "not a file");
  expect_refused(today, into, "needs no upgrade");
  if (::geteuid() != 0) {
    fs::create_directory(folder / "locked");
    fs::permissions(folder / "locked", fs::perms::owner_read | fs::perms::owner_exec);
    expect_refused(old, (folder / "locked" / "new.sqlite").string(), "can be written");
  }
  const std::string whole = read_text(old);
  for (const std::size_t kept : {std::size_t{0}, std::size_t{60}, whole.size() / 2}) {
    test::write_text(old, whole.substr(0, kept));
    expect_refused(old, into, "log");
  }
  for (std::size_t page = 0; page < whole.size() / 4096; page += 7) {
    std::string damaged = whole;
    damaged.replace(page * 4096, 4096, 4096, '\0');
    test::write_text(old, damaged);
    expect_refused(old, into, "log recover");
  }
}

TEST_F(Upgrade, TheFormerSpellingMakesOneThingAtATime) {
  for (const std::string other : {"--status", "--tracks", "--exclude sim-0001", "--forget sim-0001"})
    for (const std::string makes : {"--upgrade ", "--recover "}) {
      const Outcome both =
          run_seamline("log " + old.string() + " " + other + " " + makes + upgraded.string());
      EXPECT_EQ(both.status, 1);
      EXPECT_THAT(both.output, HasSubstr("at a time"));
      EXPECT_FALSE(fs::exists(upgraded));
    }
  const Outcome former = run_seamline("log " + old.string() + " --upgrade " + upgraded.string());
  EXPECT_EQ(former.status, 0) << former.output;
  EXPECT_THAT(former.output, HasSubstr("this is now seamline log upgrade " + old.string()));
  EXPECT_TRUE(fs::exists(upgraded));
}

}  // namespace
}  // namespace seamline
