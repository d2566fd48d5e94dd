// A session that another program shows. The page's Python is run too.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <sstream>

#include "study/log/log.h"
#include "study/online/asking/ask.h"
#include "study/running/quest_plus_results.h"
#include "tests/complaint.h"
#include "tests/online/online_people.h"

namespace seamline::study::online {
namespace {

using test::complaint_of;
using testing::HasSubstr;

std::string adaptive_text_of_ask() {
  std::string text = online_study_text("64, 128, 256, 512, 1024", "");
  text.insert(text.find("seed ="), "procedure = \"quest_plus\"\n");
  text.insert(text.find("[session]"), "[quest_plus]\nmax_shows_per_image = 3\nmax_trials = 12\n");
  return text;
}

/// The other program's end: answers right where the level is below 300, as lines that the questions must ask
/// for in this order.
std::string line_for(int trial_index, int chosen, int rating) {
  return fmt::format(
      "{{\"trial_index\":{},\"chosen_index\":{},\"rating\":{},\"choice_s\":0.5,\"rating_s\":1.25}}\n",
      trial_index, chosen, rating);
}

/// Asks until the lines end; the questions and what else was said.
std::vector<nlohmann::json> said(const AskRequest& request, const std::string& lines) {
  std::istringstream in(lines);
  std::vector<nlohmann::json> all;
  ask(
      request, [&](std::string& line) { return static_cast<bool>(std::getline(in, line)); },
      [&](const std::string& line) { all.push_back(nlohmann::json::parse(line)); });
  return all;
}

class AskTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  AskRequest request(const std::string& text) const {
    write_file_atomically(folder / "study.toml", text);
    return {.source = folder / "study.toml", .log = folder / "log.sqlite", .participant = "p01"};
  }
  /// A whole session, each answer in a call of its own, as if the other program had been killed every time.
  int run_broken(const AskRequest& request) const {
    for (int index = 0;; ++index) {
      const nlohmann::json due = said(request, "").at(0);
      if (due.at("type") != "question" || due.at("trial_index") != index) return -1;
      const bool seen = due.at("level") < 300.0;
      const std::vector<nlohmann::json> after =
          said(request, line_for(index, seen ? due.at("object_index").get<int>() : 1, seen ? 3 : 1));
      if (after.at(0) != due) return -2;  // the same question, asked again
      if (after.back().at("type") == "done") return after.back().at("answered");
    }
  }
};

TEST_F(AskTest, ABrokenSessionIsTheSessionThatWasNot) {
  const AskRequest one = request(adaptive_text_of_ask());
  const int answered = run_broken(one);
  EXPECT_GT(answered, 5);
  // The same answers in one call lead to the same questions.
  const LogContents broken = read_log(one.log);
  ASSERT_TRUE(broken.participants.at(0).completed);
  AskRequest whole = one;
  whole.log = folder / "whole.sqlite";
  std::string lines;
  std::map<int, std::pair<int, int>> given;
  for (const Answer& answer : broken.answers)
    given[answer.trial_index] = {answer.chosen_index, answer.rating};
  for (const CatchTrialAnswer& answer : broken.catches)
    given[answer.trial_index] = {answer.chosen_index, answer.rating};
  for (const auto& [index, answer] : given) lines += line_for(index, answer.first, answer.second);
  EXPECT_EQ(said(whole, lines).back().at("type"), "done");
  const LogContents again = read_log(whole.log);
  ASSERT_EQ(again.answers.size(), broken.answers.size());
  for (std::size_t i = 0; i < again.answers.size(); ++i) {
    EXPECT_EQ(again.answers[i].stimulus_id, broken.answers[i].stimulus_id);
    EXPECT_EQ(again.answers[i].choice_ns, 500'000'000);
    EXPECT_EQ(again.answers[i].rating_ns, 1'250'000'000);
  }
  EXPECT_FALSE(quest_plus_estimates(again).empty());
  EXPECT_THAT(complaint_of([&] { (void)said(one, ""); }), HasSubstr("one who has"));
}

TEST_F(AskTest, ALineThatIsNoAnswerIsAskedForAgain) {
  const AskRequest one = request(online_study_text());
  const std::vector<std::string> wrong = {
      "",
      "hello",
      "{}",
      "{\"trial_index\":1,\"chosen_index\":1,\"rating\":1,\"choice_s\":1,\"rating_s\":2}",
      "{\"trial_index\":0,\"chosen_index\":4,\"rating\":1,\"choice_s\":1,\"rating_s\":2}",
      "{\"trial_index\":0,\"chosen_index\":1,\"rating\":1,\"choice_s\":2,\"rating_s\":1}"};
  std::string lines;
  for (const std::string& line : wrong) lines += line + "\n";
  const std::vector<nlohmann::json> all = said(one, lines + line_for(0, 2, 4));
  ASSERT_EQ(all.size(), 2 + wrong.size());
  for (std::size_t i = 1; i <= wrong.size(); ++i) EXPECT_EQ(all[i].at("type"), "error") << all[i];
  EXPECT_EQ(all.back().at("trial_index"), 1);
  EXPECT_EQ(read_log(one.log).answers.size() + read_log(one.log).catches.size(), 1U);
}

TEST_F(AskTest, ARenderedSetNamesItsPictures) {
  const RenderedSet set = write_set_of_text(folder / "set", online_study_text());
  const AskRequest one{.source = folder / "set", .log = folder / "log.sqlite", .participant = "p01"};
  for (int index = 0; index < 5; ++index) {
    const nlohmann::json question = said(one, line_for(index, 1, 1)).at(0);
    if (question.at("kind") != "stimulus") continue;
    EXPECT_THAT(question.at("picture").get<std::string>(), HasSubstr((folder / "set").string()));
  }
  // A study file is another set: its people cannot come into this log.
  AskRequest other = one;
  write_file_atomically(folder / "study.toml", online_study_text());
  other.source = folder / "study.toml";
  EXPECT_THAT(complaint_of([&] { (void)said(other, ""); }), HasSubstr("set"));
}

}  // namespace
}  // namespace seamline::study::online
