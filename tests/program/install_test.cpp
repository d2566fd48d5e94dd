// The program installed like other software: it finds its own files wherever it lies, manual pages are
// without a warning, and completion knows every command and option.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <regex>
#include <set>

#include "commands/options/command_help.h"
#include "commands/program.h"
#include "run_program.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::fresh_folder;
using test::Outcome;
using test::run_program;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

const fs::path build_folder = SEAMLINE_BUILD_DIR;
const fs::path manual = build_folder / "manual";

/// A folder for each test: two of them may run at once.
Outcome run_shell(const std::string& script) {
  const fs::path folder =
      fresh_folder(std::string("shell-") + testing::UnitTest::GetInstance()->current_test_info()->name());
  test::write_text(folder / "run", script);
  return run_program("bash", (folder / "run").string());
}

void install_into(const fs::path& prefix) {
  const Outcome outcome = run_program(
      SEAMLINE_CMAKE, "--install " + build_folder.string() + " --strip --prefix " + prefix.string());
  ASSERT_EQ(outcome.status, 0) << outcome.output;
}

TEST(Install, EveryPartIsWhereOtherSoftwareHasIt) {
  const fs::path prefix = fresh_folder("install-parts");
  install_into(prefix);
  for (const auto& entry : fs::recursive_directory_iterator(prefix)) {
    const std::string name = entry.path().filename().string();
    EXPECT_FALSE(name == "CMakeFiles" || name.ends_with(".a") || name.ends_with(".o")) << entry.path();
  }
  for (const char* part :
       {"bin/seamline", "lib/seamline/seamline_pictures.so", "share/seamline/scenes/builtin/bedroom.glb",
        "share/seamline/stimuli/quick.toml", "share/seamline/stimuli/depth_resolution.toml",
        "share/doc/seamline/README.md", "share/doc/seamline/LICENSE", "share/doc/seamline/CHANGELOG.md",
        "share/doc/seamline/documentation/reference/study_file.md",
        "share/doc/seamline/documentation/pictures/readme.png", "share/man/man1/seamline.1.gz",
        "share/man/man1/seamline-render.1.gz", "share/doc/seamline/changelog.gz",
        "share/bash-completion/completions/seamline"})
    EXPECT_TRUE(fs::is_regular_file(prefix / part)) << part;
  std::set<std::string> in_stimuli;  // no sources
  for (const auto& entry : fs::directory_iterator(prefix / "share/seamline/stimuli"))
    in_stimuli.insert(entry.path().extension().string());
  EXPECT_EQ(in_stimuli, (std::set<std::string>{"", ".toml"})) << "study files, and the folder texts";
  EXPECT_TRUE(fs::is_regular_file(prefix / "share/seamline/stimuli/texts/de.toml"));
}

TEST(Install, FindsItsOwnFilesFromAnyFolderThroughLinksAndBesideAnother) {
  const fs::path folder = fresh_folder("install-two"), one = folder / "one", two = folder / "two";
  install_into(one);
  fs::copy(one, two, fs::copy_options::recursive);
  // Both studies are broken, so that the demo says at once which it reads; the second lacks a scene; the
  // current folder holds what must not be believed.
  for (const fs::path& place : {one, two})
    test::write_text(place / "share/seamline/stimuli/quick.toml", "format = 1\n");
  fs::remove(two / "share/seamline/scenes/builtin/lion.glb");
  const fs::path current = folder / "current", links = folder / "links";
  for (const char* trap : {"stimuli", "share/seamline/stimuli", "scenes/builtin"})
    fs::create_directories(current / trap);
  for (const char* trap : {"stimuli/quick.toml", "share/seamline/stimuli/quick.toml"})
    test::write_text(current / trap, "format = 2\n");
  fs::create_directories(links / "deep");
  fs::create_symlink(one / "bin/seamline", links / "first");
  fs::create_symlink("../first", links / "deep/seamline");
  fs::create_directory_symlink(two, links / "whole");

  const auto said = [&](const std::string& command) {
    return run_shell("cd " + current.string() + "\n" + command + "\n").output;
  };
  const auto of = [](const std::string& place) {  // the broken study that is complained about
    return HasSubstr("/" + place + "/share/seamline/stimuli/quick.toml: ");
  };
  const std::string lion = " capture builtin:lion --at 0 1 5 --width 16 --out depth.exr";
  const std::string on_path = "PATH=" + (links / "deep").string() + ":$PATH; seamline";
  EXPECT_THAT(said((one / "bin/seamline").string() + " demo"), of("one"));
  EXPECT_THAT(said((links / "first").string() + " demo"), of("one"));
  EXPECT_THAT(said(on_path + " demo"), of("one"));
  EXPECT_THAT(said((two / "bin/seamline").string() + " demo"), of("two"));
  EXPECT_THAT(said((links / "whole/bin/seamline").string() + " demo"), of("two"));
  EXPECT_THAT(said("HOME=/nowhere XDG_DATA_HOME=. env -i ../one/bin/seamline demo"), of("one"));

  EXPECT_THAT(said(on_path + lion), Not(HasSubstr("wanted")));
  EXPECT_TRUE(fs::is_regular_file(current / "depth.exr"));
  EXPECT_THAT(said((two / "bin/seamline").string() + lion), HasSubstr("wanted a built-in scene or object"));
  // Moved whole, it is another place and the same installation.
  fs::rename(one, folder / "moved");
  EXPECT_THAT(said("../moved/bin/seamline demo"), of("moved"));
}

