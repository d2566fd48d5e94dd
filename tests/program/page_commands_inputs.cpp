#include "page_commands_inputs.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <functional>
#include <map>
#include <stdexcept>
#include <vector>

#include "page_commands_files.h"
#include "page_commands_photographs.h"
#include "page_commands_steps.h"
#include "study/running/simulation.h"
#include "support/files/assets.h"
#include "tests/online/online_people.h"
#include "tests/study/schema_2_log.h"

namespace seamline::page_commands {
namespace {

namespace fs = std::filesystem;
using test::read_text;
using test::write_text;

const fs::path sources = SEAMLINE_SOURCE_DIR;

fs::path made(const std::string& name);

/// The first block of a page that begins so.
std::string block_of(const std::string& page, const std::string& beginning) {
  for (const test::PageBlock& block : test::pages().at("documentation/" + page).blocks)
    if (block.text.starts_with(beginning)) return block.text;
  throw std::runtime_error(page + " has no block that begins with " + beginning);
}

/// Runs the program; {name} is what was made under that name.
void run_for_input(std::string arguments, const fs::path& out) {
  for (std::size_t open = arguments.find('{'); open != std::string::npos; open = arguments.find('{')) {
    const std::size_t close = arguments.find('}', open);
    const std::string name = arguments.substr(open + 1, close - open - 1);
    arguments.replace(open, close - open + 1, "'" + (name == "out" ? out : made(name)).string() + "'");
  }
  const test::Outcome outcome = test::run_built(arguments);
  if (outcome.status != 0) throw std::runtime_error(arguments + ": " + outcome.output);
}

// ---- Studies, sets, logs ------------------------------------------------------------------------------

/// The bedroom of the quick study, at three widths, with a consent and a form of its
/// own. `keys`: lines of the top level, then tables.
std::string bedroom_study(const std::string& keys, const std::string& artifacts = R"("receiver")") {
  std::string text = smaller_study(test::quick_study_with({{"[64, 256, 512, 1024, 2048]", "[64, 512, 1024]"},
                                                           {R"("receiver")", artifacts}}),
                                   false);
  text.insert(text.find("[[scene]]"), keys + R"(
[consent]
text = "You will see pictures of a room, and say which object was inserted. We store your answers under a code."

[[form_field]]
name = "age"
label = "Your age"
kind = "number"
least = 18
most = 120

[[form_field]]
name = "gender"
label = "Your gender"
kind = "choice"
options = ["female", "male", "another"]

)");
  return text;
}

std::string study_of_page(const std::string& page, const std::string& beginning) {
  return bedroom_study(block_of(page, beginning));
}

/// A study in a language that Seamline has, with the texts that only the study itself can translate.
void make_language_study(const fs::path& folder) {
  fs::create_directories(folder);
  const std::string language = "[[language]]\ntag = \"de\"\ntexts = [\"builtin:de\", \"texts_de.toml\"]\n";
  const std::string untranslated =
      test::run_program(SEAMLINE_PROGRAM,
                        "study '" + made("set").string() + "' --print-texts --language de 2>/dev/null #")
          .output;
  write_text(folder / "texts_de.toml", untranslated);
  write_text(folder / "study.toml", bedroom_study(language));
}

/// What the page of one person would send, from a host of files.
std::string results_of(std::uint64_t person) {
  using namespace study::online;
  const study::RenderedSet set = study::load_rendered_set(made("set"));
  return lines_of(page_elsewhere(set, person).whole_stream());
}

void make_old_log(const fs::path& out) {
  const fs::path folder = out.string() + "-of";
  fs::create_directories(folder);
  (void)study::write_set_of_text(folder / "set", test::quick_study_with({}));
  (void)study::run_simulated_study(
      {.set_folder = folder / "set", .log = folder / "today.sqlite", .count = 5, .seed = 7});
  study::write_schema_2(folder / "today.sqlite", out);
}

// ---- Everything by its name ---------------------------------------------------------------------------

using Maker = std::function<void(const fs::path&)>;

Maker text_of(const std::function<std::string()>& text) {
  return [text](const fs::path& out) { write_text(out, text()); };
}

Maker by_program(const std::string& arguments) {
  return [arguments](const fs::path& out) { run_for_input(arguments, out); };
}

Maker builtin_file(const std::string& name) {
  return
      [name](const fs::path& out) { fs::copy_file(resolve_named_file("builtin:" + name, "--scene"), out); };
}

const std::string light_of_room = "--environment-map builtin:clear_sky --environment-rotation 163 --spp 4 ";

Maker set_of(const std::string& study) {
  return by_program("render {" + study + "} --spp 2 --out {out}");
}

const std::map<std::string, Maker>& makers() {
  static const std::map<std::string, Maker> table = {
      {"study.toml", text_of([] { return bedroom_study(""); })},
      {"occluded.toml", text_of([] { return bedroom_study("", R"("receiver", "occlusion")"); })},
      {"none.toml", text_of([] { return bedroom_study("", R"("none")"); })},
      {"adaptive.toml", text_of([] { return study_of_page("how-to/adaptive_placement.md", "procedure"); })},
      {"recruited.toml", text_of([] {
         return bedroom_study("[catch]\nattention = 2\n" +
                              block_of("how-to/recruitment.md", "[recruitment]"));
       })},
      {"match.toml", text_of([] { return study_of_page("how-to/match_the_level.md", "[task]"); })},
      {"yes_no.toml", text_of([] {
         return test::quick_study_with(
             {{"\n# Type 1", "\n[task]\nkind = \"yes_no\"\n[catch]\nreference = 2\n\n# Type 1"}});
       })},
      {"lights.toml", text_of([] { return read_text(sources / "stimuli/soft_light.toml"); })},
      {"language", make_language_study},
      {"set", set_of("study.toml")},
      {"occluded", set_of("occluded.toml")},
      {"none", set_of("none.toml")},
      {"adaptive", set_of("adaptive.toml")},
      {"recruited", set_of("recruited.toml")},
      {"languages",
       [](const fs::path& out) {
         run_for_input("render '" + (made("language") / "study.toml").string() + "' --spp 2 --out {out}",
                       out);
       }},
      {"log.sqlite", by_program("study {set} --log {out} --observer threshold --count 12 --seed 3")},
      {"one.sqlite", by_program("import {out} {one.jsonl} --set {set}")},
      {"two.sqlite", by_program("import {out} {two.jsonl} --set {set}")},
      {"three.sqlite", by_program("import {out} {three.jsonl} --set {set}")},
      {"one.jsonl", text_of([] { return results_of(1); })},
      {"two.jsonl", text_of([] { return results_of(2); })},
      {"three.jsonl", text_of([] { return results_of(3); })},
      {"old.sqlite", make_old_log},
      {"counts.csv", text_of([] {
         return "level,correct,trials\n64,29,30\n256,24,30\n512,17,30\n1024,11,30\n2048,10,30\n";
       })},
      {"room.gltf",
       [](const fs::path& out) { fs::copy_file(sources / "documentation/tutorials/room/room.gltf", out); }},
      {"panorama.exr", by_program("picture builtin:painted_room --panorama --width 128 --height 64 " +
                                  light_of_room + "--out {out}")},
      {"panorama.hdr", text_of([] { return hdr_of(read_image(made("panorama.exr"))); })},
      {"photograph.png",
       by_program("picture builtin:painted_room --width 320 --height 240 " + light_of_room + "--out {out}")},
      {"photograph.jpg", text_of([] { return jpeg_of(read_bytes_image(made("photograph.png"))); })},
      {"panorama_depth.exr", by_program("capture builtin:painted_room --width 128 --out {out}")},
      {"object.glb", builtin_file("teapot")},
      {"room.glb", builtin_file("furnished_room")},
      {"objects.toml", text_of([] { return block_of("how-to/composite.md", "[[object]]"); })},
      {"balls.toml", text_of([] { return block_of("papers/paper_000.md", "[[object]]"); })},
      {"gestures.toml", text_of([] { return block_of("how-to/clips.md", "format = \"seamline gestures"); })},
      {"published.csv",
       text_of([] { return block_of("how-to/compare_with_published.md", "artifact,quantity"); })},
      {"pairs.csv", text_of([] { return block_of("how-to/check_the_observer.md", "reference,picture"); })},
      {"pairs", make_pairs},
      {"figure.glb", text_of(jointed_figure)},
      {"joints.csv", text_of(recorded_joints)},
      {"street.jpg", text_of(street_photograph)},
      {"kitti.png", text_of(street_depth)},
      {"midas.png", text_of(street_inverse_depth)},
      {"kitti.txt", text_of(street_camera)},
      {"boards", make_board_pictures},
      {"known.toml", text_of([] {
         return "format = \"seamline camera 1\"\nconvention = \"planar\"\nmetres_per_step = 0.001\n";
       })},
      {"desk.toml", text_of(desk_camera)},
      {"desk.pgm", text_of(desk_depth)},
      {"frames", make_depth_frames},
      {"evidence", [](const fs::path& out) {
         fs::copy(sources / "documentation/evidence", out, fs::copy_options::recursive);
       }}};
  return table;
}

/// One process at a time makes one input.
class InputLock {
 public:
  explicit InputLock(const fs::path& file) : file_(::open(file.c_str(), O_CREAT | O_RDWR | O_CLOEXEC, 0644)) {
    if (file_ < 0 || ::flock(file_, LOCK_EX) != 0) throw std::runtime_error(file.string() + ": no lock");
  }
  ~InputLock() { ::close(file_); }
  InputLock(const InputLock&) = delete;
  InputLock& operator=(const InputLock&) = delete;

