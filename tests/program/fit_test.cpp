// `seamline fit`: the contract of its JSON, its table, and its complaints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "run_program.h"

namespace seamline {
namespace {

using test::fresh_folder;
using test::Outcome;
using test::run_seamline;
using test::write_text;
using ::testing::HasSubstr;

const std::string falling =
    "level,correct,trials\n64,59,60\n128,58,60\n256,52,60\n512,41,60\n1024,27,60\n2048,22,60\n4096,19,60\n";

std::string file_with(const std::string& name, const std::string& text) {
  const auto path = fresh_folder("fit-" + name) / "data.csv";
  write_text(path, text);
  return path.string();
}

TEST(Fit, JsonHoldsItsContract) {
  const Outcome outcome = run_seamline("fit " + file_with("json", falling) +
                                       " --alternatives 3 --json --percent 75 --bootstrap 200 --seed 3");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const nlohmann::json json = nlohmann::json::parse(outcome.output);
  for (const char* name : {"threshold", "width", "lapse", "guess", "overdispersion"}) {
    ASSERT_TRUE(json.contains(name)) << name;
    EXPECT_TRUE(json[name].contains("estimate")) << name;
    EXPECT_EQ(json[name]["ci95"].size(), 2U) << name;
  }
  EXPECT_NEAR(json["threshold"]["estimate"].get<double>(), 529.7, 0.1);
  EXPECT_NEAR(json["width"]["estimate"].get<double>(), 3.640, 0.001);
  EXPECT_NEAR(json["log_likelihood"].get<double>(), -193.162, 1e-3);
  EXPECT_EQ(json["verdict"], "identified");
  EXPECT_EQ(json["converged"], true);
  EXPECT_EQ(json["model"]["direction"], "decreasing");
  EXPECT_GT(json["deviance_p"].get<double>(), 0.5);
  EXPECT_TRUE(json["warnings"].is_array());
  EXPECT_LT(json["percent_correct"][0]["ci95"][0].get<double>(),
            json["percent_correct"][0]["estimate"].get<double>());
}

TEST(Fit, OneLevelHasNoDegreesOfFreedomAndNoResidual) {
  const Outcome outcome =
      run_seamline("fit " + file_with("one", "level,correct,trials\n16,23,40\n") + " --alternatives 2");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("not identified: one level tested"));
  EXPECT_THAT(outcome.output,
              HasSubstr("deviance 0.000, not tested: 1 group of answers for 3 free parameters"));
  EXPECT_THAT(outcome.output, HasSubstr("| 0.575 |  0.575 |        0 |"));
}

TEST(Fit, OneSigmoidInOtherWordsIsTheSameCommand) {
  const std::string file = file_with("same", falling);
  const Outcome one = run_seamline("fit " + file + " --alternatives 3 --json");
  const Outcome two =
      run_seamline("fit " + file +
                   " --alternatives 3 --sigmoid norm --axis log2 --direction decreasing --lapse "
                   "free:0.1 --guess 0.3333333333333333 --json");
  ASSERT_EQ(one.status, 0) << one.output;
  ASSERT_EQ(two.status, 0) << two.output;
  const auto a = nlohmann::json::parse(one.output), b = nlohmann::json::parse(two.output);
  EXPECT_NEAR(a["threshold"]["estimate"].get<double>(), b["threshold"]["estimate"].get<double>(), 1e-6);
}

TEST(Fit, TheTableSaysWhatIsNotIdentified) {
  const Outcome outcome = run_seamline(
      "fit " + file_with("step", "trials,level,correct\n60,32,20\n60,16,20\n60,64,60\n60,128,60\n") +
      " --alternatives 3 --unit px");
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.output, HasSubstr("Threshold: between 32 and 64 px"));
  EXPECT_THAT(outcome.output, HasSubstr("Warning: separation"));
}

