#include "sets/sharing/set_claim.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

#include "support/files/held/byte_lock.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

/// Bytes of the file that locks are taken on; it need not be so long. Everybody who renders shares the part;
/// one newcomer at a time goes through the gate, and reads the inputs or changes them.
constexpr ByteRange part_byte = {.begin = 1000}, gate_byte = {.begin = 1001};

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
  // A link in a set that somebody sent must not lead what is written here to another file.
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0) throw unwritable();
  if (lock_bytes(descriptor_, gate_byte, F_WRLCK, F_OFD_SETLKW) == Lock::not_supported) return;
  if (text_of(descriptor_) != inputs) {
    // Exclusive only when nobody else has a part: then the set is ours to change.
    if (lock_bytes(descriptor_, part_byte, F_WRLCK, F_OFD_SETLK) != Lock::taken) {
      ::close(descriptor_);
      throw input_error({.file = set_folder.string(),
                         .wanted = "a set that nobody is rendering with other settings or inputs",
                         .found = "another `seamline render` at work on it"});
    }
    if (!write_text(descriptor_, inputs)) throw unwritable();
  }
  lock_bytes(descriptor_, part_byte, F_RDLCK, F_OFD_SETLK);
  lock_bytes(descriptor_, gate_byte, F_UNLCK, F_OFD_SETLK);
}

SetClaim::~SetClaim() {
  ::close(descriptor_);
}

}  // namespace seamline::renderer
