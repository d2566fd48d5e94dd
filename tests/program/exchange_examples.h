#pragma once
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "run_program.h"
#include "tests/app/picture_set.h"

/// The examples of documentation/how-to/exchange.md, and tables to run them on.
namespace seamline::test {

/// The `number`th block of a page in a language, from 0.
inline std::string example_of(const std::string& file, const std::string& language, int number) {
  const std::string page = read_text(std::filesystem::path(SEAMLINE_SOURCE_DIR) / file);
  const std::string fence = "```" + language + "\n";
  std::size_t at = page.find(fence);
  for (int i = 0; i < number; ++i) at = page.find(fence, at + 1);
  if (at == std::string::npos) throw std::runtime_error("no such example");
  at += fence.size();
  return page.substr(at, page.find("```", at) - at);
}

inline std::string example(const std::string& language, int number) {
  return example_of("documentation/how-to/exchange.md", language, number);
}

/// A set of four artifacts at four widths; every stimulus has the reference's picture.
inline void write_small_set(const std::filesystem::path& folder) {
  std::string text =
      "format = \"seamline study 1\"\nname = \"examples\"\nseed = 7\nwidth_px = 64\nheight_px = 48\n"
      "depth_width_px = [64, 256, 1024, 4096]\n[[scene]]\nname = \"room\"\nfile = \"none.glb\"\n"
      "artifacts = [\"receiver\", \"shadow\", \"occlusion\", \"overlap\"]\n";
  for (const char* object : {"ball", "disc", "coin"})
    text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"none.glb\"\n", object);
  Manifest manifest = study::begin_set_of_text(folder, text);
  write_png(folder / "room.png", noise_with_discs(64, 48, 0));
  write_png(folder / "room-ids.png", disc_ids(64, 48));
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
inline std::map<std::string, double> numbers_of(const std::string& text) {
  std::map<std::string, double> numbers;
  std::istringstream lines(text);
  std::string name, number;
  while (lines >> name >> number) numbers[name] = std::stod(number);
  return numbers;
}

class ExchangeTables : public testing::Test {
 protected:
  /// Twenty simulated people in the paper's study, their tables and their report, in a folder of each test:
  /// two of them may run side by side.
  void SetUp() override {
    folder = fresh_folder(std::string("exchange-examples-") +
                          testing::UnitTest::GetInstance()->current_test_info()->name());
    write_small_set(folder / "set");
    for (const char* arguments :
         {"study set --log log.sqlite --observer threshold --count 20 --seed 3",
          "export tables log.sqlite tables", "analyze log.sqlite --out report --bootstrap 100"}) {
      const Outcome outcome = in_folder(std::string(SEAMLINE_PROGRAM) + " " + arguments);
      ASSERT_EQ(outcome.status, 0) << outcome.output;
    }
  }
  [[nodiscard]] Outcome in_folder(const std::string& command) const {
    return run_program("cd " + folder.string() + " && " + command, "");
  }
  void expect_thresholds(const std::string& printed) const {
    const std::map<std::string, double> found = numbers_of(printed);
    const auto report = nlohmann::json::parse(read_text(folder / "report/thresholds.json"));
    int finite = 0;
    for (const auto& artifact : report.at("artifacts")) {
      const std::string name = artifact.at("artifact");
      ASSERT_TRUE(found.contains(name)) << printed;
      const auto& threshold = artifact.at("perceptual_threshold_px");
      const auto& estimate = threshold.at("estimate");
      if (estimate.is_null()) {  // the interval is open: the crossing lies in it, or beyond the widths
        const auto& interval = threshold.at("ci95");
        if (!interval.at(0).is_null()) {
          EXPECT_GE(found.at(name), interval.at(0).get<double>()) << printed;
        }
        if (!interval.at(1).is_null()) {
          EXPECT_LE(found.at(name), interval.at(1).get<double>()) << printed;
        }
        continue;
      }
      ++finite;
      EXPECT_NEAR(found.at(name) / estimate.get<double>(), 1, 1e-5) << name;
    }
    EXPECT_EQ(found.size(), report.at("artifacts").size());
    EXPECT_GE(finite, 2);
  }
  std::filesystem::path folder;
};

}  // namespace seamline::test
