#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "compare.h"
#include "process.h"

namespace seamline::faults {

/// One line of the table.
struct Tally {
  std::string fault;
  int tries = 0;
  std::int64_t committed = 0;  ///< things that were there before the fault, summed over the tries
  std::int64_t lost = 0;       ///< of them; must be 0
  int reruns = 0;              ///< that came to their end
  int equal = 0;               ///< reruns whose result equals that of an undisturbed run
  std::string note = {};
};

/// Where faults are tried: the program, a tiny study, and what an undisturbed run makes of it.
struct Lab {
  std::filesystem::path program, folder, clock_shim;
  bool quick = false;
  std::uint64_t seed = 1;

  std::filesystem::path study_file, set, log, report;  ///< of the undisturbed run
  std::filesystem::path old_log;                       ///< as a program of schema version 2 wrote the log
  std::filesystem::path
      answered_set;  ///< four widths, so that answers to it can be analysed; the log is of this set
  Files set_files, report_files;
  std::string old_log_bytes;
  std::vector<std::string> log_rows, log_answers;
  std::int64_t render_us = 0, study_us = 0, analyze_us = 0,
               upgrade_us = 0;               ///< durations of the undisturbed run
  std::vector<std::string> complaints = {};  ///< whatever was not as promised

  [[nodiscard]] int tries(int quick_tries, int long_tries) const { return quick ? quick_tries : long_tries; }
  [[nodiscard]] Arguments render_command(const std::filesystem::path& out) const;
  [[nodiscard]] Arguments study_command(const std::filesystem::path& into) const;
  [[nodiscard]] Arguments analyze_command(const std::filesystem::path& from,
                                          const std::filesystem::path& out) const;
  [[nodiscard]] Arguments upgrade_command(const std::filesystem::path& into) const;

  /// Notes what was not as promised; `what` names fault and try.
  void complain(const std::string& what, const Ending& ending);
  /// The run ended with status 0; complains otherwise.
  bool completes(const std::string& what, const Ending& ending);
  /// The run ended with status 1 and one sentence of ours; complains otherwise.
  bool refuses(const std::string& what, const Ending& ending);
};

/// Makes the tiny study and runs it undisturbed.
[[nodiscard]] Lab open_lab(const std::filesystem::path& program, const std::filesystem::path& clock_shim,
                           const std::filesystem::path& folder, bool quick);

/// A rerun of the same command: whether it completes, and whether the result equals the undisturbed one.
Ending rerun_render(Lab& lab, const std::filesystem::path& set, Tally& tally);
void rerun_study(Lab& lab, const std::filesystem::path& log, Tally& tally);
void rerun_analyze(Lab& lab, const std::filesystem::path& report, Tally& tally);

/// What every try asks of `log upgrade`: the old log has its bytes, the new one is there whole or not at
/// all, and nothing else lies in its folder but after a kill, when this returns true. `rerun_upgrade` removes
/// the new one and makes it undisturbed.
bool check_upgrade(Lab& lab, Tally& tally, const std::filesystem::path& into, const Ending& ending,
                   const std::string& what);
void rerun_upgrade(Lab& lab, const std::filesystem::path& into, Tally& tally);

// The faults, one function a line of the table.
[[nodiscard]] Tally kill_render(Lab& lab);
[[nodiscard]] Tally kill_study(Lab& lab);
[[nodiscard]] Tally kill_analyze(Lab& lab);
[[nodiscard]] Tally kill_upgrade(Lab& lab);
[[nodiscard]] Tally limit_render(Lab& lab);
[[nodiscard]] Tally limit_study(Lab& lab);
[[nodiscard]] Tally limit_analyze(Lab& lab);
[[nodiscard]] Tally limit_upgrade(Lab& lab);
[[nodiscard]] Tally small_disk(Lab& lab);
[[nodiscard]] Tally small_disk_upgrade(Lab& lab);
[[nodiscard]] Tally change_pictures(Lab& lab);
[[nodiscard]] Tally renders_at_once(Lab& lab);
[[nodiscard]] Tally shards_at_once(Lab& lab);
[[nodiscard]] Tally containers_at_once(Lab& lab);
[[nodiscard]] Tally other_settings_at_once(Lab& lab);
[[nodiscard]] Tally studies_at_once(Lab& lab);
[[nodiscard]] Tally clock_set_back(Lab& lab);

}  // namespace seamline::faults
