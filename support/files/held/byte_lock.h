#pragma once
#include <sys/types.h>

namespace seamline {

/// Bytes of an open file that a lock is asked for; the file need not be so long.
struct ByteRange {
  off_t begin = 0;
  off_t count = 1;  ///< 0: none
};

enum class Lock { taken, busy, not_supported };

/// Asks for a lock of `type` (F_RDLCK, F_WRLCK, F_UNLCK) on the bytes. Open file description locks: they
/// belong to the open file, and the kernel frees them when the process ends, however it ends. `how` is
/// F_OFD_SETLK, or F_OFD_SETLKW to wait. After `not_supported` errno says why.
Lock lock_bytes(int descriptor, ByteRange bytes, short type, int how);

/// Whether somebody else holds a lock on any of the bytes. False too where the file system knows no locks, or
/// keeps those of other machines to itself.
[[nodiscard]] bool is_locked(int descriptor, ByteRange bytes);

}  // namespace seamline
