// The tutorials do what they say: their files and commands, as they stand on the pages, in a folder that
// holds nothing but the scene; the studies in smaller pictures. Of what is done by hand, the server runs, and
// a participant answers it; windows are left out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "browser_person.h"
#include "pages.h"
#include "run_program.h"
#include "running_program.h"
#include "study/trials/rendered_set.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

const fs::path tutorials = fs::path(SEAMLINE_SOURCE_DIR) / "documentation/tutorials";

/// Smaller pictures of fewer samples: what the commands do does not depend on them.
std::string smaller(std::string text) {
  const std::vector<std::pair<std::string, std::string>> replacements = {
      {"width_px = 480", "width_px = 96"},
      {"height_px = 270", "height_px = 54"},
      {"samples_per_pixel = 16", "samples_per_pixel = 2\nmesh_tolerance = 1e-2"},
      {"--width 1024 --height 512 --spp 64", "--width 256 --height 128 --spp 4"},
      {"--view 480x270", "--spp 2 --view 96x54"},
      {"--studies 50", "--studies 10"}};
  for (const auto& [from, to] : replacements)
    if (const std::size_t at = text.find(from); at != std::string::npos) text.replace(at, from.size(), to);
  return text;
}

void run_line(const fs::path& folder, const std::string& line) {
  test::write_text(folder / "command", "set -e\ncd '" + folder.string() + "'\nPATH='" +
                                           fs::path(SEAMLINE_PROGRAM).parent_path().string() + "':$PATH\n" +
                                           smaller(line) + "\n");
  const test::Outcome outcome = test::run_program("bash", (folder / "command").string());
  ASSERT_EQ(outcome.status, 0) << line << "\n" << outcome.output;
}

/// The port that a server says, once it does.
int port_of(const test::Running& server) {
  const std::string before = "at http://127.0.0.1:";
  for (int look = 0; look < 20000; ++look) {
    const std::string said = test::read_text(server.output);
    const std::size_t at = said.find(before), end = said.find("/ into", at);
    if (at != std::string::npos && end != std::string::npos)
      return std::stoi(said.substr(at + before.size(), end - at - before.size()));
    ::usleep(1000);
  }
  return 0;
}

/// Serves as the line says, at any free port of this machine. Who has an invitation comes on another day.
void serve_line(const fs::path& folder, const std::string& line) {
  std::istringstream words(line);
  std::vector<std::string> arguments;
  std::string word;
  for (words >> word; words >> word;)
    arguments.push_back(word.starts_with("192.168.")                             ? "127.0.0.1"
                        : fs::exists(folder / word) || word.ends_with(".sqlite") ? (folder / word).string()
                                                                                 : word);
  arguments.insert(arguments.end(), {"--port", "0"});
  const test::Running server = test::start(arguments, folder / "served");
  if (const int port = port_of(server); port == 0)
    ADD_FAILURE() << line << "\n" << test::read_text(server.output);
  else if (line.find("--tokens") == std::string::npos) {
    const study::RenderedSet set = study::load_rendered_set(folder / "my_set");
    test::answer_in_browser({.set = &set, .number = 1, .pilot = true}, port);
  }
  EXPECT_EQ(test::status_after(server, SIGINT), 0) << test::read_text(server.output);
}

/// Does what a page says. Behind a fence stands what its block is: `sh` for commands, `sh by hand` for those
/// that need a person, `toml FILE` and `csv FILE` for a file to write, `toml append FILE` for lines to add to
/// one, nothing for what the program says.
void follow(const std::string& page, const fs::path& folder) {
  int lines_run = 0;
  for (const test::PageBlock& block : test::read_manual_page(tutorials / page).blocks) {
    std::istringstream words(block.kind);
    std::string language, name;
    words >> language >> name;
    if (language == "toml" || language == "csv") {
      const bool append = name == "append";
      if (append) words >> name;
      ASSERT_NE(name, "") << page << ": a file without a name";
      const fs::path file = folder / name;
      test::write_text(file, (append ? test::read_text(file) + "\n" : "") + smaller(block.text));
    } else if (block.kind == "sh") {
      std::istringstream lines(block.text);
      for (std::string line; std::getline(lines, line); ++lines_run) run_line(folder, line);
    } else if (block.kind == "sh by hand" && block.text.starts_with("seamline serve ")) {
      serve_line(folder, block.text);
    } else {
      EXPECT_TRUE(block.kind.empty() || block.kind == "sh by hand") << page << ": " << block.kind;
    }
  }
  EXPECT_GE(lines_run, 2) << page;
}

TEST(Tutorial, AStudyGoesFromAnEmptyFolderThroughLabAndBrowserToAReport) {
  const fs::path folder = test::fresh_folder("tutorial");
  fs::copy(tutorials / "room/room.gltf", folder);
  follow("first_study.md", folder);
  EXPECT_TRUE(fs::is_regular_file(folder / "my_set" / "contact-receiver.png"));
  EXPECT_THAT(test::read_text(folder / "report" / "report.html"), HasSubstr("20 simulated observers"));
  follow("lab_session.md", folder);
  EXPECT_THAT(test::read_text(folder / "people_report" / "report.html"), HasSubstr("18 simulated observers"));
  follow("online_study.md", folder);
  EXPECT_THAT(test::read_text(folder / "web_report" / "report.html"), HasSubstr("1 participant"));
  EXPECT_TRUE(fs::is_regular_file(folder / "both_report" / "report.html"));
}

TEST(Tutorial, AnObjectComesIntoAPhotograph) {
  const fs::path folder = test::fresh_folder("tutorial-photograph");
  follow("object_in_photograph.md", folder);
  EXPECT_TRUE(fs::is_regular_file(folder / "seamless.png"));
}

TEST(Tutorial, CountsBecomeAThreshold) {
  follow("counts_to_threshold.md", test::fresh_folder("tutorial-counts"));
}

}  // namespace
}  // namespace seamline
