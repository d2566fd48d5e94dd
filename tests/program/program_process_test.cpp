#include <gtest/gtest.h>

#include "run_program.h"

namespace seamline::test {
namespace {

TEST(ProgramProcess, DoesWhatTheBuiltProgramDoes) {
  const auto folder = fresh_folder("program-process");
  write_text(folder / "no picture.png", "no picture");
  const std::string picture = "'" + (folder / "no picture.png").string() + "'";
  for (const std::string& arguments : {std::string(), std::string("--version"), std::string("flip --help"),
                                       std::string("flip \"a b\""), "flip " + picture + " " + picture}) {
    const Outcome built = run_built(arguments);
    for (int again = 0; again < 2; ++again) {
      const Outcome here = run_seamline(arguments);
      EXPECT_EQ(here.status, built.status) << arguments;
      EXPECT_EQ(here.output, built.output) << arguments;
    }
  }
}

}  // namespace
}  // namespace seamline::test
