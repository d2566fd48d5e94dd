// A log as tables for other programs, and anonymised.
#include <gmock/gmock.h>

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "log_fixture.h"
#include "study/exchange/anonymise.h"
#include "study/exchange/answer_tables.h"
#include "study/exchange/export_tables.h"
#include "support/arithmetic/random.h"
#include "support/files/atomic_file.h"

namespace seamline::study {
namespace {

using testing::HasSubstr;
using testing::Not;

class Exchange : public LogTest {
 protected:
  /// Twelve people; ages 20 to 42, one of them has a rare answer.
  [[nodiscard]] LogContents people() {
    LogContents log;
    {
      LogWriter writer(path, set);
      for (int i = 0; i < 12; ++i)
        (void)enter(writer, {.code = "Anna-" + std::to_string(i), .pilot = false}, 3);
    }
    log = read_log(path);
    int i = 0;
    for (ParticipantRecord& participant : log.participants) {
      participant.last_seen_unix_s = 1700000000 + i;
      participant.form = {{"age", std::to_string(20 + 2 * i)}, {"gender", i == 4 ? "another" : "female"}};
      ++i;
    }
    for (ParticipantRecord& participant : log.participants) participant.completed = true;
    for (Answer& answer : log.answers) answer.choice_ns = 1234567891;
    return log;
  }
};

/// A table's rows without some columns, as text, sorted.
std::vector<std::string> sorted_rows(const CsvTable& table, const std::set<std::string>& without) {
  std::vector<std::string> rows;
  for (const auto& row : table.rows) {
    CsvTable one{.name = {}, .columns = {}, .rows = {{}}};
    for (std::size_t i = 0; i < row.size(); ++i)
      if (!without.contains(table.columns[i].name)) {
        one.columns.push_back(table.columns[i]);
        one.rows[0].push_back(row[i]);
      }
    rows.push_back(csv_text(one));
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

/// As somebody sees them who has the tables alone.
std::vector<CsvTable> published(const AnonymisedLog& anonymised) {
  return answer_tables(anonymised.log, anonymised.anonymity);
}

TEST_F(Exchange, NoCodeNoExactTimeAndNoRareAnswerIsLeft) {
  const LogContents log = people();
  const AnonymisedLog anonymised = anonymise(log, 3);
  std::string all;
  for (const CsvTable& table : published(anonymised)) all += csv_text(table);
  EXPECT_THAT(all, Not(HasSubstr("Anna")));
  EXPECT_THAT(all, Not(HasSubstr("another")));
  EXPECT_THAT(all, Not(HasSubstr("1.234")));
  EXPECT_THAT(all, HasSubstr(",1.2,"));
  std::map<std::string, std::map<std::string, int>> people_who_say;
  for (const ParticipantRecord& participant : anonymised.log.participants)
    for (const FormAnswer& answer : participant.form) ++people_who_say[answer.field][answer.value];
  for (const auto& [field, values] : people_who_say)
    for (const auto& [value, count] : values) EXPECT_GE(count, 3) << field << " " << value;
  EXPECT_EQ(people_who_say["age"]["other"] + people_who_say["age"]["withheld"],
            7);  // two of forty and more, and the next rarest decade
  ASSERT_EQ(anonymised.fields.size(), 2U);
  EXPECT_FALSE(anonymised.fields[0].withheld);
  EXPECT_TRUE(anonymised.fields[1].withheld);  // one rare answer takes the only other one with it
  EXPECT_GE(anonymised.smallest_group, 3);
}

TEST_F(Exchange, WhatIsAnalysedStays) {
  const LogContents log = people();
  const AnonymisedLog anonymised = anonymise(log, 3);
  ASSERT_EQ(anonymised.log.answers.size(), log.answers.size());
  const auto tally = [](const LogContents& contents) {
    std::map<std::string, int> sums;
    for (const Answer& answer : contents.answers)
      sums[answer.stimulus_id + (answer.correct() ? " right" : " wrong")] += answer.rating;
    return sums;
  };
  EXPECT_EQ(tally(anonymised.log), tally(log));
  EXPECT_EQ(published(anonymise(log, 3))[0].rows, published(anonymised)[0].rows);
  EXPECT_THAT(complaint_of([&] { (void)anonymise(log, 1); }), HasSubstr("at least 2 people"));
}

TEST_F(Exchange, NothingTellsWhoCameWhen) {
  LogContents log = people();
  for (const ParticipantRecord& participant : log.participants)
    for (int i = 0; i < 2; ++i)
      log.catches.push_back({.participant = participant.code,
                             .trial_index = 5 + 10 * i,
                             .kind = TrialKind::attention,
                             .scene = i == 0 ? "room" : "hall",
                             .right_index = 1 + (participant.slot + i) % 3,
                             .chosen_index = 1 + (participant.slot + i) % 3,
                             .rating = 4});
  // The same people with the same answers, who came in the contrary order and had the orders of others.
  LogContents other = log;
  std::reverse(other.participants.begin(), other.participants.end());
  std::map<std::string, int> slot_of;
  for (std::size_t i = 0; i < other.participants.size(); ++i) {
    ParticipantRecord& participant = other.participants[i];
    EXPECT_NE(participant.slot, static_cast<int>(i));
    slot_of[participant.code] = participant.slot = static_cast<int>(i);
  }
  for (Answer& answer : other.answers) answer.trial_index = 50 - 3 * answer.trial_index;
  for (CatchTrialAnswer& answer : other.catches) {
    answer.trial_index = 40 - answer.trial_index;
    answer.right_index = answer.chosen_index = 1 + (slot_of[answer.participant] + answer.trial_index) % 3;
    answer.scene = "attic";
  }
  const std::vector<CsvTable> tables = published(anonymise(log, 3)), others = published(anonymise(other, 3));
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_FALSE(tables[t].rows.empty());
    EXPECT_EQ(sorted_rows(tables[t], {"participant"}), sorted_rows(others[t], {"participant"}));
    for (const CsvColumn& column : tables[t].columns)
      for (const char* tells : {"slot", "trial_index", "restarts"}) EXPECT_NE(column.name, tells);
  }
  // Those who broke off answered the first of their order.
  for (std::size_t i = 0; i < 6; ++i) log.participants[i].completed = false;
  const AnonymisedLog some = anonymise(log, 3);
  EXPECT_EQ(some.anonymity.unfinished_people, 6);
  EXPECT_EQ(some.log.participants.size(), 12U);
  EXPECT_EQ(some.log.answers.size(), 18U);
  EXPECT_EQ(some.log.catches.size(), 12U);
}

TEST_F(Exchange, EveryRowOfThePeopleIsThatOfAtLeastK) {
  const LogContents twelve = people();
  Random random(1, 7);
  const auto below = [&](int most) {
    return static_cast<int>(random.below(static_cast<std::uint64_t>(most)));
  };
  int kept_answers = 0, refused = 0;
  for (int round = 0; round < 300; ++round) {
    LogContents log = twelve;
    const int k = 2 + below(5), questions = below(5);
    for (ParticipantRecord& participant : log.participants) {
      participant.form.clear();
      for (int question = 0; question < questions; ++question)
        if (below(8) != 0)
          participant.form.push_back({"q" + std::to_string(question), std::to_string(below(2 + question))});
      participant.completed = below(5) != 0;
      participant.excluded = below(8) == 0;
      participant.pilot = below(9) == 0;
      participant.origin = every_origin[static_cast<std::size_t>(below(round % 2 == 0 ? 4 : 1))];
      participant.restarts = below(2);
    }
    std::map<std::string, int> states;
    for (const ParticipantRecord& one : log.participants)
      ++states[fmt::format("{}{}{}", one.completed, one.excluded, one.pilot)];
    int expected = 0;
    for (const auto& [state, count] : states) expected += count >= k ? count : 0;
    if (expected == 0) {
      EXPECT_THAT(complaint_of([&] { (void)anonymise(log, k); }), HasSubstr("who are alike"));
      ++refused;
      continue;
    }
    const AnonymisedLog anonymised = anonymise(log, k);
    EXPECT_EQ(static_cast<int>(anonymised.log.participants.size()), expected);
    EXPECT_EQ(anonymised.anonymity.left_out_people, 12 - expected);
    std::map<std::string, int> rows;
    for (const std::string& row : sorted_rows(published(anonymised)[2], {"participant"})) ++rows[row];
    int smallest = 12;
    for (const auto& [row, count] : rows) smallest = std::min(smallest, count);
    EXPECT_GE(smallest, k) << "round " << round;
    EXPECT_EQ(smallest, anonymised.smallest_group);
    for (const ParticipantRecord& participant : anonymised.log.participants)
      for (const FormAnswer& answer : participant.form)
        kept_answers += answer.value != "other" && answer.value != "withheld" ? 1 : 0;
  }
  EXPECT_GT(kept_answers, 300) << "not everything is withheld";
  EXPECT_LT(refused, 150);
}

TEST_F(Exchange, TablesHoldEveryAnswerAndTheDictionaryEveryColumn) {
  const LogContents log = people();
  const std::vector<CsvTable> tables = answer_tables(log);
  ASSERT_EQ(tables.size(), 4U);
  EXPECT_EQ(tables[0].rows.size(), log.answers.size());
  EXPECT_EQ(tables[2].rows.size(), 12U);
  std::size_t columns = 0;
  for (std::size_t t = 0; t < 3; ++t) {
    columns += tables[t].columns.size();
    for (const auto& row : tables[t].rows) EXPECT_EQ(row.size(), tables[t].columns.size());
  }
  EXPECT_EQ(tables[3].rows.size(), columns);
}

TEST_F(Exchange, AFolderIsWrittenWholeOrNotAtAll) {
  (void)people();
  const TableSummary summary = export_tables({.log = path, .out_folder = folder / "tables"});
  EXPECT_EQ(summary.participants, 12);
  EXPECT_EQ(summary.answers, 36);
  const std::string answers = read_file(folder / "tables" / "answers.csv");
  EXPECT_THAT(answers, testing::StartsWith("participant,trial_index,stimulus_id,"));
  EXPECT_THAT(complaint_of([&] { (void)export_tables({.log = path, .out_folder = folder / "tables"}); }),
              HasSubstr("tables: wanted"));
  EXPECT_EQ(read_file(folder / "tables" / "answers.csv"), answers);
  EXPECT_THAT(complaint_of([&] {
                (void)export_tables({.log = folder / "none.sqlite", .out_folder = folder / "other"});
              }),
              HasSubstr("none.sqlite"));
  EXPECT_FALSE(std::filesystem::exists(folder / "other"));
}

}  // namespace
}  // namespace seamline::study
