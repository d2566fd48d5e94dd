#include "stimuli/pictures/set_seams.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/files/hash.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/stimuli/manifest_records.h"

namespace seamline {
namespace {

/// A set of two truths, as studies of the sun's radius have them: grey, and brighter by ten steps. A stimulus
/// shows a band that is ten steps brighter than grey.
class SetOfBands : public testing::Test {
 protected:
  void SetUp() override {
    manifest_.width_px = 40;
    manifest_.height_px = 30;
    write("ids.png", 1, 0, 0);
    for (const auto& [truth, bright_px] : {std::pair{"room", 0}, {"room_bright", 40}}) {
      const std::string image = std::string(truth) + ".png";
      write(image, 3, bright_px, 0);
      manifest_.references.push_back(
          {truth, image, "ids.png", sha256_of_file(folder_ / image), sha256_of_file(folder_ / "ids.png")});
      for (const int band_px : {2, 5}) add(truth, image, band_px);
    }
  }

  void write(const std::string& name, int channels, int bright_px, int from) {
    ByteImage image{40, 30, channels, {}};
    for (int y = 0; y < 30; ++y)
      for (int x = 0; x < 40; ++x)
        image.values.insert(image.values.end(), static_cast<std::size_t>(channels),
                            x >= from && x < from + bright_px ? 110 : 100);
    write_png(folder_ / name, image);
  }
  void add(const std::string& truth, const std::string& reference, int band_px) {
    ManifestStimulus record = test::record_of(Artifact::receiver, truth, 64 * band_px);
    record.stimulus.truth = truth;
    record.image = record.id + ".png";
    record.reference = reference;
    record.object_ids = "ids.png";
    write(record.image, 3, band_px, 10);
    record.sha256 = sha256_of_file(folder_ / record.image);
    manifest_.stimuli.push_back(record);
  }

  const TemporaryFolder folder_;
  Manifest manifest_;
};

TEST_F(SetOfBands, EachStimulusIsMeasuredAgainstItsOwnTruth) {
  const std::vector<SeamMeasure> seams = measure_seams(folder_.path(), manifest_);
  ASSERT_EQ(seams.size(), 4U);
  for (const SeamExtent& extent : seams[0].beyond) {
    EXPECT_EQ(extent.area_px, 2 * 30);
    EXPECT_EQ(extent.widest_band_px, 2);
  }
  EXPECT_EQ(seams[1].beyond[2].widest_band_px, 5);
  // In the bright truth all differs but the band.
  EXPECT_EQ(seams[2].beyond[2].area_px, 38 * 30);
  EXPECT_EQ(seams[3].beyond[2].widest_band_px, 25);
}

TEST_F(SetOfBands, TheSameForAnyNumberOfThreads) {
  int finished = 0;
  const std::vector<SeamMeasure> one = measure_seams(folder_.path(), manifest_, 1),
                                 four = measure_seams(folder_.path(), manifest_, 4,
                                                      [&](int n) { finished = n; });
  EXPECT_EQ(finished, 4);
  for (std::size_t i = 0; i < one.size(); ++i)
    for (std::size_t step = 0; step < seam_steps.size(); ++step) {
      EXPECT_EQ(one[i].beyond[step].area_px, four[i].beyond[step].area_px);
      EXPECT_EQ(one[i].beyond[step].widest_band_px, four[i].beyond[step].widest_band_px);
    }
}

TEST_F(SetOfBands, AChangedOrMissingPictureIsTheUsersInput) {
  write(manifest_.stimuli[1].image, 3, 7, 0);
  EXPECT_THROW((void)measure_seams(folder_.path(), manifest_), InputError);
  std::filesystem::remove(folder_ / manifest_.stimuli[1].image);
  EXPECT_THROW((void)measure_seams(folder_.path(), manifest_), InputError);
}

}  // namespace
}  // namespace seamline
