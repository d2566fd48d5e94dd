#include "study/log/session_claims.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "study/log/log_place.h"
#include "study/log/one_computer.h"
#include "support/files/held/byte_lock.h"
#include "support/text/error.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

InputError trouble(const fs::path& path, const std::string& wanted, int error) {
  return input_error({.file = path.string(), .wanted = wanted, .found = std::strerror(error)});
}

}  // namespace

SessionClaims::SessionClaims(const fs::path& log) : log_(log_place(log)), path_(claims_file(log)) {}

SessionClaims::~SessionClaims() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

void SessionClaims::open() {
  if (descriptor_ >= 0) return;
  const mode_t mode = mode_of_log(log_);
  descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  if (descriptor_ >= 0)
    ::fchmod(descriptor_, mode);  // whoever may write to the log may lock it, whatever the umask
  else if (errno == EEXIST)
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor_ < 0) throw trouble(path_, "a place where the log's lock file can be written", errno);
  try {
    claim_for_computer(descriptor_, path_, computer_place(path_));
  } catch (...) {
    ::close(descriptor_);
    descriptor_ = -1;
    throw;
  }
}

bool SessionClaims::claim(std::int64_t participant) {
  open();
  const Lock lock = lock_bytes(descriptor_, {.begin = participant}, F_WRLCK, F_OFD_SETLK);
  if (lock == Lock::not_supported) throw trouble(path_, "a file system that has locks", errno);
  return lock == Lock::taken;
}

bool SessionClaims::claimed_elsewhere(std::int64_t participant) {
  open();
  return is_locked(descriptor_, {.begin = participant});
}

bool is_claimed(const fs::path& log, std::int64_t participant) {
  const int descriptor = ::open(claims_file(log).c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool claimed = is_locked(descriptor, {.begin = participant});
  ::close(descriptor);
  return claimed;
}

}  // namespace seamline::study
