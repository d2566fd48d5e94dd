#pragma once
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "run_program.h"

namespace seamline::test {

/// The program ends with status 1 and one sentence in which `said` stands.
inline void expect_refused(const std::string& arguments, const std::string& said) {
  const Outcome outcome = run_seamline(arguments);
  EXPECT_EQ(outcome.status, 1) << arguments << "\n" << outcome.output;
  EXPECT_THAT(outcome.output, testing::StartsWith("seamline: ")) << arguments;
  EXPECT_THAT(outcome.output, testing::HasSubstr(said)) << arguments;
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
}

}  // namespace seamline::test
