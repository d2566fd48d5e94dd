// A log as tables for other programs, and anonymised.
#include <gmock/gmock.h>

#include <map>

#include "log_fixture.h"
#include "study/exchange/anonymise.h"
#include "study/exchange/answer_tables.h"
#include "study/exchange/export_tables.h"
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
    for (Answer& answer : log.answers) answer.choice_ns = 1234567891;
    return log;
  }
};

TEST_F(Exchange, NoCodeNoExactTimeAndNoRareAnswerIsLeft) {
  const LogContents log = people();
  const AnonymisedLog anonymised = anonymise(log, 3);
  std::string all;
  for (const CsvTable& table : answer_tables(anonymised.log)) all += csv_text(table);
  EXPECT_THAT(all, Not(HasSubstr("Anna")));
  EXPECT_THAT(all, Not(HasSubstr("another")));
  EXPECT_THAT(all, Not(HasSubstr("1.234")));
  EXPECT_THAT(all, HasSubstr(",1.2,"));
  std::map<std::string, std::map<std::string, int>> people_who_say;
  for (const ParticipantRecord& participant : anonymised.log.participants)
    for (const FormAnswer& answer : participant.form) ++people_who_say[answer.field][answer.value];
  for (const auto& [field, values] : people_who_say)
    for (const auto& [value, count] : values) EXPECT_GE(count, 3) << field << " " << value;
  EXPECT_EQ(people_who_say["age"]["other"], 7);  // two of forty and more, and the next rarest decade
  ASSERT_EQ(anonymised.fields.size(), 2U);
  EXPECT_FALSE(anonymised.fields[0].withheld);
  EXPECT_TRUE(anonymised.fields[1].withheld);  // one rare answer takes the only other one with it
  EXPECT_GE(anonymised.smallest_combination, 1);
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
  EXPECT_EQ(answer_tables(anonymise(log, 3).log)[0].rows, answer_tables(anonymised.log)[0].rows);
  EXPECT_THAT(complaint_of([&] { (void)anonymise(log, 1); }), HasSubstr("at least 2 people"));
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
