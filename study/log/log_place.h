#pragma once
#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>

namespace seamline::study {

// A log has one place: the real path of its file, after every link. Its write-ahead log, its journal and its
// lock lie beside that, whatever path a person gave; beside a link there is nothing.

/// The real path of a log, or of one that is about to be made. Never fails: where a part of the path does not
/// exist it stays as it is, and whoever opens it complains.
[[nodiscard]] std::filesystem::path log_place(const std::filesystem::path& given);

/// The file of the answers that are committed but not yet in the log itself; the one that SQLite undoes half
/// a transaction with; and the lock of `SessionClaims`.
[[nodiscard]] std::filesystem::path ahead_file(const std::filesystem::path& given);
[[nodiscard]] std::filesystem::path journal_file(const std::filesystem::path& given);
[[nodiscard]] std::filesystem::path claims_file(const std::filesystem::path& given);

/// Throws InputError when the file has a second name that leads to it and to other files beside it: a hard
/// link, or a mount of the file alone (a container's). Answers that wait beside the one name would not be
/// seen under the other, and two programs would not see each other's locks.
void check_one_place(const std::filesystem::path& given);

/// Permissions of what is made beside a log: the log's own, as SQLite has it for the files that it makes.
[[nodiscard]] mode_t mode_of_log(const std::filesystem::path& place);

/// Copies a log with its write-ahead log and journal, while nobody writes to them, to `copy`, which may be
/// written to. Throws InputError when it cannot be read, or somebody goes on writing.
void copy_log(const std::filesystem::path& given, const std::filesystem::path& copy);

/// Which file a path leads to: a file that is deleted and made again, or another one moved there, differs.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t inode = 0;
  bool operator==(const FileIdentity&) const = default;
};

/// None where there is no file.
[[nodiscard]] std::optional<FileIdentity> file_identity(const std::filesystem::path& path);

}  // namespace seamline::study
