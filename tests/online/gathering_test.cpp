// Files of messages and other logs become part of a log: all of them once, or none.
#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "analysis/log_analysis/analysis.h"
#include "analysis/report/json/thresholds_json.h"
#include "online_people.h"
#include "study/log/log_admin.h"
#include "study/log/online/log_merge.h"
#include "study/online/intake/import.h"
#include "study/online/intake/intake.h"
#include "study/running/participant_session.h"
#include "study/running/simulation.h"
#include "tests/complaint.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class GatheringTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  RenderedSet set = write_set_of_text(folder / "set", online_study_text());
  fs::path path = folder / "log.sqlite";

  fs::path file(const std::string& name, const std::string& text) const {
    write_file_atomically(folder / name, text);
    return folder / name;
  }
  /// What is in a log, without numbers that a log gives.
  static std::string contents(const fs::path& log) {
    const LogContents read = read_log(log);
    std::string text;
    for (const ParticipantRecord& person : read.participants)
      text += fmt::format("{} {} {} {} {}\n", person.code, person.slot, person.completed, word(person.origin),
                          person.sessions);
    for (const Answer& answer : read.answers)
      text += fmt::format("{} {} {} {} {} {}\n", answer.participant, answer.trial_index, answer.stimulus_id,
                          answer.chosen_index, answer.rating, answer.rating_ns);
    for (const CatchTrialAnswer& answer : read.catches)
      text += fmt::format("{} {} {}\n", answer.participant, answer.trial_index, answer.rating);
    return text;
  }
};

TEST_F(GatheringTest, AFileIsImportedOnceHoweverOften) {
  Page one = page_elsewhere(set, 1), two = page_elsewhere(set, 2, Origin::jatos);
  const fs::path first = file("one.txt", lines_of(one.whole_stream()));
  const fs::path second = file("two.txt", lines_of(two.whole_stream()));
  const ImportReport report = import_messages(set, path, {first, second});
  ASSERT_EQ(report.people.size(), 2U);
  for (const ImportedPerson& person : report.people) {
    EXPECT_TRUE(person.completed);
    EXPECT_EQ(person.answered, 26);
    EXPECT_EQ(person.stored, 59 - 1);
    EXPECT_EQ(person.known, 0);
    EXPECT_THAT(person.refused, IsEmpty());
    EXPECT_THAT(person.gaps, IsEmpty());
  }
  EXPECT_EQ(report.people[1].origin, Origin::jatos);
  const std::string before = contents(path);
  const ImportReport again = import_messages(set, path, {second, first, first});
  for (const ImportedPerson& person : again.people) EXPECT_EQ(person.stored, 0);
  EXPECT_EQ(contents(path), before);
  EXPECT_THAT(import_text(again, path), HasSubstr("0 new"));
  EXPECT_THAT(import_text(report, path), HasSubstr("2 participants complete, 0 incomplete"));
}

TEST_F(GatheringTest, DownloadsOfPagesBeforeShownNamesAreReadAsTodays) {
  std::vector<std::string> logs;
  for (const bool is_old : {false, true}) {
    Page page = page_elsewhere(set, 1);
    page.is_old = is_old;
    const std::string text = lines_of(page.whole_stream());
    EXPECT_EQ(text.find(set.manifest.stimuli[0].id) != std::string::npos, is_old);
    const fs::path own = folder / (is_old ? "old.sqlite" : "new.sqlite");
    const ImportReport report = import_messages(set, own, {file("download.jsonl", text)});
    EXPECT_TRUE(report.people.at(0).completed);
    EXPECT_THAT(report.people.at(0).refused, IsEmpty());
    logs.push_back(contents(own));
  }
  EXPECT_EQ(logs[0], logs[1]);
}

TEST_F(GatheringTest, LinesInAnyOrderAndTwiceGiveTheSameLog) {
  Page one = page_elsewhere(set, 1), two = page_elsewhere(set, 2);
  std::vector<Message> messages = one.whole_stream();
  for (const Message& message : two.whole_stream()) messages.push_back(message);
  (void)import_messages(set, path, {file("in_order.txt", lines_of(messages))});
  std::vector<Message> mixed = messages;
  mixed.insert(mixed.end(), messages.begin(), messages.begin() + 30);
  Random random(1, 1);
  shuffle(std::span<Message>(mixed), random);
  const fs::path other = folder / "other.sqlite";
  const ImportReport report = import_messages(set, other, {file("mixed.txt", lines_of(mixed))});
  EXPECT_EQ(report.people[0].known + report.people[1].known, 30);
  EXPECT_EQ(contents(other), contents(path));
}

