// A log on a network file system is one computer's at a time.
#include "study/log/one_computer.h"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include "support/files/temporary_folder.h"
#include "tests/complaint.h"

namespace seamline::study {
namespace {

using testing::HasSubstr;

/// One program's open lock file.
struct LockFile {
  explicit LockFile(const std::filesystem::path& path)
      : path(path), descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {}
  ~LockFile() { ::close(descriptor); }
  LockFile(const LockFile&) = delete;
  LockFile& operator=(const LockFile&) = delete;

  [[nodiscard]] std::string claim(const std::string& host, bool shared = true) const {
    return test::complaint_of(
        [&] { claim_for_computer(descriptor, path, {.host = host, .shared = shared}); });
  }
  std::filesystem::path path;
  int descriptor;
};

TEST(OneComputer, TheFirstHasTheLogUntilItsLastProgramEnds) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder / "log.sqlite-lock";
  const LockFile other(path);
  {
    const LockFile first(path), second(path);
    EXPECT_EQ(first.claim("lab-1"), "no complaint");
    EXPECT_EQ(second.claim("lab-1"), "no complaint");  // a program more on the same computer
    EXPECT_THAT(other.claim("lab-2"), HasSubstr("another computer that has it open"));
    EXPECT_THAT(other.claim("lab-0"), HasSubstr("seamline merge"));
    EXPECT_EQ(other.claim("lab-2", false), "no complaint");  // on a file system of its own
  }
  EXPECT_EQ(other.claim("lab-2"), "no complaint");
  const LockFile first(path);
  EXPECT_THAT(first.claim("lab-1"), HasSubstr("another computer"));
}

TEST(OneComputer, AParticipantsByteIsNoComputers) {
  const TemporaryFolder folder;
  const LockFile one(folder / "lock"), other(folder / "lock");
  struct flock lock = {};
  lock.l_type = F_WRLCK;
  lock.l_whence = SEEK_SET;
  lock.l_start = 1'000'000;
  lock.l_len = 1;
  ASSERT_EQ(::fcntl(one.descriptor, F_OFD_SETLK, &lock), 0);
  EXPECT_EQ(other.claim("lab-2"), "no complaint");
}

TEST(OneComputer, AFolderForTemporaryFilesIsThisComputers) {
  const TemporaryFolder folder;
  const ComputerPlace place = computer_place(folder.path());
  EXPECT_FALSE(place.host.empty());
}

}  // namespace
}  // namespace seamline::study
