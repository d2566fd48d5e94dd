// A set may come from somebody else, with links out of its folder: nothing behind them is opened.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/pictures/visible_difference.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/hash.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "tests/complaint.h"
#include "tests/stimuli/manifest_records.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::HasSubstr;

class SetLinks : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const fs::path set_ = folder_ / "set", outside_ = folder_ / "outside.png";
  Manifest manifest_;

  void SetUp() override {
    fs::create_directory(set_);
    manifest_.width_px = manifest_.height_px = 16;
    const ByteImage grey{
        .width_px = 16, .height_px = 16, .channels = 3, .values = std::vector<std::uint8_t>(768, 100)};
    for (const fs::path& file : {outside_, set_ / "image.png", set_ / "reference.png"}) write_png(file, grey);
    write_png(set_ / "ids.png", {16, 16, 1, std::vector<std::uint8_t>(256, 0)});
    const std::string hash = sha256_of_file(outside_);
    ManifestStimulus record = test::record_of(Artifact::receiver, "left", 64);
    record.image = "image.png";
    record.reference = "reference.png";
    record.object_ids = "ids.png";
    record.sha256 = hash;
    manifest_.references = {{"room", "reference.png", "ids.png", hash, sha256_of_file(set_ / "ids.png")}};
    manifest_.stimuli = {record};
  }
  void put_link(const std::string& name, const fs::path& target) const {
    fs::remove(set_ / name);
    fs::create_symlink(target, set_ / name);
  }
};

TEST_F(SetLinks, OutOfTheFolderAreRefusedByEveryReader) {
  for (const std::string name : {"image.png", "reference.png"}) {
    put_link(name, outside_);
    EXPECT_THAT(complaint_of([&] { (void)visible_differences(set_, manifest_, 60, {}, 1); }),
                HasSubstr("leads out of it"))
        << name;
    EXPECT_THAT(complaint_of([&] { check_manifest_shapes(set_, manifest_); }), HasSubstr("leads out of it"));
    EXPECT_THAT(complaint_of([&] { check_manifest_pictures(set_, manifest_); }),
                HasSubstr("leads out of it"));
    fs::remove(set_ / name);
    fs::copy_file(outside_, set_ / name);
  }
  EXPECT_NO_THROW((void)visible_differences(set_, manifest_, 60, {}, 1));
}

TEST_F(SetLinks, InsideTheFolderAreFollowed) {
  put_link("image.png", "reference.png");
  EXPECT_NO_THROW((void)visible_differences(set_, manifest_, 60, {}, 1));
  EXPECT_NO_THROW(check_manifest_pictures(set_, manifest_));
}

}  // namespace
}  // namespace seamline
