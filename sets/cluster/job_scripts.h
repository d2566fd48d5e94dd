#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sets/cluster/render_job.h"

namespace seamline::renderer {

/// Where a job's pieces find what they need.
struct JobPlace {
  std::filesystem::path folder;      ///< of the scripts and `job.json`
  std::filesystem::path set_folder;  ///< on a file system that all machines see
  std::filesystem::path study;
  std::vector<std::string> options = {};  ///< of `seamline render` that decide what is rendered
};

/// Throws InputError where the folder's path has a letter that lines of Slurm's own (`#SBATCH`) or the shell
/// would read as something else.
void check_slurm_folder(const std::filesystem::path& folder);
/// Likewise where GNU parallel would put something in the place of a part of it ({}, {#}).
void check_parallel_folder(const std::filesystem::path& folder);

/// `task`, the one command that every piece runs; `truths.sbatch` and `stimuli.sbatch`, arrays;
/// `join.sbatch`; and `submit`, which hands them to Slurm, each waiting for the one before. Memory and time
/// limits are the job's estimates with room above them.
void write_slurm_scripts(const JobPlace& place, const RenderJob& job);

/// `task` and `run`, which gives the pieces to GNU parallel: on this machine, or on those that a file `nodes`
/// names (`--sshloginfile`).
void write_parallel_scripts(const JobPlace& place, const RenderJob& job);

}  // namespace seamline::renderer
