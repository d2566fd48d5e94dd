// `seamline picture`: a scene file alone.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

#include "refusal.h"
#include "run_program.h"
#include "support/files/image.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::run_seamline;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* small = " --width 48 --height 27 --spp 2 --bounces 1 --out ";

TEST(Picture, ShowsASceneWithItsOwnCameraAndLightAndTheSameBytesAgain) {
  const fs::path folder = test::fresh_folder("picture");
  for (const char* name : {"a.exr", "b.exr", "a.png"}) {
    const test::Outcome outcome =
        run_seamline("picture builtin:bedroom" + (small + (folder / name).string()));
    EXPECT_EQ(outcome.status, 0) << outcome.output;
    EXPECT_THAT(outcome.output, Not(HasSubstr("camera")));
  }
  EXPECT_EQ(test::read_text(folder / "a.exr"), test::read_text(folder / "b.exr"));
  const Image picture = read_image(folder / "a.exr");
  EXPECT_EQ(picture.width_px, 48);
  EXPECT_EQ(picture.height_px, 27);
}

TEST(Picture, WithoutACameraItShowsTheWholeSceneAndSaysHow) {
  const fs::path file = test::fresh_folder("picture-view") / "a.exr";
  const test::Outcome outcome =
      run_seamline("picture builtin:statue --environment 1 1 1 --albedo 0.25" + (small + file.string()));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output,
              AllOf(HasSubstr("has no camera"), HasSubstr("--look-at"), HasSubstr("--fov 50")));
  const Image picture = read_image(file);
  // Sky all around, the statue in the middle.
  for (int x = 0; x < picture.width_px; ++x) {
    EXPECT_EQ(picture.at(x, 0), 1);
    EXPECT_EQ(picture.at(x, picture.height_px - 1), 1);
  }
  EXPECT_LT(picture.at(24, 13), 1);
}

TEST(Picture, AViewNobodyGaveHasNoCrumbsOfRounding) {
  const fs::path folder = test::fresh_folder("picture-crumbs");
  const std::array<float, 9> corners = {-1, 0, 1e-9F, 1, 0, 1e-9F, 0, 1, 1e-9F};
  std::string bytes(sizeof corners, '\0');
  std::memcpy(bytes.data(), corners.data(), sizeof corners);
  test::write_text(folder / "a.bin", bytes);
  test::write_text(
      folder / "a.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"a.bin"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})");
  const test::Outcome outcome = run_seamline("picture " + (folder / "a.gltf").string() +
                                             " --environment 1 1 1" + (small + (folder / "a.exr").string()));
  EXPECT_EQ(outcome.status, 0) << outcome.output;
  EXPECT_THAT(outcome.output, HasSubstr("--look-at 0 0.5 0 --fov"));
}

TEST(Picture, AFileInWhichNothingHasAnAreaIsRefusedWhereverItIsRead) {
  const fs::path folder = test::fresh_folder("picture-nothing");
  const auto in = [&](const std::string& name) { return (folder / name).string(); };
  const std::array<float, 9> on_a_line = {0.1F, 0.2F, 0.3F, 0.2F, 0.4F, 0.6F, 0.3F, 0.6F, 0.9F};
  std::string bytes(sizeof on_a_line, '\0');
  std::memcpy(bytes.data(), on_a_line.data(), sizeof on_a_line);
  test::write_text(folder / "a.bin", bytes);
  test::write_text(
      folder / "flat.gltf",
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"a.bin"}],"bufferViews":[{"buffer":0,"byteLength":36}],)"
      R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],)"
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})");
  test::write_text(folder / "none.gltf", R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[]}]})");
  write_exr(folder / "photo.exr", Image(16, 8, 3, 0.5F));
  write_exr(folder / "depth.exr", Image(16, 8, 1, 2));
  for (const auto& [name, found] :
       {std::pair("flat.gltf", "triangles that have an area, found 1 triangle without any"),
        std::pair("none.gltf", "triangles, found none")}) {
    const std::string file = in(name);
    test::expect_refused("picture " + file + " --environment 1 1 1" + (small + in("a.png")),
                         std::string("wanted a scene with ") + found);
    test::expect_refused("composite --background " + in("photo.exr") + " --depth " + in("depth.exr") +
                             " --object " + file + " --out " + in("a.png"),
                         std::string("wanted an object with ") + found);
    test::write_text(folder / "study.toml", test::quick_study_with({{"builtin:statue", name}}));
    test::expect_refused("check " + in("study.toml"), std::string("wanted an object with ") + found);
  }
  EXPECT_FALSE(fs::exists(folder / "a.png"));
}

