#include "study/log/recovery/new_log.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "study/log/log_place.h"
#include "support/text/error.h"

namespace seamline::study {
namespace fs = std::filesystem;
namespace {

InputError taken(const fs::path& file) {
  return input_error({.file = file.string(), .wanted = "a file that does not exist yet", .found = "one"});
}

InputError unwritable(const fs::path& out, int error_number) {
  return input_error({.file = out.string(),
                      .wanted = "a place where a log can be written",
                      .found = std::strerror(error_number)});
}

/// Some file systems cannot flush a folder and say EINVAL.
void flush(const fs::path& file, int flags, const fs::path& out) {
  const int descriptor = ::open(file.empty() ? "." : file.c_str(), O_RDONLY | O_CLOEXEC | flags);
  if (descriptor < 0) throw unwritable(out, errno);
  const int error_number = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  if (error_number != 0 && error_number != EINVAL && error_number != ENOTSUP)
    throw unwritable(out, error_number);
}

}  // namespace

void check_is_free(const fs::path& out) {
  for (const fs::path& file : {out, ahead_file(out), journal_file(out)})
    if (fs::exists(fs::symlink_status(file))) throw taken(file);
}

void take_name(const fs::path& made, const fs::path& out) {
  flush(made, 0, out);
  int failed = ::renameat2(AT_FDCWD, made.c_str(), AT_FDCWD, out.c_str(), RENAME_NOREPLACE);
  if (failed != 0 && (errno == EINVAL || errno == ENOSYS)) {  // a file system that cannot promise it
    check_is_free(out);
    failed = ::rename(made.c_str(), out.c_str());
  }
  if (failed != 0 && errno == EEXIST) throw taken(out);
  if (failed != 0) throw unwritable(out, errno);
  flush(out.parent_path(), O_DIRECTORY, out);
}

}  // namespace seamline::study