 private:
  int file_;
};

/// Where an input of that name is; it is made anew where the program or this test was built since.
fs::path made(const std::string& name) {
  const fs::path folder = fs::path(SEAMLINE_TEST_OUTPUT) / "page-inputs";
  fs::path out = folder / name / name;
  fs::create_directories(folder);
  const InputLock lock(folder / (name + ".lock"));
  const fs::path stamp = folder / (name + ".of");
  std::string programs;
  for (const char* program : {SEAMLINE_PROGRAM, "/proc/self/exe"})
    programs += std::to_string(fs::last_write_time(program).time_since_epoch().count()) + "\n";
  if (fs::exists(stamp) && read_text(stamp) == programs) return out;
  fs::remove_all(folder / name);
  fs::create_directories(folder / name);
  makers().at(name)(out);
  write_text(stamp, programs);
  return out;
}

/// What pages call an input.
struct InputName {
  const char *page, *word, *input;  ///< no page: on all others
};
constexpr InputName input_names[] = {{"how-to/predict_and_plan.md", "STUDY.toml", "lights.toml"},
                                     {"how-to/adaptive_placement.md", "SET", "adaptive"},
                                     {"how-to/recruitment.md", "SET", "recruited"},
                                     {"how-to/languages.md", "SET", "languages"},
                                     {"how-to/x3d.md", "my_set", "occluded"},
                                     {"how-to/gltf_files.md", "room.exr", "panorama_depth.exr"},
                                     {"papers/paper_000.md", "objects.toml", "balls.toml"},
                                     {"how-to/registration.md", "depth.pgm", "desk.pgm"},
                                     {"", "my_study.toml", "study.toml"},
                                     {"", "study.toml", "study.toml"},
                                     {"", "STUDY.toml", "study.toml"},
                                     {"", "match.toml", "match.toml"},
                                     {"", "YES_NO.toml", "yes_no.toml"},
                                     {"", "SET", "set"},
                                     {"", "my_set", "set"},
                                     {"", "NONE_SET", "none"},
                                     {"", "LOG.sqlite", "log.sqlite"},
                                     {"", "log.sqlite", "log.sqlite"},
                                     {"", "answers.sqlite", "log.sqlite"},
                                     {"", "people.sqlite", "log.sqlite"},
                                     {"", "station1.sqlite", "one.sqlite"},
                                     {"", "station2.sqlite", "two.sqlite"},
                                     {"", "station3.sqlite", "three.sqlite"},
                                     {"", "INTO.sqlite", "one.sqlite"},
                                     {"", "FROM.sqlite", "two.sqlite"},
                                     {"", "RESULTS", "three.jsonl"},
                                     {"", "OLD.sqlite", "old.sqlite"},
                                     {"", "DATA.csv", "counts.csv"},
                                     {"", "PAIRS.csv", "pairs.csv"},
                                     {"", "published.csv", "published.csv"},
                                     {"", "room.gltf", "room.gltf"},
                                     {"", "room.exr", "panorama.exr"},
                                     {"", "room.hdr", "panorama.hdr"},
                                     {"", "studio.hdr", "panorama.hdr"},
                                     {"", "room.jpg", "photograph.jpg"},
                                     {"", "photograph.png", "photograph.png"},
                                     {"", "room_depth.exr", "panorama_depth.exr"},
                                     {"", "depth.exr", "panorama_depth.exr"},
                                     {"", "vase.glb", "object.glb"},
                                     {"", "chair.glb", "object.glb"},
                                     {"", "plant.glb", "object.glb"},
                                     {"", "bust.glb", "object.glb"},
                                     {"", "statue.glb", "object.glb"},
                                     {"", "~/Downloads/lamp.glb", "object.glb"},
                                     {"", "scene.glb", "room.glb"},
                                     {"", "room.glb", "room.glb"},
                                     {"", "objects.toml", "objects.toml"},
                                     {"", "gestures.toml", "gestures.toml"},
                                     {"", "person.glb", "figure.glb"},
                                     {"", "walk.csv", "joints.csv"},
                                     {"", "photo.jpg", "street.jpg"},
                                     {"", "kitti_depth.png", "kitti.png"},
                                     {"", "midas.png", "midas.png"},
                                     {"", "calib_cam_to_cam.txt", "kitti.txt"},
                                     {"", "known.toml", "known.toml"},
                                     {"", "rig/camera.toml", "desk.toml"},
                                     {"", "documentation/evidence", "evidence"}};

const InputName* input_called(const std::string& page, const std::string& word) {
  const InputName* found = nullptr;
  for (const InputName& name : input_names) {
    if (word != name.word) continue;
    if ("documentation/" + std::string(name.page) == page) return &name;
    if (*name.page == '\0' && found == nullptr) found = &name;
  }
  return found;
}

/// Everything in a folder that was made, beside what is there.
void copy_contents(const std::string& name, const fs::path& folder) {
  fs::copy(made(name), folder, fs::copy_options::recursive | fs::copy_options::skip_existing);
}

void provide_study(const fs::path& folder, const std::string& word) {
  const fs::path from = sources / word;
  if (fs::exists(folder / word) || !fs::is_regular_file(from)) return;
  fs::create_directories(folder / "stimuli");
  fs::copy_file(from, folder / word);
  fs::copy(sources / "stimuli/estimated", folder / "stimuli/estimated",
           fs::copy_options::recursive | fs::copy_options::skip_existing);
}

}  // namespace

void provide(const fs::path& folder, const std::string& page, const std::string& word) {
  if (word.starts_with("stimuli/")) return provide_study(folder, word);
  if (word == "ir*.png" || word == "rgb*.png") return copy_contents("boards", folder);
  if (word == "frame*.png") return copy_contents("frames", folder);
  const InputName* name = input_called(page, word);
  if (name == nullptr) return;
  const fs::path to = folder / (word.starts_with("~/") ? word.substr(2) : word);
  if (fs::exists(to)) return;
  fs::create_directories(to.parent_path());
  fs::copy(made(name->input), to, fs::copy_options::recursive);
  if (word == "PAIRS.csv") {
    fs::create_directories(folder / "room");
    copy_contents("pairs", folder / "room");
  }
}

}  // namespace seamline::page_commands
