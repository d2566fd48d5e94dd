// Output that cannot be written: every command still does its work, says so in one sentence and ends with
// status 1. The program's own list of commands is walked, and every command does some real work; `demo` does
// in demo_test.cpp.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <map>
#include <set>

#include "commands/options/command_help.h"
#include "commands/program.h"
#include "physics/rigid_world.h"
#include "registration/calibration/aruco.h"
#include "run_program.h"
#include "running_program.h"
#include "study/online/messages/message_writer.h"
#include "support/files/assets.h"
#include "support/files/image.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::Outcome;
using test::Outputs;
using test::run_seamline;

class LostOutput : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder() = test::fresh_folder("lost-output");
    const study::RenderedSet set = test::write_picture_set(folder() / "set", {});
    write_inputs(set);
    test::write_small_study(folder(), test::small_study_with({{"[64, 256, 512, 1024, 2048]", "[64, 512]"}}));
    for (const char* made_by :
         {"study {set} --observer threshold --count 5 --log {log}",
          "study {set} --observer threshold --count 1 --log {in}/other.sqlite",
          "capture builtin:bedroom --width 256 --out {in}/depth.exr",
          "sense builtin:bedroom --sensor tof_160x120 --spp 1 --bounces 0 --out {in}/sensed",
          "record builtin:bedroom --preset tof_160x120 --frames 1 --spp 1 --bounces 0 "
          "--out {in}/recording"})
      if (const Outcome outcome = run_seamline(filled(made_by, "made")); outcome.status != 0)
        throw std::runtime_error(outcome.output);
  }

  static void write_inputs(const study::RenderedSet& set) {
    test::write_text(folder() / "counts.csv", "level,correct,trials\n1,20,60\n2,30,60\n3,50,60\n4,58,60\n");
    write_exr(folder() / "photograph.exr", Image(32, 24, 3, 0.5F));
    write_png(folder() / "frame.png", display_image(Image(32, 12, 3, 0.5F)));
    test::write_text(folder() / "line.jsonl",
                     study::online::message_line({.study_hash = set.manifest.study_hash,
                                                  .set_hash = set.set_hash,
                                                  .participant = {},
                                                  .sequence = 0,
                                                  .id = "00000000-0000-4000-8000-000000000000",
                                                  .body = study::online::DeclineBody{}}) +
                         "\n");
    test::write_text(
        folder() / "known.toml",
        "format = \"seamline camera 1\"\n[colour]\nwidth_px = 320\nheight_px = 240\nfx_px = 300\n"
        "fy_px = 300\ncx_px = 160\ncy_px = 120\n");
    std::string pairs = "u,v,x,y,z,confidence\n";
    for (int i = 0; i < 12; ++i) {
      const double x_m = 0.3 * (i % 3 - 1), y_m = 0.2 * (i % 2), z_m = 1 + 0.1 * i;
      pairs += fmt::format("{},{},{},{},{},1\n", 160 + 300 * x_m / z_m, 120 + 300 * y_m / z_m, x_m, y_m, z_m);
    }
    test::write_text(folder() / "pairs.csv", pairs);
  }

  static fs::path& folder() {
    static fs::path made;
    return made;
  }

  /// The places that a command line names; `{out}` is new for every `run`.
  static std::string filled(std::string line, const std::string& run) {
    const std::map<std::string, fs::path> places = {{"{in}", folder()},
                                                    {"{set}", folder() / "set"},
                                                    {"{log}", folder() / "log.sqlite"},
                                                    {"{study}", folder() / "study.toml"},
                                                    {"{quick}", test::studies() / "quick.toml"},
                                                    {"{out}", folder() / ("out-" + run)}};
    for (const auto& [name, path] : places)
      for (std::size_t at = line.find(name); at != std::string::npos; at = line.find(name))
        line.replace(at, name.size(), path.string());
    return line;
  }
};