TEST_F(GatheringTest, WhatIsMissingIsNamedAndFilledByTheOtherFile) {
  Page page = page_elsewhere(set, 1);
  const std::vector<Message> messages = page.whole_stream();
  std::vector<Message> some, others;
  for (const Message& message : messages)
    (message.sequence == 9 || (message.sequence >= 20 && message.sequence <= 22) ? others : some)
        .push_back(message);
  const ImportReport report = import_messages(set, path, {file("some.txt", lines_of(some))});
  const ImportedPerson& person = report.people.at(0);
  EXPECT_THAT(person.gaps, ElementsAre(9, 20, 21, 22));
  EXPECT_FALSE(person.completed);
  EXPECT_LT(person.answered, 26);
  ASSERT_EQ(person.refused.size(), 1U);  // that everything is answered
  EXPECT_THAT(person.refused[0], HasSubstr("of 26 answered"));
  EXPECT_THAT(import_text(report, path), HasSubstr("missing messages: 9, 20-22"));
  (void)read_log(path);  // a log with a gap is read
  const ImportReport filled =
      import_messages(set, path, {file("others.txt", lines_of(others)), folder / "some.txt"});
  EXPECT_TRUE(filled.people.at(0).completed);
  EXPECT_THAT(filled.people.at(0).gaps, IsEmpty());
  const fs::path whole = folder / "whole.sqlite";
  (void)import_messages(set, whole, {file("whole.txt", lines_of(messages))});
  EXPECT_EQ(contents(path), contents(whole));
}

TEST_F(GatheringTest, AnotherStudyOrALineThatIsNoMessageStoresNothing) {
  Page page = page_elsewhere(set, 1);
  const std::string good = lines_of(page.whole_stream());
  const RenderedSet other_set = write_set_of_text(folder / "other", online_study_text("64, 1024"));
  Page stranger = page_elsewhere(other_set, 2);
  const fs::path strange = file("strange.txt", good + lines_of(stranger.whole_stream()));
  EXPECT_THAT(complaint_of([&] { (void)import_messages(set, path, {strange}); }),
              HasSubstr("strange.txt:59"));
  EXPECT_THAT(complaint_of([&] { (void)import_messages(set, path, {strange}); }), HasSubstr("study_hash"));
  const fs::path odd = file("odd.txt", good + "{\"format\":1}\n" + good);
  EXPECT_THAT(complaint_of([&] { (void)import_messages(set, path, {odd}); }), HasSubstr("odd.txt:59"));
  EXPECT_FALSE(fs::exists(path));
  EXPECT_THAT(complaint_of([&] { (void)import_messages(set, path, {file("empty.txt", "\n\n")}); }),
              HasSubstr("wanted lines of messages"));
  EXPECT_THAT(complaint_of([&] { (void)set_for_log(path, {}); }), HasSubstr("set: wanted the rendered set"));
  // A line that ends in the middle is where the browser or the network stopped.
  const ImportReport cut = import_messages(set, path, {file("cut.txt", good.substr(0, good.size() - 20))});
  EXPECT_EQ(cut.cut_files.size(), 1U);
  EXPECT_EQ(cut.people.at(0).answered, 26);
  EXPECT_FALSE(cut.people.at(0).completed);
  EXPECT_EQ(set_for_log(path, {}).set_hash, set.set_hash);
}

TEST_F(GatheringTest, ACodeThatSomebodyElseHasIsLeftOutByName) {
  {
    LogWriter log(path, set);
    (void)enter_session(log, {.code = "w-0000000000000001"}, 0);
  }
  Page page = page_elsewhere(set, 1);
  const ImportReport report = import_messages(set, path, {file("one.txt", lines_of(page.whole_stream()))});
  EXPECT_EQ(report.people.at(0).stored, 0);
  EXPECT_EQ(report.people.at(0).refused.size(), 58U);
  EXPECT_THAT(import_text(report, path), HasSubstr("one of the window"));
}

/// The numbers that a study is about; whoever gave them has another code in each log.
std::string thresholds_of(const fs::path& log) {
  const std::string json = analysis::thresholds_json(
      analysis::analyze(read_log(log), false, {.replicates = 200, .seed = 1, .threads = 2}));
  return std::regex_replace(json, std::regex("\"participant\": \"[^\"]*\""), "\"participant\": \"somebody\"");
}

