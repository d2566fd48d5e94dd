#include "commands/study/study_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <memory>

#include "commands/photographs/mesh_options.h"
#include "commands/study/render_command.h"
#include "commands/study/render_options.h"
#include "sets/cluster/job_scripts.h"
#include "sets/cluster/set_status.h"
#include "sets/pages/explain.h"
#include "sets/set_manifest.h"
#include "sets/set_work.h"
#include "stimuli/definition/clip_frames.h"
#include "support/files/atomic_file.h"
#include "support/files/held/prepared_folder.h"
#include "support/running/progress.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

struct JobOptions {
  RenderOptions render;
  std::string slurm, parallel;
  int elements = 0;
};

struct PieceOptions {
  RenderOptions render;
  std::string job, element;
};

/// How long the probe of a job may take.
constexpr double probe_s = 60;

void write_cluster_job(const JobOptions& options) {
  const StudyDefinition study = still_study(study_of(options.render));
  const RenderRequest asked = request_of(options.render);
  if (options.slurm.empty() == options.parallel.empty())
    throw input_error({.field = "seamline job write",
                       .wanted = "one of --slurm DIR and --parallel DIR",
                       .found = options.slurm.empty() ? "neither" : "both"});
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  if (std::none_of(stimuli.begin(), stimuli.end(), [&](const Stimulus& stimulus) {
        return matches_pattern(stimulus_id(stimulus), asked.only);
      }))
    throw no_such_stimulus(study, asked.only);
  RenderRequest request = asked;
  request.threads = options.render.threads > 0 ? options.render.threads : 1;
  const fs::path folder = fs::absolute(options.slurm.empty() ? options.parallel : options.slurm);
  options.slurm.empty() ? check_parallel_folder(folder) : check_slurm_folder(folder);
  require_set_folder(request.set_folder);
  const PreparedFolder prepared(folder);
  const JobCosts costs = measure_costs(study, request, probe_s);
  const RenderJob job = plan_job(study, request, costs, options.elements);
  const JobPlace place{.folder = folder,
                       .set_folder = fs::absolute(options.render.set),
                       .study = fs::absolute(options.render.study),
                       .options = options_for_pieces(options.render)};
  write_job(folder, job);
  // Now, so that `--status` knows the job before its first piece has begun.
  prepare_output_folder(place.set_folder / "records");
  write_work_list(
      place.set_folder,
      list_work(study, request.only, InputHashes(study, render_settings(study, request)), folder.string()));
  if (options.slurm.empty())
    write_parallel_scripts(place, job);
  else
    write_slurm_scripts(place, job);
  double all_s = 0, elements_s = 0;
  for (const JobTruth& truth : job.truths) all_s += truth.seconds;
  for (const JobElement& element : job.elements) elements_s += element.seconds;
  all_s += elements_s;
  fmt::print(
      "{}: {}, then {} of {} to {} (mean {}), then join; {} in all on {} each, {} "
      "MB; from a probe of {}\nrun {}\n",
      folder.string(), counted(job.truths.size(), "truth"), counted(job.elements.size(), "element"),
      duration_text(std::min_element(job.elements.begin(), job.elements.end(),
                                     [](const auto& a, const auto& b) { return a.seconds < b.seconds; })
                        ->seconds),
      duration_text(job.longest_element_s()), duration_text(elements_s / job.elements.size()),
      duration_text(all_s), counted(job.threads, "thread"), job.memory_bytes >> 20,
      duration_text(costs.measured_s), (folder / (options.slurm.empty() ? "run" : "submit")).string());
}

void run_piece(const PieceOptions& options) {
  const StudyDefinition study = study_of(options.render);
  RenderRequest request = request_of(options.render);
  take_element(read_job(options.job), options.job, options.element, still_study(study), request);
  (void)render_and_say(study, request);
  say_of_whole_set(study, request, options.render.error);
}

/// A piece that fails, whatever for, says so in the set too: `job status` is asked elsewhere.
void run_piece_or_complain(const PieceOptions& options) {
  try {
    run_piece(options);
  } catch (const std::exception& error) {
    leave_refusal(options.render.set, options.job, options.element, error.what());
    throw;
  }
}

void run_status(const std::string& set, const std::string& html) {
  if (!html.empty()) need_extension(html, {".html"}, "--html");
  const SetStatus status = read_status(set);
  if (html.empty())
    fmt::print("{}", status_text(set, status));
  else
    write_status_page(html, set, status);
}

void add_write(CLI::App& job) {
  const auto options = std::make_shared<JobOptions>();
  CLI::App* write = job.add_subcommand("write", "write the scripts of a job, after a probe of a minute");
  add_render_options(*write, options->render);
  write->get_option("--out")->required();
  write->add_option("--slurm", options->slurm,
                    "folder for a Slurm job that makes the set of --out: an array of truths, an array of "
                    "elements, a job that joins; all machines must see the folder");
  write->add_option("--parallel", options->parallel,
                    "folder for the same by GNU parallel, on this machine or over ssh");
  add_number(*write, "--elements", options->elements, {1, most_elements},
             "pieces that the stimuli are cut into (default: of ten minutes each)");
  write->callback([options] { write_cluster_job(*options); });
}

void add_piece(CLI::App& job) {
  const auto options = std::make_shared<PieceOptions>();
  CLI::App* piece = job.add_subcommand("piece", "do one piece of a job (its scripts do this)");
  add_render_options(*piece, options->render);
  piece->get_option("--out")->required();
  piece->add_option("--job", options->job, "folder of the job")->required();
  piece->add_option("--element", options->element, "truth-N, stimuli-N or join")->required();
  piece->callback([options] { run_piece_or_complain(*options); });
}

void add_status(CLI::App& job) {
  const auto set = std::make_shared<std::string>();
  const auto html = std::make_shared<std::string>();
  CLI::App* status =
      job.add_subcommand("status", "what of a job's set is done, running, failed and left, from any machine");
  status->add_option("set", *set, "folder of the set")->required();
  status->add_option("--html", *html, "write it as a page");
  status->callback([set, html] { run_status(*set, *html); });
}

}  // namespace

void add_job_command(CLI::App& app) {
  CLI::App* job = app.add_subcommand("job", "render a set on many machines: write, piece, status");
  job->require_subcommand(1);
  add_write(*job);
  add_piece(*job);
  add_status(*job);
}

}  // namespace seamline::renderer
