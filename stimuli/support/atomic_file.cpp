#include "stimuli/support/atomic_file.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

#include "stimuli/support/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

InputError unwritable(const fs::path& path, int error_number) {
  return input_error({.file = path.string(),
                      .wanted = "a place that can be written to",
                      .found = std::strerror(error_number)});
}

void sync_file(const fs::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) throw unwritable(path, errno);
  const int failed = ::fsync(descriptor);
  const int error_number = errno;
  ::close(descriptor);
  if (failed != 0) throw unwritable(path, error_number);
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

void write_all(const fs::path& path, const fs::path& shown, std::string_view bytes) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) throw unwritable(shown, errno);
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) {
      const int error_number = errno;
      ::close(descriptor);
      throw unwritable(shown, error_number);
    }
    bytes.remove_prefix(static_cast<std::size_t>(written));
  }
  if (::close(descriptor) != 0) throw unwritable(shown, errno);
}

}  // namespace

void write_file_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  const fs::path temporary = path.parent_path() / ("." + path.stem().string() + "." +
                                                   std::to_string(::getpid()) + path.extension().string());
  try {
    write(temporary);
    sync_file(temporary);
    if (::rename(temporary.c_str(), path.c_str()) != 0) throw unwritable(path, errno);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  sync_folder(path.parent_path(), path);
}

void write_file_atomically(const fs::path& path, std::string_view bytes) {
  write_file_atomically(path, [&](const fs::path& temporary) { write_all(temporary, path, bytes); });
}

std::string read_file(const fs::path& path, std::int64_t most_bytes) {
  std::ifstream in(path, std::ios::binary);
  std::error_code error;
  if (!in || fs::is_directory(path, error))
    throw input_error({.file = path.string(),
                       .wanted = "a readable file",
                       .found = fs::exists(path, error) ? "something else" : "none"});
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
  const fs::path probe = folder / (".writable." + std::to_string(::getpid()));
  write_all(probe, folder, "");
  ::unlink(probe.c_str());
}

}  // namespace seamline
