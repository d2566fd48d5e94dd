// SIGKILL at random instants of render, study and analyze.
#include <fmt/core.h>

#include <algorithm>

#include "lab.h"
#include "support/arithmetic/random.h"

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

std::int64_t instant(Random& random, std::int64_t duration_us) {
  return 1 + static_cast<std::int64_t>(random.below(static_cast<std::uint64_t>(duration_us)));
}

/// Stimuli whose record says that they are finished.
int finished_stimuli(const Files& files) {
  return static_cast<int>(std::count_if(files.begin(), files.end(), [](const auto& file) {
    return file.first.starts_with("records/") && !file.first.starts_with("records/reference-");
  }));
}

int kept_from_before(const std::string& output) {
  const std::size_t words = output.find(" kept from before");
  if (words == std::string::npos) return 0;
  const std::size_t number = output.rfind(' ', words - 1);
  return std::stoi(output.substr(number + 1, words - number - 1));
}

}  // namespace

Tally kill_render(Lab& lab) {
  Tally tally{.fault = "SIGKILL of render"};
  Random random(lab.seed, 1);
  const fs::path set = lab.folder / "killed-set";
  int left_behind = 0;
  for (int round = 0; tally.tries < lab.tries(1, 60); ++round) {
    fs::remove_all(set);
    Files before;
    for (int kill = 0; kill <= round % 3; ++kill) {  // a run that continues may be killed as well
      const Ending ending = run(lab.render_command(set), {.kill_after_us = instant(random, lab.render_us)});
      if (!ending.killed && ending.status != 0) lab.complain(tally.fault, ending);
      ++tally.tries;
      const Files now = files_of(set);
      tally.lost += files_not_in(before, now) + files_not_in(now, lab.set_files);
      before = now;
    }
    left_behind += leftovers(set);
    tally.committed += static_cast<std::int64_t>(before.size());
    const int finished = finished_stimuli(before);
    const Ending again = rerun_render(lab, set, tally);
    tally.lost += std::max(0, finished - kept_from_before(again.output));
    if (finished > kept_from_before(again.output))
      lab.complain(tally.fault + ": finished stimuli were rendered again", again);
  }
  tally.note = fmt::format("{} temporary files left", left_behind);
  return tally;
}

Tally kill_study(Lab& lab) {
  Tally tally{.fault = "SIGKILL of study --observer"};
  Random random(lab.seed, 2);
  const fs::path log = lab.folder / "killed.sqlite";
  for (int round = 0; tally.tries < lab.tries(1, 100); ++round) {
    remove_log(log);
    for (int kill = 0; kill <= round % 3; ++kill) {
      std::vector<std::string> seen;  // by a second reader, an instant before
      const Ending ending = run(lab.study_command(log), {.kill_after_us = instant(random, lab.study_us),
                                                         .before_kill = [&] { seen = answers_of(log); }});
      if (!ending.killed && ending.status != 0) lab.complain(tally.fault, ending);
      ++tally.tries;
      const std::vector<std::string> kept = answers_of(log);
      tally.committed += static_cast<std::int64_t>(seen.size());
      tally.lost += missing(seen, kept) + missing(kept, lab.log_answers);
      if (fs::exists(log) && fs::file_size(log) > 0 && !is_sound(log))
        lab.complain(tally.fault + ": the log is unsound", ending);
    }
    rerun_study(lab, log, tally);
  }
  return tally;
}

Tally kill_analyze(Lab& lab) {
  Tally tally{.fault = "SIGKILL of analyze"};
  Random random(lab.seed, 3);
  const fs::path report = lab.folder / "killed-report";
  for (int round = 0; round < lab.tries(0, 20); ++round) {
    fs::remove_all(report);
    const Ending ending =
        run(lab.analyze_command(lab.log, report), {.kill_after_us = instant(random, lab.analyze_us)});
    if (!ending.killed && ending.status != 0) lab.complain(tally.fault, ending);
    ++tally.tries;
    tally.committed += static_cast<std::int64_t>(lab.log_rows.size());
    tally.lost += missing(lab.log_rows, rows_of(lab.log));
    rerun_analyze(lab, report, tally);
  }
  return tally;
}

Tally kill_upgrade(Lab& lab) {
  Tally tally{.fault = "SIGKILL of log upgrade"};
  Random random(lab.seed, 4);
  const fs::path folder = lab.folder / "killed-upgrade", upgraded = folder / "new.sqlite";
  int left_behind = 0;
  for (int round = 0; round < lab.tries(2, 100); ++round) {
    fs::remove_all(folder);
    fs::create_directories(folder);
    const Ending ending =
        run(lab.upgrade_command(upgraded), {.kill_after_us = instant(random, lab.upgrade_us)});
    left_behind += check_upgrade(lab, tally, upgraded, ending, tally.fault) ? 1 : 0;
    rerun_upgrade(lab, upgraded, tally);
  }
  tally.note = fmt::format("{} temporary folders left", left_behind);
  return tally;
}

}  // namespace seamline::faults
