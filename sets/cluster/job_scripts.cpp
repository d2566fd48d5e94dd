#include "sets/cluster/job_scripts.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>

#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/shell_word.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

/// `folder` as a word of the shell, with a name in it.
std::string quoted(const fs::path& folder, const char* name) {
  return shell_quoted((folder / name).string());
}

/// A study's name where Slurm wants a word.
std::string plain_name(std::string name) {
  for (char& c : name)
    if (!std::isalnum(static_cast<unsigned char>(c))) c = '-';
  return name;
}

void write_script(const fs::path& path, const std::string& text) {
  write_file_atomically(path, text);
  fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec, fs::perm_options::add);
}

/// So long before its time limit a piece is asked to stop: it takes up to ten of them to end, and Slurm may
/// ask a minute early.
constexpr int seconds_before_the_limit = 60;

/// Twice the estimate and five minutes, in whole minutes: a probe of a minute knows no better.
int time_limit_min(double seconds) {
  return static_cast<int>(std::ceil(2 * seconds / 60)) + 5;
}

int memory_limit_mb(std::int64_t bytes) {
  constexpr int step_mb = 256;
  const auto mb = static_cast<int>(bytes >> 20) + 1;
  return (mb + step_mb - 1) / step_mb * step_mb;
}

void write_task(const JobPlace& place, const RenderJob& job) {
  const fs::path self = fs::read_symlink("/proc/self/exe");
  std::string options;
  for (const std::string& option : place.options) options += " " + shell_quoted(option);
  write_script(
      place.folder / "task",
      fmt::format("#!/bin/bash\n"
                  "# One piece of the job: truth-N, stimuli-N or join.\n"
                  "if [ $# -ne 1 ] || [ -z \"$1\" ]; then\n"
                  "  echo \"$0: wanted one of truth-N, stimuli-N and join, found ${{*:-nothing}}\" >&2\n"
                  "  exit 1\n"
                  "fi\n"
                  "exec {} job piece {} --out={} --threads={}{} --job={} --element=\"$1\"\n",
                  shell_quoted(self.string()), shell_quoted(place.study.string()),
                  shell_quoted(place.set_folder.string()), job.threads, options,
                  shell_quoted(place.folder.string())));
}

/// `limits` are `#SBATCH` lines, `command` what a piece runs.
std::string batch_script(const RenderJob& job, const std::string& stage, const std::string& limits,
                         const std::string& command) {
  return fmt::format(
      "#!/bin/bash\n"
      "#SBATCH --job-name=seamline-{0}-{1}\n"
      "{2}"
      "#SBATCH --cpus-per-task={3}\n"
      "#SBATCH --mem={4}M\n"
      "#SBATCH --requeue\n"
      "#SBATCH --open-mode=append\n"
      "{5}\n",
      plain_name(job.study_name), stage, limits, job.threads, memory_limit_mb(job.memory_bytes), command);
}

std::string array_script(const JobPlace& place, const RenderJob& job, const std::string& stage,
                         const std::string& element, std::size_t count, double longest_s) {
  const std::string limits = fmt::format(
      "#SBATCH --array=1-{}\n#SBATCH --time={}\n#SBATCH --signal=B:USR1@{}\n#SBATCH "
      "--output={}/logs/{}-%a.log\n",
      count, time_limit_min(longest_s), seconds_before_the_limit, place.folder.string(), element);
  const std::string command = fmt::format(
      "# Slurm sends USR1 shortly before the time limit: the piece stops, and what it had finished is kept.\n"
      "# The piece may not have been started yet, or its number not be known: then it is stopped after that.\n"
      "piece= is_asked=\n"
      "stop() {{\n"
      "  is_asked=yes\n"
      "  [ -z \"$piece\" ] || kill \"$piece\"\n"
      "}}\n"
      "trap stop USR1\n"
      "{0} {1}-\"$SLURM_ARRAY_TASK_ID\" &\n"
      "piece=$!\n"
      "[ -z \"$is_asked\" ] || kill \"$piece\"\n"
      "while\n"
      "  wait \"$piece\"\n"
      "  status=$?\n"
      "  kill -0 \"$piece\" 2>/dev/null\n"
      "do :; done\n"
      "# Wrong input (1) would be wrong again. Whatever else ended the piece need not come again: once more,\n"
      "# and this piece alone.\n"
      "if [ $status -gt 1 ] && [ \"${{SLURM_RESTART_COUNT:-0}}\" -lt 3 ]; then\n"
      "  scontrol requeue \"${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID\"\n"
      "fi\n"
      "exit $status",
      quoted(place.folder, "task"), element);
  return batch_script(job, stage, limits, command);
}

}  // namespace

