#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "renderer/cluster/render_job.h"

namespace seamline::renderer {

/// Where a job's pieces find what they need.
struct JobPlace {
  std::filesystem::path folder;      ///< of the scripts and `job.json`
  std::filesystem::path set_folder;  ///< on a file system that all machines see
  std::filesystem::path study;
  std::vector<std::string> options = {};  ///< of `seamline render` that decide what is rendered
};

/// `task`, the one command that every piece runs; `truths.sbatch` and `stimuli.sbatch`, arrays;
/// `join.sbatch`; and `submit`, which hands them to Slurm, each waiting for the one before. Memory and time
/// limits are the job's estimates with room above them.
void write_slurm_scripts(const JobPlace& place, const RenderJob& job);

/// `task` and `run`, which gives the pieces to GNU parallel: on this machine, or on those that a file `nodes`
/// names (`--sshloginfile`).
void write_parallel_scripts(const JobPlace& place, const RenderJob& job);

}  // namespace seamline::renderer
