#include "renderer/set/sharing/byte_lock.h"

#include <fcntl.h>

#include <cerrno>
#include <cstdio>

namespace seamline::renderer {
namespace {

struct flock one_byte(off_t byte, short type) {
  struct flock lock = {};
  lock.l_type = type;
  lock.l_whence = SEEK_SET;
  lock.l_start = byte;
  lock.l_len = 1;
  return lock;
}

}  // namespace

Lock lock_byte(int descriptor, off_t byte, short type, int how) {
  struct flock lock = one_byte(byte, type);
  while (::fcntl(descriptor, how, &lock) != 0)
    if (errno != EINTR) return errno == EAGAIN || errno == EACCES ? Lock::busy : Lock::not_supported;
  return Lock::taken;
}

bool is_locked(int descriptor, off_t byte) {
  struct flock lock = one_byte(byte, F_WRLCK);
  return ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

}  // namespace seamline::renderer