/// A short way of every command but `demo`; each prints something. `serve` has another one below, and `place`
/// is a window.
const std::map<std::string, std::string> short_ways = {
    {"render", "{study} --only bedroom-receiver-statue-0064 --spp 1 --out {out}"},
    {"verify", "{set}"},
    {"check", "{quick}"},
    {"capture", "builtin:bedroom --width 64 --out {out}.exr"},
    {"mesh", "{in}/depth.exr --tolerance 1e-2 --out {out}.glb"},
    {"composite",
     "--background {in}/photograph.exr --depth {in}/depth.exr --object builtin:teapot --position 0 -1 -3 "
     "--fov 60 --to-sun 1 1 0.5 --sun-irradiance 8 8 7 --environment 0.5 0.5 0.6 --spp 1 --out {out}.png"},
    {"picture", "builtin:statue --environment 1 1 1 --width 16 --height 9 --spp 1 --out {out}.png"},
    {"animate", "--help"},
    {"flip", "{in}/photograph.exr {in}/photograph.exr"},
    {"study", "{set} --observer perfect --count 1 --log {out}.sqlite"},
    {"log status", "{log}"},
    {"log backup", "{log} {out}.sqlite"},
    {"log recover", "{log} {out}.sqlite"},
    {"log tracks", "--help"},
    {"log exclude", "--help"},
    {"log forget", "--help"},
    {"log identifiers", "--help"},
    {"log forget-identifiers", "--help"},
    {"log upgrade", "--help"},
    {"job write", "--help"},
    {"job piece", "--help"},
    {"job status", "{set}"},
    {"analyze", "{log} --bootstrap 100 --out {out}"},
    {"fit", "{in}/counts.csv --alternatives 3 --json"},
    {"predict", "{set} --gain 1"},
    {"plan", "{study} --studies 1"},
    {"freeze", "{study} --participants 5 --why enough --out {out}.json"},
    {"sense", "builtin:bedroom --sensor tof_160x120 --spp 1 --bounces 0 --out {out}"},
    {"register",
     "--depth {in}/sensed/depth.exr --colour {in}/sensed/colour.exr --camera {in}/sensed/camera.toml --out "
     "{out}"},
    {"record", "builtin:bedroom --preset tof_160x120 --frames 1 --spp 1 --bounces 0 --out {out}"},
    {"live", "{in}/recording --object builtin:teapot --headless --time --frames 1 --size 32x24"},
    {"relight", "builtin:bedroom --sensor tof_160x120 --frames 2 --out {out}"},
    {"export tables", "{log} {out} --layout bids"},
    {"export web", "--help"},
    {"export video", "--help"},
    {"export x3d", "--help"},
    {"lab stability", "--list"},
    {"lab convergence",
     "{study} --only bedroom-receiver-statue-0064 --parts mesh --tolerances 1e-2 --spp 2 --size 32x18 --out {out}"},
    {"views", "{in}/frame.png --max-depth 5 --fov 60 --zero-parallax 2 --views 2 --out {out}"},
    {"settle",
     "builtin:bedroom --sensor tof_160x120 --ball 0.1 --position 0 1 0 --frames 2 --frames-to-rest 0 --out {out}"},
    {"lab marker", "--spp 1 --frames 1 --noise 0 --out {out}"},
    {"lab person", "--sensor tof_160x120 --out {out}"},
    {"lab scenes", "arcades --count 1 --out {out}"},
    {"observe", "--help"},
    {"lab field", "{in}/cube.gltf --out {out}.png"},
    {"lab evidence", ""},
    {"lab bench", "--quick --only capture --threads 1"},
    {"ask", "{study} --log {out}.sqlite --participant p01"},
    {"serve", "--make-tokens 1 --tokens {out}"},
    {"import", "{out}.sqlite {in}/line.jsonl --set {set}"},
    {"merge", "{in}/other.sqlite {log}"},
    {"calibrate", "--pairs {in}/pairs.csv --camera {in}/known.toml --out {out}"},
};

