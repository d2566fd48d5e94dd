#pragma once
#include <sys/types.h>

namespace seamline::renderer {

enum class Lock { taken, busy, not_supported };

/// Asks for a lock of `type` (F_RDLCK, F_WRLCK, F_UNLCK) on one byte of an open file, which need not be so
/// long. Open file description locks: the kernel frees them when the process ends, however it ends. `how` is
/// F_OFD_SETLK, or F_OFD_SETLKW to wait.
Lock lock_byte(int descriptor, off_t byte, short type, int how);

/// Whether somebody else holds a lock on the byte. False too where the file system knows no locks, or keeps
/// those of other machines to itself.
[[nodiscard]] bool is_locked(int descriptor, off_t byte);

}  // namespace seamline::renderer
