// Input made to do harm: what people see of it is one short printable line, and no picture holds a pixel that
// is no number.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "run_program.h"
#include "support/files/image.h"
#include "support/text/printable.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::Outcome;
using test::quick_study_with;
using test::run_seamline;
using test::write_text;
using testing::HasSubstr;
using testing::Not;

void expect_a_line(const Outcome& outcome) {
  EXPECT_EQ(outcome.status, 1) << outcome.output.substr(0, 2000);
  EXPECT_LT(outcome.output.size(), 2500U);
  ASSERT_FALSE(outcome.output.empty());
  EXPECT_EQ(outcome.output.back(), '\n');
  const std::string line = outcome.output.substr(0, outcome.output.size() - 1);
  EXPECT_EQ(line, printable(line, 10'000));
}

TEST(HostileInput, ValuesOfAStudyFileAreShortPrintableText) {
  const auto folder = fresh_folder("hostile-study");
  const std::string escapes = R"(\u001b[31m\u0000\n\u202e)", long_text(5'000'000, 'x');
  for (const std::string& value : {escapes, long_text, std::string("größer 視差")})
    for (const char* key :
         {"format = \"seamline study 1\"", "isolation = \"query\"", "file = \"builtin:statue\""}) {
      const std::string text = key;
      const std::string name = text.substr(0, text.find(' '));
      std::string study = quick_study_with({});
      if (study.find(text) == std::string::npos) {
        study = text + "\n" + study;  // a key that the quick study leaves out
      }
      study.replace(study.find(text), text.size(), name + " = \"" + value + "\"");
      write_text(folder / "study.toml", study);
      const Outcome outcome = run_seamline("render " + (folder / "study.toml").string() + " --dry-run");
      expect_a_line(outcome);
      EXPECT_THAT(outcome.output, HasSubstr(name));
    }
  EXPECT_THAT(run_seamline("render " + (folder / "study.toml").string() + " --dry-run").output,
              HasSubstr("größer 視差"));
}

TEST(HostileInput, BytesThatAreNoTextAreWrittenOut) {
  const auto folder = fresh_folder("hostile-bytes");
  write_text(folder / "study.toml", "format = \"\xff\x1b[2J\"\n");
  expect_a_line(run_seamline("render " + (folder / "study.toml").string() + " --dry-run"));
  write_text(folder / "counts.csv", "level,correct,trials\n6\x1b[31m\xff,1,2\n");
  expect_a_line(run_seamline("fit " + (folder / "counts.csv").string() + " --alternatives 3"));
  write_text(folder / "scene.gltf",
             R"({"asset":{"version":"2.0"},"extensionsRequired":["\u001b[31m\u0000\n"]})");
  expect_a_line(run_seamline("capture " + (folder / "scene.gltf").string() + " --at 0 0 0 --out " +
                             (folder / "d.exr").string()));
  fs::create_directories(folder / "set");
  write_text(folder / "set" / "manifest.json", R"({"format": "\u001b[31m\u0000\n"})");
  expect_a_line(run_seamline("verify " + (folder / "set").string()));
}

TEST(HostileInput, DamagedPicturesAreOneLineOfTheProgramAlone) {
  const auto folder = fresh_folder("hostile-pictures");
  write_png(folder / "whole.png", ByteImage{64, 64, 3, std::vector<std::uint8_t>(64 * 64 * 3, 99)});
  write_exr(folder / "whole.exr", Image(64, 32, 1, 2.0F));
  const auto composite = [&](const fs::path& photograph) {
    return run_seamline("composite --depth " + (folder / "whole.exr").string() +
                        " --object builtin:statue --background " + photograph.string() + " --out " +
                        (folder / "out.png").string());
  };
  for (const char* name : {"whole.png", "whole.exr"}) {
    std::string bytes = test::read_text(folder / name);
    bytes[bytes.size() / 2] ^= 0x55;
    write_text(folder / "changed", bytes);
    expect_a_line(composite(folder / "changed"));
    write_text(folder / "cut", bytes.substr(0, bytes.size() * 2 / 3));
    expect_a_line(composite(folder / "cut"));
  }
  write_exr(folder / "eight.exr", Image(64, 32, 8, 1.0F));
  const Outcome eight =
      run_seamline("mesh " + (folder / "eight.exr").string() + " --out " + (folder / "m.glb").string());
  expect_a_line(eight);
  EXPECT_THAT(eight.output, HasSubstr("one channel, found 3"));
}

/// A file with one square as large as a floor and one light.
std::string lit_scene(const std::string& light) {
  return R"({"asset":{"version":"2.0"},"extensionsUsed":["KHR_lights_punctual"],"scene":0,"scenes":[{"nodes":[0,1]}],)"
         R"("nodes":[{"mesh":0},{"extensions":{"KHR_lights_punctual":{"light":0}}}],)"
         R"("extensions":{"KHR_lights_punctual":{"lights":[{"type":"directional",)" +
         light +
         R"(}]}},"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":3}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,)"
         R"("uri":"data:application/octet-stream;base64,)" +
         std::string(48, 'A') + R"("}]})";
}

TEST(HostileInput, LightsThatNoSumHoldsAreRefused) {
  const auto folder = fresh_folder("hostile-lights");
  for (const char* light :
       {R"("intensity":1e308)", R"("color":[1e300,1,1])", R"("intensity":-3)", R"("color":[-1,1,1])"}) {
    write_text(folder / "scene.gltf", lit_scene(light));
    const Outcome outcome = run_seamline("capture " + fs::absolute(folder / "scene.gltf").string() +
                                         " --at 0 1 0 --out " + (folder / "d.exr").string());
    expect_a_line(outcome);
    EXPECT_THAT(outcome.output, HasSubstr("KHR_lights_punctual.lights[0]: wanted light from 0 to 1e+12"));
  }
  write_text(folder / "scene.gltf", lit_scene(R"("intensity":68300)"));
  EXPECT_EQ(run_seamline("capture " + fs::absolute(folder / "scene.gltf").string() +
                         " --at 0 1 0 --width 64 --out " + (folder / "d.exr").string())
                .status,
            0);
}

TEST(HostileInput, APhotographOfNoNumbersGivesNoPicture) {
  const auto folder = fresh_folder("hostile-photograph");
  write_exr(folder / "depth.exr", Image(64, 32, 1, 4.0F));
  for (const float value : {std::nanf(""), HUGE_VALF, 3e38F}) {
    Image photograph(16, 9, 3, 0.5F);
    photograph.at(3, 3, 1) = value;
    write_exr(folder / "photo.exr", photograph);
    for (const char* out : {"out.exr", "out.png"}) {
      const Outcome outcome =
          run_seamline("composite --background " + (folder / "photo.exr").string() + " --depth " +
                       (folder / "depth.exr").string() + " --object builtin:statue --spp 1 --out " +
                       (folder / out).string());
      expect_a_line(outcome);
      EXPECT_THAT(outcome.output, HasSubstr("photo.exr: wanted colours that are numbers"));
      EXPECT_FALSE(fs::exists(folder / out));
    }
  }
}

}  // namespace
}  // namespace seamline