void check_slurm_folder(const fs::path& folder) {
  const std::string text = folder.string();
  const auto is_plain = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 ||
           std::string_view("/._-+=@,:~").find(c) != std::string_view::npos ||
           static_cast<unsigned char>(c) >= 0x80;
  };
  if (std::all_of(text.begin(), text.end(), is_plain) && printable(text, text.size()) == text) return;
  throw input_error({.field = "--slurm",
                     .wanted = "a path of letters, digits and / . _ - + = @ , : ~ alone, since Slurm's own "
                               "lines can hold no others",
                     .found = "\"" + text + "\""});
}

void write_slurm_scripts(const JobPlace& place, const RenderJob& job) {
  check_slurm_folder(place.folder);
  prepare_output_folder(place.folder / "logs");
  write_task(place, job);
  write_file_atomically(
      place.folder / "truths.sbatch",
      array_script(place, job, "truths", "truth", job.truths.size(), job.longest_truth_s()));
  write_file_atomically(
      place.folder / "stimuli.sbatch",
      array_script(place, job, "stimuli", "stimuli", job.elements.size(), job.longest_element_s()));
  const std::string stimuli = quoted(place.folder, "stimuli.sbatch"),
                    join = quoted(place.folder, "join.sbatch");
  write_file_atomically(
      place.folder / "join.sbatch",
      batch_script(
          job, "join",
          fmt::format("#SBATCH --time=60\n#SBATCH --output={}/logs/join.log\n", place.folder.string()),
          fmt::format("{} join && exit\n"
                      "echo pieces that ended otherwise than well: sacct, or {}\n"
                      "echo run them again: sbatch --array=N {}, then sbatch {}\n"
                      "exit 1",
                      quoted(place.folder, "task"), quoted(place.folder, "logs"), stimuli, join)));
  write_script(place.folder / "submit",
               fmt::format("#!/bin/bash\n"
                           "# Hands the job to Slurm. Arguments go to sbatch, e.g. --partition=NAME.\n"
                           "set -euo pipefail\n"
                           "truths=$(sbatch --parsable \"$@\" {0})\n"
                           "stimuli=$(sbatch --parsable --dependency=afterok:\"${{truths%%;*}}\" "
                           "--kill-on-invalid-dep=yes \"$@\" {1})\n"
                           "join=$(sbatch --parsable --dependency=afterany:\"${{stimuli%%;*}}\" \"$@\" {2})\n"
                           "echo \"truths ${{truths%%;*}}, stimuli ${{stimuli%%;*}}, join ${{join%%;*}}\"\n",
                           quoted(place.folder, "truths.sbatch"), stimuli, join));
}

void check_parallel_folder(const fs::path& folder) {
  if (folder.string().find_first_of("{}") != std::string::npos)
    throw input_error({.field = "--parallel",
                       .wanted = "a path without { and }, which GNU parallel would read as its own",
                       .found = "\"" + folder.string() + "\""});
}

void write_parallel_scripts(const JobPlace& place, const RenderJob& job) {
  check_parallel_folder(place.folder);
  prepare_output_folder(place.folder / "logs");
  write_task(place, job);
  const std::string folder = shell_quoted(place.folder.string());
  write_script(
      place.folder / "run",
      fmt::format(
          "#!/bin/bash\n"
          "# Gives the pieces to GNU parallel: on this machine, or on those that a file `nodes` beside\n"
          "# this one names, a line each (parallel's --sshloginfile). Arguments go to parallel. A piece\n"
          "# that fails is tried three times; run this again, and only what is not done is done.\n"
          "set -euo pipefail\n"
          "cd {0}\n"
          "where=()\n"
          "[ -f nodes ] && where=(--sshloginfile nodes)\n"
          "stage() {{\n"
          "  local first=$1 last=$2\n"
          "  shift 2\n"
          "  seq 1 \"$last\" | parallel \"${{where[@]}}\" --retries 3 --halt now,fail=1 --joblog "
          "\"$first.log\" \\\n"
          "    --results \"logs/$first-{{}}\" --wd \"$PWD\" \"$@\" ./task \"$first-{{}}\"\n"
          "}}\n"
          "stage truth {1} \"$@\"\n"
          "stage stimuli {2} \"$@\"\n"
          "./task join\n",
          folder, job.truths.size(), job.elements.size()));
}

}  // namespace seamline::renderer
