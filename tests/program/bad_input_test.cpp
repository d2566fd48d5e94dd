// Wrong input: exit status 1, one clear sentence naming file, field, what was wanted and what was found.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "refusal.h"
#include "run_program.h"

namespace seamline {
namespace {

using test::expect_refused;
using test::fresh_folder;
using test::Outcome;
using test::quick_study_with;
using test::run_seamline;
using test::write_text;
using testing::HasSubstr;

void expect_complaint(const Outcome& outcome, std::initializer_list<std::string> parts) {
  EXPECT_EQ(outcome.status, 1) << outcome.output;
  for (const std::string& part : parts) EXPECT_THAT(outcome.output, HasSubstr(part));
  EXPECT_EQ(std::count(outcome.output.begin(), outcome.output.end(), '\n'), 1) << outcome.output;
}

Outcome render_study(const std::filesystem::path& folder, const std::string& text) {
  write_text(folder / "study.toml", text);
  return run_seamline("render " + (folder / "study.toml").string() + " --out " + (folder / "set").string() +
                      " --only '*-0064' --spp 1");
}

TEST(BadInput, MissingStudyFile) {
  expect_complaint(run_seamline("render no/such.toml --dry-run"), {"no/such.toml", "readable file", "none"});
}

TEST(BadInput, StudyFileThatIsNotToml) {
  const auto folder = fresh_folder("bad-toml");
  expect_complaint(render_study(folder, "format = \"seamline"), {"study.toml", "line 1", "TOML"});
}

TEST(BadInput, MisspeltKeySuggestsTheRightOne) {
  const auto folder = fresh_folder("bad-key");
  expect_complaint(render_study(folder, quick_study_with({{"exposure_ev", "exposure_eV"}})),
                   {"scene[0].exposure_eV", "did you mean \"exposure_ev\""});
  expect_complaint(render_study(folder, quick_study_with({{"depth_width_px", "depth_width"}})),
                   {"study.toml: depth_width: wanted a known key; did you mean \"depth_width_px\"?"});
  expect_complaint(render_study(folder, quick_study_with({{"name = \"statue\"", "nane = \"statue\""}})),
                   {"scene[0].object[0].nane", "did you mean \"name\"?"});
  expect_complaint(render_study(folder, quick_study_with({{"depth_width_px", "widths"}})),
                   {"depth_width_px: wanted an array of whole numbers, found nothing"});
}

TEST(BadInput, WrongUnitOrImpossibleValue) {
  const auto folder = fresh_folder("bad-value");
  expect_complaint(render_study(folder, quick_study_with({{"albedo = 0.5", "albedo = \"50 %\""}})),
                   {"scene[0].albedo", "from 0 to 1", "50 %"});
  expect_complaint(render_study(folder, quick_study_with({{"albedo = 0.5", "albedo = 1.5"}})),
                   {"scene[0].albedo", "1.5"});
  expect_complaint(render_study(folder, quick_study_with({{"width_px = 480", "width_px = -480"}})),
                   {"width_px", "px", "-480"});
  expect_complaint(render_study(folder, quick_study_with({{"\"receiver\"", "\"reciever\""}})),
                   {"artifacts", "receiver", "reciever"});
}

TEST(BadInput, ArtifactGivenTwice) {
  const auto folder = fresh_folder("bad-twice");
  expect_complaint(
      render_study(folder, quick_study_with({{"[\"receiver\"]", "[\"receiver\", \"receiver\"]"}})),
      {"scene[0].artifacts", "twice"});
  expect_complaint(
      render_study(folder, quick_study_with({{"position_m = [", "position_m = [9007199254740993, 0, 0] #"}})),
      {"position_m"});
}

TEST(BadInput, AFolderWithOtherThingsIsNoPlaceForASetOrAReport) {
  const auto folder = fresh_folder("bad-full");
  const auto out = (folder / "out").string();
  std::filesystem::create_directories(out);
  write_text(folder / "out" / "letter.txt", "mine");
  expect_complaint(run_seamline("render " + (test::studies() / "quick.toml").string() + " --out " + out),
                   {"--out", "wanted a new or an empty folder, or one with a set"});
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(out), {}), 1);
  expect_complaint(run_seamline("render " + (test::studies() / "quick.toml").string() + " --out " +
                                (folder / "out" / "letter.txt").string()),
                   {"--out", "wanted a new or an empty folder, or one with a set, found a file"});
  std::filesystem::create_directories(folder / "out" / "records");  // somebody else's, and empty
  expect_complaint(run_seamline("render " + (test::studies() / "quick.toml").string() + " --out " + out),
                   {"--out", "wanted a new or an empty folder, or one with a set"});
}

