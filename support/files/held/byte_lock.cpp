#include "support/files/held/byte_lock.h"

#include <fcntl.h>

#include <cerrno>

namespace seamline {
namespace {

struct flock lock_of(ByteRange bytes, short type) {
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = bytes.begin;
  lock.l_len = bytes.count;
  return lock;
}

}  // namespace

Lock lock_bytes(int descriptor, ByteRange bytes, short type, int how) {
  if (bytes.count == 0) return Lock::taken;  // to fcntl, 0 is everything behind `begin`
  struct flock lock = lock_of(bytes, type);
  while (::fcntl(descriptor, how, &lock) != 0)
    if (errno != EINTR) return errno == EAGAIN || errno == EACCES ? Lock::busy : Lock::not_supported;
  return Lock::taken;
}

bool is_locked(int descriptor, ByteRange bytes) {
  if (bytes.count == 0) return false;
  struct flock lock = lock_of(bytes, F_WRLCK);
  return ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

}  // namespace seamline
