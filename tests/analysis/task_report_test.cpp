// What a report says of tasks other than the paper's.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <set>
#include <sstream>

#include "analysis/log_analysis/headline_rows.h"
#include "analysis/log_analysis/people_choices.h"
#include "analysis/log_analysis/report_numbers.h"
#include "analysis/log_analysis/task_words.h"
#include "analysis/report/figures/figures.h"
#include "analysis/report/page/methods_text.h"
#include "analysis/report/page/report_html.h"
#include "analysis/report/text/threshold_text.h"
#include "analysis/scores/level_words.h"
#include "analysis/thresholds/planted_noticeability.h"
#include "study/running/simulation.h"
#include "tests/study/temporary_set.h"

namespace seamline::analysis {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A study of a task that simulated people sat, analysed.
struct TaskStudy {
  TemporaryFolder folder;
  Analysis analysis;
};

std::unique_ptr<TaskStudy> task_study(const std::string& task, study::ObserverKind observer, int people,
                                      std::uint64_t seed = 2) {
  auto made = std::make_unique<TaskStudy>();
  (void)study::write_set_of_text(made->folder / "set",
                                 study::study_text("tiny", study::paper_widths_px) + task);
  study::run_simulated_study({.set_folder = made->folder / "set",
                              .log = made->folder / "log",
                              .observer = observer,
                              .count = people,
                              .seed = seed});
  made->analysis = analyze(study::read_log(made->folder / "log"), false, {.replicates = 40, .seed = 1});
  return made;
}

constexpr const char* pair_of_repetitions = "[task]\nkind = \"pair\"\nrepetitions = 12\n";

TEST(TaskReport, TwoPeopleWhoSeeAreNotSaidToBeAtChance) {
  const auto seeing = task_study(pair_of_repetitions, study::ObserverKind::threshold, 2);
  for (const JointVerdict verdict : seeing->analysis.joint->fit.curves)
    EXPECT_EQ(verdict, std::nullopt) << verdict_text(verdict);
  const auto guessing = task_study(pair_of_repetitions, study::ObserverKind::guesser, 2);
  for (const JointVerdict verdict : guessing->analysis.joint->fit.curves)
    EXPECT_EQ(verdict, NoThreshold::at_chance) << verdict_text(verdict);
  // A few reference trials say nothing of the chance of a forced choice.
  const auto with_references = task_study("[catch]\nreference = 1\n" + std::string(pair_of_repetitions),
                                          study::ObserverKind::threshold, 2);
  for (const JointVerdict verdict : with_references->analysis.joint->fit.curves)
    EXPECT_EQ(verdict, std::nullopt) << verdict_text(verdict);
}

TEST(TaskReport, AnIntervalThatIsOpenOnOneSideIsShownAndSaysWhatToAdd) {
  TemporaryFolder folder;
  (void)study::write_set_of_text(folder / "set", study::study_text("tiny", "64, 256, 1024"));
  study::run_simulated_study({.set_folder = folder / "set",
                              .log = folder / "log",
                              .observer = study::ObserverKind::threshold,
                              .count = 4,
                              .seed = 1});
  const Analysis analysis = analyze(study::read_log(folder / "log"), false, {.replicates = 40, .seed = 1});
  const std::string table = table_text(analysis),
                    page = report_html(analysis, report_numbers(analysis), {}, {}, {}, {});
  int open = 0;
  for (const HeadlineRow& row : headline_rows(analysis)) {
    if (row.here.level_x || !has_end(row.here.ci95)) continue;
    ++open;
    const std::string interval = interval_text(row.here.ci95, row.tested);
    EXPECT_THAT(interval, testing::AnyOf(HasSubstr(" to above 1024"), HasSubstr("below 64 to ")));
    const std::string reason = reason_text(row.here, row.tested.axis);
    EXPECT_THAT(reason, testing::EndsWith("add people, or levels there"));
    std::istringstream words(reason);  // a long one goes on below
    for (std::string word; words >> word;) EXPECT_THAT(table, HasSubstr(word));
    EXPECT_THAT(table, HasSubstr(interval));
    EXPECT_THAT(page, HasSubstr(interval + ": " + reason));
  }
  EXPECT_GT(open, 0) << "three levels and four people leave none open: take another seed";
}

TEST(TaskReport, LinesOfATableHaveAtMost160LettersAndKeepEveryWord) {
  const std::string reason = "not identified: the interval is open above, so add people, or levels there";
  const std::string interval = "1000 to above 4096";
  const std::vector<std::vector<std::string>> lines = {
      {"artifact", "", "joint model", "95 % interval (W)", "paper's way", "planted (W)"},
      {"Receiver (type IV), weiß und groß", "PT", reason, interval, reason + " (" + interval + ")", "1234"},
      {"", "SN", "2050 x 1025", interval, "2048 (1500 to 3000)", "2100"}};
  const std::string text = aligned(lines);
  std::istringstream read(text);
  int count = 0;
  for (std::string line; std::getline(read, line); ++count)
    EXPECT_LE(std::count_if(line.begin(), line.end(), [](char c) { return (c & 0xC0) != 0x80; }), 160)
        << line;
  EXPECT_GT(count, 3);
  std::multiset<std::string> wanted, found;
  for (const auto& line : lines)
    for (const std::string& cell : line) {
      std::istringstream words(cell);
      for (std::string word; words >> word;) wanted.insert(word);
    }
  std::istringstream words(text);
  for (std::string word; words >> word;) found.insert(word);
  EXPECT_EQ(found, wanted);
  EXPECT_THAT(text, HasSubstr("  " + interval + "  "));  // words break, numbers beside them do not
  // What fits stays as it is, letters counted, not bytes.
  EXPECT_EQ(aligned({{"ä", "b"}, {"cc", "d e"}}), "ä   b\ncc  d e\n");
}

TEST(TaskReport, WithoutRatingsThereIsDetectionAlone) {
  const auto study = task_study(pair_of_repetitions, study::ObserverKind::threshold, 8);
  const Analysis& analysis = study->analysis;
  const std::vector<HeadlineRow> rows = headline_rows(analysis);
  ASSERT_EQ(rows.size(), 4U);
  const ObserverDefinition observer;
  for (const HeadlineRow& row : rows) {
    EXPECT_STREQ(row.rule->name, "detection");
    ASSERT_TRUE(row.here.level_x && row.planted && row.planted->level_x);
    EXPECT_NEAR(*row.planted->level_x, x_of(analysis.data.axis, observer.midpoint.at(row.artifact)), 1e-9);
    EXPECT_NEAR(*row.here.level_x, *row.planted->level_x, 0.6);
    EXPECT_FALSE(row.paper_way);
  }
  EXPECT_TRUE(threshold_rows(analysis).empty());
  EXPECT_THAT(table_text(analysis), Not(HasSubstr("PT")));
  EXPECT_THAT(table_text(analysis), Not(HasSubstr("paper's way")));
}

TEST(TaskReport, FiguresHaveTheChanceOfTheTask) {
  const auto study = task_study(pair_of_repetitions, study::ObserverKind::threshold, 3);
  const ReportNumbers numbers = report_numbers(study->analysis);
  std::filesystem::create_directories(study->folder / "figures");
  const std::vector<Figure> figures = draw_figures(study->analysis, numbers, study->folder / "figures");
  for (const Figure& figure : figures) {
    EXPECT_THAT(figure.caption, Not(HasSubstr("oticeability"))) << figure.name;
    EXPECT_THAT(figure.caption, Not(HasSubstr("PT"))) << figure.name;
    EXPECT_THAT(figure.title, Not(HasSubstr("oticeability"))) << figure.name;
    EXPECT_NE(figure.name, "joint_scores");
  }
  const auto named = [&](const std::string& name) {
    return std::find_if(figures.begin(), figures.end(), [&](const Figure& one) { return one.name == name; });
  };
  for (const char* name : {"fig7_averages", "psychometric"}) {
    ASSERT_NE(named(name), figures.end()) << name;
    EXPECT_THAT(named(name)->caption, HasSubstr("chance, 1/2")) << name;
  }
  const std::string methods = plain_text(methods_text(study->analysis, numbers));
  EXPECT_THAT(methods, HasSubstr("two pictures side by side"));
  EXPECT_THAT(methods, HasSubstr("Each stimulus was shown 12 times"));
  EXPECT_THAT(methods, Not(HasSubstr("three objects")));
  EXPECT_THAT(methods, Not(HasSubstr("1/3")));
}

TEST(TaskReport, EveryParticipantHasAThresholdOfTheirOwn) {
  const auto one = task_study(pair_of_repetitions, study::ObserverKind::threshold, 1);
  const std::vector<OwnThreshold> own = own_thresholds(one->analysis);
  ASSERT_EQ(own.size(), 4U);
  for (const OwnThreshold& row : own) {
    EXPECT_EQ(row.answers, 12 * 3 * 7);
    EXPECT_TRUE(row.threshold) << word(row.artifact) << ": " << row.verdict.text;
  }
  EXPECT_TRUE(own_thresholds(task_study("", study::ObserverKind::threshold, 3)->analysis).empty());
}

TEST(TaskReport, ThePapersTaskIsCalledAsItWas) {
  const auto study = task_study("", study::ObserverKind::threshold, 6);
  const TaskWords words = task_words(study->analysis);
  EXPECT_TRUE(words.rated && words.of_three);
  EXPECT_EQ(words.mean, "mean noticeability");
  EXPECT_EQ(words.chance_text, "chance, 1/3");
  EXPECT_TRUE(words.procedure.empty());
  EXPECT_EQ(headline_rows(study->analysis).size(), 24U);
}

}  // namespace
}  // namespace seamline::analysis
