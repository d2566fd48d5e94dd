#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "support/arithmetic/colour.h"
#include "support/files/atomic_file.h"
#include "support/files/gnuplot.h"
#include "support/files/hash.h"
#include "support/files/held/written_files.h"
#include "support/files/image.h"
#include "support/files/temporary_folder.h"
#include "support/running/interrupt.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/suggest.h"
#include "tests/complaint.h"

namespace seamline {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;

class InTemporaryFolder : public testing::Test {
 protected:
  const TemporaryFolder folder_;
};

using AtomicFile = InTemporaryFolder;
using ImageFile = InTemporaryFolder;

/// What a process that was told to stop says of a file's hash: 0, it is right; 1, it is another; 2, stopped.
[[noreturn]] void hash_after_ctrl_c(const fs::path& file, const std::string& expected) {
  catch_interrupts();
  std::raise(SIGINT);
  try {
    std::_Exit(sha256_of_file(file) == expected ? 0 : 1);
  } catch (const Interrupted&) {
    std::_Exit(2);
  }
}

TEST(Hash, APictureThatWasJustWrittenIsHashedToItsEndAfterCtrlCAndALongFileIsNot) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "file";
  write_file_atomically(file, std::string(1 << 20, 'x'));
  const std::string of_short = sha256_of_file(file);
  EXPECT_EXIT(hash_after_ctrl_c(file, of_short), testing::ExitedWithCode(0), "");
  fs::resize_file(file, 64 << 20);
  EXPECT_EXIT(hash_after_ctrl_c(file, ""), testing::ExitedWithCode(2), "");
}

TEST(Hash, Sha256OfPublishedMessages) {  // FIPS 180-2, appendix B
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST_F(AtomicFile, FailedWriteLeavesTheOldFileAndNothingElse) {
  write_file_atomically(folder_ / "a.txt", "old");
  fs::create_directory(folder_ / "b.txt");  // which no file can replace
  EXPECT_THROW(write_file_atomically(folder_ / "b.txt", "new"), InputError);
  EXPECT_EQ(read_file(folder_ / "a.txt"), "old");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 2);
}