TEST(Install, PicturesThatAreNotPlainNeedTheirLibraryAndNothingElseDoes) {
  const fs::path folder = fresh_folder("install-pictures"), prefix = folder / "prefix";
  install_into(prefix);
  const fs::path library = prefix / "lib/seamline/seamline_pictures.so";
  const std::string program = (prefix / "bin/seamline").string(), radiance = (folder / "one.hdr").string();
  test::write_text(radiance, "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 1\n\x40\x40\x40\x80");
  const std::string look = program + " flip " + radiance + " " + radiance;
  const Outcome whole = run_shell(look);
  EXPECT_EQ(whole.status, 0) << whole.output;
  fs::remove(library);
  EXPECT_THAT(run_shell(look).output, HasSubstr(library.string() + ": wanted Seamline's own library"));
  EXPECT_EQ(run_shell(look).status, 1);
  const Outcome plain = run_shell(program + " capture builtin:lion --at 0 1 5 --width 16 --out " +
                                  (folder / "depth.exr").string());
  EXPECT_EQ(plain.status, 0) << plain.output;
  test::write_text(library, std::string(1000, 'x'));
  EXPECT_THAT(run_shell(look).output, HasSubstr("invalid ELF header"));
}

/// "" is the program itself.
std::string manual_page_of(const std::string& command) {
  return "seamline" + std::string(command.empty() ? "" : "-") +
         std::regex_replace(command, std::regex(" "), "-");
}

TEST(Manual, APageForEveryCommandWithoutAWarning) {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  std::set<std::string> pages = {"seamline"};
  for (const auto& [name, command] : every_command(*app)) pages.insert(manual_page_of(name));
  std::set<std::string> found;
  for (const auto& entry : fs::directory_iterator(manual / "man1")) {
    found.insert(entry.path().stem().string());
    const Outcome outcome =
        run_program("bash", "-c 'groff -ww -man -Tutf8 " + entry.path().string() + " 2>&1 >/dev/null'");
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_EQ(outcome.output, "") << entry.path();
  }
  EXPECT_EQ(found, pages);
}

/// Options that --help shows, by command; those of the program itself under "".
std::map<std::string, std::vector<std::string>> options_by_command() {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  std::map<std::string, std::vector<std::string>> options;
  const auto add = [&](const CLI::App& command, const std::string& name) {
    for (const CLI::Option* option : command.get_options())
      if (!option->get_positional() && !option->get_group().empty())
        options[name].push_back("--" + option->get_single_name());
  };
  add(*app, "");
  for (const auto& [name, command] : every_command(*app)) add(*command, name);
  return options;
}

TEST(Manual, EveryOptionOfEveryCommandIsOnItsPage) {
  for (const auto& [command, options] : options_by_command()) {
    const std::string name = manual_page_of(command) + ".1";
    const Outcome page =
        run_program("groff", "-man -Tascii -P-c -P-b -P-u -P-o " + (manual / "man1" / name).string());
    for (const std::string& option : options) EXPECT_THAT(page.output, HasSubstr(option)) << name;
  }
}

/// What bash would propose for the last of these words.
std::vector<std::string> completed(const std::string& words) {
  const Outcome outcome = run_shell(". " + (manual / "seamline.bash").string() + "\nCOMP_WORDS=(" + words +
                                    ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_seamline\n" +
                                    "printf '%s\\n' \"${COMPREPLY[@]}\"\n");
  std::istringstream lines(outcome.output);
  std::vector<std::string> proposals;
  for (std::string line; std::getline(lines, line);)
    if (!line.empty()) proposals.push_back(line);
  return proposals;
}

TEST(Completion, KnowsEveryCommandAndEveryOption) {
  std::set<std::string> commands;
  for (const auto& [command, options] : options_by_command()) {
    if (!command.empty()) commands.insert(command.substr(0, command.find(' ')));
    EXPECT_THAT(completed("seamline " + command + (command.empty() ? "" : " ") + "--"), IsSupersetOf(options))
        << command;
  }
  EXPECT_GE(commands.size(), 16U);
  EXPECT_THAT(completed("seamline ''"), IsSupersetOf(commands));
}

TEST(Completion, ProposesWordsWherePathsMakeNoSense) {
  using testing::ElementsAre;
  EXPECT_THAT(completed("seamline rend"), ElementsAre("render"));
  EXPECT_THAT(completed("seamline lab con"), ElementsAre("convergence"));
  EXPECT_THAT(completed("seamline render my.toml --con"), ElementsAre("--contact-sheet"));
  EXPECT_THAT(completed("seamline render --estimator ''"), ElementsAre("fast", "path"));
  EXPECT_THAT(completed("seamline render --mesh = f"), ElementsAre("full"));
  EXPECT_THAT(completed("seamline render --out -"), ElementsAre());  // bash proposes paths
  EXPECT_THAT(completed("seamline render ''"), ElementsAre());
}

TEST(Install, TheProgramsOwnReaderOfGltfIsTheFirstThatIsLoaded) {
  // Debian's libdraco exports a tinygltf of another shape: loaded first, it would answer for ours.
  const std::string libraries = run_program("readelf", std::string("-d ") + SEAMLINE_PROGRAM).output;
  const std::size_t ours = libraries.find("libtinygltf"), other = libraries.find("libdraco");
  ASSERT_NE(ours, std::string::npos) << libraries;
  EXPECT_TRUE(other == std::string::npos || ours < other);
}

}  // namespace
}  // namespace seamline
