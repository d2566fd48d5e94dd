// documentation/tutorials/tutorial.md does what it says: its study, in smaller pictures, and its commands, as
// they stand on the page, in a folder that holds nothing but the scene.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "pages.h"
#include "run_program.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path documentation = fs::path(SEAMLINE_SOURCE_DIR) / "documentation/tutorials";

/// The page's study in smaller pictures, of fewer samples: what its commands do does not depend on them.
std::string smaller(const std::string& study) {
  return test::with_replaced(study,
                             {{"width_px = 480", "width_px = 96"},
                              {"height_px = 270", "height_px = 54"},
                              {"samples_per_pixel = 16", "samples_per_pixel = 2\nmesh_tolerance = 1e-2"}});
}

TEST(Tutorial, EveryCommandOfThePageWorksInAnEmptyFolder) {
  const fs::path folder = test::fresh_folder("tutorial");
  fs::copy(documentation / "tutorial" / "room.gltf", folder);
  int studies = 0, lines_run = 0, by_hand = 0;
  for (const test::PageBlock& block : test::read_manual_page(documentation / "tutorial.md").blocks) {
    if (block.kind == "toml") {
      test::write_text(folder / "my_study.toml", smaller(block.text));
      ++studies;
    } else if (block.kind == "sh by hand") {
      ++by_hand;
    } else if (block.kind == "sh") {
      std::istringstream lines(block.text);
      for (std::string line; std::getline(lines, line);) {
        test::write_text(folder / "command", "set -e\ncd '" + folder.string() + "'\nPATH='" +
                                                 fs::path(SEAMLINE_PROGRAM).parent_path().string() +
                                                 "':$PATH\n" + line + "\n");
        const test::Outcome outcome = test::run_program("bash", (folder / "command").string());
        ASSERT_EQ(outcome.status, 0) << line << "\n" << outcome.output;
        ++lines_run;
      }
    } else {
      EXPECT_EQ(block.kind, "");  // what the program says
    }
  }
  EXPECT_EQ(studies, 1);
  EXPECT_EQ(by_hand, 1);
  EXPECT_GE(lines_run, 6);
  EXPECT_TRUE(fs::is_regular_file(folder / "my_set" / "contact-receiver.png"));
  EXPECT_THAT(test::read_text(folder / "report" / "report.html"), HasSubstr("20 simulated observers"));
}

}  // namespace
}  // namespace seamline