TEST(Picture, DepthWithoutAUnitNamesTheOptionsThatGiveOne) {
  const fs::path folder = test::fresh_folder("depth-unit");
  const auto in = [&](const char* name) { return (folder / name).string(); };
  write_exr(folder / "photo.exr", Image(16, 12, 3, 0.5F));
  write_exr(folder / "depth.exr", Image(16, 12, 1, 1500));
  test::expect_refused(
      "composite --background " + in("photo.exr") + " --depth " + in("depth.exr") +
          " --object builtin:teapot --environment 1 1 1 --out " + in("a.png"),
      "depth.exr: --metres-per-step: wanted a median depth from 0.05 to 500 m, found 1500 m with 1 metres a "
      "step: give 0.001 metres a step if it is 1.5 m, or set unusual_distances in the file of --camera if "
      "that is meant");
  EXPECT_FALSE(fs::exists(folder / "a.png"));
}

TEST(Picture, WithoutLightItSaysWhichOptionsGiveSome) {
  const fs::path file = test::fresh_folder("picture-dark") / "a.png";
  const auto said = [&](const std::string& options) {
    const test::Outcome outcome = run_seamline("picture builtin:statue " + options + (small + file.string()));
    EXPECT_EQ(outcome.status, 1);
    return outcome.output;
  };
  EXPECT_THAT(said(""), AllOf(HasSubstr("--environment"), HasSubstr("--to-sun")));
  EXPECT_THAT(said("--environment 1 1 1 --at 0 1 0 --look-at 0 0 0"),
              HasSubstr("--look-at: wanted a point that is not"));
  EXPECT_THAT(said("--environment-map none.hdr"), HasSubstr("none.hdr"));
}

TEST(Picture, ObjectsStandWhereCompositeWouldPutThemAndBringNoLight) {
  const fs::path folder = test::fresh_folder("picture-objects");
  const std::string view = "picture builtin:bedroom --environment 1 1 1 --at 0 1 1 --look-at 0 1 0";
  const auto made = [&](const char* name, const std::string& position, const std::string& light = {}) {
    test::write_text(folder / "objects.toml", light + "[[object]]\nfile = \"builtin:teapot\"\nposition_m = " +
                                                  position + "\nheight_m = 0.2\n");
    return run_seamline(view + " --objects " + (folder / "objects.toml").string() +
                        (small + (folder / name).string()));
  };
  ASSERT_EQ(run_seamline(view + (small + (folder / "without.exr").string())).status, 0);
  ASSERT_EQ(made("before.exr", "[0, -0.1, -0.5]").status, 0);
  const Image without = read_image(folder / "without.exr"), before = read_image(folder / "before.exr");
  EXPECT_FALSE((without.rgb(24, 13) == before.rgb(24, 13)).all())
      << "half a metre before the camera, in the middle";
  EXPECT_EQ(made("lit.exr", "[0, 0, 0]", "environment_radiance = [1, 1, 1]\n").status, 1);
}

TEST(Outputs, AreNoInputsAndAreTriedBeforeAnythingIsRead) {
  const fs::path folder = test::fresh_folder("outputs");
  write_png(folder / "photo.png", display_image(Image(8, 6, 3, 0.5F)));
  const std::string photograph = test::read_text(folder / "photo.png");
  fs::create_symlink("photo.png", folder / "link.png");
  const auto in = [&](const std::string& name) { return (folder / name).string(); };
  const std::string composite = "composite --background " + in("photo.png") + " --depth " + in("none.exr") +
                                " --object builtin:statue --environment 1 1 1 --out ";
  test::expect_refused(composite + in("photo.png"), "--out: wanted another file than --background");
  test::expect_refused(composite + in("a.png") + " --local-scene " + in("link.png"),
                       "--local-scene: wanted another file than --background");
  // The depth map is not there: who had begun to read would say so.
  test::expect_refused(composite + in("a.png") + " --report " + in("missing/a.html"),
                       "--report: wanted a place that can be written to");
  test::expect_refused("picture builtin:bedroom --out " + in("missing/a.png"),
                       "--out: wanted a place that can be written to");
  test::expect_refused("flip " + in("photo.png") + " " + in("photo.png") + " --map " + in("photo.png"),
                       "--map: wanted another file than reference");
  test::expect_refused(
      "animate figure.glb " + in("photo.png") + " --out " + in("a.glb") + " --angles " + in("photo.png"),
      "--angles: wanted another file than joints");
  for (const char* option : {"--systemd", "--nginx"})
    for (const char* log : {"photo.png", "new.sqlite"})
      test::expect_refused("serve pages --log " + in(log) + " " + option + " " + in(log),
                           std::string(option) + ": wanted another file than --log");
  test::expect_refused("study pages --log " + in("new") + " --frame-times " + in("./new"),
                       "--frame-times: wanted another file than --log");
  test::expect_refused("log identifiers " + in("photo.png") + " " + in("photo.png"),
                       "file: wanted another file than log");
  test::expect_refused("freeze s.toml set --out " + in("new") + " --kit " + in("new"),
                       "--kit: wanted another file than --out");
  test::expect_refused("job status . --html " + in("photo.png"), "--html: wanted");
  test::expect_refused("serve pages --log l --tokens t --codes " + in("new") + " --watch " + in("./new"),
                       "--watch: wanted another file than --codes");
  EXPECT_EQ(test::read_text(folder / "photo.png"), photograph);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
}

