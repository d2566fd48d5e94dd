// `seamline fit`: the contract of its JSON, its table, and its complaints.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

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
  complains(file_with("header", "x,k,n\n1,2,3\n") + " --alternatives 3", {"line 1", "level,correct,trials"});
  complains(file_with("many", "level,correct,trials\n64,5,4\n") + " --alternatives 3",
            {"line 2", "at most the 4", "5"});
  complains(file_with("word", "level,correct,trials\n64,x,4\n") + " --alternatives 3",
            {"line 2: correct", "'x'"});
  complains(file_with("zero", "level,correct,trials\n0,1,4\n") + " --alternatives 3",
            {"line 2: level", "positive", "linear"});
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
  complains("tabs", "level\tcorrect\ttrials\n64\t5\t60\n", "line 1: wanted commas or semicolons");
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
  for (const std::string& text : {semicolons, quoted}) {
    const Outcome same = run_seamline("fit " + file_with("same-data", text) + " --alternatives 3 --json");
    EXPECT_EQ(same.output, plain.output);
  }
}

}  // namespace
}  // namespace seamline
