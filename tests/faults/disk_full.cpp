// A disk without room at every position: by a limit on the size of files, and on a small file system.
#include <fmt/core.h>
#include <sys/mount.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <functional>

#include "compare.h"
#include "lab.h"

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

std::uintmax_t largest(const Files& files) {
  std::uintmax_t bytes = 0;
  for (const auto& [name, text] : files) bytes = std::max<std::uintmax_t>(bytes, text.size());
  return bytes;
}

std::uintmax_t sum(const Files& files) {
  std::uintmax_t bytes = 0;
  for (const auto& [name, text] : files) bytes += (text.size() + 4095) / 4096 * 4096;
  return bytes;
}

/// Position number `at` of `count`, between 0 and `end`, denser at the beginning where most files end.
std::uint64_t position(int at, int count, std::uintmax_t end) {
  const double share = static_cast<double>(at + 1) / (count + 1);
  return static_cast<std::uint64_t>(share * share * static_cast<double>(end));
}

/// Tries `count` positions up to `end`.
void sweep(int count, std::uintmax_t end, const std::function<void(std::uint64_t bytes)>& attempt) {
  for (int at = 0; at < count; ++at) attempt(position(at, count, end));
}

std::string at_most(const std::string& command, std::uint64_t bytes) {
  return fmt::format("{}, files of at most {} bytes", command, bytes);
}

/// What every try asks of a run that had no room for the files of a set or report: it says so, and what it
/// leaves is whole.
void check_files(Lab& lab, Tally& tally, const fs::path& folder, const Files& undisturbed,
                 const Ending& ending, const std::string& what) {
  ++tally.tries;
  if (ending.status != 0) lab.refuses(what, ending);
  const Files left = files_of(folder);
  tally.committed += static_cast<std::int64_t>(left.size());
  tally.lost += files_not_in(left, undisturbed);
  if (leftovers(folder) > 0) lab.complaints.push_back(what + ": temporary files were left behind");
}

void check_log(Lab& lab, Tally& tally, const fs::path& log, const Ending& ending, const std::string& what) {
  ++tally.tries;
  if (ending.status != 0) lab.refuses(what, ending);
  const std::vector<std::string> kept = answers_of(log);
  tally.committed += static_cast<std::int64_t>(kept.size());
  tally.lost += missing(kept, lab.log_answers);
  if (fs::exists(log) && fs::file_size(log) > 0 && !is_sound(log))
    lab.complaints.push_back(what + ": the log is unsound");
}

/// A file system of so many bytes; nothing when we may not make one.
class SmallDisk {
 public:
  SmallDisk(fs::path at, std::uint64_t bytes) : at_(std::move(at)) {
    fs::create_directories(at_);
    made_ = ::mount("tmpfs", at_.c_str(), "tmpfs", 0, fmt::format("size={}", bytes).c_str()) == 0;
  }
  ~SmallDisk() {
    if (made_) ::umount2(at_.c_str(), MNT_DETACH);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;
  [[nodiscard]] bool made() const { return made_; }
  void grow() const { ::mount("tmpfs", at_.c_str(), "tmpfs", MS_REMOUNT, "size=64m"); }

 private:
  fs::path at_;
  bool made_ = false;
};

}  // namespace

Tally limit_render(Lab& lab) {
  Tally tally{.fault = "file size limit, render"};
  const fs::path set = lab.folder / "limited-set";
  sweep(lab.tries(1, 20), largest(lab.set_files) + 2048, [&](std::uint64_t bytes) {
    fs::remove_all(set);
    const Ending ending = run(lab.render_command(set), {.file_limit_bytes = bytes});
    check_files(lab, tally, set, lab.set_files, ending, at_most("render", bytes));
    rerun_render(lab, set, tally);
  });
  return tally;
}

