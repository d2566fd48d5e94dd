// [recruitment] of a study file: what is read, what is refused, and that it changes no hash.
#include <gtest/gtest.h>

#include "stimuli/definition/people/recruitment_definition.h"
#include "stimuli/study_file/study_file.h"
#include "tests/complaint.h"
#include "tests/study/temporary_set.h"

namespace seamline {
namespace {

using test::complaint_of;

std::string recruited(const std::string& more) {
  return study::study_text("panel", "64, 512") + "[catch]\nattention = 2\n[recruitment]\n" + more;
}

StudyDefinition read(const std::string& more) {
  return read_study_text(recruited(more), "study.toml");
}

TEST(Recruitment, IsNoPartOfTheHash) {
  const StudyDefinition with = read("identifiers = [\"PROLIFIC_PID\"]\nmost_people = 3\n");
  const StudyDefinition without =
      read_study_text(study::study_text("panel", "64, 512") + "[catch]\nattention = 2\n", "study.toml");
  ASSERT_NE(with.recruitment, nullptr);
  EXPECT_EQ(without.recruitment, nullptr);
  EXPECT_EQ(study_hash(with), study_hash(without));
}

TEST(Recruitment, TheWayBackHoldsWhatTheLinkSaidAsAQueryMay) {
  const StudyDefinition study = read(
      "identifiers = [\"survey_code\"]\n"
      "return_link = \"https://uni.sona-systems.com/credit?e=7&s={survey_code}&c={code}\"\n"
      "[recruitment.codes]\nfinished = \"A B\"\n");
  EXPECT_EQ(filled_return_link(*study.recruitment, "A B", {{"survey_code", "1&x={code}"}}),
            "https://uni.sona-systems.com/credit?e=7&s=1%26x%3D%7Bcode%7D&c=A%20B");
  EXPECT_EQ(return_host(*study.recruitment), "https://uni.sona-systems.com");
}

TEST(Recruitment, ClosingIsAMinuteOfUniversalTime) {
  EXPECT_EQ(read("closes = \"2026-11-26 12:40\"\n").recruitment->closes_unix_s, 1'795'696'800);
  for (const std::string wrong : {"2026-02-30 00:00", "tomorrow", "2026-11-26 24:00", "2026-11-26T12:40"})
    EXPECT_NE(complaint_of([&] { (void)read("closes = \"" + wrong + "\"\n"); }).find("recruitment.closes"),
              std::string::npos)
        << wrong;
}

TEST(Recruitment, ARuleIsKeptByTheAnswersThatItNames) {
  const StudyDefinition study = read(
      "[[recruitment.screen]]\nfield = \"age\"\nleast = 18\nmost = 65\n"
      "[[recruitment.quota]]\nfield = \"gender\"\nanswers = [\"female\", \"another\"]\nmost_people = 5\n");
  const FormRule& age = study.recruitment->screen.at(0);
  const FormRule& gender = study.recruitment->quotas.at(0).rule;
  const auto answers = [](const std::string& years, const std::string& word) {
    return std::vector<FormAnswer>{{"age", years}, {"gender", word}};
  };
  EXPECT_TRUE(keeps(age, answers("18", "male")));
  EXPECT_TRUE(keeps(age, answers("65", "male")));
  EXPECT_FALSE(keeps(age, answers("65.5", "male")));
  EXPECT_FALSE(keeps(age, {}));
  EXPECT_TRUE(keeps(gender, answers("18", "another")));
  EXPECT_FALSE(keeps(gender, answers("18", "male")));
}

TEST(Recruitment, WhatCannotBeKeptIsRefusedByName) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"identifiers = [\"token\"]\n", "recruitment.identifiers"},
      {"identifiers = [\"A\", \"A\"]\n", "recruitment.identifiers"},
      {"return_link = \"http://panel.example/{code}\"\n[recruitment.codes]\nfinished = \"A\"\n",
       "recruitment.return_link"},
      {"return_link = \"https://panel.example/{who}\"\n[recruitment.codes]\nfinished = \"A\"\n",
       "recruitment.return_link"},
      {"return_link = \"https://{code}.example/\"\n[recruitment.codes]\nfinished = \"A\"\n",
       "recruitment.return_link"},
      {"return_link = \"https://panel.example/{code}\"\n", "recruitment.codes"},
      {"least_attention = 3\n", "recruitment.least_attention"},
      {"[recruitment.codes]\nfailed_attention = \"A\"\n", "recruitment.codes.failed_attention"},
      {"[recruitment.codes]\nscreened_out = \"A\"\n", "recruitment.codes.screened_out"},
      {"[recruitment.codes]\nfinished = \"{code}\"\n", "recruitment.codes.finished"},
      {"[[recruitment.screen]]\nfield = \"shoe_size\"\nleast = 1\n", "recruitment.screen[0].field"},
      {"[[recruitment.screen]]\nfield = \"gender\"\nanswers = [\"fluid\"]\n",
       "recruitment.screen[0].answers"},
      {"[[recruitment.screen]]\nfield = \"age\"\nanswers = [\"20\"]\n", "recruitment.screen[0].least"},
      {"[[recruitment.quota]]\nfield = \"age\"\nleast = 18\n", "recruitment.quota[0].most_people"},
      {"hold = 5\n", "recruitment.hold"}};
  for (const auto& [text, field] : cases) {
    const std::string complaint = complaint_of([&] { (void)read(text); });
    EXPECT_NE(complaint.find(field), std::string::npos) << text << complaint;
  }
}

TEST(Recruitment, ItsTextsAreKnownOnlyWhereItIs) {
  const std::string texts = "[texts]\nrecruitment_code = \"Ihr Code: {code}\"\n";
  EXPECT_EQ(read("most_people = 1\n" + texts).recruitment->texts.at("recruitment_code"), "Ihr Code: {code}");
  EXPECT_NE(complaint_of([&] {
              (void)read_study_text(study::study_text("panel", "64") + texts, "study.toml");
            }).find("recruitment_code"),
            std::string::npos);
  EXPECT_NE(complaint_of([&] {
              (void)read("most_people = 1\n[texts]\nrecruitment_code = \"{host}\"\n");
            }).find("texts.recruitment_code"),
            std::string::npos);
}

}  // namespace
}  // namespace seamline
