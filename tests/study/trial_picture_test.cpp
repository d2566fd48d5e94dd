#include "study/trials/trial_picture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "stimuli/pictures/attention_image.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

using testing::HasSubstr;

constexpr int width = 32, height = 16;

ByteImage plain(std::uint8_t code) {
  return {.width_px = width,
          .height_px = height,
          .channels = 3,
          .values = std::vector<std::uint8_t>(static_cast<std::size_t>(width) * height * 3, code)};
}

ByteImage three_stripes(int to_right_px = 0) {
  ByteImage ids{.width_px = width, .height_px = height, .channels = 1, .values = {}};
  for (int i = 0; i < width * height; ++i)
    ids.values.push_back(static_cast<std::uint8_t>((i + width - to_right_px) % width / 8));
  return ids;
}

class TrialPictureTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  RenderedSet set;

  void SetUp() override {
    std::string text = study_text("tiny", "64");
    text.insert(text.find("seed"), fmt::format("width_px = {}\nheight_px = {}\n", width, height));
    set = write_set_of_text(folder / "set", text);
    for (std::size_t i = 0; i < set.manifest.stimuli.size(); ++i) {
      ManifestStimulus& record = set.manifest.stimuli[i];
      write_png(set.folder / record.image, plain(static_cast<std::uint8_t>(10 + i)));
      record.sha256 = sha256_of_file(set.folder / record.image);
    }
    for (const char* scene : {"bedroom", "gazebo"}) {
      write_png(folder / fmt::format("set/{}.png", scene), plain(100));
      write_png(folder / fmt::format("set/{}-ids.png", scene), three_stripes());
      set.manifest.references.push_back({scene, fmt::format("{}.png", scene),
                                         fmt::format("{}-ids.png", scene),
                                         sha256_of_file(folder / fmt::format("set/{}.png", scene)),
                                         sha256_of_file(folder / fmt::format("set/{}-ids.png", scene))});
    }
  }
};

TEST_F(TrialPictureTest, ShowsTheStimulusTheReferenceOrTheReferenceWithOneObjectChanged) {
  for (int stimulus = 0; stimulus < 9; ++stimulus) {
    const int object = set.manifest.stimuli[static_cast<std::size_t>(stimulus)].stimulus.object_index;
    const auto picture = [&](TrialKind kind) { return load_trial_picture(set, {kind, stimulus}).values; };
    EXPECT_EQ(picture(TrialKind::stimulus), plain(static_cast<std::uint8_t>(10 + stimulus)).values);
    EXPECT_EQ(picture(TrialKind::reference), plain(100).values);
    EXPECT_EQ(picture(TrialKind::attention), attention_image(plain(100), three_stripes(), object).values);
    EXPECT_EQ(load_object_ids(set, {TrialKind::stimulus, stimulus}).values, three_stripes().values);
    EXPECT_EQ(right_object(set, {TrialKind::stimulus, stimulus}), object);
    EXPECT_EQ(right_object(set, {TrialKind::attention, stimulus}), object);
    EXPECT_EQ(right_object(set, {TrialKind::reference, stimulus}), 0);
  }
}

TEST_F(TrialPictureTest, EachEyeSeesItsOwnPictureInEveryKindOfTrial) {
  ManifestStimulus& record = set.manifest.stimuli.front();
  ManifestReference& reference = set.manifest.references.front();
  const auto add = [&](const char* file, const ByteImage& picture) {
    write_png(set.folder / file, picture);
    return EyePicture{file, sha256_of_file(set.folder / file)};
  };
  const std::string one_eye = shown_sha256(record);
  EXPECT_EQ(one_eye, record.sha256);
  record.more_eyes = {add("right.png", plain(11))};
  EXPECT_NE(shown_sha256(record), one_eye);
  const std::string both_eyes = shown_sha256(record);
  record.more_eyes = {add("other.png", plain(12))};
  EXPECT_NE(shown_sha256(record), both_eyes) << "the right eye's picture belongs to what is shown";
  record.more_eyes = {{"right.png", sha256_of_file(set.folder / "right.png")}};
  reference.more_eyes = {add("room-right.png", plain(101))};
  const auto complaint = test::complaint_of([&] { (void)load_all_eyes(set, {TrialKind::attention, 0}); });
  EXPECT_THAT(complaint, HasSubstr("a click map for each eye"));
  reference.more_object_ids = {add("room-right-ids.png", three_stripes(3))};

  const auto stacked = [](const ByteImage& left, const ByteImage& right) {
    std::vector<std::uint8_t> both = left.values;
    both.insert(both.end(), right.values.begin(), right.values.end());
    return both;
  };
  const auto shown = [&](TrialKind kind) { return load_all_eyes(set, {kind, 0}).values; };
  EXPECT_EQ(shown(TrialKind::stimulus), stacked(plain(10), plain(11)));
  EXPECT_EQ(shown(TrialKind::reference), stacked(plain(100), plain(101)));
  const int object = record.stimulus.object_index;
  EXPECT_EQ(shown(TrialKind::attention), stacked(attention_image(plain(100), three_stripes(), object),
                                                 attention_image(plain(101), three_stripes(3), object)));
}

TEST_F(TrialPictureTest, NamesTheFileThatIsMissingHasOtherBytesOrAnotherSize) {
  const auto complaint = [&](const Trial& trial) {
    return test::complaint_of([&] { (void)load_trial_picture(set, trial); });
  };
  const int atrium = static_cast<int>(set.manifest.stimuli.size()) - 1;
  EXPECT_THAT(complaint({TrialKind::reference, atrium}), HasSubstr("a reference of the scene atrium"));
  ByteImage small = plain(1);
  small.height_px = 8;
  small.values.resize(small.values.size() / 2);
  ManifestStimulus& first = set.manifest.stimuli[0];
  write_png(set.folder / first.image, small);
  EXPECT_THAT(complaint({TrialKind::stimulus, 0}), HasSubstr("found other bytes"));
  first.sha256 = sha256_of_file(set.folder / first.image);
  EXPECT_THAT(complaint({TrialKind::stimulus, 0}),
              HasSubstr("32 x 16 pixels with 3 channels, as in the manifest, found 32 x 8"));
  std::filesystem::remove(folder / ("set/" + set.manifest.stimuli[1].image));
  EXPECT_THAT(complaint({TrialKind::stimulus, 1}), HasSubstr(set.manifest.stimuli[1].image));
}

}  // namespace
}  // namespace seamline::study