TEST(Outputs, AreNoFilesThatASceneOrATableOfObjectsNames) {
  const fs::path folder = test::fresh_folder("outputs-named");
  const auto in = [&](const std::string& name) { return (folder / name).string(); };
  test::write_text(folder / "room.gltf",
                   R"({"asset": {"version": "2.0"}, "images": [{"uri": "the%2Dwall.png"}]})");
  test::write_text(folder / "the-wall.png", "a picture");
  test::write_text(folder / "objects.toml", "[[object]]\nfile = \"room.gltf\"\nposition_m = [0, 0, -1]\n");
  const std::string wall = in("the-wall.png");
  test::expect_refused("picture " + in("room.gltf") + " --out " + wall,
                       "--out: wanted another file than one that scene names, which would be lost");
  test::expect_refused("picture builtin:bedroom --objects " + in("objects.toml") + " --out " + wall,
                       "--out: wanted another file than one that --objects names");
  const std::string json = R"({"asset": {"version": "2.0"}, "images": [{"uri": "the-wall.png"}]})";
  const auto number = [](std::size_t n) {
    return std::string{static_cast<char>(n), static_cast<char>(n / 256), '\0', '\0'};
  };
  test::write_text(folder / "room.glb",
                   "glTF" + number(2) + number(json.size() + 20) + number(json.size()) + "JSON" + json);
  test::expect_refused("picture " + in("room.glb") + " --out " + wall,
                       "--out: wanted another file than one that scene names, which would be lost");
  // As TOML writes names, too: in single quotes, with letters as numbers, and below an asset root.
  fs::create_directories(folder / "assets/rooms");
  fs::copy_file(folder / "room.gltf", folder / "assets/rooms/room.gltf");
  test::write_text(folder / "assets/rooms/the-wall.png", "another picture");
  test::write_text(folder / "more.toml", "[[object]]\nfile = 'rooms/room.gltf'\nposition_m = [0, 0, -1]\n");
  test::write_text(folder / "coded.toml", "[[object]]\nfile = \"ro\\u006Fm.gltf\"\n");
  const std::string composite = "composite --background none.png --depth none.exr --objects ";
  test::expect_refused(composite + in("more.toml") + " --asset-root " + in("assets") + " --out " +
                           in("assets/rooms/the-wall.png"),
                       "--out: wanted another file than one that --objects names");
  test::expect_refused(composite + in("coded.toml") + " --out " + wall,
                       "--out: wanted another file than one that --objects names");
  test::write_text(folder / "self.toml", "[[object]]\nfile = \"self.toml\"\nposition_m = [0, 0, -1]\n");
  test::expect_refused("picture builtin:bedroom --objects " + in("self.toml") + " --out " + in("new.png"),
                       "self.toml: wanted a whole glTF 2.0 file");
  EXPECT_EQ(test::read_text(folder / "the-wall.png"), "a picture");
  EXPECT_EQ(test::read_text(folder / "assets/rooms/the-wall.png"), "another picture");
}

TEST(Outputs, InAFolderAreNoneOfTheFilesThatAreRead) {
  const fs::path folder = test::fresh_folder("outputs-in-folder");
  const auto in = [&](const std::string& name) { return (folder / name).string(); };
  const std::vector<std::string> names = {"view-2.png", "interleaved.png", "ball.glb", "exact.png",
                                          "shake.csv"};
  for (const std::string& name : names) test::write_text(folder / name, "mine");
  const std::string views = " --max-depth 8 --fov 60 --zero-parallax 4 --out " + folder.string();
  test::expect_refused("views " + in("view-2.png") + views,
                       "--out: wanted another file than frame, which would be lost");
  test::expect_refused("views none.png --background " + in("interleaved.png") + views,
                       "--out: wanted another file than --background");
  test::expect_refused("relight " + in("exact.png") + " --sensor tof_160x120 --out " + folder.string(),
                       "--out: wanted another file than scene");
  test::expect_refused("settle --depth " + in("shake.csv") +
                           " --camera none.toml --ball 0.1 --position 0 0 -1 --out " + folder.string(),
                       "--out: wanted another file than --depth");
  for (const std::string& name : names) EXPECT_EQ(test::read_text(folder / name), "mine") << name;
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), std::ssize(names));
}

TEST(Outputs, PicturesOfPatternsReplaceNothing) {
  const fs::path folder = test::fresh_folder("outputs-patterns");
  test::write_text(folder / "07.png", "mine");
  test::expect_refused("observe --pictures " + folder.string(),
                       "--pictures: wanted a folder without files of the patterns' names");
  // Pairs that cannot be read, or are a folder: nothing is written beside them.
  test::write_text(folder / "pairs.csv", "reference,picture,seen,n,pixels_per_degree\n");
  for (const std::string& pairs : {(folder / "pairs.csv").string(), folder.string()})
    EXPECT_EQ(run_seamline("observe " + pairs + " --pictures " + (folder / "new").string()).status, 1);
  EXPECT_EQ(test::read_text(folder / "07.png"), "mine");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 2);
}

}  // namespace
}  // namespace seamline
