// Where a slider stood, as the log holds it and every layout of tables says it.
#include "study/exchange/slider_records.h"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <tuple>

#include "study/exchange/answer_tables.h"
#include "study/exchange/dataset.h"
#include "study/running/simulation.h"
#include "temporary_set.h"

namespace seamline::study {
namespace {

constexpr const char* a_line = "[task]\nkind = \"rating\"\nscale = \"slider\"\n[catch]\nreference = 8\n";
constexpr const char* a_line_and_a_word =
    "[catch]\nreference = 8\n[[condition]]\nname = \"line\"\n[condition.task]\nkind = \"rating\"\n"
    "scale = \"slider\"\n[[condition]]\nname = \"word\"\n[condition.task]\nkind = \"yes_no\"\n";

class SliderRecords : public testing::Test {
 protected:
  TemporaryFolder folder;

  LogContents simulated(const std::string& tables) const {
    (void)write_set_of_text(folder / "set", study_text("tiny", "64, 512") + tables);
    run_simulated_study({.set_folder = folder / "set",
                         .log = folder / "log.sqlite",
                         .observer = ObserverKind::threshold,
                         .count = 3,
                         .seed = 4});
    return read_log(folder / "log.sqlite");
  }
  /// "CODE INDEX" and the place, by SQL alone.
  [[nodiscard]] std::map<std::string, std::int64_t> places_by_sql() const {
    SQLite::Database database((folder / "log.sqlite").string());
    SQLite::Statement row(
        database,
        "SELECT code || ' ' || trial_index, CAST(detail AS INTEGER) FROM events JOIN "
        "sessions USING (session) JOIN participants USING (participant) WHERE kind = 'slid'");
    std::map<std::string, std::int64_t> places;
    while (row.executeStep()) places[row.getColumn(0).getString()] = row.getColumn(1).getInt64();
    return places;
  }
};

const CsvValue& cell(const CsvTable& table, std::size_t row, const std::string& name) {
  const auto column = std::find_if(table.columns.begin(), table.columns.end(),
                                   [&](const CsvColumn& one) { return one.name == name; });
  return table.rows.at(row).at(static_cast<std::size_t>(column - table.columns.begin()));
}

std::int64_t number_in(const CsvTable& table, std::size_t row, const std::string& name) {
  return std::get<std::int64_t>(cell(table, row, name));
}

/// What an anonymised log may say of answers to stimuli, in no order.
std::multiset<std::tuple<std::string, std::int64_t, std::int64_t>> what_was_answered(
    const CsvTable& answers) {
  std::multiset<std::tuple<std::string, std::int64_t, std::int64_t>> rows;
  for (std::size_t row = 0; row < answers.rows.size(); ++row)
    rows.emplace(std::get<std::string>(cell(answers, row, "stimulus_id")), number_in(answers, row, "rating"),
                 number_in(answers, row, "position"));
  return rows;
}

/// The column of places in the BIDS files of all people, by the line's first cell.
std::multiset<std::string> places_in_bids(const std::vector<DatasetFile>& files) {
  std::multiset<std::string> places;
  for (const DatasetFile& file : files) {
    if (!file.path.ends_with("_beh.tsv")) continue;
    std::istringstream lines(file.text);
    std::string line;
    std::getline(lines, line);
    EXPECT_TRUE(line.ends_with("\tposition")) << line;
    while (std::getline(lines, line)) places.insert(line.substr(line.rfind('\t') + 1));
  }
  return places;
}

TEST_F(SliderRecords, TablesOfAnswersAndCatchAnswersSayWhereItStood) {
  const LogContents log = simulated(a_line);
  const std::map<std::string, std::int64_t> wanted = places_by_sql();
  EXPECT_EQ(wanted.size(), 3U * (24 + 8));
  const std::vector<CsvTable> tables = answer_tables(log);
  std::size_t compared = 0;
  for (const std::size_t which : {std::size_t{0}, std::size_t{1}})
    for (std::size_t row = 0; row < tables[which].rows.size(); ++row, ++compared)
      EXPECT_EQ(number_in(tables[which], row, "position"),
                wanted.at(fmt::format("{} {}", std::get<std::string>(cell(tables[which], row, "participant")),
                                      number_in(tables[which], row, "trial_index"))));
  EXPECT_EQ(compared, wanted.size());
}

TEST_F(SliderRecords, BidsHasThePlacesOfStimuliAndReferences) {
  const LogContents log = simulated(a_line);
  std::multiset<std::string> wanted;
  for (const auto& [trial, place] : places_by_sql()) wanted.insert(std::to_string(place));
  EXPECT_EQ(places_in_bids(bids_files(log, {})), wanted);
  const AnonymisedLog anonymous = anonymise(log, 3);
  EXPECT_EQ(places_in_bids(bids_files(anonymous.log, anonymous.anonymity)), wanted);
}

TEST_F(SliderRecords, AnonymisedTablesKeepEachPlaceBesideItsRating) {
  const LogContents log = simulated(a_line);
  const AnonymisedLog anonymous = anonymise(log, 3);
  const std::vector<CsvTable> before = answer_tables(log),
                              after = answer_tables(anonymous.log, anonymous.anonymity);
  EXPECT_EQ(what_was_answered(after[0]), what_was_answered(before[0]));
  std::multiset<std::int64_t> wanted, found;
  for (std::size_t row = 0; row < before[1].rows.size(); ++row) {
    wanted.insert(number_in(before[1], row, "position"));
    found.insert(number_in(after[1], row, "position"));
  }
  EXPECT_EQ(found, wanted);
  EXPECT_GT(found.size(), 0U);
}

TEST_F(SliderRecords, OfAnotherQuestionTheCellIsEmpty) {
  const LogContents log = simulated(a_line_and_a_word);
  const AnonymisedLog anonymous = anonymise(log, 3);
  for (const CsvTable& answers :
       {answer_tables(log)[0], answer_tables(anonymous.log, anonymous.anonymity)[0]}) {
    int on_the_line = 0;
    for (std::size_t row = 0; row < answers.rows.size(); ++row) {
      const bool has_place = std::holds_alternative<std::int64_t>(cell(answers, row, "position"));
      EXPECT_EQ(has_place, std::get<std::string>(cell(answers, row, "condition")) == "line");
      on_the_line += has_place ? 1 : 0;
    }
    EXPECT_EQ(on_the_line, 3 * 24);
  }
}

}  // namespace
}  // namespace seamline::study
