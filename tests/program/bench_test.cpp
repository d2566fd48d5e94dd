// `seamline lab bench` runs, and its data says what was wanted beside what was found.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "laboratory/bench/bench.h"
#include "run_program.h"

namespace seamline {
using namespace renderer;
namespace {

TEST(Bench, WantedIsOfTheRatioOrElseOfWhatWasFound) {
  const auto met = [](double found, std::optional<double> ratio, Wanted wanted) {
    return is_met({.what = {}, .unit = {}, .found = found, .beside = {}, .ratio = ratio, .wanted = wanted});
  };
  EXPECT_FALSE(met(1, 2, {}).has_value());
  EXPECT_TRUE(*met(1, 2, {Wanted::Kind::at_least, 2}));
  EXPECT_FALSE(*met(5, 1.9, {Wanted::Kind::at_least, 2}));
  EXPECT_TRUE(*met(5, {}, {Wanted::Kind::at_most, 5}));
  EXPECT_FALSE(*met(5, {}, {Wanted::Kind::at_most, 4.9}));
}

TEST(Bench, WritesMeasurementsAsData) {
  const test::Outcome outcome = test::run_seamline("lab bench --only capture --quick --json");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto report = nlohmann::json::parse(outcome.output);
  EXPECT_EQ(report["format"], "seamline bench 1");
  ASSERT_EQ(report["measurements"].size(), 2U);
  for (const auto& line : report["measurements"]) {
    EXPECT_EQ(line["benchmark"], "capture");
    EXPECT_GT(line["found"].get<double>(), 0);
    EXPECT_GT(line["beside"].get<double>(), 0);
    EXPECT_EQ(line["wanted_at_least"], 0.8);
    EXPECT_EQ(line["met"], line["ratio"] >= 0.8);
  }
}

}  // namespace
}  // namespace seamline
