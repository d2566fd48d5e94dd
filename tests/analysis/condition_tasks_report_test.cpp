// A log whose conditions ask different questions: each is analysed by its own chance.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "analysis/analyze_log.h"
#include "analysis/by_task/log_of_task.h"
#include "analysis/foresight/plan_study.h"
#include "analysis/log_analysis/analysis.h"
#include "analysis/report_folder.h"
#include "study/running/simulation.h"
#include "support/files/atomic_file.h"
#include "tests/complaint.h"
#include "tests/study/temporary_set.h"

namespace seamline::analysis {
namespace {

constexpr const char* asked_tables =
    "[catch]\nreference = 42\n[[condition]]\nname = \"which\"\n"
    "[[condition]]\nname = \"twice\"\n[condition.task]\nkind = \"interval\"\nrepetitions = 2\n"
    "[[condition]]\nname = \"beside\"\n[condition.task]\nkind = \"pair\"\nrepetitions = 2\n"
    "[[condition]]\nname = \"seen\"\n[condition.task]\nkind = \"yes_no\"\nrepetitions = 2\n";

class ConditionTasksReport : public testing::Test {
 protected:
  TemporaryFolder folder;
  ObserverDefinition observer;

  std::filesystem::path answered(int people) {
    const study::RenderedSet set = study::write_set_of_text(
        folder / "set", study::study_text("asked", study::paper_widths_px) + asked_tables);
    observer = set.study.observer;
    study::run_simulated_study({.set_folder = folder / "set",
                                .log = folder / "log",
                                .observer = study::ObserverKind::threshold,
                                .count = people,
                                .seed = 3});
    return folder / "log";
  }
};

TEST_F(ConditionTasksReport, PlantedDetectionIsFoundInEveryTask) {
  const std::vector<LogOfTask> parts = logs_of_tasks(study::read_log(answered(20)));
  ASSERT_EQ(parts.size(), 4U);
  EXPECT_EQ(parts[1].name, "2_interval");
  EXPECT_EQ(parts[3].conditions, std::vector<std::string>{"seen"});
  int curves = 0, held = 0;
  for (const LogOfTask& part : parts) {
    const Analysis analysis = analyze(part.log, false, {.replicates = 20, .seed = 1});
    ASSERT_TRUE(analysis.joint) << part.name;
    ASSERT_EQ(analysis.data.artifacts.size(), 4U) << part.name;
    for (int c = 0; c < 4; ++c) {
      const ArtifactScores& scores = analysis.data.artifacts[static_cast<std::size_t>(c)];
      const JointThreshold& found = threshold_of(*analysis.joint, c, JointQuantity::detection);
      const double planted = x_of(analysis.data.axis, observer.midpoint.at(scores.artifact));
      ASSERT_TRUE(found.here.level_x) << part.name;
      EXPECT_NEAR(*found.here.level_x, planted, 0.8) << part.name << ' ' << word(scores.artifact);
      ++curves;
      if (found.here.ci95.low_x <= planted && planted <= found.here.ci95.high_x) ++held;
    }
  }
  EXPECT_GE(held, curves - 4);  // 95 % each, and a study's curves share their people
}

TEST_F(ConditionTasksReport, EveryTaskHasAReportAndOnePageLeadsToThem) {
  const AnalysisSummary summary =
      analyze_log({.log = answered(6), .report_folder = folder / "report", .bootstrap_replicates = 100});
  EXPECT_EQ(summary.report_html, folder / "report" / "report.html");
  const auto json = nlohmann::json::parse(read_file(folder / "report" / "thresholds.json"));
  ASSERT_EQ(json["tasks"].size(), 4U);
  const std::string page = read_file(summary.report_html);
  for (const auto& task : json["tasks"]) {
    const std::string name = task["report"];
    EXPECT_TRUE(std::filesystem::exists(folder / "report" / name / "report.html")) << name;
    EXPECT_EQ(task["thresholds"],
              nlohmann::json::parse(read_file(folder / "report" / name / "thresholds.json")));
    EXPECT_THAT(page, testing::HasSubstr(name + "/report.html"));
  }
  EXPECT_THAT(
      test::complaint_of([&] {
        (void)analyze_log({.log = folder / "log", .report_folder = folder / "other", .published = "paper"});
      }),
      testing::HasSubstr("one question"));
}

TEST_F(ConditionTasksReport, ARenewedReportHasNothingOfTheEarlierOneAndKeepsWhatIsNotItsOwn) {
  namespace fs = std::filesystem;
  const fs::path report = folder / "report", earlier = folder / "earlier", later = folder / "later";
  for (const fs::path& made : {earlier / "figures", earlier / "asked", later}) fs::create_directories(made);
  write_file_atomically(earlier / "figures" / "old.svg", "old");
  write_file_atomically(earlier / "asked" / "report.html", "old");
  write_file_atomically(earlier / "report.html", "old");
  write_file_atomically(later / "report.html", "new");
  fs::create_directories(report);
  write_file_atomically(report / ".gitkeep", "");
  require_report_folder(report);
  renew_report(report, earlier);
  write_file_atomically(report / "figures" / "mine.svg", "mine");
  require_report_folder(report);
  renew_report(report, later);
  EXPECT_EQ(read_file(report / "report.html"), "new");
  EXPECT_EQ(read_file(report / report_list_name), "report.html\n");
  EXPECT_FALSE(fs::exists(report / "figures" / "old.svg"));
  EXPECT_FALSE(fs::exists(report / "asked"));
  EXPECT_EQ(read_file(report / "figures" / "mine.svg"), "mine");
  // A list that leads elsewhere removes nothing there.
  write_file_atomically(report / report_list_name, "report.html\n../later/report.html\n/etc/hostname\n");
  renew_report(report, earlier);
  EXPECT_TRUE(fs::exists(later / "report.html"));
  // What no analysis made is left alone.
  EXPECT_THAT(test::complaint_of([&] { (void)analyze_log({.log = folder / "log", .report_folder = later}); }),
              testing::HasSubstr("found a folder with other things in it"));
  write_file_atomically(later / "thresholds.json", "{}");
  EXPECT_THAT(test::complaint_of([&] { require_report_folder(later); }),
              testing::HasSubstr("remove it first"));
  EXPECT_EQ(read_file(later / "report.html"), "new");
}

TEST_F(ConditionTasksReport, APlanIsOfTheConditionsThatAskTheSame) {
  write_file_atomically(folder / "study.toml",
                        study::study_text("asked", study::paper_widths_px) + asked_tables);
  PlanRequest request{.study_file = folder / "study.toml", .participants = {5}, .studies = 4, .threads = 1};
  EXPECT_THAT(test::complaint_of([&] { (void)plan_study(request); }),
              testing::HasSubstr("conditions that ask the same: which (object), or twice (interval)"));
  request.wanted.conditions = {"beside"};
  const StudyPlan plan = plan_study(request);
  ASSERT_EQ(plan.curves.size(), 4U);
  EXPECT_EQ(plan.curves[0].condition, "beside");
  EXPECT_EQ(plan.targets[0].quantity.word, "detection");
}

}  // namespace
}  // namespace seamline::analysis
