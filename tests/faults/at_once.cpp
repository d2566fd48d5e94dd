// Two programs at once: two renders into one set, two studies into one log.
#include <fmt/core.h>

#include "lab.h"

namespace seamline::faults {
namespace fs = std::filesystem;

Tally renders_at_once(Lab& lab) {
  Tally tally{.fault = "two renders into one set at once"};
  for (int at = 0; at < lab.tries(1, 15); ++at) {
    const fs::path set = lab.folder / "shared-set";
    fs::remove_all(set);
    const Child one = start(lab.render_command(set)), other = start(lab.render_command(set));
    const Ending first = finish(one), second = finish(other);
    lab.completes(tally.fault, first);
    lab.completes(tally.fault, second);
    ++tally.tries;
    const Files files = files_of(set);
    tally.committed += static_cast<std::int64_t>(lab.set_files.size());
    tally.lost += files_not_in(lab.set_files, files);
    rerun_render(lab, set, tally);
  }
  return tally;
}

Tally shards_at_once(Lab& lab) {
  Tally tally{.fault = "three shards of one set at once"};
  for (int at = 0; at < lab.tries(0, 8); ++at) {
    const fs::path set = lab.folder / "shared-set";
    fs::remove_all(set);
    std::vector<Child> shards;
    for (const char* shard : {"1/3", "2/3", "3/3"}) {
      Arguments command = lab.render_command(set);
      command.insert(command.end(), {"--shard", shard});
      shards.push_back(start(command));
    }
    for (const Child& shard : shards) lab.completes(tally.fault, finish(shard));
    ++tally.tries;
    tally.committed += static_cast<std::int64_t>(lab.set_files.size());
    tally.lost += files_not_in(lab.set_files, files_of(set));
    rerun_render(lab, set, tally);
  }
  return tally;
}

namespace {

/// Runs the rest as process 1 of a PID namespace of its own, as a container does; empty where nobody may.
Arguments container() {
  for (const Arguments& words :
       {Arguments{"/usr/bin/unshare", "--pid", "--fork", "--mount-proc"},
        Arguments{"/usr/bin/unshare", "--user", "--map-root-user", "--pid", "--fork", "--mount-proc"}}) {
    Arguments probe = words;
    probe.insert(probe.end(), {"/bin/sh", "-c", "test $$ = 1"});
    if (run(probe).status == 0) return words;
  }
  return {};
}

}  // namespace

Tally containers_at_once(Lab& lab) {
  const int count = lab.quick ? 4 : 32;
  Tally tally{.fault = fmt::format("{} shards, each process 1 of a container", count)};
  const Arguments in_container = container();
  if (in_container.empty()) {
    tally.note = "skipped: unshare is not permitted here";
    return tally;
  }
  int failed = 0;
  for (int at = 0; at < lab.tries(1, 8); ++at) {
    const fs::path set = lab.folder / "shared-set";
    fs::remove_all(set);
    std::vector<Child> shards;
    for (int shard = 1; shard <= count; ++shard) {
      Arguments command = in_container;
      const Arguments render = lab.render_command(set);
      command.insert(command.end(), render.begin(), render.end());
      command.insert(command.end(), {"--threads", "1", "--shard", fmt::format("{}/{}", shard, count)});
      shards.push_back(start(command));
    }
    for (const Child& shard : shards) failed += lab.completes(tally.fault, finish(shard)) ? 0 : 1;
    ++tally.tries;
    tally.committed += static_cast<std::int64_t>(lab.set_files.size());
    tally.lost += files_not_in(lab.set_files, files_of(set)) + leftovers(set);
    rerun_render(lab, set, tally);
  }
  tally.note = fmt::format("{} of {} shards failed", failed, tally.tries * count);
  return tally;
}

/// Another number of samples is another picture under the same name: one of the two must be refused, or the
/// set must be that of one of them.
Tally other_settings_at_once(Lab& lab) {
  Tally tally{.fault = "renders with other settings at once"};
  int refused = 0;
  for (int at = 0; at < lab.tries(0, 20); ++at) {
    const fs::path set = lab.folder / "shared-set";
    fs::remove_all(set);
    Arguments more_samples = lab.render_command(set);
    more_samples.insert(more_samples.end(), {"--spp", "4"});
    const Child one = start(lab.render_command(set)), other = start(more_samples);
    for (const Ending& ending : {finish(one), finish(other)}) {
      refused += ending.status == 1 ? 1 : 0;
      if (ending.status != 0) lab.refuses(tally.fault, ending);
    }
    ++tally.tries;
    const Ending verified = run({lab.program, "verify", set});
    if (verified.status != 0) lab.complain(tally.fault + ": the set is mixed", verified);
    ++tally.committed;
    tally.lost += verified.status == 0 ? 0 : 1;
    rerun_render(lab, set, tally);
  }
  if (tally.tries > 0) tally.note = fmt::format("{} refused", refused);
  return tally;
}

Tally studies_at_once(Lab& lab) {
  Tally tally{.fault = "two studies into one log at once"};
  for (int at = 0; at < lab.tries(1, 30); ++at) {
    const fs::path log = lab.folder / "shared.sqlite";
    remove_log(log);
    const Child one = start(lab.study_command(log)), other = start(lab.study_command(log));
    const Ending first = finish(one), second = finish(other);
    lab.completes(tally.fault, first);
    lab.completes(tally.fault, second);
    ++tally.tries;
    tally.committed += static_cast<std::int64_t>(lab.log_answers.size());
    tally.lost += missing(lab.log_answers, answers_of(log));
    rerun_study(lab, log, tally);
  }
  return tally;
}

Tally clock_set_back(Lab& lab) {
  Tally tally{.fault = "clock set back during and between studies"};
  // Seconds since 1970 at the start, and at each look: from now backwards, around 1970 and before, and
  // leaping.
  const std::vector<std::pair<long long, long long>> clocks = {
      {1800000000, -1}, {1800000000, -86400}, {3, -1}, {-100000, -1}, {1, 0}, {4000000000, -7}};
  for (const auto& [start_s, step_s] : clocks) {
    if (tally.tries >= lab.tries(1, static_cast<int>(clocks.size()))) break;
    const fs::path log = lab.folder / "clock.sqlite";
    remove_log(log);
    const std::vector<std::string> clock = {"LD_PRELOAD=" + lab.clock_shim.string(),
                                            fmt::format("SEAMLINE_CLOCK_START_S={}", start_s),
                                            fmt::format("SEAMLINE_CLOCK_STEP_S={}", step_s)};
    Arguments half = lab.study_command(log);
    half[8] = "26";  // --count: the rest comes after the clock was set back once more
    lab.completes(tally.fault, run(half, {.environment = clock}));
    const std::vector<std::string> kept = answers_of(log);
    lab.completes(tally.fault, run({lab.program, "log", "status", log}, {.environment = clock}));
    ++tally.tries;
    tally.committed += static_cast<std::int64_t>(kept.size());
    rerun_study(lab, log, tally);
    tally.lost += missing(kept, answers_of(log)) + (kept.empty() ? 1 : 0);
  }
  return tally;
}

}  // namespace seamline::faults
