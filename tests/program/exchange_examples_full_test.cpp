// What documentation/exchange.md tells readers to type gives what `analyze` gives.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::run_program;

/// The `number`th block of the page in a language, from 0.
std::string example(const std::string& language, int number) {
  const std::string page = test::read_text(fs::path(SEAMLINE_SOURCE_DIR) / "documentation/exchange.md");
  const std::string fence = "```" + language + "\n";
  std::size_t at = page.find(fence);
  for (int i = 0; i < number; ++i) at = page.find(fence, at + 1);
  if (at == std::string::npos) throw std::runtime_error("no such example");
  at += fence.size();
  return page.substr(at, page.find("```", at) - at);
}

/// A set of four artifacts at four widths; every stimulus has the reference's picture.
void write_small_set(const fs::path& folder) {
  std::string text =
      "format = \"seamline study 1\"\nname = \"examples\"\nseed = 7\nwidth_px = 64\nheight_px = 48\n"
      "depth_width_px = [64, 256, 1024, 4096]\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\n"
      "artifacts = [\"receiver\", \"shadow\", \"occlusion\", \"overlap\"]\n";
  for (const char* object : {"ball", "disc", "coin"})
    text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"none.glb\"\n", object);
  Manifest manifest = study::begin_set_of_text(folder, text);
  write_png(folder / "room.png", test::noise_with_discs(64, 48, 0));
  write_png(folder / "room-ids.png", test::disc_ids(64, 48));
  const std::string picture = sha256_of_file(folder / "room.png");
  manifest.references.push_back(
      {"room", "room.png", "room-ids.png", picture, sha256_of_file(folder / "room-ids.png")});
  for (ManifestStimulus& record : manifest.stimuli) {
    record.image = record.reference = "room.png";
    record.object_ids = "room-ids.png";
    record.sha256 = picture;
  }
  write_manifest(folder, manifest);
}

/// "receiver 931.2429" a line.
std::map<std::string, double> numbers_of(const std::string& text) {
  std::map<std::string, double> numbers;
  std::istringstream lines(text);
  std::string name, number;
  while (lines >> name >> number) numbers[name] = std::stod(number);
  return numbers;
}

class ExchangeExamples : public testing::Test {
 protected:
  /// Twenty simulated people in the paper's study, their tables and their report, in a folder of each test:
  /// two of them may run side by side.
  void SetUp() override {
    folder = test::fresh_folder(std::string("exchange-examples-") +
                                testing::UnitTest::GetInstance()->current_test_info()->name());
    write_small_set(folder / "set");
    for (const char* arguments :
         {"study set --log log.sqlite --observer threshold --count 20 --seed 3",
          "export log.sqlite --csv tables", "analyze log.sqlite --out report --bootstrap 100"}) {
      const Outcome outcome = in_folder(std::string(SEAMLINE_PROGRAM) + " " + arguments);
      ASSERT_EQ(outcome.status, 0) << outcome.output;
    }
  }
  [[nodiscard]] Outcome in_folder(const std::string& command) const {
    return run_program("cd " + folder.string() + " && " + command, "");
  }
  void expect_thresholds(const std::string& printed) const {
    const std::map<std::string, double> found = numbers_of(printed);
    const auto report = nlohmann::json::parse(test::read_text(folder / "report/thresholds.json"));
    int finite = 0;
    for (const auto& artifact : report.at("artifacts")) {
      const std::string name = artifact.at("artifact");
      ASSERT_TRUE(found.contains(name)) << printed;
      const auto& estimate = artifact.at("perceptual_threshold_px").at("estimate");
      if (estimate.is_null()) {
        EXPECT_TRUE(std::isinf(found.at(name))) << printed;
        continue;
      }
      ++finite;
      EXPECT_NEAR(found.at(name) / estimate.get<double>(), 1, 1e-5) << name;
    }
    EXPECT_EQ(found.size(), report.at("artifacts").size());
    EXPECT_GE(finite, 2);
  }
  fs::path folder;
};

TEST_F(ExchangeExamples, RComputesTheSameThresholds) {
  if (in_folder("Rscript --version").status != 0) GTEST_SKIP() << "there is no R here";
  test::write_text(folder / "thresholds.R", example("r", 0));
  const Outcome outcome = in_folder("Rscript thresholds.R");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  expect_thresholds(outcome.output);
}

TEST_F(ExchangeExamples, PythonComputesTheSameThresholds) {
  std::string python;
  for (const char* one : {"/usr/bin/python3", "python3"})
    if (python.empty() && in_folder(std::string(one) + " -c 'import numpy'").status == 0) python = one;
  if (python.empty()) GTEST_SKIP() << "there is no Python with numpy here";
  test::write_text(folder / "thresholds.py", example("python", 0));
  const Outcome outcome = in_folder(python + " thresholds.py");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  expect_thresholds(outcome.output);
}

TEST_F(ExchangeExamples, ROrdinalFindsTheSameSlopes) {
  if (in_folder("Rscript -e 'library(ordinal)'").status != 0)
    GTEST_SKIP() << "there is no R with ordinal here";
  test::write_text(folder / "slopes.R", example("r", 0) + example("r", 1));
  const Outcome outcome = in_folder("Rscript slopes.R");
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  std::istringstream words(outcome.output);  // two lines: names, numbers
  std::vector<std::string> names;
  std::map<std::string, double> slope;
  std::size_t next = 0;
  for (std::string word; words >> word;) {
    if (word.starts_with("artifact") && word.ends_with(":x")) {
      names.push_back(word.substr(8, word.size() - 10));
      continue;
    }
    if (next < names.size()) slope[names[next++]] = std::stod(word);
  }
  const std::string table = test::read_text(folder / "report/comparisons_coefficients.csv");
  ASSERT_EQ(slope.size(), 4U) << outcome.output;
  for (const auto& [artifact, value] : slope) {
    const std::string row = "\"" + artifact + ", per octave of width\",";
    const std::size_t at = table.find(row);
    ASSERT_NE(at, std::string::npos) << artifact;
    EXPECT_NEAR(value, std::stod(table.substr(at + row.size())), 1e-3) << artifact;
  }
}

}  // namespace
}  // namespace seamline
