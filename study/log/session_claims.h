#pragma once
#include <cstdint>
#include <filesystem>

namespace seamline::study {

/// Which participants of a log are in a session right now: a lock on one byte of a file beside the log
/// (`claims_file`) for each, byte N for participant N. The file is empty and stays so. The locks belong to
/// the open file (F_OFD_SETLK), so the kernel frees them when the process ends, however it ends, and two
/// programs can run sessions of one log at once.
class SessionClaims {
 public:
  explicit SessionClaims(const std::filesystem::path& log);
  ~SessionClaims();
  SessionClaims(const SessionClaims&) = delete;
  SessionClaims& operator=(const SessionClaims&) = delete;

  /// Opens or makes the file, which the other calls do by themselves: logs of simulated people need none.
  /// Throws InputError when it cannot be made.
  void open();

  /// Takes the participant for this program; false when another one has them. Taking twice is taking once.
  /// Throws InputError when the file system knows no locks.
  [[nodiscard]] bool claim(std::int64_t participant);
  [[nodiscard]] bool claimed_elsewhere(std::int64_t participant);

 private:
  std::filesystem::path log_, path_;
  int descriptor_ = -1;
};

/// Whether any program has the participant; for readers. False where there is no file.
[[nodiscard]] bool is_claimed(const std::filesystem::path& log, std::int64_t participant);

}  // namespace seamline::study
