#include "stimuli/pictures/visible_difference.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "stimuli/pictures/flip.h"
#include "support/files/temporary_folder.h"
#include "support/text/error.h"
#include "tests/stimuli/manifest_records.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

TEST(VisibleDifference, ASquareDegreeOfFlipOneIsOne) {
  Image flip(50, 40, 1);
  for (int y = 5; y < 15; ++y)
    for (int x = 5; x < 15; ++x) flip.at(x, y) = 1;
  EXPECT_NEAR(pooled_difference(flip, 10), 1, 1e-12);
  EXPECT_NEAR(pooled_difference(flip, 20), std::cbrt(0.25), 1e-12);
  EXPECT_EQ(pooled_difference(Image(50, 40, 1), 10), 0);
}

TEST(VisibleDifference, FloorsAreTakenOffWhereTheyWereAdded) {
  EXPECT_NEAR(above_floor(std::cbrt(9.0), 1), 2, 1e-12);
  EXPECT_EQ(above_floor(0.3, 0.3), 0);
  EXPECT_EQ(above_floor(0.2, 0.3), 0);
}

/// A set of two objects: each at two widths and without a seam, as grey pictures with a square.
class SmallSet : public testing::Test {
 protected:
  void SetUp() override {
    manifest_.width_px = 30;
    manifest_.height_px = 20;
    write("reference.png", 0);
    add(Artifact::receiver, "left", 64, 60);
    add(Artifact::receiver, "left", 128, 20);
    add(Artifact::none, "left", 64, 4);
    add(Artifact::receiver, "right", 64, 60);
  }

  void write(const std::string& name, int contrast, int width_px = 30) {
    ByteImage image{width_px, 20, 3, std::vector<std::uint8_t>(static_cast<std::size_t>(width_px) * 60, 100)};
    for (std::size_t i = 300; i < 420; ++i) image.values[i] = static_cast<std::uint8_t>(100 + contrast);
    write_png(folder_ / name, image);
  }
  void add(Artifact artifact, const std::string& object, int width_px, int contrast) {
    ManifestStimulus record = test::record_of(artifact, object, width_px);
    record.image = record.id + ".png";
    record.reference = "reference.png";
    write(record.image, contrast);
    manifest_.stimuli.push_back(record);
  }

  const TemporaryFolder folder_;
  Manifest manifest_;
};

TEST_F(SmallSet, DifferencesGrowWithContrastAndLoseTheirFloor) {
  const VisibleDifferences found = visible_differences(folder_.path(), manifest_, 38);
  ASSERT_EQ(found.size(), 4U);
  const VisibleDifference strong = found.at("room-receiver-left-0064");
  const VisibleDifference weak = found.at("room-receiver-left-0128");
  const VisibleDifference none = found.at("room-none-left-0064");
  EXPECT_GT(strong.pooled, weak.pooled);
  EXPECT_GT(weak.pooled, none.pooled);
  EXPECT_GT(none.pooled, 0);
  EXPECT_EQ(none.above_floor, 0);
  EXPECT_DOUBLE_EQ(weak.above_floor, above_floor(weak.pooled, none.pooled));
  const VisibleDifference other = found.at("room-receiver-right-0064");  // no floor known
  EXPECT_EQ(other.pooled, strong.pooled);
  EXPECT_EQ(other.above_floor, other.pooled);
  EXPECT_EQ(difference_floors(manifest_, found), (DifferenceFloors{{"room/left", none.pooled}}));
  const VisibleDifferences given =
      visible_differences(folder_.path(), manifest_, 38, {{"room/right", 100.0}});
  EXPECT_EQ(given.at("room-receiver-right-0064").above_floor, 0);
}

TEST_F(SmallSet, SameBytesForAnyNumberOfThreads) {
  const VisibleDifferences one = visible_differences(folder_.path(), manifest_, 38, {}, 1);
  const VisibleDifferences four = visible_differences(folder_.path(), manifest_, 38, {}, 4);
  for (const auto& [id, difference] : one) EXPECT_EQ(difference.pooled, four.at(id).pooled);
}

TEST_F(SmallSet, AMissingOrWrongPictureIsTheUsersInput) {
  write("room-receiver-left-0064.png", 60, 31);
  EXPECT_THROW((void)visible_differences(folder_.path(), manifest_, 38), InputError);
  fs::remove(folder_ / "room-receiver-left-0064.png");
  EXPECT_THROW((void)visible_differences(folder_.path(), manifest_, 38), InputError);
}

}  // namespace
}  // namespace seamline
