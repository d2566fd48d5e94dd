#include "lab.h"

#include <fmt/core.h>

#include <stdexcept>

#include "tests/study/schema_2_log.h"
#include "tiny_study.h"

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

constexpr const char* quick_people = "30";  // more than one transaction of the simulation
constexpr const char* many_people = "200";

Ending must_run(const Arguments& command) {
  Ending ending = run(command);
  if (ending.status != 0)
    throw std::runtime_error(fmt::format("{} ended with {}: {}", command[1], ending.status, ending.output));
  return ending;
}

}  // namespace

Arguments Lab::render_command(const fs::path& out) const {
  return {program, "render", study_file, "--out", out};
}

Arguments Lab::study_command(const fs::path& into) const {
  return {program,     "study",   answered_set,
          "--log",     into,      "--observer",
          "threshold", "--count", quick ? quick_people : many_people,
          "--seed",    "5"};
}

Arguments Lab::analyze_command(const fs::path& from, const fs::path& out) const {
  return {program, "analyze", from, "--out", out, "--bootstrap", "100", "--seed", "1"};
}

Arguments Lab::upgrade_command(const fs::path& into) const {
  return {program, "log", "upgrade", old_log, into};
}

void Lab::complain(const std::string& what, const Ending& ending) {
  complaints.push_back(fmt::format("{}: status {}: {}", what, ending.status, ending.output));
}

bool Lab::completes(const std::string& what, const Ending& ending) {
  if (ending.status != 0) complain(what + ": the rerun should complete", ending);
  return ending.status == 0;
}

bool Lab::refuses(const std::string& what, const Ending& ending) {
  const std::size_t sentence = ending.output.find("seamline: ");
  const bool one_sentence =
      sentence != std::string::npos && ending.output.find("wanted") != std::string::npos;
  if (ending.status == 1 && one_sentence) return true;
  complain(what + ": should be refused with status 1 and a sentence", ending);
  return false;
}

Lab open_lab(const fs::path& program, const fs::path& clock_shim, const fs::path& folder, bool quick) {
  Lab lab;
  lab.program = program;
  lab.folder = folder;
  lab.clock_shim = clock_shim;
  lab.quick = quick;
  fs::remove_all(folder);
  const char* artifacts = quick ? "\"none\"" : R"("receiver", "shadow", "occlusion", "overlap")";
  lab.study_file = write_tiny_study(folder / "study", quick ? 4 : 1, artifacts);
  const fs::path answered_study = write_tiny_study(folder / "answered-study", 4, artifacts);
  lab.answered_set = folder / "undisturbed" / "answered-set";
  lab.set = folder / "undisturbed" / "set";
  lab.log = folder / "undisturbed" / "log.sqlite";
  lab.report = folder / "undisturbed" / "report";
  lab.render_us = must_run(lab.render_command(lab.set)).duration_us;
  must_run({program, "render", answered_study, "--out", lab.answered_set});
  lab.study_us = must_run(lab.study_command(lab.log)).duration_us;
  lab.analyze_us = must_run(lab.analyze_command(lab.log, lab.report)).duration_us;
  lab.set_files = files_of(lab.set);
  lab.report_files = files_of(lab.report);
  lab.log_rows = rows_of(lab.log);
  lab.log_answers = answers_of(lab.log);
  lab.old_log = folder / "undisturbed" / "old.sqlite";
  study::write_schema_2(lab.log, lab.old_log);
  lab.old_log_bytes = bytes_of(lab.old_log);
  lab.upgrade_us = must_run(lab.upgrade_command(folder / "undisturbed" / "upgraded.sqlite")).duration_us;
  return lab;
}

Ending rerun_render(Lab& lab, const fs::path& set, Tally& tally) {
  Ending ending = run(lab.render_command(set));
  if (!lab.completes(tally.fault, ending)) return ending;
  ++tally.reruns;
  const Files files = files_of(set);
  const bool same = files == lab.set_files;
  tally.equal += same ? 1 : 0;
  if (!same)
    lab.complaints.push_back(fmt::format("{}: the set differs from the undisturbed one in {} and {} files",
                                         tally.fault, files_not_in(files, lab.set_files),
                                         files_not_in(lab.set_files, files)));
  return ending;
}

void rerun_study(Lab& lab, const fs::path& log, Tally& tally) {
  if (!lab.completes(tally.fault, run(lab.study_command(log)))) return;
  ++tally.reruns;
  const bool same = is_sound(log) && rows_of(log) == lab.log_rows;
  tally.equal += same ? 1 : 0;
  if (!same)
    lab.complaints.push_back(fmt::format("{}: the log differs from the undisturbed one: {} rows are missing",
                                         tally.fault, missing(lab.log_rows, rows_of(log))));
}

void rerun_analyze(Lab& lab, const fs::path& report, Tally& tally) {
  if (!lab.completes(tally.fault, run(lab.analyze_command(lab.log, report)))) return;
  ++tally.reruns;
  const bool same = files_of(report) == lab.report_files;
  tally.equal += same ? 1 : 0;
  if (!same) lab.complaints.push_back(tally.fault + ": the report differs from the undisturbed one");
}

bool check_upgrade(Lab& lab, Tally& tally, const fs::path& into, const Ending& ending,
                   const std::string& what) {
  ++tally.tries;
  bool left_behind = false;
  for (const fs::directory_entry& entry : fs::directory_iterator(into.parent_path()))
    left_behind = left_behind || entry.path() != into;
  if (left_behind && !ending.killed) lab.complain(what + ": temporary files were left behind", ending);
  if (!ending.killed && ending.status != 0) lab.refuses(what, ending);
  if (ending.status == 0 && !fs::exists(into)) lab.complain(what + ": there is no new log", ending);
  tally.committed += static_cast<std::int64_t>(lab.log_rows.size());
  if (bytes_of(lab.old_log) != lab.old_log_bytes) {
    tally.lost += static_cast<std::int64_t>(lab.log_rows.size());
    lab.complain(what + ": the old log was touched", ending);
  }
  if (fs::exists(into) && (!is_sound(into) || rows_of(into) != lab.log_rows))
    lab.complain(what + ": the new log is not whole", ending);
  return left_behind;
}

void rerun_upgrade(Lab& lab, const fs::path& into, Tally& tally) {
  remove_log(into);
  if (!lab.completes(tally.fault, run(lab.upgrade_command(into)))) return;
  ++tally.reruns;
  tally.equal += is_sound(into) && rows_of(into) == lab.log_rows ? 1 : 0;
}

}  // namespace seamline::faults
