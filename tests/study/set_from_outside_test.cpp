// Whatever a manifest says: the set is refused in a sentence, or people can answer to it. Never a bug of
// ours.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "study/log/log.h"
#include "study/running/simulation.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::HasSubstr;

class SetFromOutside : public testing::Test {
 protected:
  const TemporaryFolder folder_;
  const fs::path set_ = folder_ / "set", log_ = folder_ / "log.sqlite";
  std::string manifest_;

  void SetUp() override {
    RenderedSet set = write_set(set_, "64");
    set.manifest.stimuli.resize(2);
    set.manifest.references = {{"bedroom", "a.png", "b.png", "1", "2"}};
    write_manifest(set_, set.manifest);
    manifest_ = read_file(set_ / "manifest.json");
  }
  /// What is said when people answer to the set; throws whatever is a bug of ours.
  [[nodiscard]] std::string tried(const std::string& manifest) const {
    write_file_atomically(set_ / "manifest.json", manifest);
    const std::string said = complaint_of([&] {
      run_simulated_study({.set_folder = set_, .log = log_, .count = 1, .seed = 3});
      (void)read_log(log_);
    });
    fs::remove(log_);
    return said;
  }
};

TEST_F(SetFromOutside, EveryValueOfAManifestIsAnsweredToOrRefusedInASentence) {
  const std::regex leaf(R"(^(\s*"[a-z0-9_]+": )([^{\[]*?)(,?)$)");
  std::vector<std::string> lines;
  std::istringstream text(manifest_);
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  int tries = 0, refused = 0;
  for (std::size_t at = 0; at < lines.size(); ++at) {
    std::smatch parts;
    if (!std::regex_match(lines[at], parts, leaf)) continue;
    for (const char* value : {R"("")", R"("\u0000")", R"("a\u0000b")", R"("\u001b[31m")", "-1", "0", "3",
                              "65", "1e308", "9223372036854775807", "null", "true", "[]", "{}"}) {
      std::string changed;
      for (std::size_t i = 0; i < lines.size(); ++i)
        changed += (i == at ? parts[1].str() + value + parts[3].str() : lines[i]) + "\n";
      std::string said;
      ASSERT_NO_THROW(said = tried(changed)) << lines[at] << " <- " << value;
      ++tries;
      refused += said == "no complaint" ? 0 : 1;
    }
  }
  EXPECT_GE(tries, 600);
  EXPECT_GE(refused, tries / 2);
  EXPECT_EQ(tried(manifest_), "no complaint");
}

TEST_F(SetFromOutside, AnIdTwiceAndAnOddWidthAreRefused) {
  const Manifest sound = read_manifest(set_);
  Manifest twice = sound;
  twice.stimuli[1].id = twice.stimuli[0].id;
  write_manifest(set_, twice);
  EXPECT_THAT(tried(read_file(set_ / "manifest.json")),
              HasSubstr("stimuli[1].id: wanted an id that no other"));
  Manifest odd = sound;
  odd.stimuli[1].stimulus.depth.width_px = 65;
  write_manifest(set_, odd);
  EXPECT_THAT(tried(read_file(set_ / "manifest.json")),
              HasSubstr("stimuli[1].condition.depth_width_px: wanted an even number, found 65"));
}

}  // namespace
}  // namespace seamline::study
