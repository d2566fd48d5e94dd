#include "stimuli/set/manifest.h"

#include <gtest/gtest.h>

#include "stimuli/pictures/difference.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

Manifest example() {
  Manifest manifest;
  manifest.study_name = "s";
  manifest.study_hash = "abc";
  manifest.program_version = "0.1.0";
  manifest.instruction_set = "avx2";
  manifest.left_out = {"textures"};
  manifest.width_px = 96;
  manifest.height_px = 54;
  manifest.references = {{"room", "references/room.png", "references/room-ids.png", "1", "2"}};
  ManifestStimulus stimulus;
  stimulus.stimulus = {.scene = "room",
                       .artifact = Artifact::overlap,
                       .object = "a",
                       .object_index = 2,
                       .level = 1.0 * 512,
                       .depth = {.width_px = 512}};
  stimulus.id = stimulus_id(stimulus.stimulus);
  stimulus.image = "stimuli/a.png";
  stimulus.spp = 16;
  stimulus.rays = 123456789012;
  stimulus.rmse = 0.01;
  stimulus.mesh = {1000, 9e-5};
  stimulus.tiny_denominators = {3, 4};
  stimulus.sha256 = "3";
  manifest.stimuli = {stimulus, stimulus};
  manifest.stimuli[1].stimulus.depth.width_px = 1024;
  manifest.stimuli[1].stimulus.level = 1024;
  manifest.stimuli[1].id = stimulus_id(manifest.stimuli[1].stimulus);
  manifest.stimuli[1].rmse.reset();
  return manifest;
}

class ManifestFile : public testing::Test {
 protected:
  const TemporaryFolder folder_;
};

TEST_F(ManifestFile, RoundTripKeepsEveryByte) {
  write_manifest(folder_.path(), example());
  const std::string bytes = read_file(folder_ / "manifest.json");
  const Manifest back = read_manifest(folder_.path());
  EXPECT_EQ(back.stimuli[0].stimulus.artifact, Artifact::overlap);
  EXPECT_EQ(back.stimuli[0].rays, 123456789012);
  EXPECT_FALSE(back.stimuli[1].rmse);
  write_manifest(folder_.path(), back);
  EXPECT_EQ(read_file(folder_ / "manifest.json"), bytes);
  EXPECT_EQ(set_hash(folder_.path()).size(), 64U);
}

TEST_F(ManifestFile, WhatASensorMeasuredIsKept) {
  ManifestStimulus record = example().stimuli[0];
  record.stimulus.depth.chain = DepthChain();
  record.stimulus.depth.chain->jumps = Jumps::cut;
  record.mesh.sensor = {.measured = 5, .holes = 4, .invented = 3, .outliers = 2};
  const std::string text = stimulus_record_text(record);
  EXPECT_NE(text.find("jumps cut 1.1"), std::string::npos) << text;
  const ManifestStimulus back = stimulus_record_from_text(text, "record");
  ASSERT_TRUE(back.mesh.sensor.has_value());
  EXPECT_EQ(back.mesh.sensor->measured, 5);
  EXPECT_EQ(back.mesh.sensor->holes, 4);
  EXPECT_EQ(back.mesh.sensor->invented, 3);
  EXPECT_EQ(back.mesh.sensor->outliers, 2);
  EXPECT_FALSE(stimulus_record_from_text(stimulus_record_text(example().stimuli[0]), "record").mesh.sensor);
}

TEST_F(ManifestFile, EveryMissingFieldAndEveryCutIsTheUsersInput) {
  write_manifest(folder_.path(), example());
  const std::string bytes = read_file(folder_ / "manifest.json");
  for (const char* key : {"\"version\"", "\"stimuli\"", "\"rays\"", "\"depth_width_px\"", "\"artifact\"",
                          "\"sha256\"", "\"references\""}) {
    std::string broken = bytes;
    broken.replace(broken.find(key), 3, "\"x_");
    write_file_atomically(folder_ / "manifest.json", broken);
    EXPECT_THROW((void)read_manifest(folder_.path()), InputError) << key;
  }
  for (std::size_t length = 0; length + 2 < bytes.size(); length += 97) {
    write_file_atomically(folder_ / "manifest.json", bytes.substr(0, length));
    EXPECT_THROW((void)read_manifest(folder_.path()), InputError) << length;
  }
  for (const char* text : {"[]", "3", "null", "{\"format\": 3}"}) {
    write_file_atomically(folder_ / "manifest.json", text);
    EXPECT_THROW((void)read_manifest(folder_.path()), InputError) << text;
  }
}

TEST(Difference, IsInDisplayUnitsAndOverTheMask) {
  Image a(2, 1, 3), b(2, 1, 3);
  b.set_rgb(1, 0, Rgb::Ones());
  EXPECT_NEAR(display_rmse(a, b, 0), std::sqrt(0.5), 1e-6);
  Image mask(2, 1, 1);
  mask.at(1, 0) = 1;
  EXPECT_NEAR(display_rmse(a, b, 0, &mask), 1.0, 1e-6);
  EXPECT_NEAR(display_rmse(a, b, 5, &mask), 1.0, 1e-6);  // clipped at white
  EXPECT_EQ(clipped_share(b, 0.0), 0.0);
  EXPECT_EQ(clipped_share(b, 1.0), 0.5);
}

}  // namespace
}  // namespace seamline