TEST_F(GatheringTest, TheSameAnswersGiveTheSameThresholdsFromTheWindowAServerAndFiles) {
  constexpr int people = 6;
  const RenderedSet curve = write_set_of_text(folder / "curve", online_study_text("64, 256, 1024, 4096"));
  const TrialRules rules = make_trial_rules(curve);
  // What simulated people say, in the window's log.
  const fs::path simulated = folder / "simulated.sqlite", window = folder / "window.sqlite";
  (void)run_simulated_study({.set_folder = curve.folder, .log = simulated, .count = people, .seed = 5});
  std::map<std::string, std::vector<TrialAnswer>> said;
  {
    LogWriter log(simulated, curve);
    for (int i = 0; i < people; ++i) {
      const std::string code = fmt::format("sim-{:04}", i + 1);
      const OpenSession place =
          log.open_session({.code = code, .simulated = Simulated{ObserverKind::threshold, 5}});
      said[code] = place.answers;
    }
  }
  const fs::path served = folder / "served.sqlite", imported = folder / "imported.sqlite";
  std::string lines;
  {
    LogWriter log(window, curve);
    Intake intake(curve, served);
    for (int i = 0; i < people; ++i) {
      const std::vector<TrialAnswer>& answers = said.at(fmt::format("sim-{:04}", i + 1));
      OpenSession place = enter_session(log, {.code = fmt::format("p{:02}", i + 1)}, 0);
      (void)open_trials(rules, log, place);
      for (const TrialAnswer& answer : answers) log.append_answer(place, answer);
      log.complete(place);
      for (const bool elsewhere : {false, true}) {
        Page page = page_elsewhere(curve, static_cast<std::uint64_t>(i + 1));
        if (!elsewhere) page = {.set = &curve, .number = static_cast<std::uint64_t>(i + 100)};
        std::vector<Message> messages = {page.enrol()};
        if (!elsewhere)
          intake.transaction([&] {
            const EnrolledPerson person = intake.enrol(
                messages[0],
                {.code = fmt::format("s-{}", i), .secret_sha256 = sha256(std::to_string(i)), .slots = 200});
            page.code = person.code;
            page.slot = person.slot;
            messages.clear();
          });
        messages.push_back(page.form());
        const std::vector<Trial> order = page.order();
        ASSERT_EQ(order.size(), answers.size());
        for (std::size_t t = 0; t < order.size(); ++t) messages.push_back(page.answer(order[t], answers[t]));
        messages.push_back(page.say(CompletionBody{}));
        if (elsewhere)
          lines += lines_of(messages);
        else
          intake.transaction([&] {
            for (const Message& message : messages) (void)intake.take(message);
          });
      }
    }
  }
  (void)import_messages(curve, imported, {file("all.txt", lines)});
  const std::string numbers = thresholds_of(window);
  EXPECT_TRUE(thresholds_of(served) == numbers);
  EXPECT_TRUE(thresholds_of(imported) == numbers);
  EXPECT_GT(numbers.size(), 1000U);
}

class MergeTest : public GatheringTest {
 protected:
  void window(const fs::path& log, const std::string& code, int answers, std::uint64_t number = 3,
              bool completes = false) const {
    LogWriter writer(log, set);
    OpenSession place = enter_session(writer, {.code = code}, 0);
    (void)open_trials(make_trial_rules(set), writer, place);
    const Page says{.set = &set, .number = number};
    while (place.answered < answers) writer.append_answer(place, says.answer_to(place.answered));
    writer.record_form(place, std::vector<FormAnswer>{{"age", "30"}});
    if (completes) writer.complete(place);
  }
  fs::path copy(const fs::path& log, const std::string& name) const {
    fs::copy_file(log, folder / name);
    return folder / name;
  }
};

