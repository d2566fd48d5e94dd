// A command that is refused has read everything before it makes anything: nothing lies where its output was
// to be, and so nothing stands in the way of the next try.
#include <algorithm>

#include "refusal.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;

class LeavesNothing : public testing::TestWithParam<const char*> {};

std::string with_path(std::string arguments, const std::string& word, const fs::path& path) {
  for (std::size_t at = arguments.find(word); at != std::string::npos; at = arguments.find(word))
    arguments.replace(at, word.size(), path.string());
  return arguments;
}

TEST_P(LeavesNothing, WhereItsInputIsWrong) {
  const std::string arguments = GetParam();
  const fs::path folder =
      test::fresh_folder("leaves-nothing-" + std::to_string(std::hash<std::string>()(arguments)));
  test::write_text(folder / "junk.txt", "nothing that anybody reads\n");
  test::write_text(folder / "junk.png", "nothing that anybody reads\n");
  test::write_text(folder / "junk.exr", "nothing that anybody reads\n");
  fs::create_directories(folder / "empty");
  const fs::path out = folder / "out", quick = test::studies() / "quick.toml";
  std::string filled = arguments;
  for (const auto& [word, path] :
       {std::pair("JUNK", folder / "junk.txt"), std::pair("PNG", folder / "junk.png"),
        std::pair("EXR", folder / "junk.exr"), std::pair("EMPTY", folder / "empty"),
        std::pair("QUICK", quick), std::pair("OUT", out)})
    filled = with_path(filled, word, path);
  const test::Outcome outcome = test::run_seamline(filled);
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  EXPECT_THAT(outcome.output, testing::StartsWith("seamline: "));
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    EXPECT_FALSE(name.starts_with("out")) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    EveryCommand, LeavesNothing,
    testing::Values("render JUNK --out OUT", "check EMPTY --out OUT", "check EMPTY --out OUT --artists",
                    "study EMPTY --log OUT --observer perfect",
                    "study EMPTY --log OUT --participant p1 --pilot", "analyze JUNK --out OUT",
                    "log recover JUNK OUT", "log upgrade JUNK OUT", "export tables JUNK OUT",
                    "export web EMPTY OUT", "import OUT JUNK --set EMPTY", "freeze JUNK EMPTY --out OUT",
                    "record JUNK --preset tof_160x120 --out OUT",
                    "live EMPTY --headless --object builtin:teapot --out OUT",
                    "sense JUNK --sensor tof_160x120 --out OUT",
                    "register --depth EXR --colour PNG --camera tof_160x120 --out OUT",
                    "composite --background PNG --depth EXR --object builtin:teapot --out OUT.png",
                    "capture JUNK --out OUT.exr", "picture JUNK --out OUT.png", "mesh EXR --out OUT.glb",
                    "views PNG --max-depth 5 --fov 60 --out OUT",
                    "settle JUNK --sensor tof_160x120 --ball 0.1 --out OUT",
                    // What is found out only by the work itself: a body that nothing holds, no stimuli.
                    "settle builtin:bedroom --sensor tof_160x120 --ball 0.1 --position 0 -3 0 --out OUT/deep",
                    "job write QUICK --only none --parallel OUT/job --out OUT/set",
                    "job write QUICK --only none --slurm OUT/job --out OUT/set",
                    "relight JUNK --sensor tof_160x120 --out OUT", "convergence JUNK --only x --out OUT"));

}  // namespace
}  // namespace seamline
