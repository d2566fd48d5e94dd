#include "support/running/standard_streams.h"

#include <fcntl.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>

#include "support/text/error.h"

namespace seamline {
namespace {

/// Where a stream writes to, and why it no longer does.
struct Outlet {
  int descriptor;
  std::atomic<int> error_number = 0;  ///< of the first write that failed; nothing is written after it
};

Outlet standard_output{STDOUT_FILENO};
Outlet standard_error{STDERR_FILENO};

/// Of a stream that takes everything: libraries would throw, or end the program, in the middle of its work.
ssize_t write_or_lose(void* cookie, const char* bytes, std::size_t count) {
  auto& outlet = *static_cast<Outlet*>(cookie);
  for (std::size_t done = 0; done < count && outlet.error_number == 0;) {
    const ssize_t written = ::write(outlet.descriptor, bytes + done, count - done);
    if (written >= 0)
      done += static_cast<std::size_t>(written);
    else if (errno != EINTR)
      outlet.error_number = errno;
  }
  return static_cast<ssize_t>(count);
}

/// glibc lets a program put another stream in the place of a standard one.
void replace(FILE*& stream, Outlet& outlet, int buffering) {
  FILE* const made = ::fopencookie(
      &outlet, "w", {.read = nullptr, .write = write_or_lose, .seek = nullptr, .close = nullptr});
  if (made == nullptr) return;
  std::setvbuf(made, nullptr, buffering, BUFSIZ);
  stream = made;
}

}  // namespace

void guard_standard_streams() {
  for (const int descriptor : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (::fcntl(descriptor, F_GETFD) < 0) {
      // The lowest free number is this one. For reading only, so that what is written there counts as lost.
      const int opened = ::open("/dev/null", O_RDONLY);
      (void)opened;
    }
  replace(stdout, standard_output, ::isatty(STDOUT_FILENO) == 1 ? _IOLBF : _IOFBF);
  replace(stderr, standard_error, _IONBF);
}

void require_standard_output() {
  std::fflush(stdout);
  if (const int number = standard_output.error_number; number != 0)
    throw input_error({.file = "standard output",
                       .wanted = "a place that takes all that is printed",
                       .found = number == EBADF ? "it closed" : std::strerror(number)});
}

}  // namespace seamline
