// Lab and web beside each other: nothing where all came by one way, no difference where there is none, and
// one where it was planted.
#include "analysis/log_analysis/origins.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "analysis/log_analysis/analysis.h"
#include "analysis/log_analysis/report_numbers.h"
#include "analysis/report/json/thresholds_json.h"
#include "analysis/report/page/sections.h"
#include "analysis/report/tables/all_tables.h"
#include "analysis/report/tables/dictionary.h"
#include "analysis/report/text/checks_text.h"
#include "online_people.h"
#include "study/running/simulation.h"

namespace seamline::analysis {
namespace {

using testing::HasSubstr;
using testing::Not;

class OriginsTest : public testing::Test {
 protected:
  static constexpr int people = 16;
  TemporaryFolder folder;
  study::LogContents log = make();

  study::LogContents make() {
    const study::RenderedSet set =
        study::write_set_of_text(folder / "set", study::online::online_study_text("64, 256, 1024, 4096"));
    (void)study::run_simulated_study(
        {.set_folder = set.folder, .log = folder / "log", .count = people, .seed = 3});
    study::LogContents read = study::read_log(folder / "log");
    for (study::ParticipantRecord& person : read.participants) {
      person.simulated = false;
      person.observer.clear();
    }
    return read;
  }
  static bool is_odd(const std::string& code) { return (code.back() - '0') % 2 == 1; }
  static study::LogContents with_web(study::LogContents log) {
    for (study::ParticipantRecord& person : log.participants)
      if (is_odd(person.code)) person.origin = study::Origin::jatos;
    return log;
  }
  /// Those of the web see nothing from 1024 px on.
  static study::LogContents with_difference(study::LogContents log) {
    log = with_web(std::move(log));
    for (study::Answer& answer : log.answers)
      if (is_odd(answer.participant) && answer.depth_width_px < 4096)
        answer.chosen_index = answer.object_index, answer.rating = 4;
    return log;
  }
  static Analysis analysis_of(study::LogContents log) {
    return analyze(std::move(log), false, {.replicates = 100, .seed = 1, .threads = 1});
  }
};

TEST_F(OriginsTest, AreNotSpokenOfWhereAllCameByOneWay) {
  const Analysis analysis = analysis_of(log);
  EXPECT_FALSE(analysis.origins);
  EXPECT_THAT(thresholds_json(analysis), Not(HasSubstr("origins")));
  EXPECT_THAT(checks_text(analysis), Not(HasSubstr("Lab and web")));
  EXPECT_EQ(origins_html(analysis), "");
  for (study::ParticipantRecord& person : log.participants) person.origin = study::Origin::serve;
  EXPECT_EQ(thresholds_json(analysis_of(log)), thresholds_json(analysis));
}

TEST_F(OriginsTest, DoNotChangeTheThresholdsOfAllTogether) {
  auto one = nlohmann::json::parse(thresholds_json(analysis_of(log)));
  auto both = nlohmann::json::parse(thresholds_json(analysis_of(with_web(log))));
  EXPECT_EQ(both.at("origins").at("lab").at("participants"), people / 2);
  EXPECT_EQ(both.at("origins").at("web").at("participants"), people / 2);
  both.erase("origins");
  EXPECT_EQ(one, both);
}

TEST_F(OriginsTest, DifferWhereADifferenceWasPlantedAndNotOtherwise) {
  const Analysis same = analysis_of(with_web(log));
  ASSERT_TRUE(same.origins);
  EXPECT_EQ(same.origins->differences.size(), 8U);  // PT and SN of four artifacts
  for (const OriginDifference& found : same.origins->differences) {
    EXPECT_GT(found.p_holm.value(), 0.05) << word(found.artifact) << found.quantity;
    EXPECT_LE(found.p.value(), found.p_holm.value());
  }
  const Analysis planted = analysis_of(with_difference(log));
  for (const OriginDifference& found : planted.origins->differences) {
    EXPECT_LT(found.p_holm.value(), 0.01) << word(found.artifact) << found.quantity;
    if (found.difference) {
      EXPECT_GT(*found.difference, 0);
    }
  }
  EXPECT_THAT(checks_text(planted), HasSubstr("Lab and web"));
  EXPECT_THAT(origins_html(planted), HasSubstr("8 participants took part in the lab and 8 in a browser"));
  // The same seed, the same numbers.
  EXPECT_EQ(thresholds_json(planted), thresholds_json(analysis_of(with_difference(log))));
}

TEST_F(OriginsTest, OnePersonOfAKindIsShownAndNotTested) {
  for (study::ParticipantRecord& person : log.participants)
    person.origin = person.code == "sim-0003" ? study::Origin::serve : study::Origin::window;
  const Analysis analysis = analysis_of(log);
  ASSERT_TRUE(analysis.origins);
  for (const OriginDifference& found : analysis.origins->differences) {
    EXPECT_FALSE(found.p);
    EXPECT_EQ(found.web, 1);
  }
}

void collect_paths(const nlohmann::json& json, const std::string& path, std::set<std::string>& paths) {
  if (json.is_object()) {
    for (const auto& [key, value] : json.items()) collect_paths(value, path + "." + key, paths);
  } else if (json.is_array()) {
    for (const auto& value : json) collect_paths(value, path + "[]", paths);
  } else {
    paths.insert(path);
  }
}

TEST_F(OriginsTest, EveryFieldAndColumnIsInTheDictionary) {
  const Analysis analysis = analysis_of(with_web(log));
  const std::vector<CsvTable> tables = all_tables(analysis, report_numbers(analysis));
  std::set<std::string> written, explained;
  collect_paths(nlohmann::json::parse(thresholds_json(analysis)).at("origins"), "origins", written);
  for (const std::vector<CsvValue>& row : report_dictionary(tables).rows)
    if (std::get<std::string>(row[0]) == "thresholds.json") explained.insert(std::get<std::string>(row[1]));
  for (const std::string& path : written) EXPECT_TRUE(explained.contains(path)) << path;
  EXPECT_GT(written.size(), 20U);
  const auto table = std::find_if(tables.begin(), tables.end(),
                                  [](const CsvTable& one) { return one.name == "lab_and_web"; });
  ASSERT_NE(table, tables.end());
  EXPECT_EQ(table->rows.size(), 8U);
  for (const std::vector<CsvValue>& row : table->rows) EXPECT_EQ(row.size(), table->columns.size());
}

}  // namespace
}  // namespace seamline::analysis
