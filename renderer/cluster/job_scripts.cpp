#include "renderer/cluster/job_scripts.h"

#include <fmt/core.h>

#include <cctype>
#include <cmath>

#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

/// A word of the shell, whatever it holds.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

/// A path that an `#SBATCH` line can hold, where the shell's quotes mean nothing.
std::string plain_path(const fs::path& path) {
  const std::string text = path.string();
  if (text.find_first_of(" \t\n\"'\\%#") != std::string::npos)
    throw input_error(
        {.field = "--slurm",
         .wanted = "a path without spaces, quotes, % and #, which Slurm's own lines cannot hold",
         .found = "\"" + text + "\""});
  return text;
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
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  std::string options;
  for (const std::string& option : place.options) options += " " + quoted(option);
  write_script(
      place.folder / "task",
      fmt::format("#!/bin/bash\n"
                  "# One piece of the job: truth-N, stimuli-N or join.\n"
                  "exec {} render {} --out {} --threads {}{} --job {} --element \"$1\"\n",
                  quoted(self.string()), quoted(place.study.string()), quoted(place.set_folder.string()),
                  job.threads, options, quoted(place.folder.string())));
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
  const std::string limits =
      fmt::format("#SBATCH --array=1-{}\n#SBATCH --time={}\n#SBATCH --output={}/logs/{}-%a.log\n", count,
                  time_limit_min(longest_s), plain_path(place.folder), element);
  const std::string command = fmt::format(
      "{0}/task {1}-\"$SLURM_ARRAY_TASK_ID\"\n"
      "status=$?\n"
      "# Wrong input (1) would be wrong again. Whatever else ended the piece need not come again: once "
      "more,\n"
      "# and this piece alone; what it had finished is kept.\n"
      "if [ $status -gt 1 ] && [ \"${{SLURM_RESTART_COUNT:-0}}\" -lt 3 ]; then\n"
      "  scontrol requeue \"${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID\"\n"
      "fi\n"
      "exit $status",
      plain_path(place.folder), element);
  return batch_script(job, stage, limits, command);
}

}  // namespace

void write_slurm_scripts(const JobPlace& place, const RenderJob& job) {
  const std::string folder = plain_path(place.folder);
  prepare_output_folder(place.folder / "logs");
  write_task(place, job);
  write_file_atomically(
      place.folder / "truths.sbatch",
      array_script(place, job, "truths", "truth", job.truths.size(), job.longest_truth_s()));
  write_file_atomically(
      place.folder / "stimuli.sbatch",
      array_script(place, job, "stimuli", "stimuli", job.elements.size(), job.longest_element_s()));
  write_file_atomically(
      place.folder / "join.sbatch",
      batch_script(
          job, "join", fmt::format("#SBATCH --time=60\n#SBATCH --output={}/logs/join.log\n", folder),
          fmt::format("{0}/task join || {{\n"
                      "  echo \"pieces that ended otherwise than well: sacct, or {0}/logs; run them again\"\n"
                      "  echo \"by sbatch --array=N {0}/stimuli.sbatch, then sbatch {0}/join.sbatch\"\n"
                      "  exit 1\n"
                      "}}",
                      folder)));
  write_script(place.folder / "submit",
               fmt::format("#!/bin/bash\n"
                           "# Hands the job to Slurm. Arguments go to sbatch, e.g. --partition=NAME.\n"
                           "set -euo pipefail\n"
                           "truths=$(sbatch --parsable \"$@\" {0}/truths.sbatch)\n"
                           "stimuli=$(sbatch --parsable --dependency=afterok:\"${{truths%%;*}}\" "
                           "--kill-on-invalid-dep=yes \"$@\" {0}/stimuli.sbatch)\n"
                           "join=$(sbatch --parsable --dependency=afterany:\"${{stimuli%%;*}}\" \"$@\" "
                           "{0}/join.sbatch)\n"
                           "echo \"truths ${{truths%%;*}}, stimuli ${{stimuli%%;*}}, join ${{join%%;*}}\"\n",
                           folder));
}

void write_parallel_scripts(const JobPlace& place, const RenderJob& job) {
  prepare_output_folder(place.folder / "logs");
  write_task(place, job);
  const std::string folder = quoted(place.folder.string());
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
