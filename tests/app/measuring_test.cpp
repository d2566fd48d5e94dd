// Clicks and typed distances give an estimate's scale and shift, before objects are placed.
#include <fmt/core.h>
#include <gtest/gtest.h>

#include <cmath>

#include "composites/objects/objects_file.h"
#include "composites/place/measuring_input.h"
#include "program_window.h"
#include "support/files/image.h"

namespace seamline::place {
namespace {

constexpr Rect shown{100, 50, 400, 200};

FrameInput click(double x_px, double y_px) {
  FrameInput input;
  input.mouse = {x_px, y_px};
  input.mouse_pressed = input.anything = true;
  return input;
}

FrameInput key(Key pressed, char letter = 0, bool control = false) {
  FrameInput input;
  input.key = KeyPress{.key = pressed, .letter = letter, .control = control};
  input.anything = true;
  return input;
}

/// An input that only changes what is open or typed.
void enters(const FrameInput& input, Measuring& measuring) {
  EXPECT_EQ(measure(input, shown, measuring), MeasuringWish::nothing);
}

MeasuringWish type(Measuring& measuring, const std::u32string& text) {
  for (const char32_t character : text) {
    FrameInput input = key(Key::digit);
    input.typed = {character};
    enters(input, measuring);
  }
  return measure(key(Key::enter), shown, measuring);
}

TEST(Measuring, AClickAndADistanceAreAKnownPlace) {
  Measuring measuring;
  EXPECT_EQ(measure(click(200, 100), shown, measuring), MeasuringWish::nothing);
  EXPECT_EQ(type(measuring, U"2,5"), MeasuringWish::known_changed) << "a comma is a point";
  ASSERT_EQ(measuring.known.size(), 1U);
  EXPECT_DOUBLE_EQ(measuring.known[0].across, 0.25);
  EXPECT_DOUBLE_EQ(measuring.known[0].down, 0.25);
  EXPECT_DOUBLE_EQ(measuring.known[0].distance_m, 2.5);
  EXPECT_FALSE(measuring.open);
}

TEST(Measuring, WhatIsNoDistanceIsComplainedOfAndCanBeMended) {
  for (const char32_t* typed : {U"", U".", U"0", U"1.2.3", U"99999"}) {
    Measuring measuring;
    enters(click(200, 100), measuring);
    EXPECT_EQ(type(measuring, typed), MeasuringWish::nothing);
    EXPECT_FALSE(measuring.complaint.empty());
    EXPECT_TRUE(measuring.open);
    for (int i = 0; i < 10; ++i) enters(key(Key::backspace), measuring);
    EXPECT_EQ(type(measuring, U"3"), MeasuringWish::known_changed);
    EXPECT_TRUE(measuring.complaint.empty());
  }
}

TEST(Measuring, OneIsNotEnoughAndTwoGoOn) {
  Measuring measuring;
  EXPECT_EQ(measure(key(Key::enter), shown, measuring), MeasuringWish::nothing);
  EXPECT_FALSE(measuring.complaint.empty());
  for (const double x_px : {150.0, 450.0}) {
    enters(click(x_px, 100), measuring);
    EXPECT_EQ(type(measuring, U"4"), MeasuringWish::known_changed);
  }
  EXPECT_EQ(measure(key(Key::enter), shown, measuring), MeasuringWish::go_on);
}

TEST(Measuring, TakingBackGoesFromTheOpenPlaceToTheOneBefore) {
  Measuring measuring;
  enters(click(150, 100), measuring);
  EXPECT_EQ(type(measuring, U"4"), MeasuringWish::known_changed);
  enters(click(250, 100), measuring);
  EXPECT_EQ(measure(key(Key::letter, 'z', true), shown, measuring), MeasuringWish::nothing);
  EXPECT_EQ(measuring.known.size(), 1U);
  EXPECT_EQ(measure(key(Key::remove), shown, measuring), MeasuringWish::known_changed);
  EXPECT_TRUE(measuring.known.empty());
  EXPECT_EQ(measure(key(Key::escape), shown, measuring), MeasuringWish::leave);
}

TEST(Measuring, ClicksBesideThePictureAndDigitsWithoutAPlaceChangeNothing) {
  Measuring measuring;
  enters(click(50, 100), measuring);
  EXPECT_FALSE(measuring.open);
  EXPECT_EQ(type(measuring, U"7"), MeasuringWish::nothing);
  EXPECT_TRUE(measuring.known.empty());
  EXPECT_TRUE(measuring.typed.empty());
}

}  // namespace
}  // namespace seamline::place

namespace seamline::test {
namespace {

namespace fs = std::filesystem;

/// A wall from 2 m at the left to 4 m at the right, and its inverse depth with a planted scale and shift.
fs::path written_wall() {
  constexpr int width_px = 320, height_px = 180;
  fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "place_measuring";
  fs::create_directories(folder);
  Image estimate(width_px, height_px, 1);
  for (int y = 0; y < height_px; ++y)
    for (int x = 0; x < width_px; ++x) {
      const float inverse = 0.5F - 0.25F * (static_cast<float>(x) + 0.5F) / width_px;
      estimate.values[static_cast<std::size_t>(y) * width_px + static_cast<std::size_t>(x)] =
          (inverse - 0.1F) / 0.02F;
    }
  write_exr(folder / "photo.exr", Image(width_px, height_px, 3, 0.4F));
  write_exr(folder / "estimate.exr", estimate);
  fs::remove(folder / "objects.toml");
  return folder;
}

TEST(Place, ClicksGiveAnEstimateItsScaleAndTheSavedCommandHoldsThem) {
  if (const std::string missing = what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const fs::path folder = written_wall();
  ProgramWindow window(
      folder,
      fmt::format("place --background '{0}/photo.exr' --depth '{0}/estimate.exr' --depth-view photograph "
                  "--depth-kind radial --depth-value inverse --fov 60 --environment 1 1 1 --objects "
                  "'{0}/objects.toml' --add builtin:teapot",
                  folder.string()));
  window.wait_for("click places", 1);
  // The window is 1280 px wide, and so is the picture in it: 1 / d is 0.4375 at x = 320, 0.3125 at x = 960.
  window.xdotool("mousemove 320 360 click 1 key 2 key period key 2 key 8 key 5 key 7 key Return");
  window.xdotool("mousemove 960 360 click 1 key 3 key period key 2 key Return");
  window.wait_for("2 places: .*1 / distance = 0\\.0[12]", 1);
  window.xdotool("key Return");
  window.wait_for("first picture", 1);
  window.xdotool("key s");
  window.wait_for("saved", 1);
  EXPECT_EQ(window.end("Escape"), 0);
  const std::string said = window.said();
  double scale = 0, shift = 0;
  const std::size_t at = said.find("1 / distance = ");
  ASSERT_NE(at, std::string::npos);
  ASSERT_EQ(std::sscanf(said.c_str() + at, "1 / distance = %lf value + %lf", &scale, &shift), 2);
  EXPECT_NEAR(scale, 0.02, 1e-4);
  EXPECT_NEAR(shift, 0.1, 1e-3);
  const std::string saved = read_file(folder / "objects.toml");
  const std::size_t points = saved.find("--depth-point ");
  ASSERT_NE(points, std::string::npos) << saved;
  EXPECT_NE(saved.find("--depth-point ", points + 1), std::string::npos) << saved;
}

}  // namespace
}  // namespace seamline::test
