// A set that somebody sent is rendered further: what its links lead to is neither taken nor shown.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sets/pages/errors_page.h"
#include "sets/set_records.h"
#include "sets/true_error_set.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/files/temporary_folder.h"
#include "support/text/html.h"
#include "tests/stimuli/manifest_records.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

TEST(SetLinks, APictureOutsideIsNoFinishedOne) {
  const TemporaryFolder folder;
  const fs::path set = folder / "set";
  fs::create_directory(set);
  fs::create_directory(set / "records");
  write_file_atomically(folder / "outside.png", "a picture");
  const std::string hash = sha256_of_file(folder / "outside.png");
  const SetRecords records(set);
  ManifestStimulus record = test::record_of(Artifact::receiver, "left", 64);
  record.image = "image.png";
  record.sha256 = hash;
  records.finish(record, "inputs");
  records.finish_reference({"room", "image.png", "image.png", hash, hash}, "inputs");
  EXPECT_FALSE(records.finished(record.id, "inputs"));
  fs::create_symlink("../outside.png", set / "image.png");
  EXPECT_FALSE(records.finished(record.id, "inputs"));
  EXPECT_FALSE(records.finished_reference("room", "inputs"));
  fs::remove(set / "image.png");
  fs::copy_file(folder / "outside.png", set / "image.png");
  EXPECT_TRUE(records.finished(record.id, "inputs"));
  EXPECT_TRUE(records.finished_reference("room", "inputs"));
  records.finish_reference({"room", "../outside.png", "image.png", hash, hash}, "inputs");
  EXPECT_FALSE(records.finished_reference("room", "inputs"));
}

TEST(SetLinks, ARecordOfAnotherHandIsUnfinishedWork) {
  const TemporaryFolder folder;
  fs::create_directory(folder / "records");
  for (const char* text :
       {R"({"inputs": 3, "record": {}})", R"({"inputs": "inputs", "record": 3})",
        R"({"inputs": "inputs", "record": {"image": 3}})", R"({"inputs": null})", "[]", "3"}) {
    write_file_atomically(folder / "records" / "a.json", text);
    write_file_atomically(folder / "records" / "reference-room.json", text);
    EXPECT_FALSE(SetRecords(folder.path()).finished("a", "inputs")) << text;
    EXPECT_FALSE(SetRecords(folder.path()).finished_reference("room", "inputs")) << text;
  }
}

TEST(SetLinks, ThePageOfErrorsShowsNothingFromOutside) {
  const TemporaryFolder folder;
  const fs::path set = folder / "set";
  fs::create_directory(set);
  write_file_atomically(folder / "secret", "a key of somebody");
  Manifest manifest;
  manifest.width_px = manifest.height_px = 16;
  manifest.stimuli = {test::record_of(Artifact::receiver, "left", 64)};
  const std::string id = manifest.stimuli[0].id;
  write_manifest(set, manifest);
  write_true_errors(set, {{id,
                           {.rmse = 0.1,
                            .standard_error = 0.01,
                            .worst_tile = 0.2,
                            .reference_spp = 64,
                            .picture_sha256 = manifest.stimuli[0].sha256}}});
  fs::create_symlink("../secret", set / ("worst-tile-" + id + ".png"));
  write_errors_page(set);
  EXPECT_THAT(read_file(set / "errors.html"), Not(HasSubstr(base64("a key of somebody"))));
  fs::remove(set / ("worst-tile-" + id + ".png"));
  write_file_atomically(set / ("worst-tile-" + id + ".png"), "a key of somebody");
  write_errors_page(set);
  EXPECT_THAT(read_file(set / "errors.html"), HasSubstr(base64("a key of somebody")));
}

}  // namespace
}  // namespace seamline::renderer