TEST_F(MergeTest, PeopleOfManyLogsAreInOne) {
  const fs::path laboratory = folder / "lab.sqlite", home = folder / "home.sqlite";
  window(path, "p01", 26, 1, true);
  window(laboratory, "p02", 12);
  Page page = page_elsewhere(set, 7);
  (void)import_messages(set, home, {file("one.txt", lines_of(page.whole_stream()))});
  const std::string before = read_file(laboratory);
  const std::vector<MergedLog> merged = merge_logs(path, {laboratory, home});
  EXPECT_THAT(merged[0].added, ElementsAre("p02"));
  EXPECT_THAT(merged[1].added, ElementsAre(page.code));
  EXPECT_EQ(read_file(laboratory), before);
  const LogContents log = read_log(path);
  ASSERT_EQ(log.participants.size(), 3U);
  EXPECT_EQ(log.answers.size() + log.catches.size(), 26U + 12 + 26);
  EXPECT_EQ(log.participants[2].origin, Origin::static_host);
  EXPECT_EQ(log.participants[1].form.size(), 1U);
  const std::string all = contents(path);
  const std::vector<MergedLog> again = merge_logs(path, {home, laboratory, home});
  for (const MergedLog& one : again) {
    EXPECT_THAT(one.added, IsEmpty());
    EXPECT_EQ(one.known, 1);
  }
  EXPECT_EQ(contents(path), all);
  EXPECT_THAT(merge_text(again, path), HasSubstr("0 participants added"));
  // The messages came along: the file is known.
  EXPECT_EQ(import_messages(set, path, {folder / "one.txt"}).people.at(0).stored, 0);
  window(path, "p02", 20);  // goes on
}

TEST_F(MergeTest, ACopyThatWentOnReplacesWhatWasBeforeIt) {
  window(path, "p01", 5);
  const fs::path copied = copy(path, "copied.sqlite");
  window(copied, "p01", 26, 3, true);
  const std::vector<MergedLog> merged = merge_logs(path, {copied});
  EXPECT_THAT(merged[0].extended, ElementsAre("p01"));
  EXPECT_EQ(contents(path), contents(copied));
  EXPECT_EQ(merge_logs(copied, {path})[0].known, 1);
}

TEST_F(MergeTest, WhoSaysTwoThingsIsNamedAndNothingIsMerged) {
  const fs::path other = folder / "other.sqlite";
  window(path, "p01", 5);
  window(path, "p00", 5);
  const fs::path copied = copy(path, "copied.sqlite");
  window(path, "p01", 9, 3);
  window(copied, "p01", 9, 4);
  window(copied, "new", 9, 4);
  const std::string before = contents(path);
  const std::string said = complaint_of([&] { (void)merge_logs(path, {copied}); });
  EXPECT_THAT(said, HasSubstr("nothing was merged"));
  EXPECT_THAT(said, HasSubstr("p01 of"));
  EXPECT_EQ(said.find("p00"), std::string::npos);
  EXPECT_EQ(contents(path), before);
}

TEST_F(MergeTest, AnotherStudyAnOldLogAndASessionThatIsOpenAreRefused) {
  window(path, "p01", 5);
  const RenderedSet other_set = write_set_of_text(folder / "other", online_study_text("64, 1024"));
  const fs::path other = folder / "other.sqlite";
  { LogWriter log(other, other_set); }
  EXPECT_THAT(complaint_of([&] { (void)merge_logs(path, {other}); }), HasSubstr("study_hash"));
  EXPECT_THAT(complaint_of([&] { (void)merge_logs(path, {path}); }), HasSubstr("another log"));
  EXPECT_THAT(complaint_of([&] { (void)merge_logs(path, {folder / "none.sqlite"}); }),
              HasSubstr("no such file"));
  const fs::path third = folder / "third.sqlite";
  window(third, "p03", 5);
  LogWriter open(third, set);
  OpenSession place = enter_session(open, {.code = "p03"}, 0);
  EXPECT_THAT(complaint_of([&] { (void)merge_logs(path, {third}); }), HasSubstr("nobody is in a session"));
}

TEST_F(MergeTest, ThoseOfWhomOnlyTheFactIsKnownAreCountedOnce) {
  const fs::path other = folder / "other.sqlite";
  window(path, "p01", 5);
  window(other, "p02", 5);
  {
    LogWriter log(other, set);
    log.record_decline();
    log.record_decline();
  }
  for (int i = 0; i < 3; ++i) {
    (void)merge_logs(path, {other});
    EXPECT_EQ(read_log(path).declined_visits, 2);
  }
}

TEST_F(MergeTest, AnAnswerOfTheWindowHasTheSameIdInEveryCopy) {
  EXPECT_EQ(window_answer_id("p01", 3, "1700000000"), window_answer_id("p01", 3, "1700000000"));
  std::set<std::string> ids;
  for (const char* code : {"p01", "p02"})
    for (int trial = 0; trial < 50; ++trial)
      for (const char* begun : {"1", "2"}) ids.insert(window_answer_id(code, trial, begun));
  EXPECT_EQ(ids.size(), 200U);
  for (const std::string& id : ids) EXPECT_EQ(id.size(), 36U);
}

}  // namespace
}  // namespace seamline::study::online