/// Many at once in one process have one process id, as every container's first process has (tests/faults
/// tries those).
TEST_F(AtomicFile, ManyWritersOfOneFileDoNotDisturbOneAnother) {
  constexpr int writers = 8, times = 40;
  const std::string whole(100000, 'x');
  std::atomic<int> failures = 0;
  std::vector<std::thread> threads;
  for (int writer = 0; writer < writers; ++writer)
    threads.emplace_back([&] {
      for (int i = 0; i < times; ++i) try {
          write_file_atomically(folder_ / "shared.bin", whole);
          prepare_output_folder(folder_.path());
          failures += read_file(folder_ / "shared.bin") == whole ? 0 : 1;
        } catch (const InputError&) {
          ++failures;
        }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(failures, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST_F(AtomicFile, ALinkAtTheTargetIsReplacedAndNotFollowed) {
  write_file_atomically(folder_ / "own", "kept");
  fs::create_symlink("own", folder_ / "link");
  write_file_atomically(folder_ / "link", "new");
  EXPECT_EQ(read_file(folder_ / "own"), "kept");
  EXPECT_EQ(read_file(folder_ / "link"), "new");
  EXPECT_FALSE(fs::is_symlink(folder_ / "link"));
}

TEST_F(AtomicFile, AFileForItsOwnerIsReadByNobodyElse) {
  write_file_atomically(folder_ / "answers.csv", "a", Readers::owner);
  EXPECT_EQ(fs::status(folder_ / "answers.csv").permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(AtomicFile, ALongNameHasRoomForItsTemporaryOne) {
  const std::string longest(255, 'n');
  write_file_atomically(folder_ / longest, "a");
  EXPECT_EQ(read_file(folder_ / longest), "a");
}

/// Reads as somebody who is not root, in another process, and ends with 0 where the sentence says why not.
[[noreturn]] void read_without_permission(const fs::path& file) {
  constexpr uid_t nobody = 65534;
  if (::geteuid() == 0 && ::setresuid(nobody, nobody, nobody) != 0) std::_Exit(3);
  const std::string text = complaint_of([&] { static_cast<void>(read_file(file)); });
  const std::string picture = complaint_of([&] { static_cast<void>(read_image(file)); });
  const std::string wanted = "wanted a readable file, found one that you may not read (permission denied)";
  std::_Exit(text.find(wanted) == std::string::npos ? 1 : picture.find(wanted) == std::string::npos ? 2 : 0);
}

TEST_F(AtomicFile, AFileThatMayNotBeReadIsToldFromNone) {
  fs::permissions(folder_.path(), fs::perms::all);
  write_file_atomically(folder_ / "closed.png", "a");
  fs::permissions(folder_ / "closed.png", fs::perms::none);
  EXPECT_EXIT(read_without_permission(folder_ / "closed.png"), testing::ExitedWithCode(0), "");
  const auto said = [&](const char* name) {
    return complaint_of([&] { static_cast<void>(read_file(folder_ / name)); });
  };
  EXPECT_NE(said("nothing").find("found none"), std::string::npos);
  EXPECT_NE(said(".").find("found a folder"), std::string::npos);
}

using WrittenFiles = InTemporaryFolder;

TEST_F(WrittenFiles, AreNoInputByAnyNameAndNotTheSameTwice) {
  write_file_atomically(folder_ / "photo.png", "a photograph");
  fs::create_symlink("photo.png", folder_ / "link.png");
  fs::create_hard_link(folder_ / "photo.png", folder_ / "other.png");
  const std::vector<OptionFile> inputs = {{"--depth", folder_ / "none.exr"},
                                          {"--background", folder_ / "photo.png"}};
  const auto said = [&](const std::vector<OptionFile>& outputs) {
    return complaint_of([&] { require_outputs(outputs, inputs); });
  };
  for (const char* name : {"photo.png", "./photo.png", "link.png", "other.png"})
    EXPECT_NE(said({{"--out", folder_ / name}}).find("--out: wanted another file than --background"),
              std::string::npos)
        << name;
  EXPECT_NE(said({{"--out", folder_ / "none.exr"}}).find("another file than --depth"), std::string::npos);
  EXPECT_NE(said({{"--out", folder_ / "new.png"}, {"--layers", folder_ / "./new.png"}})
                .find("--layers: wanted another file than --out"),
            std::string::npos);
  EXPECT_NE(said({{"--out", "new.png"}, {"--layers", "./new.png"}}).find("another file than --out"),
            std::string::npos);
  EXPECT_EQ(said({{"--out", folder_ / "new.png"}, {"--layers", folder_ / "new.exr"}}), "no complaint");
  EXPECT_EQ(read_file(folder_ / "photo.png"), "a photograph");
}

TEST_F(WrittenFiles, NeedAPlaceThatTakesThemAndLeaveNothingThere) {
  fs::create_directory(folder_ / "folder.png");
  const auto said = [&](const fs::path& path) {
    return complaint_of([&] { require_outputs(std::vector<OptionFile>{{"--out", path}}, {}); });
  };
  EXPECT_NE(said(folder_ / "folder.png").find("found a folder"), std::string::npos);
  EXPECT_NE(said(folder_ / "missing" / "a.png").find("No such file or directory"), std::string::npos);
  EXPECT_NE(said("/proc/a.png").find("wanted a place that can be written to"), std::string::npos);
  EXPECT_EQ(said(folder_ / "a.png"), "no complaint");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_.path()), {}), 1);
}

TEST(TemporaryFolders, AreNewTheOwnersAloneAndGoneAtTheEnd) {
  fs::path first, beside;
  {
    const TemporaryFolder one, other;
    EXPECT_NE(one.path(), other.path());
    first = one.path();
    EXPECT_EQ(fs::status(first).permissions(), fs::perms::owner_all);
    const TemporaryFolder near_file(one / "log.sqlite");
    beside = near_file.path();
    EXPECT_EQ(beside.parent_path(), first);
    EXPECT_EQ(fs::status(beside).permissions(), fs::perms::owner_all);
  }
  EXPECT_FALSE(fs::exists(first));
  EXPECT_THROW(TemporaryFolder(first / "no such folder" / "file"), InputError);
}

TEST(Gnuplot, ControlCharactersOfATextAreBlank) {
  EXPECT_EQ(gnuplot_text(std::string("a\0b\x1b[1m\x7f", 8)), "a b [1m ");
}

TEST_F(AtomicFile, HashOfAFileIsTheHashOfItsBytes) {
  const std::string bytes(200000, 'x');
  write_file_atomically(folder_ / "b", bytes);
  EXPECT_EQ(sha256_of_file(folder_ / "b"), sha256(bytes));
  EXPECT_THROW((void)sha256_of_file(folder_ / "none"), InputError);
  EXPECT_THROW((void)sha256_of_file(folder_.path()), InputError);
}

TEST(Colour, SrgbCurveMeetsItsInverseAndItsCodes) {
  for (int code = 0; code < 256; ++code) {
    const float linear = linear_from_srgb(static_cast<float>(code) / 255.0F);
    EXPECT_EQ(code_from_display(srgb_from_linear(linear)), code);
  }
  EXPECT_FLOAT_EQ(srgb_from_linear(0.18F), 0.46135613F);
  EXPECT_EQ(srgb_from_linear(std::nanf("")), 0.0F);
  EXPECT_EQ(srgb_from_linear(7.0F), 1.0F);
  EXPECT_EQ(srgb_from_linear(-1.0F), 0.0F);
}

TEST_F(ImageFile, ExrKeepsEveryBit) {
  Image image(5, 3, 3);
  for (std::size_t i = 0; i < image.values.size(); ++i)
    image.values[i] = 1e-7F * static_cast<float>(i * i) + 1.0F / 3;
  image.values[7] = 1e30F;
  write_exr(folder_ / "a.exr", image);
  EXPECT_EQ(read_image(folder_ / "a.exr").values, image.values);
}

TEST_F(ImageFile, PngKeepsEveryCodeAndTheSamePictureGivesTheSameBytes) {
  ByteImage image{16, 16, 3, {}};
  for (int i = 0; i < 16 * 16 * 3; ++i) image.values.push_back(static_cast<std::uint8_t>(i % 256));
  write_png(folder_ / "a.png", image);
  write_png(folder_ / "b.png", image);
  EXPECT_EQ(read_bytes_image(folder_ / "a.png").values, image.values);
  EXPECT_EQ(read_file(folder_ / "a.png"), read_file(folder_ / "b.png"));
  EXPECT_NEAR(read_image(folder_ / "a.png").values[188], linear_from_srgb(188.0F / 255), 1e-6);
}

TEST_F(ImageFile, DamagedPictureIsTheUsersInput) {
  write_file_atomically(folder_ / "a.png", "\x89PNG\r\n\x1a\nnothing more");
  EXPECT_THROW((void)read_image(folder_ / "a.png"), InputError);
  EXPECT_THROW((void)read_image(folder_ / "none.png"), InputError);
}

TEST(Suggest, NearestWordOrNone) {
  const std::array<std::string, 3> known = {"exposure_ev", "albedo", "bounces"};
  EXPECT_EQ(nearest_word("exposure", known), "exposure_ev");
  EXPECT_EQ(nearest_word("albdo", known), "albedo");
  EXPECT_EQ(nearest_word("xyzzy_zyx", known), "");
  const std::vector<std::string> camera = {"position_m", "look_at_m", "horizontal_fov_deg"};
  EXPECT_EQ(nearest_word("fov_deg", camera), "horizontal_fov_deg");
  EXPECT_EQ(nearest_word("_m", camera), "");
}

TEST(Progress, DurationsReadWell) {
  EXPECT_EQ(duration_text(14.2), "14 s");
  EXPECT_EQ(duration_text(200), "3 min 20 s");
  EXPECT_EQ(duration_text(7500), "2 h 05 min");
}

TEST(Error, SentenceNamesFileFieldWantedAndFound) {
  EXPECT_STREQ(
      input_error({.file = "a.toml", .field = "scene[0].scale", .wanted = "a positive number", .found = "-1"})
          .what(),
      "a.toml: scene[0].scale: wanted a positive number, found -1");
  // Empty parts are left out.
  EXPECT_STREQ(input_error({.file = "a.jsonl:1", .field = "message: wanted one value"}).what(),
               "a.jsonl:1: message: wanted one value");
  EXPECT_STREQ(input_error({.wanted = "a disk", .found = "none"}).what(), "wanted a disk, found none");
}

}  // namespace
}  // namespace seamline
