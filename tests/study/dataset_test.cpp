// A log in the layouts that others expect: Psych-DS and BIDS.
#include <gmock/gmock.h>

#include <map>
#include <nlohmann/json.hpp>
#include <regex>
#include <set>
#include <sstream>

#include "log_fixture.h"
#include "study/exchange/dataset.h"
#include "study/exchange/export_tables.h"
#include "support/files/atomic_file.h"
#include "support/text/csv.h"

namespace seamline::study {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

using Files = std::map<std::string, std::string>;

Files by_path(const std::vector<DatasetFile>& files) {
  Files texts;
  for (const DatasetFile& file : files) texts[file.path] = file.text;
  EXPECT_EQ(texts.size(), files.size()) << "a path stands twice";
  return texts;
}

std::vector<std::string> pieces(const std::string& line, char between) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, between);) cells.push_back(cell);
  return cells;
}

std::vector<std::string> header_of(const std::string& table, char between) {
  return pieces(table.substr(0, table.find('\n')), between);
}

class Dataset : public LogTest {
 protected:
  /// Three people; the second answered nothing, and the first saw a catch trial between two answers.
  [[nodiscard]] LogContents people() {
    {
      LogWriter writer(path, set);
      for (int i = 0; i < 3; ++i)
        (void)enter(writer, {.code = "Anna_" + std::to_string(i), .pilot = false}, i == 1 ? 0 : 3);
    }
    LogContents log = read_log(path);
    log.answers[1].trial_index = 7;
    log.catches.push_back({.participant = "Anna_0",
                           .trial_index = 5,
                           .kind = TrialKind::reference,
                           .scene = "room",
                           .chosen_index = 2,
                           .rating = 1});
    for (ParticipantRecord& participant : log.participants) participant.form = {{"sight", "a\tb"}};
    return log;
  }
};

TEST_F(Dataset, PsychDsKeepsItsRules) {
  const Files files = by_path(dataset_files(people(), TableLayout::psych_ds, {}));
  const json whole = json::parse(files.at("dataset_description.json"));
  EXPECT_EQ(whole.at("@context"), "https://schema.org/");
  EXPECT_EQ(whole.at("@type"), "Dataset");
  EXPECT_FALSE(whole.at("name").get<std::string>().empty());
  EXPECT_FALSE(whole.at("description").get<std::string>().empty());
  std::set<std::string> declared;
  for (const json& variable : whole.at("variableMeasured")) {
    EXPECT_EQ(variable.at("@type"), "PropertyValue");
    EXPECT_TRUE(declared.insert(variable.at("name")).second) << variable;
  }
  EXPECT_TRUE(files.contains("README.md"));
  // A data file: one or more keyword-value pairs, the values without any mark, and `_data.csv`.
  const std::regex name("data/([a-z]+-[A-Za-z0-9]+)(_[a-z]+-[A-Za-z0-9]+)*_data\\.csv");
  int tables = 0;
  for (const auto& [place, text] : files) {
    if (!place.starts_with("data/") || !place.ends_with(".csv")) continue;
    ++tables;
    EXPECT_TRUE(std::regex_match(place, name)) << place;
    const json sidecar = json::parse(files.at(place.substr(0, place.size() - 3) + "json"));
    std::vector<std::string> named;
    for (const json& variable : sidecar.at("variableMeasured")) named.push_back(variable.at("name"));
    EXPECT_EQ(header_of(text, ','), named) << place;
    EXPECT_EQ(std::set<std::string>(named.begin(), named.end()).size(), named.size()) << place;
    for (const std::string& column : named) EXPECT_TRUE(declared.contains(column)) << column;
    const json of_sidecar = sidecar.at("@type");
    EXPECT_EQ(of_sidecar, "Dataset");
  }
  EXPECT_EQ(tables, 3);
}

TEST_F(Dataset, BidsHoldsEveryTrialOnceInItsOrder) {
  const Files files = by_path(dataset_files(people(), TableLayout::bids, {}));
  const std::string task = file_label(set.study.name);
  const json beh = json::parse(files.at("task-" + task + "_beh.json"));
  EXPECT_EQ(beh.at("TaskName"), task);
  const json whole = json::parse(files.at("dataset_description.json"));
  EXPECT_EQ(whole.at("BIDSVersion"), "1.9.0");
  EXPECT_TRUE(files.contains("README") && files.contains("CHANGES"));

  const std::string& first = files.at("sub-001/beh/sub-001_task-" + task + "_beh.tsv");
  std::vector<std::string> trials;
  std::istringstream lines(first);
  for (std::string line; std::getline(lines, line);) {
    EXPECT_EQ(pieces(line, '\t').size(), header_of(first, '\t').size()) << line;
    trials.push_back(pieces(line, '\t')[0] + " " + pieces(line, '\t')[1]);
  }
  EXPECT_THAT(trials, testing::ElementsAre("trial_index trial_type", "0 stimulus", "2 stimulus",
                                           "5 reference", "7 stimulus"));
  for (const std::string& column : header_of(first, '\t')) EXPECT_TRUE(beh.contains(column)) << column;
  const std::string& second = files.at("sub-002/beh/sub-002_task-" + task + "_beh.tsv");
  EXPECT_EQ(std::count(second.begin(), second.end(), '\n'), 1) << "who answered nothing has a header alone";

  const std::string& table = files.at("participants.tsv");
  EXPECT_THAT(table, HasSubstr("\nsub-003\tAnna_2\t"));
  EXPECT_THAT(table, HasSubstr("\ta b\n")) << "a tab within a cell is a blank";
  EXPECT_THAT(table, HasSubstr("\tn/a\t")) << "what has no value";
  const json columns = json::parse(files.at("participants.json"));
  for (const std::string& column : header_of(table, '\t')) EXPECT_TRUE(columns.contains(column)) << column;
}

TEST_F(Dataset, NamesOfFilesAreLettersAndFigures) {
  EXPECT_EQ(file_label("Depth resolution, 2nd study"), "Depthresolution2ndstudy");
  EXPECT_EQ(file_label("../x"), "x");
  EXPECT_EQ(file_label("深さ"), "study");
}

TEST_F(Dataset, EveryLayoutCanBeAnonymisedAndIsWholeOrNotThere) {
  namespace fs = std::filesystem;
  (void)people();
  for (const auto& [layout, name] :
       {std::pair(TableLayout::psych_ds, "psych"), {TableLayout::bids, "bids"}}) {
    const fs::path out = folder / name, hidden = folder / (std::string(name) + "-anonymous");
    (void)export_tables({.log = path, .out_folder = out, .layout = layout});
    (void)export_tables({.log = path, .out_folder = hidden, .anonymise_k = 2, .layout = layout});
    std::string named, anonymous;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(out))
      if (entry.is_regular_file()) {
        named += read_file(entry.path());
        EXPECT_EQ(entry.status().permissions(), fs::perms::owner_read | fs::perms::owner_write);
      }
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(hidden))
      if (entry.is_regular_file()) anonymous += entry.path().string() + read_file(entry.path());
    EXPECT_THAT(named, HasSubstr("Anna_1"));
    EXPECT_THAT(anonymous, Not(HasSubstr("Anna")));
    EXPECT_THAT(anonymous, HasSubstr("Anonymised: codes are new"));
    EXPECT_THAT(
        complaint_of([&] { (void)export_tables({.log = path, .out_folder = out, .layout = layout}); }),
        HasSubstr("wanted a folder that is empty or not there yet"));
  }
}

}  // namespace
}  // namespace seamline::study
