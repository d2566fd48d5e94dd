// A depth camera that covers the photograph's view is as good as a panorama of as many texels per degree.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "run_program.h"

namespace seamline {
namespace {

using test::fresh_folder;
using test::read_text;
using test::run_seamline;

/// The shipped study of discontinuities with these two sources in place of its conditions.
std::string two_sources() {
  const std::string text = read_text(test::studies() / "discontinuity.toml");
  return text.substr(0, text.find("[depth]")) +
         "[[condition]]\nname = \"panorama\"\n\n"
         "[[condition]]\nname = \"pinhole\"\ndepth.source = \"pinhole\"\ndepth.size_px = [640, 480]\n"
         "depth.field_of_view_deg = 100\n\n" +
         text.substr(text.find("# Pictures of half"));
}

/// Thresholds that both sources have are within a third of an octave of each other, with 200 simulated
/// observers who look at the pictures, and their intervals of 95 % overlap.
TEST(PinholeThreshold, IsThePanoramasAtEqualTexelsPerDegree) {
  const auto folder = fresh_folder("pinhole-threshold");
  const std::string set = (folder / "set").string(), log = (folder / "log.sqlite").string();
  test::write_text(folder / "study.toml", two_sources());
  const auto run = [](const std::string& command) {
    const test::Outcome outcome = run_seamline(command);
    ASSERT_EQ(outcome.status, 0) << outcome.output;
  };
  run("render " + (folder / "study.toml").string() + " --spp 8 --out " + set);
  run("study " + set + " --log " + log + " --observer image --gain 1.29 --count 200 --seed 1");
  run("analyze " + log + " --out " + (folder / "report").string());
  const nlohmann::json found = nlohmann::json::parse(read_text(folder / "report" / "thresholds.json"));
  int compared = 0;
  for (const nlohmann::json& panorama : found["artifacts"])
    for (const nlohmann::json& pinhole : found["artifacts"]) {
      if (panorama["condition"] != "panorama" || pinhole["condition"] != "pinhole" ||
          panorama["artifact"] != pinhole["artifact"])
        continue;
      for (const char* key :
           {"perceptual_threshold_texels_per_degree", "slightly_noticeable_texels_per_degree"}) {
        std::cout << panorama["artifact"] << " " << key << ": panorama " << panorama[key]["estimate"] << " "
                  << panorama[key]["ci95_text"] << ", pinhole " << pinhole[key]["estimate"] << " "
                  << pinhole[key]["ci95_text"] << "\n";
        if (panorama[key]["estimate"].is_null() || pinhole[key]["estimate"].is_null()) continue;
        ++compared;
        const auto value = [](const nlohmann::json& json, double otherwise) {
          return json.is_null() ? otherwise : json.get<double>();
        };
        const double one = panorama[key]["estimate"], other = pinhole[key]["estimate"];
        EXPECT_LT(std::abs(std::log2(one / other)), 1.0 / 3) << panorama["artifact"] << " " << key;
        EXPECT_LE(value(panorama[key]["ci95"][0], 0), value(pinhole[key]["ci95"][1], 1e9));
        EXPECT_LE(value(pinhole[key]["ci95"][0], 0), value(panorama[key]["ci95"][1], 1e9));
      }
    }
  EXPECT_GE(compared, 2);
}

}  // namespace
}  // namespace seamline
