// Pictures in the report are those that the sessions showed, or a sentence.
#include "analysis/report/figures/stimulus_samples.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "analysis/report/page/report_html.h"
#include "analysis/report/page/sections.h"
#include "tests/app/picture_set.h"

namespace seamline::analysis {
using namespace study;
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// A set of one scene at three widths, and what is needed of an analysis of its sessions.
class StimulusSamplesTest : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  RenderedSet set_ = test::write_picture_set(folder_ / "set", {.widths = "64, 128, 256"});
  Analysis analysis_;

  void SetUp() override {
    analysis_.data.artifacts.resize(1);
    analysis_.data.artifacts[0].artifact = Artifact::receiver;
    look_again();
  }

  /// The log was written with the set as it is now.
  void look_again() {
    analysis_.log.set_folder = set_.folder;
    analysis_.log.set_hash = set_hash(set_.folder);
  }

  ManifestStimulus& left_at(int width_px) {
    for (ManifestStimulus& stimulus : set_.manifest.stimuli)
      if (stimulus.stimulus.object_index == 1 && stimulus.stimulus.depth.width_px == width_px)
        return stimulus;
    throw std::logic_error("no such stimulus");
  }

  StimulusSamples samples() { return sample_stimuli(analysis_, folder_.path()); }
  SampleRow row() { return std::get<std::vector<SampleRow>>(samples()).at(0); }
};

std::vector<bool> shown(const SampleRow& row) {
  std::vector<bool> shown;
  for (const SampleImage& image : row.images) {
    EXPECT_NE(image.png.empty(), image.trouble.empty());
    shown.push_back(!image.png.empty());
  }
  return shown;
}

TEST_F(StimulusSamplesTest, ShowsTheReferenceAndEveryWidth) {
  EXPECT_THAT(shown(row()), ElementsAre(true, true, true, true));
  EXPECT_THAT(notes_on(samples()), IsEmpty());
  EXPECT_THAT(samples_html(samples()), Not(HasSubstr("not shown")));
}

TEST_F(StimulusSamplesTest, LeavesOutAPictureThatIsMissingDamagedOrALink) {
  fs::remove(set_.folder / left_at(256).image);
  std::ofstream(set_.folder / left_at(128).image, std::ios::app) << "more";
  const fs::path linked = set_.folder / left_at(64).image;
  fs::rename(linked, folder_ / "outside.png");
  fs::create_symlink(folder_ / "outside.png", linked);
  EXPECT_THAT(shown(row()), ElementsAre(true, false, false, false));
  EXPECT_THAT(row().images[1].trouble, HasSubstr("no such file"));
  EXPECT_THAT(row().images[2].trouble, HasSubstr("other bytes"));
  EXPECT_THAT(row().images[3].trouble, HasSubstr("leads out of it"));
  EXPECT_THAT(notes_on(samples()), ElementsAre(HasSubstr("3 of the set's pictures are not shown")));
  EXPECT_THAT(samples_html(samples()), HasSubstr("not shown: "));
}

TEST_F(StimulusSamplesTest, LeavesOutPicturesOfAnotherSizeThanTheClickMap) {
  ManifestStimulus& small = left_at(128);
  write_png(set_.folder / small.image, test::noise_with_discs(40, 24, 1));
  small.sha256 = sha256_of_file(set_.folder / small.image);
  ManifestReference& room = set_.manifest.references.at(0);
  write_png(set_.folder / room.image, test::noise_with_discs(400, 20, 1));
  room.image_sha256 = sha256_of_file(set_.folder / room.image);
  write_manifest(set_.folder, set_.manifest);
  look_again();
  EXPECT_THAT(shown(row()), ElementsAre(false, true, false, true));
  EXPECT_THAT(row().images[2].trouble, HasSubstr("wanted 400 x 240 pixels with 3 channels"));
}

TEST_F(StimulusSamplesTest, SaysThatThereIsNoClickMap) {
  fs::remove(set_.folder / "room-ids.png");
  EXPECT_THAT(row().images, IsEmpty());
  EXPECT_THAT(row().trouble, HasSubstr("room-ids.png"));
  EXPECT_THAT(notes_on(samples()), ElementsAre(HasSubstr("1 of the set's pictures is not shown")));
  EXPECT_THAT(samples_html(samples()), HasSubstr("room-ids.png"));
}

}  // namespace
}  // namespace seamline::analysis
