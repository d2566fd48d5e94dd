// Masks in the real program on a real (virtual) screen: what the screen's own memory holds while a mask is
// seen is the mask's picture, byte for byte, between two pictures and after the last one.
#include <gtest/gtest.h>

#include "picture_set.h"
#include "study/exchange/answer_tables.h"
#include "study/log/log.h"
#include "study/trials/trial_picture.h"
#include "window_driver.h"

namespace seamline::study::app {
namespace {

namespace fs = std::filesystem;

class MaskWindow : public testing::TestWithParam<const char*> {};

/// How many bytes of a picture are another on the screen, at a place of the trace.
std::size_t different_bytes(const ByteImage& screen, const ByteImage& picture, const test::Line& place) {
  const auto left = place[0].get<std::size_t>(), top = place[1].get<std::size_t>();
  const auto width = static_cast<std::size_t>(picture.width_px),
             across = static_cast<std::size_t>(screen.width_px);
  std::size_t different = 0;
  for (std::size_t y = 0; y < static_cast<std::size_t>(picture.height_px); ++y)
    for (std::size_t i = 0; i < 3 * width; ++i)
      different +=
          screen.values.at(3 * ((top + y) * across + left) + i) != picture.values[3 * y * width + i] ? 1 : 0;
  return different;
}

/// What was seen of masks in a sitting.
struct SeenMasks {
  int between = 0, after_last = 0;
  std::size_t different_bytes = 0;
};

/// Looks at the screen in each gap, and waits for the mask before each answer, until the screen says thanks.
SeenMasks look_through(test::WindowDriver& window, const test::XServer& server, const ByteImage& mask,
                       const fs::path& picture) {
  constexpr auto beat = std::chrono::milliseconds(60);  // the server copies after the swap
  SeenMasks seen;
  for (int look = 0; look < 20000 && window.running(); ++look, std::this_thread::sleep_for(beat / 3)) {
    const std::optional<test::Line> line = window.now();
    const std::string screen = line ? line->value("screen", "") : "";
    const std::string phase = line ? line->value("phase", "") : "";
    if (screen == "thanks") return seen;
    if (screen == "consent") window.keys("Tab Tab Return");
    if (screen == "instructions" || screen == "ready") window.key("Return");
    if (phase == "gap") {
      std::this_thread::sleep_for(beat);
      const ByteImage shown = server.picture();
      std::this_thread::sleep_for(beat);
      if (window.now() != line) continue;  // the gap may have ended under the look
      if (seen.between++ == 0) write_png(picture, shown);
      seen.different_bytes += different_bytes(shown, mask, (*line)["picture"]);
    }
    if (phase == "choosing") {
      bool found = false;
      for (int wait = 0; wait < 500 && !found; ++wait, std::this_thread::sleep_for(beat / 3))
        found = different_bytes(server.picture(), mask, (*line)["picture"]) == 0;
      seen.after_last += found ? 1 : 0;
      window.key("1");
      window.wait("the next trial", [&](const test::Line& now) { return now != *line; });
    }
  }
  throw std::runtime_error("the sitting did not end: " + window.output());
}

TEST_P(MaskWindow, TheScreenHoldsTheMasksBytesAndTheLogItsFrames) {
  if (const std::string missing = test::what_is_missing(); !missing.empty()) GTEST_SKIP() << missing;
  const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "app" / "mask" / GetParam();
  fs::remove_all(folder);
  const RenderedSet set = test::write_picture_set(
      folder / "set",
      {.widths = "64",
       .objects = 2,
       .session = "inter_trial_s = 0.05\n",
       .top = "participant_form = false",
       .more = fmt::format(
           "[task]\nkind = \"interval\"\nobjects = 2\nexposure_s = 0.2\ngap_s = 1\nmask = \"{}\"\n"
           "mask_s = 1\n[consent]\ntext = \"Discs.\"\n[training]\ntrials = 0\n"
           "[[instructions.page]]\ntext = \"Press a digit.\"\n",
           GetParam())});
  const ByteImage mask = load_trial_picture(set, {.kind = TrialKind::mask, .stimulus = 0});
  const test::XServer server(folder / "screen", 1024, 768);
  test::keep_display_profile(folder / "run" / "config", 1024, 768);
  test::WindowDriver window(server,
                            {.set = folder / "set", .log = folder / "log.sqlite", .folder = folder / "run"});
  const SeenMasks seen = look_through(window, server, mask, folder / "mask.png");
  window.kill();
  EXPECT_GT(seen.between, 0);
  EXPECT_EQ(seen.different_bytes, 0U);
  EXPECT_EQ(seen.after_last, 2);
  const CsvTable answers = answer_tables(read_log(folder / "log.sqlite")).front();
  const auto column = std::find_if(answers.columns.begin(), answers.columns.end(),
                                   [](const CsvColumn& one) { return one.name == "mask_frames"; });
  ASSERT_NE(column, answers.columns.end());
  ASSERT_EQ(answers.rows.size(), 2U);
  for (const std::vector<CsvValue>& row : answers.rows)
    // A late frame lets it stand longer.
    EXPECT_GE(std::get<std::int64_t>(row.at(static_cast<std::size_t>(column - answers.columns.begin()))), 60);
}

INSTANTIATE_TEST_SUITE_P(, MaskWindow, testing::Values("noise", "scrambled"),
                         [](const auto& mask) { return std::string(mask.param); });

}  // namespace
}  // namespace seamline::study::app
