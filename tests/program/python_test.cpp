// documentation/how-to/use_from_python.md as its readers type it, and python/seamline.py against the report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "python_page.h"

namespace seamline {
namespace {

using test::Outcome;
using testing::HasSubstr;

std::vector<std::string> split(const std::string& line, char between) {
  std::vector<std::string> parts;
  std::istringstream text(line);
  for (std::string part; std::getline(text, part, between);) parts.push_back(part);
  return parts;
}

class Python : public test::PythonPage {};

/// Of the report that the fixture wrote, read by another reader.
TEST_F(Python, ThresholdsAreThoseOfTheReport) {
  const Outcome outcome = python(0);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto report = nlohmann::json::parse(test::read_text(folder / "report/thresholds.json"));
  std::map<std::string, nlohmann::json> joint;
  for (const auto& artifact : report.at("artifacts"))
    joint[artifact.at("artifact")] = artifact.at("joint").at("perceptual_threshold_px");
  int compared = 0;
  std::istringstream lines(outcome.output);
  for (std::string line; std::getline(lines, line);) {
    const std::vector<std::string> parts = split(line, ';');
    ASSERT_EQ(parts.size(), 6U) << line;
    if (parts[1] != "PT") continue;
    const nlohmann::json& expected = joint.at(parts[0]);
    const auto same = [&](const std::string& found, const nlohmann::json& wanted) {
      if (wanted.is_null())
        EXPECT_EQ(found, "None") << line;
      else
        EXPECT_DOUBLE_EQ(std::stod(found), wanted.get<double>()) << line;
    };
    same(parts[2], expected.at("estimate"));
    same(parts[3], expected.at("ci95").at(0));
    same(parts[4], expected.at("ci95").at(1));
    EXPECT_EQ(parts[5], "px");
    ++compared;
  }
  EXPECT_EQ(compared, 4);
}

/// documentation/how-to/other_programs.md as its readers type it.
TEST_F(Python, AnotherProgramRunsASessionThatIsAnalysed) {
  test::write_text(folder / "session.py",
                   test::example_of("documentation/how-to/other_programs.md", "python", 0));
  const std::string quick = (std::filesystem::path(SEAMLINE_SOURCE_DIR) / "stimuli/quick.toml").string();
  const std::string path = std::filesystem::path(SEAMLINE_PROGRAM).parent_path().string();
  const Outcome asked =
      in_folder("PATH=" + path + ":$PATH python3 session.py " + quick + " asked.sqlite p01 2>&1");
  ASSERT_EQ(asked.status, 0) << asked.output;
  EXPECT_THAT(asked.output, HasSubstr(" answers"));
  const Outcome report = in_folder(SEAMLINE_PROGRAM " analyze asked.sqlite --out asked 2>&1");
  EXPECT_EQ(report.status, 0) << report.output;
  EXPECT_TRUE(std::filesystem::exists(folder / "asked/thresholds.json"));
}

TEST_F(Python, MeansOfAnswersAreThoseOfTheReport) {
  const Outcome outcome = python(1);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const auto report = nlohmann::json::parse(test::read_text(folder / "report/thresholds.json"));
  std::size_t compared = 0;
  for (const auto& artifact : report.at("artifacts"))
    for (const auto& point : artifact.at("curve")) {
      const std::string begin = artifact.at("artifact").get<std::string>() + " " +
                                std::to_string(point.at("width_px").get<int>()) + ".0 ";
      const std::size_t at = outcome.output.find(begin);
      ASSERT_NE(at, std::string::npos) << begin << outcome.output;
      EXPECT_NEAR(std::stod(outcome.output.substr(at + begin.size())), point.at("mean").get<double>(), 1e-4);
      ++compared;
    }
  EXPECT_EQ(compared, 16U);
}

TEST_F(Python, AFitIsThatOfTheCommand) {
  const Outcome outcome = python(2);
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  test::write_text(folder / "counts.csv",
                   "level,correct,trials\n64,40,40\n128,37,40\n256,30,40\n512,20,40\n1024,14,40\n");
  const auto found = nlohmann::json::parse(
      test::run_seamline("fit " + (folder / "counts.csv").string() + " --alternatives 3 --json").output);
  const std::vector<std::string> parts = split(outcome.output, ' ');
  ASSERT_EQ(parts.size(), 4U) << outcome.output;
  EXPECT_EQ(parts[0], found.at("verdict").get<std::string>());
  EXPECT_DOUBLE_EQ(std::stod(parts[1]), found.at("threshold").at("estimate").get<double>());
  EXPECT_DOUBLE_EQ(std::stod(parts[3]), found.at("threshold").at("ci95").at(1).get<double>());
}

TEST_F(Python, ARefusalIsTheProgramsOwnSentence) {
  const Outcome outcome = python(3);
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_EQ(outcome.output, "no_such_log.sqlite: wanted a Seamline log, found no such file\n");
  EXPECT_FALSE(std::filesystem::exists(folder / "never_written"));
}

TEST_F(Python, CodesStayTextAndOptionsAreTyped) {
  test::write_text(
      folder / "try.py",
      "import seamline\n"
      "print(seamline._value('participant', '007'), seamline._value('level', '64'),\n"
      "      seamline._value('rating', ''), seamline._value('pilot', '1'))\n"
      "print(seamline._words({'at': (0, 1, 2), 'rest': True, 'spp': None, 'depth_kind': 'planar'}))\n");
  EXPECT_EQ(in_python("try.py").output,
            "007 64.0 None True\n['--at', '0', '1', '2', '--rest', '--depth-kind', 'planar']\n");
}

}  // namespace
}  // namespace seamline
