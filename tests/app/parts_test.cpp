// Small parts of the window that need no screen.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>

#include "picture_set.h"
#include "study/app/pictures/display_profile.h"
#include "study/app/pictures/picture_loader.h"
#include "study/app/pictures/picture_place.h"
#include "support/text/error.h"
#include "window/type/characters.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

TEST(PicturePlace, APictureLiesOnWholePixelsAndKeepsItsSize) {
  for (const Size screen : {Size{1280, 800}, Size{1367, 911}, Size{1001, 733}})
    for (const Size picture : {Size{960, 540}, Size{333, 201}}) {
      const TrialPlace place = place_trial(screen, picture, 22);
      ASSERT_TRUE(fits(screen, picture, 22));
      EXPECT_EQ(place.scale, 1);
      EXPECT_EQ(place.picture.width_px, picture.width_px);
      EXPECT_EQ(place.picture.height_px, picture.height_px);
      EXPECT_EQ(place.picture.x_px, std::floor(place.picture.x_px));
      EXPECT_EQ(place.picture.y_px, std::floor(place.picture.y_px));
      EXPECT_LE(place.questions.bottom_px(), screen.height_px);
      const Rect there = on_screen(place, {10, 20, 30, 40});
      const Point back = in_picture(place, {there.x_px, there.y_px});
      EXPECT_EQ(back.x_px, 10);
      EXPECT_EQ(back.y_px, 20);
    }
}

TEST(PicturePlace, WhatDoesNotFitIsShrunkIntoTheScreen) {
  const Size screen{800, 600}, picture{1920, 1080};
  EXPECT_FALSE(fits(screen, picture, 22));
  const TrialPlace place = place_trial(screen, picture, 22);
  EXPECT_LT(place.scale, 1);
  EXPECT_LE(place.picture.width_px, screen.width_px);
  EXPECT_LE(place.questions.bottom_px(), screen.height_px);
}

TEST(PicturePlace, UnderALensSheetItIsWhereThePictureWasMadeForAndOnNoOtherScreen) {
  StudyDefinition study;
  study.width_px = 960;
  study.height_px = 540;
  EXPECT_FALSE(picture_corner(study));
  EXPECT_NO_THROW(require_panel(study, {800, 600}, false));
  SceneDefinition scene;
  scene.view = {.kind = ViewKind::interleaved, .zero_parallax_m = 2, .panel_px = {1921, 1080}};
  study.scenes = {scene};
  const std::optional<Point> corner = picture_corner(study);
  ASSERT_TRUE(corner);
  EXPECT_EQ(corner->x_px, 480);
  EXPECT_EQ(corner->y_px, 0);
  const TrialPlace place = place_trial({1921, 1080}, {960, 540}, 22, corner);
  EXPECT_EQ(place.picture.x_px, 480);
  EXPECT_EQ(place.picture.y_px, 0);
  EXPECT_EQ(place.questions.y_px, 540);
  EXPECT_NO_THROW(require_panel(study, {1921, 1080}, false));
  for (const bool scaling : {false, true}) {
    try {
      require_panel(study, {1920, 1080}, scaling);
      ADD_FAILURE();
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("the whole screen of 1921 x 1080 pixels"));
    }
  }
  // Side by side nothing but the size is promised, and --allow-scaling says that it need not be.
  study.scenes[0].view.kind = ViewKind::side_by_side;
  EXPECT_FALSE(picture_corner(study));
  EXPECT_NO_THROW(require_panel(study, {1920, 1080}, true));
  EXPECT_THROW(require_panel(study, {1920, 1080}, false), InputError);
}

TEST(Characters, AreReadFromUtf8AndBrokenBytesAreMarked) {
  EXPECT_EQ(characters_of("aé€😀"), U"aé€😀");
  EXPECT_EQ(characters_of("a\xff"
                          "b\xc3"),
            U"a\uFFFDb\uFFFD");
}

TEST(Characters, OfALineAreOneParagraph) {
  EXPECT_THAT(lines_of("a\tb\r\n\nשלום\n"), testing::ElementsAre(U"a b", U"", U"שלום", U""));
}

TEST(DisplayProfile, IsKeptForEachScreenAndReadBack) {
  const fs::path file = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "profile" / "display.json";
  fs::remove_all(file.parent_path());
  const DisplayProfile one{
      .mm_per_px = 0.2512345678901234, .viewing_distance_mm = 600, .gamma_confirmed = true};
  const DisplayProfile other{.mm_per_px = 0.1, .viewing_distance_mm = 750, .gamma_confirmed = false};
  EXPECT_EQ(read_display_profile(file, "a"), std::nullopt);
  EXPECT_TRUE(write_display_profile(file, "a", one));
  EXPECT_TRUE(write_display_profile(file, "b", other));
  EXPECT_EQ(read_display_profile(file, "a"), one);
  EXPECT_EQ(read_display_profile(file, "b"), other);
  EXPECT_EQ(read_display_profile(file, "c"), std::nullopt);
  write_file_atomically(file, "{\"format\": \"another\"");
  EXPECT_EQ(read_display_profile(file, "a"), std::nullopt);
  EXPECT_TRUE(write_display_profile(file, "a", one));
  EXPECT_EQ(read_display_profile(file, "a"), one);
}

TEST(PictureLoader, GivesEachWantedPictureOnceAndDropsTheOthers) {
  std::atomic<int> loaded = 0;
  PictureLoader loader([&](const Trial& trial) {
    ++loaded;
    if (trial.stimulus == 9) throw InputError("picture 9 is damaged");
    return ByteImage{1, 1, 3, std::vector<std::uint8_t>(3, static_cast<std::uint8_t>(trial.stimulus))};
  });
  const auto fetch = [&](int stimulus) {
    for (int look = 0; look < 5000; ++look) {
      if (auto picture = loader.take({.stimulus = stimulus})) return static_cast<int>(picture->values[0]);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return -1;
  };
  loader.want({{.stimulus = 1}, {.stimulus = 2}});
  EXPECT_EQ(fetch(2), 2);
  EXPECT_EQ(fetch(1), 1);
  EXPECT_EQ(loader.take({.stimulus = 1}), std::nullopt);
  EXPECT_EQ(loaded, 2);
  loader.want({{.stimulus = 3}});
  loader.want({{.stimulus = 4}});
  EXPECT_EQ(fetch(4), 4);
  EXPECT_EQ(loader.take({.stimulus = 3}), std::nullopt);
  loader.want({{.stimulus = 9}});
  EXPECT_THROW((void)fetch(9), InputError);
}

}  // namespace
}  // namespace seamline::study::app