TEST(BadInput, AnEmptyFolderOfRecordsIsNoBegunSetWhoseIdleSettingsAreKept) {
  const auto folder = fresh_folder("bad-begun");
  std::filesystem::create_directories(folder / "set" / "records");
  expect_complaint(render_study(folder, quick_study_with({{"mesh = \"adaptive\"", "mesh = \"full\""}})),
                   {"mesh_tolerance", "wanted mesh = \"adaptive\" beside it"});
}

TEST(BadInput, FileNamesThatNoFileSystemHolds) {
  expect_complaint(run_seamline("render " + std::string(400, 'x') + ".toml --dry-run"), {"xxx"});
}

TEST(BadInput, UnknownBuiltinSuggestsTheRightOne) {
  const auto folder = fresh_folder("bad-builtin");
  expect_complaint(render_study(folder, quick_study_with({{"builtin:statue", "builtin:statu"}})),
                   {"scene[0].object[0].file", "builtin:statue"});
}

TEST(BadInput, TruncatedGlb) {
  const auto folder = fresh_folder("bad-glb");
  ASSERT_EQ(run_seamline("capture builtin:bedroom --width 64 --out " + (folder / "d.exr").string()).status,
            0);
  ASSERT_EQ(run_seamline("mesh " + (folder / "d.exr").string() + " --out " + (folder / "whole.glb").string())
                .status,
            0);
  const std::string whole = test::read_text(folder / "whole.glb");
  write_text(folder / "cut.glb", whole.substr(0, whole.size() / 2));
  expect_complaint(run_seamline("capture " + std::filesystem::absolute(folder / "cut.glb").string() +
                                " --at 0 0 0 --width 64 --out " + (folder / "e.exr").string()),
                   {"cut.glb", "whole glTF"});
  EXPECT_FALSE(std::filesystem::exists(folder / "e.exr"));
}

TEST(BadInput, WhatWasTakenForASceneIsNamed) {
  const auto folder = fresh_folder("bad-kind");
  const auto said = [&](const std::string& name, const std::string& bytes, const std::string& found) {
    write_text(folder / name, bytes);
    expect_refused("picture " + (folder / name).string() + " --out " + (folder / "a.png").string(), found);
  };
  said("empty.glb", "", "found an empty file");
  said("page.glb", "\n\n<!DOCTYPE html>\n<html></html>\n", "found a page of HTML or XML");
  said("photo.glb", "\x89PNG\r\n\x1a\n" + std::string(300, '['), "found another kind of file");
  said("model.gltf", "o cube\nv 0 0 0\n", "found another kind of file");
  said("far.gltf",
       R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"https://example.org/a.bin"}]})",
       "found the address \"https://example.org/a.bin\", which is not fetched");
  EXPECT_FALSE(std::filesystem::exists(folder / "a.png"));
}

TEST(BadInput, StudyFilesInOtherEncodingsAreNamed) {
  const auto folder = fresh_folder("bad-encoding");
  const auto said = [&](const std::string& bytes, const std::string& found) {
    write_text(folder / "study.toml", bytes);
    expect_refused("check " + (folder / "study.toml").string(), found);
  };
  said("name = \"Z\xC3\xBCrich\"\nfile = \"B\xFCro.glb\"\n",
       "study.toml: line 2: wanted text in UTF-8 (save the file anew with that encoding), found letters in "
       "another encoding");
  said(std::string("\xFF\xFEn\0a\0", 6),
       "wanted text in UTF-8 (save the file anew with that encoding), found UTF-16");
}

TEST(BadInput, AFolderIsNoSceneNoPictureAndNoDepthMap) {
  const auto folder = fresh_folder("bad-folder");
  expect_refused("picture " + folder.string() + " --out a.png",
                 "wanted a file, found a folder at " + folder.string());
  expect_complaint(render_study(folder, quick_study_with({{"builtin:statue", "."}})),
                   {"scene[0].object[0].file", "wanted a file, found a folder at"});
  expect_refused("flip " + folder.string() + " " + folder.string(), "wanted an image file, found a folder");
}

TEST(BadInput, GltfWithABadAccessor) {
  const auto folder = fresh_folder("bad-accessor");
  const std::string gltf =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
      std::string(48, 'A') +
      R"("}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":COUNT}],)" +
      R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],"scenes":[{"nodes":[0]}]})";
  const auto with = [&](const std::string& count) {
    std::string text = gltf;
    write_text(folder / "scene.gltf", text.replace(text.find("COUNT"), 5, count));
    return run_seamline("capture " + std::filesystem::absolute(folder / "scene.gltf").string() +
                        " --at 0 1 0 --width 64 --out " + (folder / "d.exr").string());
  };
  EXPECT_EQ(with("3").status, 0);
  expect_complaint(with("4"), {"scene.gltf", "meshes[0].primitives[0].POSITION", "inside its buffer",
                               "4 elements of 12 bytes from byte 0 of 36"});
  expect_complaint(with("4000000000"), {"scene.gltf", "POSITION"});
}