/// The way of a command where this program has the library that it needs; else, and without one, its help.
std::string way_of(const std::string& command) {
  const auto way = short_ways.find(command);
  const bool lacks = (command == "lab marker" && !registration::has_aruco()) ||
                     (command == "settle" && !renderer::has_physics());
  return way == short_ways.end() || lacks ? "--help" : way->second;
}

std::vector<std::string> command_names() {
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  std::vector<std::string> names = {""};
  for (const NamedCommand& command : seamline::every_command(*app)) names.push_back(command.name);
  return names;
}

TEST_F(LostOutput, EndsEveryCommandWithOneSentence) {
  for (const std::string& command : command_names())
    for (const Outputs outputs : {Outputs::full, Outputs::closed, Outputs::both_closed}) {
      const std::string run =
          command.substr(command.find(' ') + 1) + "-" + std::to_string(static_cast<int>(outputs));
      const Outcome outcome = run_seamline(command + " " + filled(way_of(command), run), outputs);
      SCOPED_TRACE(run);
      EXPECT_EQ(outcome.status, 1) << outcome.output;
      if (outputs == Outputs::both_closed) continue;  // nobody can be told
      EXPECT_THAT(
          outcome.output,
          testing::EndsWith(std::string("seamline: standard output: wanted a place that takes all that "
                                        "is printed, found ") +
                            (outputs == Outputs::full ? "No space left on device\n" : "it closed\n")));
      EXPECT_EQ(outcome.output.find("bug in seamline"), std::string::npos);
    }
}

TEST_F(LostOutput, OnlyAWindowAndTheDemoAreNotTriedHere) {
  std::set<std::string> untried;
  for (const std::string& command : command_names())
    if (!short_ways.contains(command)) untried.insert(command);
  EXPECT_EQ(untried, (std::set<std::string>{"", "demo", "place"}));
}

TEST_F(LostOutput, AServerServesOnAndSaysSoAtItsEnd) {
  if (!fs::exists(web_page_folder() / "jspsych.js"))
    return;  // built without its page: `export --web` says so
  const Outcome page = run_seamline(filled("export web {set} {in}/site --serve --pilot --slots 1", "site"));
  ASSERT_EQ(page.status, 0) << page.output;
  const auto line = [&](const char* text) { return filled(text, "served"); };
  const test::Running server = test::start(
      {"serve", line("{in}/site"), "--log", line("{out}.sqlite"), "--set", line("{set}"), "--port", "0"},
      folder() / "serve.txt", 3, "/dev/full");
  ASSERT_TRUE(test::stands_still(server)) << test::read_text(server.output);
  EXPECT_EQ(test::status_after(server, SIGTERM), 1);
  EXPECT_THAT(test::read_text(server.output), testing::HasSubstr("found No space left on device"));
}

/// Without those that say how long it took.
std::map<std::string, std::string> files_of(const fs::path& folder) {
  const std::set<std::string> timed = {"timings.json", "errors.csv", "errors.html"};
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && !timed.contains(entry.path().filename().string()))
      files[fs::relative(entry.path(), folder).string()] = test::read_text(entry.path());
  return files;
}

TEST_F(LostOutput, LeavesTheSameFilesToTheByte) {
  // With both closed, files of theirs would get the numbers 1 and 2 and take what is printed.
  for (const std::string command : {"render", "record", "sense", "relight"}) {
    SCOPED_TRACE(command);
    std::map<std::string, std::string> kept;
    for (const Outputs outputs : {Outputs::kept, Outputs::full, Outputs::both_closed}) {
      const std::string run =
          command.substr(command.find(' ') + 1) + "-" + std::to_string(static_cast<int>(outputs)) + "-files";
      const Outcome outcome = run_seamline(command + " " + filled(short_ways.at(command), run), outputs);
      EXPECT_EQ(outcome.status, outputs == Outputs::kept ? 0 : 1) << outcome.output;
      const auto files = files_of(folder() / ("out-" + run));
      if (outputs == Outputs::kept) kept = files;
      EXPECT_GT(files.size(), 1U);
      EXPECT_EQ(files, kept);
    }
  }
}

}  // namespace
}  // namespace seamline
