#include "support/files/atomic_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "support/text/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

InputError unwritable(const fs::path& path, int error_number) {
  return input_error({.file = path.string(),
                      .wanted = "a place that can be written to",
                      .found = std::strerror(error_number)});
}

/// Of what could not be opened as a file.
std::string instead_of_file(const fs::path& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) return "a folder";
  if (::access(path.c_str(), R_OK) == 0) return "something that cannot be opened";
  if (errno == EACCES) return "one that you may not read (permission denied)";
  return errno == ENOENT || errno == ENOTDIR ? "none" : std::strerror(errno);
}

/// So that the new name outlives a power cut too. Some file systems cannot do it and say EINVAL.
void sync_folder(const fs::path& folder, const fs::path& shown) {
  const int descriptor = ::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;  // a folder that may be written to but not listed
  const int failed = ::fsync(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  if (failed != 0 && error_number != EINVAL && error_number != ENOTSUP) throw unwritable(shown, error_number);
}

/// Everything on the file system of a folder, by one flush.
void sync_everything_beside(const fs::path& folder, const fs::path& shown) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) throw unwritable(shown, errno);
  const int failed = ::syncfs(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  if (failed != 0) throw unwritable(shown, error_number);
}

/// An open file with a name that no other program can have: process ids are not enough, every container has
/// a process 1.
struct TemporaryFile {
  fs::path path;
  int descriptor = -1;
};

std::uint64_t random_bits(const fs::path& shown) {
  std::uint64_t bits = 0;
  while (::getrandom(&bits, sizeof bits, 0) != static_cast<ssize_t>(sizeof bits))
    if (errno != EINTR) throw unwritable(shown, errno);
  return bits;
}

/// Beside `target`; hidden, with its extension.
TemporaryFile begin_temporary(const fs::path& target, const fs::path& shown, Readers readers) {
  constexpr std::size_t longest_stem = 100, longest_extension = 20;  // a name has room for 255 bytes
  const std::string stem = target.stem().string().substr(0, longest_stem);
  const std::string extension = target.extension().string().substr(0, longest_extension);
  const mode_t mode = readers == Readers::owner ? 0600 : 0666;
  for (;;) {
    const fs::path path =
        target.parent_path() / fmt::format(".{}.{:016x}{}", stem, random_bits(shown), extension);
    // Made here and now, or not at all: neither a file nor a link that somebody laid there is opened.
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    if (descriptor >= 0) return {.path = path, .descriptor = descriptor};
    if (errno != EEXIST) throw unwritable(shown, errno);
  }
}

enum class Flush { now, with_folder };

/// Writes, flushes and closes.
void write_all(const TemporaryFile& file, const fs::path& shown, std::string_view bytes, Flush flush) {
  int error_number = 0;
  while (!bytes.empty() && error_number == 0) {
    const ssize_t written = ::write(file.descriptor, bytes.data(), bytes.size());
    if (written >= 0)
      bytes.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      error_number = errno;
  }
  if (error_number == 0 && flush == Flush::now && ::fsync(file.descriptor) != 0) error_number = errno;
  if (::close(file.descriptor) != 0 && error_number == 0) error_number = errno;
  if (error_number != 0) throw unwritable(shown, error_number);
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view bytes, Readers readers) {
  const TemporaryFile temporary = begin_temporary(path, path, readers);
  try {
    write_all(temporary, path, bytes, Flush::now);
    if (::rename(temporary.path.c_str(), path.c_str()) != 0) throw unwritable(path, errno);
  } catch (...) {
    ::unlink(temporary.path.c_str());
    throw;
  }
  sync_folder(path.parent_path(), path);
}

void write_unpublished_file(const fs::path& path, std::string_view bytes) {
  const int descriptor =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW | O_CLOEXEC, mode_t{0666});
  if (descriptor < 0) throw unwritable(path, errno);
  write_all({.path = path, .descriptor = descriptor}, path, bytes, Flush::with_folder);
}

void publish_folder(const fs::path& folder, const fs::path& name) {
  sync_everything_beside(folder, name);
  sync_folder(folder, name);
  if (::rename(folder.c_str(), name.c_str()) != 0) {
    if (errno != ENOTEMPTY && errno != EEXIST && errno != ENOTDIR) throw unwritable(name, errno);
    throw input_error({.file = name.string(),
                       .wanted = "a folder that is empty or not there yet",
                       .found = "something else of that name"});
  }
  sync_folder(name.parent_path(), name);
}

std::string read_file(const fs::path& path, std::int64_t most_bytes) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  if (!in || fs::is_directory(path, error))
    throw input_error({.file = path.string(), .wanted = "a readable file", .found = instead_of_file(path)});
  std::string bytes;
  if (const std::uintmax_t size = fs::file_size(path, error); !error)
    bytes.reserve(static_cast<std::size_t>(std::min(size, static_cast<std::uintmax_t>(most_bytes) + 1)));
  std::array<char, 1 << 16> block{};
  while (in.read(block.data(), block.size()) || in.gcount() > 0) {
    bytes.append(block.data(), static_cast<std::size_t>(in.gcount()));
    if (static_cast<std::int64_t>(bytes.size()) > most_bytes)
      throw input_error(
          {.file = path.string(), .wanted = fmt::format("at most {} bytes", most_bytes), .found = "more"});
  }
  return bytes;
}

void prepare_output_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw unwritable(folder, error.value());
  const TemporaryFile probe = begin_temporary(folder / "writable", folder, Readers::owner);
  ::close(probe.descriptor);
  ::unlink(probe.path.c_str());
}

}  // namespace seamline