TEST(Fit, WrongInputIsOneSentence) {
  const auto complains = [](const std::string& arguments, std::initializer_list<std::string> parts) {
    const Outcome outcome = run_seamline("fit " + arguments);
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    for (const std::string& part : parts) EXPECT_THAT(outcome.output, HasSubstr(part));
  };
  complains("no/such.csv --alternatives 3", {"no/such.csv", "readable file"});
  complains(file_with("header", "a,b,c\n1,2,3\n") + " --alternatives 3", {"line 1", "level,correct,trials"});
  complains(file_with("many", "level,correct,trials\n64,5,4\n") + " --alternatives 3",
            {"line 2", "at most the 4", "5"});
  complains(file_with("word", "level,correct,trials\n64,x,4\n") + " --alternatives 3",
            {"line 2: correct", "'x'"});
  complains(file_with("negative", "level,correct,trials\n-1,1,4\n") + " --alternatives 3",
            {"line 2: level", "positive", "linear"});
  complains(file_with("zero", "level,correct,trials\n0,1,4\n") + " --alternatives 3",
            {"level: wanted", "positive", "only 0"});
  complains(
      file_with("blanks", "level,correct,trials\n0,1,4\n1,1,4\n2,3,4\n") + " --alternatives 1 --guess 0",
      {"level 0: wanted a guess rate that is not 0", "1 of 4"});
  complains(file_with("equal", falling) + " --alternatives 3 --guess equal", {"--guess", "yes/no"});
  complains(file_with("lapse", falling) + " --alternatives 3 --lapse 5", {"--lapse", "free:MAX"});
  complains(file_with("percent", falling) + " --alternatives 3 --percent 100",
            {"--percent", "between 0 and 100"});
}

TEST(Fit, WhatCannotBeMeantIsNotRead) {
  const auto complains = [](const std::string& name, const std::string& text, const std::string& part) {
    const Outcome outcome = run_seamline("fit " + file_with(name, text) + " --alternatives 3");
    EXPECT_EQ(outcome.status, 1) << outcome.output;
    EXPECT_THAT(outcome.output, HasSubstr(part));
  };
  complains("comma", "level,correct,trials\n\"64,5\",58,60\n",
            "line 2: level: wanted a number with a decimal");
  complains("bare-comma", "level,correct,trials\n64,5,58,60\n", "line 2: wanted 3 values");
  complains("twice", "level,correct,trials,level\n64,58,60,9\n", "line 1: wanted a header that names");
  complains("more", "level,correct,trials\n\n64,0,2e12\n",
            "line 3: trials: wanted a whole number from 0 to 1e12");
  complains("two-names", "level,k,yes,trials\n64,5,6,60\n", "'k' and 'yes'");
  complains("one-answer", "level,correct\n64,1\n64,2\n", "line 3: correct: wanted 0 or 1");
  complains("mixed", "level;correct;trials\n0,5;1;2\n1.5;1;2\n", "a point in line 3 and a comma in line 2");
  std::string weighted = "level,correct,trials\n";
  for (int i = 1; i <= 8; ++i) weighted += std::to_string(i) + "," + std::to_string(i % 2) + ",20\n";
  complains("weighted", weighted, "--times trials");
}

TEST(Fit, ATableInOtherWordsIsTheSameData) {
  const Outcome plain = run_seamline("fit " + file_with("plain", falling) + " --alternatives 3 --json");
  ASSERT_EQ(plain.status, 0) << plain.output;
  std::string semicolons = falling, quoted = "note,level,correct,trials\r\n";
  for (char& c : semicolons)
    if (c == ',') c = ';';
  for (std::size_t at = falling.find('\n') + 1; at < falling.size();) {
    const std::size_t end = falling.find('\n', at);
    quoted += "\"Smith, \"\"J.\"\"\nagain\"," + falling.substr(at, end - at) + "\r\n";
    at = end + 1;
  }
  std::string tabs = falling, renamed = falling;
  std::replace(tabs.begin(), tabs.end(), ',', '\t');
  renamed.replace(0, renamed.find('\n'), "Stimulus,k,N");
  for (const std::string& text : {semicolons, quoted, tabs, renamed}) {
    const Outcome same = run_seamline("fit " + file_with("same-data", text) + " --alternatives 3 --json");
    auto json = nlohmann::ordered_json::parse(same.output);
    json.erase("ignored_columns");
    json.erase("remarks");
    EXPECT_EQ(json, nlohmann::ordered_json::parse(plain.output));
  }
}

TEST(Fit, DecimalCommasAndAnswersOneARowAreTheSameData) {
  const Outcome counts =
      run_seamline("fit " + file_with("counts", "level,correct,trials\n0.5,1,3\n1.5,2,3\n2.5,3,3\n") +
                   " --alternatives 1 --axis linear --json");
  const std::string answers =
      "who;x;saw "
      "it\na;0,5;no\na;0,5;yes\na;0,5;no\nb;1,5;1\nb;1,5;0\nb;1,5;1\nb;2,5;TRUE\nb;2,5;1\nb;2,5;1\n";
  const Outcome single = run_seamline("fit " + file_with("answers", answers) +
                                      " --alternatives 1 --axis linear --correct \"saw it\" --json");
  ASSERT_EQ(counts.status, 0) << counts.output;
  ASSERT_EQ(single.status, 0) << single.output;
  const auto a = nlohmann::json::parse(counts.output), b = nlohmann::json::parse(single.output);
  EXPECT_EQ(a["levels"], b["levels"]);
  EXPECT_EQ(a["threshold"], b["threshold"]);
  EXPECT_EQ(b["ignored_columns"], nlohmann::json::array({"who"}));
}

