#include "window/input.h"

#include <gtest/gtest.h>

namespace seamline::study::app {
namespace {

KeyPressed digit(int value) {
  return {.press = {.key = Key::digit, .digit = value}, .now_ns = 100 + value};
}

TEST(Input, AFrameReactsToOneKeyAndTwoQuickOnesAreNeverMerged) {
  std::deque<RawInput> queue = {digit(1), CharacterTyped{U'1'}, digit(2), CharacterTyped{U'2'}};
  const FrameInput first = take_frame_input(queue, {}, 5);
  EXPECT_EQ(first.digit(), 1);
  EXPECT_EQ(first.typed, U"1");
  EXPECT_EQ(first.now_ns, 101);
  const FrameInput second = take_frame_input(queue, {}, 6);
  EXPECT_EQ(second.digit(), 2);
  EXPECT_EQ(second.typed, U"2");
  EXPECT_FALSE(take_frame_input(queue, {}, 7).anything);
}

TEST(Input, APressKeepsThePlaceWhereTheMouseWasThen) {
  std::deque<RawInput> queue = {MouseMoved{{10, 20}}, MousePressed{55}, MouseMoved{{90, 90}},
                                MouseReleased{}};
  const FrameInput press = take_frame_input(queue, {1, 1}, 60);
  EXPECT_TRUE(press.mouse_pressed);
  EXPECT_FALSE(press.mouse_released);
  EXPECT_EQ(press.mouse.x_px, 10);
  EXPECT_EQ(press.now_ns, 55);
  const FrameInput release = take_frame_input(queue, press.mouse, 61);
  EXPECT_TRUE(release.mouse_released);
  EXPECT_EQ(release.mouse.x_px, 90);
  EXPECT_TRUE(queue.empty());
}

TEST(Input, TheRightButtonIsNoPressOfTheLeftOne) {
  std::deque<RawInput> queue = {MousePressed{55, MouseButton::right}, MouseReleased{MouseButton::right}};
  const FrameInput press = take_frame_input(queue, {1, 1}, 60);
  EXPECT_TRUE(press.right_pressed);
  EXPECT_FALSE(press.mouse_pressed);
  const FrameInput release = take_frame_input(queue, {1, 1}, 61);
  EXPECT_TRUE(release.right_released);
  EXPECT_FALSE(release.mouse_released);
}

TEST(Input, WithoutNewsTheMouseStaysAndTheTimeIsTheFrames) {
  std::deque<RawInput> queue;
  const FrameInput nothing = take_frame_input(queue, {3, 4}, 77);
  EXPECT_FALSE(nothing.anything);
  EXPECT_EQ(nothing.mouse.y_px, 4);
  EXPECT_EQ(nothing.now_ns, 77);
}

TEST(Input, AKeyThatIsHeldDownIsNoAnswer) {
  std::deque<RawInput> queue = {
      KeyPressed{.press = {.key = Key::digit, .digit = 3, .repeated = true}, .now_ns = 1}};
  EXPECT_EQ(take_frame_input(queue, {}, 2).digit(), 0);
}

}  // namespace
}  // namespace seamline::study::app