Tally limit_study(Lab& lab) {
  Tally tally{.fault = "file size limit, study --observer"};
  const fs::path log = lab.folder / "limited.sqlite";
  // The write-ahead log grows beyond the log.
  sweep(lab.tries(2, 50), 3 * fs::file_size(lab.log), [&](std::uint64_t bytes) {
    remove_log(log);
    const Ending ending = run(lab.study_command(log), {.file_limit_bytes = bytes});
    check_log(lab, tally, log, ending, at_most("study", bytes));
    rerun_study(lab, log, tally);
  });
  return tally;
}

Tally limit_analyze(Lab& lab) {
  Tally tally{.fault = "file size limit, analyze"};
  const fs::path report = lab.folder / "limited-report";
  sweep(lab.tries(0, 20), largest(lab.report_files) + 4096, [&](std::uint64_t bytes) {
    fs::remove_all(report);
    const Ending ending = run(lab.analyze_command(lab.log, report), {.file_limit_bytes = bytes});
    check_files(lab, tally, report, lab.report_files, ending, at_most("analyze", bytes));
    rerun_analyze(lab, report, tally);
  });
  return tally;
}

Tally small_disk(Lab& lab) {
  Tally tally{.fault = "full disk (tmpfs), render and study"};
  const fs::path place = lab.folder / "small-disk";
  const int count = lab.tries(1, 20);
  for (int at = 0; at < count; ++at) {
    const std::uint64_t set_bytes = page_bytes * (1 + position(at, count, sum(lab.set_files) / page_bytes));
    const SmallDisk for_set(place, set_bytes);
    if (!for_set.made()) {
      tally.note = fmt::format("left out: no file system can be made here ({})", std::strerror(errno));
      return tally;
    }
    const Ending rendering = run(lab.render_command(place / "set"));
    check_files(lab, tally, place / "set", lab.set_files, rendering,
                fmt::format("render on a disk of {} bytes", set_bytes));
    for_set.grow();
    rerun_render(lab, place / "set", tally);
  }
  for (int at = 0; at < count; ++at) {
    const std::uint64_t log_bytes =
        page_bytes * (1 + position(at, count, 4 * fs::file_size(lab.log) / page_bytes));
    const SmallDisk for_log(place, log_bytes);
    const Ending session = run(lab.study_command(place / "log.sqlite"));
    for_log.grow();  // a reader needs room too
    check_log(lab, tally, place / "log.sqlite", session,
              fmt::format("study on a disk of {} bytes", log_bytes));
    rerun_study(lab, place / "log.sqlite", tally);
  }
  return tally;
}

Tally limit_upgrade(Lab& lab) {
  Tally tally{.fault = "file size limit, log upgrade"};
  const fs::path folder = lab.folder / "limited-upgrade", upgraded = folder / "new.sqlite";
  sweep(lab.tries(2, 30), lab.old_log_bytes.size() + 8 * page_bytes, [&](std::uint64_t bytes) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const Ending ending = run(lab.upgrade_command(upgraded), {.file_limit_bytes = bytes});
    (void)check_upgrade(lab, tally, upgraded, ending, at_most("upgrade", bytes));
    rerun_upgrade(lab, upgraded, tally);
  });
  return tally;
}

Tally small_disk_upgrade(Lab& lab) {
  Tally tally{.fault = "full disk (tmpfs), log upgrade"};
  const fs::path place = lab.folder / "small-disk", upgraded = place / "new.sqlite";
  sweep(lab.tries(2, 40), 4 * lab.old_log_bytes.size() / page_bytes, [&](std::uint64_t pages) {
    const SmallDisk disk(place, page_bytes * (1 + pages));
    if (!disk.made()) {
      tally.note = fmt::format("left out: no file system can be made here ({})", std::strerror(errno));
      return;
    }
    const std::string what = fmt::format("upgrade on a disk of {} pages", 1 + pages);
    const Ending ending = run(lab.upgrade_command(upgraded));
    disk.grow();  // a reader needs room too
    (void)check_upgrade(lab, tally, upgraded, ending, what);
    rerun_upgrade(lab, upgraded, tally);
  });
  return tally;
}

}  // namespace seamline::faults
