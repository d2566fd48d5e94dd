// The first Ctrl-C or SIGTERM ends every command that can run longer than a second: status 130, one sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <csignal>
#include <regex>
#include <set>

#include "commands/options/command_help.h"
#include "commands/program.h"
#include "physics/rigid_world.h"
#include "registration/calibration/aruco.h"
#include "registration/calibration/opencv.h"
#include "run_program.h"
#include "running_program.h"
#include "support/files/assets.h"
#include "tests/app/picture_set.h"

namespace seamline {
namespace {

using study::RenderedSet;

using test::fresh_folder;
using test::run_seamline;
namespace fs = std::filesystem;

/// What the commands work on; each piece takes them much longer than the moment after which they are stopped.
struct Work {
  fs::path folder, set, long_set, log, small_log, lines, counts, depth, photograph, rig, rig_depth, frame,
      recording;
};

/// A set whose pictures go on for gigabytes after their last byte that says anything.
void write_long_set(const fs::path& folder) {
  const RenderedSet set = test::write_picture_set(folder, {.width_px = 64, .height_px = 48});
  fs::resize_file(set.folder / "room.png", std::uintmax_t{1} << 34U);
}

/// A large depth camera beside the photograph's.
void write_rig(const Work& work) {
  const auto camera = [](const char* name, int width, int height) {
    return fmt::format(
        "[{}]\nwidth_px = {}\nheight_px = {}\nfx_px = 2000\nfy_px = 2000\ncx_px = 960\n"
        "cy_px = 540\nk1 = -0.05\n",
        name, width, height);
  };
  test::write_text(work.rig, "format = \"seamline camera 1\"\nconvention = \"radial\"\n" +
                                 camera("depth", 4096, 3072) + camera("colour", 1920, 1080) +
                                 "[colour_from_depth]\ntranslation_m = [0.05, 0, 0]\n");
  write_exr(work.rig_depth, Image(4096, 3072, 1, 2.0F));
}

/// What a page would say whose participant opened it again and again.
void write_lines(const Work& work, const RenderedSet& set) {
  std::string lines;
  for (int i = 0; i < 200000; ++i)
    lines += fmt::format(
        "{{\"format\":\"seamline-online-1\",\"study_hash\":\"{}\",\"set_hash\":\"{}\",\"participant\":"
        "\"w-aaaaaaaaaaaaaaaa\",\"sequence\":{},\"id\":\"00000000-0000-4000-8000-{:012}\",\"kind\":\"begin\","
        "\"body\":{{\"user_agent\":\"x\"}}}}\n",
        set.manifest.study_hash, set.set_hash, i + 1, i);
  test::write_text(work.lines, lines);
}

const Work& work() {
  static const Work made = [] {
    const fs::path folder = fresh_folder("signals");
    Work work{.folder = folder,
              .set = folder / "set",
              .long_set = folder / "long-set",
              .log = folder / "log.sqlite",
              .small_log = folder / "small.sqlite",
              .lines = folder / "lines.jsonl",
              .counts = folder / "counts.csv",
              .depth = folder / "depth.exr",
              .photograph = folder / "photograph.exr",
              .rig = folder / "rig.toml",
              .rig_depth = folder / "rig-depth.exr",
              .frame = folder / "frame.png",
              .recording = folder / "recording"};
    const RenderedSet set = test::write_picture_set(
        work.set, {.width_px = 640, .height_px = 480, .widths = "64, 128, 256, 512, 1024, 2048, 4096, 8192"});
    write_long_set(work.long_set);
    write_lines(work, set);
    std::string counts = "level,correct,trials\n";
    for (int level = 1; level <= 2000; ++level) counts += fmt::format("{},{},60\n", level, 20 + level % 41);
    test::write_text(work.counts, counts);
    write_exr(work.photograph, Image(1920, 1080, 3, 0.5F));
    write_png(work.frame, display_image(Image(2048, 4096, 3, 0.5F)));
    write_rig(work);
    for (const std::string& made_by :
         {"study " + work.set.string() + " --observer guesser --count 12000 --log " + work.log.string(),
          "study " + work.set.string() + " --observer perfect --count 1 --log " + work.small_log.string(),
          "capture builtin:bedroom --width 4096 --out " + work.depth.string(),
          "record builtin:bedroom --preset tof_160x120 --frames 1 --spp 1 --bounces 0 --out " +
              work.recording.string()})
      if (const test::Outcome outcome = run_seamline(made_by); outcome.status != 0)
        throw std::runtime_error(outcome.output);
    return work;
  }();
  return made;
}

/// Forty scenes where the quick study has three.
fs::path study_of_many_scenes() {
  const fs::path file = work().folder / "many.toml";
  const std::string text = test::read_text(test::studies() / "quick.toml");
  const std::size_t scenes = text.find("[[scene]]"), end = text.find("[[scene]]", scenes + 1);
  const std::regex name("(\\[\\[scene\\]\\]\\s*name = \"[a-z]+)");
  std::string many = text.substr(0, scenes);
  for (int i = 0; i < 40; ++i)
    many += std::regex_replace(text.substr(scenes, end - scenes), name, "$1_" + std::to_string(i),
                               std::regex_constants::format_first_only);
  test::write_text(file, many);
  return file;
}

/// Every command, and which of its ways.
const std::vector<std::pair<std::string, std::string>> commands = {
    {"demo", ""},       {"render", ""},        {"job write", ""},       {"verify", ""},
    {"check", ""},      {"check", "set"},      {"lab convergence", ""}, {"capture", ""},
    {"mesh", ""},       {"composite", ""},     {"lab bench", ""},       {"study", "threshold"},
    {"study", "image"}, {"log status", ""},    {"log recover", ""},     {"analyze", ""},
    {"fit", "levels"},  {"fit", "bootstrap"},  {"predict", ""},         {"observe", ""},
    {"plan", ""},       {"lab stability", ""}, {"register", ""},        {"calibrate", ""},
    {"sense", ""},      {"picture", ""},       {"lab marker", ""},      {"views", ""},
    {"settle", ""},     {"relight", ""},       {"record", ""},          {"live", ""},
    {"export web", ""}, {"export tables", ""}, {"export x3d", ""},      {"lab person", ""},
    {"lab scenes", ""}, {"lab field", ""},     {"import", ""},          {"merge", ""},
    {"freeze", ""},     {"flip", ""},          {"animate", ""}};

/// A figure of one node, and where it was in 400 moments.
std::vector<std::string> recorded_figure(const fs::path& folder) {
  const std::string text = R"({"asset":{"version":"2.0"},"nodes":[{"name":"body"}]} )";
  const auto word = [](std::size_t number) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(number >> (8 * i) & 255U);
    return bytes;
  };
  test::write_text(folder / "figure.glb",
                   "glTF" + word(2) + word(20 + text.size()) + word(text.size()) + "JSON" + text);
  std::string rows = "time_s,joint,x_m,y_m,z_m\n";
  for (int i = 0; i < 400; ++i) rows += std::to_string(i) + ",body,0,1,0\n";
  test::write_text(folder / "joints.csv", rows);
  return {(folder / "figure.glb").string(), (folder / "joints.csv").string()};
}

std::vector<std::string> arguments_of(const std::string& command, const std::string& what) {
  const Work& at = work();
  const std::string out = (at.folder / ("out-" + command.substr(command.find(' ') + 1) + what)).string();
  const std::string quick = (test::studies() / "quick.toml").string();
  if (command == "demo") return {"--out", out};
  if (command == "job write") return {quick, "--out", out, "--parallel", out + "-job"};
  if (command == "render") return {quick, "--out", out, "--spp", "4096"};
  if (command == "verify") return {at.long_set.string()};
  if (command == "check" && what == "set") return {at.long_set.string()};
  if (command == "check") return {study_of_many_scenes().string()};
  if (command == "lab convergence")
    return {quick, "--only", "bedroom-receiver-statue-0064", "--out", out, "--seconds", "600"};
  if (command == "capture") return {"builtin:bedroom", "--width", "16384", "--out", out + ".exr"};
  if (command == "mesh") return {at.depth.string(), "--tolerance", "1e-7", "--out", out + ".glb"};
  if (command == "composite")
    return {"--background",
            at.photograph.string(),
            "--depth",
            at.depth.string(),
            "--object",
            "builtin:statue",
            "--position",
            "0",
            "-1",
            "-3",
            "--fov",
            "60",
            "--to-sun",
            "1",
            "1",
            "0.5",
            "--sun-irradiance",
            "8",
            "8",
            "7",
            "--environment",
            "0.5",
            "0.5",
            "0.6",
            "--spp",
            "4096",
            "--out",
            out + ".png"};
  if (command == "study")
    return {at.set.string(), "--log", out + ".sqlite", "--observer", what,
            "--gain",        "1",     "--count",       "1000000"};
  if (command == "log status") return {at.log.string()};
  if (command == "log recover") return {at.log.string(), out + ".sqlite"};
  if (command == "analyze") return {at.log.string(), "--out", out};
  if (command == "fit" && what == "levels") return {at.counts.string(), "--alternatives", "3"};
  if (command == "fit") return {at.counts.string(), "--alternatives", "3", "--bootstrap", "1000"};
  if (command == "predict") return {at.set.string()};
  if (command == "register")
    return {"--depth",  at.rig_depth.string(),
            "--colour", at.photograph.string(),
            "--camera", at.rig.string(),
            "--repair", "joint_bilateral",
            "--out",    out};
  if (command == "calibrate") {
    std::vector<std::string> arguments = {"--out", out, "--colour-pictures"};
    arguments.insert(arguments.end(), 200, at.photograph.string());
    return arguments;
  }
  if (command == "sense")
    return {"builtin:bedroom", "--sensor", "tof_160x120", "--spp", "4096", "--out", out};
  if (command == "settle")
    return {"builtin:bedroom",
            "--sensor",
            "structured_light_640x480",
            "--ball",
            "0.1",
            "--position",
            "0",
            "1",
            "0",
            "--frames",
            "100000",
            "--out",
            out};
  if (command == "relight")
    return {"builtin:bedroom", "--sensor", "structured_light_640x480", "--frames", "1000000", "--out", out};
  if (command == "record")
    return {"builtin:bedroom", "--preset", "tof_160x120", "--spp", "4096", "--out", out};
  if (command == "live")
    return {
        at.recording.string(), "--object", "builtin:statue", "--headless", "--time", "--frames", "1000000"};
  if (command == "import") return {out + ".sqlite", at.lines.string(), "--set", at.set.string()};
  if (command == "merge") return {at.small_log.string(), at.log.string()};
  if (command == "export x3d") return {"builtin:bedroom", out, "--object", "builtin:statue", "--spp", "4096"};
  if (command == "lab person") return {"--out", out};
  if (command == "lab scenes") return {"arcades", "--count", "99", "--out", out};
  if (command == "observe") return {};
  if (command == "lab field") return {"builtin:statue", "--out", out + ".png"};
  if (command == "export tables") return {at.log.string(), out};
  if (command == "export web") return {at.set.string(), out, "--pilot", "--slots", "9999"};
  if (command == "lab marker") return {"--spp", "4096", "--out", out};
  if (command == "picture") return {"builtin:bedroom", "--spp", "4096", "--out", out + ".png"};
  if (command == "views")
    return {at.frame.string(), "--max-depth", "5",     "--fov", "60", "--zero-parallax", "2",
            "--views",         "8",           "--out", out};
  if (command == "animate") {
    std::vector<std::string> words = recorded_figure(at.folder);
    words.insert(words.end(), {"--out", out + ".glb"});
    return words;
  }
  if (command == "flip") return {at.photograph.string(), at.photograph.string()};
  if (command == "freeze")
    return {quick, "--studies", "1000000", "--estimator", "straight-lines", "--out", out + ".json"};
  if (command == "plan") return {quick, "--studies", "1000000", "--estimator", "straight-lines"};
  return {};
}

/// The signal comes when the command asks for the n-th time whether to stop: in the middle of its work, which
/// asks oftener (`flip` some dozen times, the others hundreds of times).
int asks_before_the_signal(const std::string& command) {
  return command == "flip" || command == "observe" ? 10 : 100;
}

TEST(Signals, TheFirstEndsEveryCommand) {
  int signal = SIGTERM;
  for (const auto& [command, what] : commands) {
    // Without their libraries they end with their one sentence.
    if (command == "calibrate" && !registration::has_opencv()) continue;
    if (command == "lab marker" && !registration::has_aruco()) continue;
    if (command == "settle" && !renderer::has_physics()) continue;
    if ((command == "export web" || command == "export x3d") &&
        !fs::exists(command == "export x3d" ? web_page_folder().parent_path() / "x3d" / "x3dom.js"
                                            : web_page_folder() / "jspsych.js"))
      continue;
    signal = signal == SIGTERM ? SIGINT : SIGTERM;
    SCOPED_TRACE(command + " " + what);
    std::vector<std::string> arguments = test::words_of(command);
    for (const std::string& argument : arguments_of(command, what)) arguments.push_back(argument);
    const test::Running running =
        test::start(arguments, work().folder / (command + what + ".txt"), asks_before_the_signal(command));
    ASSERT_TRUE(test::stands_still(running))
        << "it asked less often whether to stop: " << test::read_text(running.output);
    EXPECT_EQ(test::status_after(running, signal), 130);
    EXPECT_THAT(test::read_text(running.output), testing::HasSubstr("seamline: stopped"));
    EXPECT_FALSE(fs::exists(work().folder / "out-write-job"));
  }
}

TEST(Signals, AreTriedOnEveryCommand) {
  std::set<std::string> tried;
  for (const auto& [command, what] : commands) tried.insert(command);
  tried.insert("place");  // a window, which needs a display
  // One step each, done or not.
  tried.merge(std::set<std::string>{"log exclude", "log forget", "log identifiers", "log forget-identifiers",
                                    "log backup", "log tracks", "log upgrade", "job status", "export video"});
  tried.insert("job piece");     // Cluster.* and ClusterScripts.*
  tried.insert("ask");           // it waits for lines, of which these commands get none: Ask.*
  tried.insert("lab evidence");  // other commands do its work, and are tried here
  tried.insert("serve");         // a signal is its only end, and a good one: tests/online
  std::set<std::string> listed;
  bool failed = false;
  const std::unique_ptr<CLI::App> app = program(failed);
  for (const NamedCommand& command : every_command(*app)) listed.insert(command.name);
  EXPECT_EQ(listed, tried);
}

}  // namespace
}  // namespace seamline
