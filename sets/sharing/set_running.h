#pragma once
#include <chrono>
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::renderer {

/// This process' mark in `SET/records/running/NAME.json`: host, how many of its stimuli are done. Written
/// again at least every ten seconds while work goes on, and removed at the end, also of an interrupted job.
/// As long as the process lives it holds a lock that bears the mark's name (a byte of
/// `records/rendered-with`), where the file system knows locks: that tells a process at work from one that
/// was killed, without a clock.
class RunningMark {
 public:
  /// `name` is the element's; `done` of `stimuli` are finished already. The set's claim is taken by now.
  RunningMark(const std::filesystem::path& set_folder, std::string name, int done, int stimuli);
  ~RunningMark();
  RunningMark(const RunningMark&) = delete;
  RunningMark& operator=(const RunningMark&) = delete;

  void finished_one();
  /// Cheap enough to be called for every tile.
  void alive();

 private:
  void write();

  std::filesystem::path path_;
  std::string name_;
  int done_, stimuli_;
  int lock_ = -1;  ///< descriptor of the file that it is in
  bool locked_ = false;
  std::chrono::steady_clock::time_point written_{};
};

/// Leaves a mark that says why a piece of work ended. It stays until the piece comes to work again.
void leave_complaint(const std::filesystem::path& set_folder, const std::string& name,
                     const std::string& complaint);

/// A mark that somebody left, and what is known of its process.
struct FoundMark {
  enum class Life {
    working,    ///< it holds its lock
    ended,      ///< it does not, and would if it lived
    not_known,  ///< no lock can be seen from here: the mark's age is all there is
  };
  std::string name, host;
  std::string complaint;  ///< empty: none
  int done = 0, of = 0;
  double age_s = 0;  ///< since it was written, by the clock of the set's file system
  Life life = Life::not_known;
};

/// All marks of a set, by name. What is no mark (a damaged file, somebody else's) is left out.
[[nodiscard]] std::vector<FoundMark> read_marks(const std::filesystem::path& set_folder);

/// Age of a mark in seconds from which on its process is taken for dead, where no lock says so.
inline constexpr double dead_after_s = 90;

}  // namespace seamline::renderer