/// Two conditions of three people, all in both.
std::string people_in_conditions() {
  std::string text = "level,correct,trials,person,condition\n";
  const std::array<std::array<int, 5>, 3> right = {
      {{3, 9, 14, 18, 20}, {1, 5, 11, 17, 19}, {2, 4, 12, 16, 20}}};
  for (int condition = 0; condition < 2; ++condition)
    for (std::size_t person = 0; person < right.size(); ++person)
      for (std::size_t level = 0; level < right[person].size(); ++level)
        text += std::to_string(level + 1) + "," +
                std::to_string(std::max(0, right[person][level] - 2 * condition)) + ",20,p" +
                std::to_string(person) + ",c" + std::to_string(condition) + "\n";
  return text;
}

TEST(Fit, GroupsAndParticipantsHaveTheirKeys) {
  const std::string file = file_with("groups", people_in_conditions());
  const Outcome outcome = run_seamline("fit " + file +
                                       " --alternatives 1 --axis linear --guess equal --group condition "
                                       "--participant person --json");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  ASSERT_EQ(json["groups"].size(), 2U);
  for (const auto& group : json["groups"]) {
    EXPECT_TRUE(group.contains("verdict"));
    EXPECT_EQ(group["people"]["participants"], 3);
    EXPECT_EQ(group["people"]["each"].size(), 3U);
  }
  ASSERT_EQ(json["differences"].size(), 1U);
  const auto& threshold = json["differences"][0]["threshold"];
  EXPECT_GT(threshold["estimate"].get<double>(), 0.2);
  EXPECT_LT(threshold["ci95"][0].get<double>(), threshold["estimate"].get<double>());
  const Outcome plain = run_seamline("fit " + file + " --alternatives 1 --axis linear");
  EXPECT_THAT(plain.output, HasSubstr("Ignored columns: person, condition."));
  EXPECT_THAT(plain.output, HasSubstr("--participant person fits a model of people who differ"));
}

TEST(Fit, AllSigmoidsAreComparedByAic) {
  const Outcome outcome =
      run_seamline("fit " + file_with("sigmoids", falling) + " --alternatives 3 --sigmoid all --json");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto json = nlohmann::json::parse(outcome.output);
  ASSERT_EQ(json["sigmoids"].size(), 3U);
  EXPECT_EQ(json["sigmoids"][0]["sigmoid"], json["model"]["sigmoid"]);
  EXPECT_EQ(json["sigmoids"][0]["aic_difference"], 0);
  double weights = 0;
  for (const auto& one : json["sigmoids"]) {
    weights += one["weight"].get<double>();
    EXPECT_GE(one["aic_difference"].get<double>(), 0);
  }
  EXPECT_NEAR(weights, 1, 1e-12);
  const Outcome refused = run_seamline("fit " + file_with("all", people_in_conditions()) +
                                       " --alternatives 1 --group condition --sigmoid all");
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.output, HasSubstr("--sigmoid: wanted one sigmoid"));
}

TEST(Fit, YesNoSaysWhatEqualRatesWouldSay) {
  const std::string file = file_with("yes-no",
                                     "level,yes,trials\n1,40,360\n3.5,54,360\n6,118,360\n8.5,165,360\n11,257,"
                                     "360\n13.5,301,360\n16,334,360\n");
  const Outcome apart = run_seamline("fit " + file + " --alternatives 1 --axis linear");
  EXPECT_THAT(apart.output, HasSubstr("--guess equal makes them one"));
  EXPECT_THAT(apart.output, HasSubstr("threshold is then 8.465"));
  const Outcome one = run_seamline("fit " + file + " --alternatives 1 --axis linear --guess equal");
  EXPECT_THAT(one.output, HasSubstr("8.4651"));
  EXPECT_THAT(one.output, ::testing::Not(HasSubstr("makes them one")));
}

}  // namespace
}  // namespace seamline
