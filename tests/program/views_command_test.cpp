// `seamline picture --view` and `seamline views`: what a new user tries, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "run_program.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::run_seamline;
using testing::HasSubstr;

constexpr const char* small_view = " --width 96 --height 54 --spp 2 --bounces 1 --out ";

TEST(ViewsCommand, MakesAFrameWithDepthAndViewsOfIt) {
  const fs::path folder = test::fresh_folder("views");
  const fs::path frame = folder / "frame.png";
  test::Outcome outcome = run_seamline("picture builtin:bedroom --view 2d_plus_depth --max-depth 8" +
                                       (small_view + frame.string()));
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  const ByteImage both = read_bytes_image(frame);
  EXPECT_EQ(both.width_px, 96);
  EXPECT_EQ(both.height_px, 54);
  outcome = run_seamline("views " + frame.string() + " --max-depth 8 --fov 60 --zero-parallax 4 --out " +
                         (folder / "made").string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("view 3: eye +0.0000 m, holes 0.00 %"));
  for (const char* name : {"view-1.png", "view-5.png", "view-5-holes.png", "interleaved.png"})
    EXPECT_EQ(read_bytes_image(folder / "made" / name).width_px, 96) << name;
}

TEST(ViewsCommand, EveryKindOfViewIsOfTheSizeThatWasAsked) {
  const fs::path folder = test::fresh_folder("views-kinds");
  for (const char* kind : {"side_by_side", "anaglyph", "interleaved"}) {
    const fs::path file = folder / (std::string(kind) + ".png");
    const test::Outcome outcome = run_seamline("picture builtin:bedroom --zero-parallax 4 --view " +
                                               (kind + (small_view + file.string())));
    ASSERT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(read_bytes_image(file).width_px, 96);
  }
}

TEST(ViewsCommand, RefusesWhatWouldBeIgnoredAndWhatIsMissing) {
  const fs::path folder = test::fresh_folder("views-refused");
  const auto refused = [&](const std::string& options, const char* because) {
    const test::Outcome outcome =
        run_seamline("picture builtin:bedroom " + options + (small_view + (folder / "a.png").string()));
    EXPECT_NE(outcome.status, 0) << options;
    EXPECT_THAT(outcome.output, HasSubstr(because)) << options;
    EXPECT_FALSE(fs::exists(folder / "a.png"));
  };
  refused("--separation 0.07", "--separation: wanted --view \"side_by_side\"");
  refused("--view side_by_side", "--zero-parallax: wanted the distance");
  refused("--view side_by_side --zero-parallax -2", "--zero-parallax");
  refused("--view side_by_side --zero-parallax 2 --separation 0", "--separation");
  refused("--view side_by_side --zero-parallax 2 --pitch 5", "--pitch: wanted --view \"interleaved\"");
  refused("--view interleaved --zero-parallax 2 --pitch 0", "--pitch");
  refused("--view interleaved --zero-parallax 2 --views 1", "--views");
  refused("--view 2d_plus_depth", "--max-depth: wanted the depth");
  refused("--view hologram", "--view");
  const fs::path frame = folder / "frame.png";
  write_png(frame, display_image(Image(31, 8, 3, 0.5F)));
  const test::Outcome odd =
      run_seamline("views " + frame.string() + " --max-depth 8 --fov 60 --zero-parallax 4 --out " +
                   (folder / "made").string());
  EXPECT_EQ(odd.status, 1);
  EXPECT_THAT(odd.output, HasSubstr("an even width"));
}

}  // namespace
}  // namespace seamline
