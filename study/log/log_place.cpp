#include "study/log/log_place.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>

#include <array>
#include <chrono>
#include <compare>
#include <optional>
#include <thread>

#include "support/text/error.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

constexpr int attempts = 20;
constexpr auto between_attempts = std::chrono::milliseconds(50);

/// What a file is, and when it was last written to.
struct FileState {
  ino_t inode = 0;
  off_t bytes = 0;
  std::int64_t seconds = 0, nanoseconds = 0;
  auto operator<=>(const FileState&) const = default;
};

std::optional<FileState> state_of(const fs::path& path) {
  struct stat status = {};
  if (::lstat(path.c_str(), &status) != 0) return std::nullopt;
  return FileState{.inode = status.st_ino,
                   .bytes = status.st_size,
                   .seconds = status.st_mtim.tv_sec,
                   .nanoseconds = status.st_mtim.tv_nsec};
}

using LogState = std::array<std::optional<FileState>, 3>;

LogState state_of_log(const fs::path& place) {
  return {state_of(place), state_of(ahead_file(place)), state_of(journal_file(place))};
}

bool is_full(const fs::path& folder, std::uintmax_t wanted_bytes) {
  std::error_code error;
  const fs::space_info room = fs::space(folder, error);
  return !error && room.available < wanted_bytes;
}

/// A copy takes over permissions, and one that cannot be written to cannot be opened either.
void copy_writable(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::remove(to, error);
  fs::copy_file(from, to, error);
  if (std::error_code gone; error) {
    fs::remove(to, gone);  // what it took does not count
    if (is_full(to.parent_path(), fs::file_size(from, gone)) && !gone)
      throw input_error({.file = from.string(),
                         .wanted = "room for a copy beside the new log, or among the temporary files",
                         .found = "a full disk"});
  }
  if (!error) fs::permissions(to, fs::perms::owner_read | fs::perms::owner_write, error);
  if (error)
    throw input_error(
        {.file = from.string(), .wanted = "a readable file, and room for a copy", .found = error.message()});
}

void copy_files(const fs::path& place, const fs::path& copy) {
  copy_writable(place, copy);
  for (const auto& [from, to] : {std::pair(ahead_file(place), copy.string() + "-wal"),
                                 std::pair(journal_file(place), copy.string() + "-journal")}) {
    std::error_code error;
    fs::remove(to, error);
    // SQLite follows no link here either.
    if (fs::is_regular_file(fs::symlink_status(from, error))) copy_writable(from, to);
  }
}

}  // namespace

fs::path log_place(const fs::path& given) {
  std::error_code error;
  if (const fs::path real = fs::canonical(given, error); !error) return real;
  const fs::path folder = fs::canonical(given.has_parent_path() ? given.parent_path() : ".", error);
  return error ? given : folder / given.filename();
}

fs::path ahead_file(const fs::path& given) {
  return log_place(given).string() + "-wal";
}

fs::path journal_file(const fs::path& given) {
  return log_place(given).string() + "-journal";
}

fs::path claims_file(const fs::path& given) {
  return log_place(given).string() + "-lock";
}

void check_one_place(const fs::path& given) {
  const auto complaint = [&](const std::string& wanted, const std::string& found) {
    return input_error({.file = given.string(), .wanted = wanted, .found = found});
  };
  struct statx facts = {};
  if (::statx(AT_FDCWD, given.c_str(), 0, STATX_NLINK, &facts) != 0) return;
  if (facts.stx_nlink > 1)
    throw complaint(
        "a log with one name (its newest answers may lie beside another one; copy it together with its -wal)",
        fmt::format("{} hard links to one file", facts.stx_nlink));
  if ((facts.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0)
    throw complaint("a log whose folder is here too (mount the folder: its newest answers may lie there)",
                    "a file that is mounted alone");
}

mode_t mode_of_log(const fs::path& place) {
  struct stat status = {};
  return ::stat(place.c_str(), &status) == 0 ? status.st_mode & 0666 : 0600;
}

void copy_log(const fs::path& given, const fs::path& copy) {
  const fs::path place = log_place(given);
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const LogState before = state_of_log(place);
    copy_files(place, copy);
    if (state_of_log(place) == before) return;
    std::this_thread::sleep_for(between_attempts);
  }
  throw input_error({.file = given.string(),
                     .wanted = "a log that rests while it is copied",
                     .found = "somebody who goes on writing to it"});
}

std::optional<FileIdentity> file_identity(const std::filesystem::path& path) {
  struct stat status = {};
  if (::stat(path.c_str(), &status) != 0) return std::nullopt;
  return FileIdentity{.device = status.st_dev, .inode = status.st_ino};
}

}  // namespace seamline::study
