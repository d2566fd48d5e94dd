#include "renderer/set_claim.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "stimuli/support/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

constexpr int attempts = 50;  ///< somebody may be writing the file this very moment
constexpr auto between_attempts = std::chrono::milliseconds(10);

enum class Lock { taken, busy, not_supported };

Lock lock_file(int descriptor, short type) {
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  if (::fcntl(descriptor, F_OFD_SETLK, &lock) == 0) return Lock::taken;
  return errno == EAGAIN || errno == EACCES ? Lock::busy : Lock::not_supported;
}

std::string text_of(int descriptor) {
  std::array<char, 256> text{};
  const ssize_t count = ::pread(descriptor, text.data(), text.size(), 0);
  return count > 0 ? std::string(text.data(), static_cast<std::size_t>(count)) : std::string();
}

bool write_text(int descriptor, const std::string& text) {
  return ::ftruncate(descriptor, 0) == 0 &&
         ::pwrite(descriptor, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size());
}

}  // namespace

SetClaim::SetClaim(const fs::path& set_folder, const std::string& inputs) {
  const fs::path path = set_folder / "records" / "rendered-with";
  const auto unwritable = [&] {
    const std::string found = std::strerror(errno);
    if (descriptor_ >= 0) ::close(descriptor_);
    return input_error({.file = path.string(), .wanted = "a place that can be written to", .found = found});
  };
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw unwritable();
  for (int attempt = 0; attempt < attempts; ++attempt) {
    const Lock shared = lock_file(descriptor_, F_RDLCK);
    if (shared == Lock::not_supported) return;
    if (shared == Lock::taken && text_of(descriptor_) == inputs) return;
    // A shared lock becomes an exclusive one only when nobody else holds one: then the set is ours to change.
    if (shared == Lock::taken && lock_file(descriptor_, F_WRLCK) == Lock::taken) {
      if (!write_text(descriptor_, inputs)) throw unwritable();
      static_cast<void>(lock_file(descriptor_, F_RDLCK));
      return;
    }
    lock_file(descriptor_, F_UNLCK);  // two newcomers would keep each other waiting
    std::this_thread::sleep_for(between_attempts);
  }
  ::close(descriptor_);
  throw input_error({.file = set_folder.string(),
                     .wanted = "a set that nobody is rendering with other settings or inputs",
                     .found = "another `seamline render` at work on it"});
}

SetClaim::~SetClaim() {
  ::close(descriptor_);
}

}  // namespace seamline