TEST(BadInput, ScenesElsewhereNeedAnAssetRoot) {
  const auto folder = fresh_folder("bad-root");
  std::filesystem::create_directories(folder / "study");
  std::filesystem::create_directories(folder / "meshes");
  write_text(folder / "meshes" / "statue.glb", "not looked at by --dry-run");
  write_text(folder / "study" / "study.toml", quick_study_with({{"builtin:statue", "../meshes/statue.glb"}}));
  const std::string render = "render " + (folder / "study" / "study.toml").string() + " --dry-run";
  expect_complaint(run_seamline(render),
                   {"study.toml", "scene[0].object[0].file", "--asset-root DIR", "../meshes/statue.glb"});
  EXPECT_EQ(run_seamline(render + " --asset-root " + (folder / "meshes").string()).status, 0);
  expect_complaint(run_seamline(render + " --asset-root " + (folder / "none").string()),
                   {"--asset-root", "a folder", "none"});
}

TEST(BadInput, FilesWithoutEnd) {
  expect_complaint(run_seamline("render /dev/zero --dry-run"), {"/dev/zero", "at most", "more"});
  expect_complaint(run_seamline("fit /dev/zero --alternatives 3"), {"/dev/zero", "at most", "more"});
  expect_complaint(run_seamline("capture /dev/zero --at 0 0 0 --width 64 --out d.exr"), {"/dev/zero"});
}

TEST(BadInput, ObjectThatCoversNoPixel) {
  const auto folder = fresh_folder("bad-object");
  expect_complaint(
      render_study(folder, quick_study_with({{"file = \"builtin:statue\"\n  position_m = [",
                                              "file = \"builtin:statue\"\n  position_m = [500, 0, 0] #"}})),
      {"object \"statue\"", "covers at least one pixel"});
  EXPECT_FALSE(std::filesystem::exists(folder / "set" / "manifest.json"));
}

TEST(BadInput, UnwritableOutput) {
  const auto folder = fresh_folder("bad-output");
  write_text(folder / "file", "");
  expect_complaint(run_seamline("render " + (test::studies() / "quick.toml").string() + " --out " +
                                (folder / "file" / "set").string()),
                   {"file/set", "written to"});
}

TEST(BadInput, SetFromAnotherVersion) {
  const auto folder = fresh_folder("bad-set");
  std::filesystem::create_directories(folder / "set");
  write_text(folder / "set" / "manifest.json", R"({"format": "seamline set", "version": 99})");
  const std::string set = (folder / "set").string();
  expect_complaint(run_seamline("verify " + set), {"manifest.json", "version 1", "99"});
  expect_complaint(run_seamline("study " + set + " --log " + (folder / "log.sqlite").string() +
                                " --observer perfect --count 1 --seed 1"),
                   {"manifest.json", "99"});
  EXPECT_FALSE(std::filesystem::exists(folder / "log.sqlite"));
  expect_complaint(run_seamline("verify " + folder.string()), {"manifest.json", "no such file"});
}

TEST(BadInput, LogThatIsNotSqlite) {
  const auto folder = fresh_folder("bad-log");
  write_text(folder / "log.sqlite", std::string(5000, 'x'));
  expect_complaint(
      run_seamline("analyze " + (folder / "log.sqlite").string() + " --out " + (folder / "report").string()),
      {"log.sqlite", "log"});
  expect_complaint(
      run_seamline("analyze " + (folder / "none.sqlite").string() + " --out " + (folder / "report").string()),
      {"none.sqlite"});
  EXPECT_FALSE(std::filesystem::exists(folder / "report"));
}

TEST(BadInput, DepthMapOfTheWrongShape) {
  const auto folder = fresh_folder("bad-depth");
  write_text(folder / "d.exr", "no picture");
  expect_complaint(
      run_seamline("mesh " + (folder / "d.exr").string() + " --out " + (folder / "m.glb").string()),
      {"d.exr", "image"});
  EXPECT_FALSE(std::filesystem::exists(folder / "m.glb"));
}

TEST(BadInput, OutputNamesThatDoNotSayWhatWillBeInThem) {
  const auto folder = fresh_folder("bad-names");
  expect_complaint(run_seamline("capture builtin:bedroom --width 64 --out " + (folder / "d.png").string()),
                   {".exr", "d.png"});
  EXPECT_FALSE(std::filesystem::exists(folder / "d.png"));
}

TEST(BadInput, UnknownCommandsAndOptionsAreExitStatusOne) {
  EXPECT_EQ(run_seamline("rendr").status, 1);
  EXPECT_EQ(run_seamline("render --no-such-option").status, 1);
  EXPECT_EQ(run_seamline("--help").status, 0);
}

}  // namespace
}  // namespace seamline
