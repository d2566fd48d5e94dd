#include "commands/study/render_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <set>
#include <tuple>

#include "commands/options/command_help.h"
#include "commands/photographs/asset_root_option.h"
#include "raytracer/scene/truth_scene.h"
#include "sets/cluster/job_scripts.h"
#include "sets/cluster/set_status.h"
#include "sets/pages/errors_page.h"
#include "sets/pages/explain.h"
#include "sets/render_set.h"
#include "sets/set_errors.h"
#include "sets/set_work.h"
#include "sets/true_error_set.h"
#include "stimuli/definition/clip_frames.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/level_notes.h"
#include "stimuli/set/manifest_pictures.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/study_file.h"
#include "support/files/atomic_file.h"
#include "support/files/held/prepared_folder.h"
#include "support/running/progress.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

namespace fs = std::filesystem;

struct RenderOptions {
  std::string study, asset_root, set, only, mesh, shard, estimator = "fast";
  double error = 0;
  int threads = 0, spp = 0;
  std::vector<std::string> no_omit;
  bool dry_run = false, explain = false, layers = false, contact_sheet = false;
  std::string true_error;
  int true_error_spp = 64;
  std::string slurm, parallel, job, element, status, html;
  int elements = 0;
};

/// How long the probe of a job may take.
constexpr double probe_s = 60;

/// Part I of N, from "I/N".
std::pair<int, int> shard_of(const std::string& text) {
  const std::optional<std::pair<int, int>> pair = whole_pair(text, '/');
  if (!pair || pair->first < 1 || pair->first > pair->second)
    throw input_error({.field = "--shard", .wanted = "I/N with I from 1 to N", .found = "\"" + text + "\""});
  return *pair;
}

/// The plan, for the scenes that have a stimulus asked for.
void print_plan(const StudyDefinition& study, const RenderRequest& request) {
  std::set<std::string> truths;
  for (const Stimulus& stimulus : list_stimuli(study))
    if (matches_pattern(stimulus_id(stimulus), request.only)) truths.insert(truth_of(stimulus));
  std::map<std::string, LightFacts> lights = lights_of(study);
  std::erase_if(lights, [&](const auto& light) { return !truths.contains(light.first); });
  fmt::print("{}", explain(study, render_plan(study, lights, render_settings(study, request))));
  for (const SceneDefinition& scene : list_truths(study))
    if (truths.contains(scene.truth)) {
      const TruthScene loaded = load_truth_scene(scene, study.width_px, study.height_px);
      for (const std::string& said : loaded.rests) fmt::print("{}\n", said);
      for (const std::string& said : left_out_sentences(loaded)) fmt::print("{}\n", said);
    }
  std::fflush(stdout);
}

/// The options that decide what is rendered, as they were given: for the pieces of a job.
std::vector<std::string> options_for_pieces(const RenderOptions& options) {
  std::vector<std::string> out = {"--estimator=" + options.estimator};
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) out.push_back(std::string(name) + "=" + value);
  };
  if (!options.asset_root.empty()) add("--asset-root", fs::absolute(options.asset_root).string());
  add("--only", options.only);
  add("--mesh", options.mesh);
  if (options.spp > 0) add("--spp", std::to_string(options.spp));
  if (options.error > 0) add("--error", fmt::format("{}", options.error));
  for (const std::string& name : options.no_omit) add("--no-omit", name);
  if (options.layers) out.emplace_back("--layers");
  return out;
}

void make_job(const RenderOptions& options, const StudyDefinition& study, const RenderRequest& asked) {
  if (!options.slurm.empty() && !options.parallel.empty())
    throw input_error({.field = "--parallel", .wanted = "one of --slurm and --parallel", .found = "both"});
  if (!options.shard.empty() || !options.true_error.empty() || options.contact_sheet)
    throw input_error(
        {.field = options.slurm.empty() ? "--parallel" : "--slurm",
         .wanted = "no --shard, --true-error or --contact-sheet, which are for single processes",
         .found = "one of them"});
  const std::vector<Stimulus> stimuli = list_stimuli(study);
  if (std::none_of(stimuli.begin(), stimuli.end(), [&](const Stimulus& stimulus) {
        return matches_pattern(stimulus_id(stimulus), asked.only);
      }))
    throw no_such_stimulus(study, asked.only);
  RenderRequest request = asked;
  request.threads = options.threads > 0 ? options.threads : 1;
  const fs::path folder = fs::absolute(options.slurm.empty() ? options.parallel : options.slurm);
  options.slurm.empty() ? check_parallel_folder(folder) : check_slurm_folder(folder);
  const PreparedFolder prepared(folder);
  const JobCosts costs = measure_costs(study, request, probe_s);
  const RenderJob job = plan_job(study, request, costs, options.elements);
  const JobPlace place{.folder = folder,
                       .set_folder = fs::absolute(options.set),
                       .study = fs::absolute(options.study),
                       .options = options_for_pieces(options)};
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
      "{}: {} truths, then {} elements of {} to {} (mean {}), then join; {} in all on {} thread{} each, {} "
      "MB; from a probe of {}\nrun {}\n",
      folder.string(), job.truths.size(), job.elements.size(),
      duration_text(std::min_element(job.elements.begin(), job.elements.end(),
                                     [](const auto& a, const auto& b) { return a.seconds < b.seconds; })
                        ->seconds),
      duration_text(job.longest_element_s()),
      duration_text(elements_s / static_cast<double>(job.elements.size())), duration_text(all_s), job.threads,
      job.threads == 1 ? "" : "s", job.memory_bytes >> 20, duration_text(costs.measured_s),
      (folder / (options.slurm.empty() ? "run" : "submit")).string());
}

void run_status(const RenderOptions& options) {
  const SetStatus status = read_status(options.status);
  if (options.html.empty())
    fmt::print("{}", status_text(options.status, status));
  else
    write_status_page(options.html, options.status, status);
}

void run_render(const RenderOptions& options) {
  if (!options.status.empty()) return run_status(options);
  if (options.study.empty())
    throw input_error({.field = "study", .wanted = "a study file (or --status SET)", .found = "nothing"});
  const StudyDefinition study = read_study(options.study, AssetCheck::must_exist, options.asset_root);
  if (options.dry_run) {
    for (const Stimulus& stimulus : list_stimuli(still_study(study)))
      if (const std::string id = stimulus_id(stimulus); matches_pattern(id, options.only))
        fmt::print("{}\n", id);
    return;
  }
  if (options.set.empty() && !options.explain)
    throw input_error({.field = "--out",
                       .wanted = "a folder for the set (or --dry-run, or --explain)",
                       .found = "nothing"});
  RenderRequest request{.set_folder = options.set,
                        .only = options.only,
                        .threads = options.threads,
                        .layers = options.layers,
                        .contact_sheet = options.contact_sheet};
  if (options.spp > 0) request.spp = options.spp;
  if (options.error > 0) request.error = options.error;
  request.estimator = options.estimator == "path" ? Estimator::path : Estimator::fast;
  if (!options.mesh.empty())
    request.mesh = options.mesh == "full" ? MeshDensity::full : MeshDensity::adaptive;
  if (!options.shard.empty()) std::tie(request.shard, request.shard_count) = shard_of(options.shard);
  request.omit = omissions_without(options.no_omit);
  if (options.elements > 0 && options.slurm.empty() && options.parallel.empty())
    throw input_error(
        {.field = "--elements", .wanted = "--slurm DIR or --parallel DIR with it", .found = "neither"});
  if (study.clip && !options.true_error.empty())
    throw input_error(
        {.field = "--true-error", .wanted = "a study of stills", .found = "a study with [clip]"});
  const StudyDefinition rendered = still_study(study);
  if (!options.slurm.empty() || !options.parallel.empty()) return make_job(options, rendered, request);
  if (!options.element.empty())
    take_element(read_job(options.job), options.job, options.element, rendered, request);
  if (options.explain) print_plan(rendered, request);
  if (options.set.empty()) return;
  const RenderSummary summary = render_set(study, request);
  fmt::print("{}: {} stimuli rendered, {} kept from before, {}\n", options.set, summary.rendered,
             summary.already_finished, duration_text(summary.seconds));
  if (options.explain)
    for (const auto& [scene, savings] : summary.savings) fmt::print("{}", explain_savings(scene, savings));
  std::fflush(stdout);
  if (!options.true_error.empty())
    measure_true_errors(study, {.set_folder = options.set,
                                .pattern = options.true_error,
                                .spp = options.true_error_spp,
                                .threads = options.threads,
                                .mesh = request.mesh});
  if (request.part == JobPart::whole || request.part == JobPart::join) {
    write_errors_page(options.set);
    if (options.error > 0)
      for (const std::string& said : sentences_on_missed(read_set_errors(options.set), options.error))
        fmt::print("{}\n", said);
    for (const std::string& said : notes_on_levels(study)) fmt::print("{}\n", said);
    for (const std::string& said : sentences(holes_of_set(read_manifest(options.set))))
      fmt::print("{}\n", said);
  }
}

/// A piece of a job that fails, whatever for, says so in the set too: `--status` is asked elsewhere.
void run_render_or_complain(const RenderOptions& options) {
  try {
    run_render(options);
  } catch (const std::exception& error) {
    if (!options.element.empty()) leave_refusal(options.set, options.job, options.element, error.what());
    throw;
  }
}

void run_verify(const std::string& set) {
  const Manifest manifest = read_manifest(set);
  (void)study_of_set(set, manifest);
  check_manifest_pictures(set, manifest);
  check_clips(set);
  fmt::print("{}: {} stimuli and {} references are as the manifest says\n", set, manifest.stimuli.size(),
             manifest.references.size());
}

}  // namespace

void add_render_command(CLI::App& app) {
  auto options = std::make_shared<RenderOptions>();
  CLI::App* render = app.add_subcommand("render", "render a study's stimuli into a set");
  render->add_option("study", options->study, "study file (.toml)");
  add_asset_root_option(*render, options->asset_root);
  render->add_option("--out", options->set, "folder of the set; an interrupted job continues there");
  render->add_option("--only", options->only, "only stimuli whose id matches; * stands for any text");
  add_number(*render, "--threads", options->threads, {1, 4096}, "worker threads (default: all cores)");
  add_number(*render, "--spp", options->spp, {1, 65536}, "samples per pixel, instead of the study's");
  CLI::Option* error =
      add_number(*render, "--error", options->error, {0.002, 1},
                 "instead of a number of samples: sample until each picture's estimated error is below "
                 "this (display units, 0 to 1) and below three times this in its worst 32 x 32 tile");
  error->excludes("--spp");
  render
      ->add_option("--estimator", options->estimator,
                   "fast: shared and filtered; path: unbiased, for reference")
      ->check(CLI::IsMember({"fast", "path"}))
      ->capture_default_str();
  render->add_option("--mesh", options->mesh, "depth mesh, instead of the study's")
      ->check(CLI::IsMember({"adaptive", "full"}));
  add_formed_text(*render, "--shard", options->shard, "I/N", "this process renders part I of N (by object)",
                  [](const std::string& text) { (void)shard_of(text); });
  render->add_flag("--layers", options->layers, "also write float EXR layers");
  render->add_flag("--contact-sheet", options->contact_sheet,
                   "also write one contact sheet for each artifact");
  render->add_flag("--explain", options->explain,
                   "print what is computed, what is left out and why; with --out also what that saved");
  render
      ->add_option("--no-omit", options->no_omit,
                   "turn off an omission that --explain names; may be given several times")
      ->type_name("NAME")
      ->allow_extra_args(false);
  CLI::Option* true_error =
      render->add_option("--true-error", options->true_error,
                         "then measure the true error of the stimuli whose id matches, against the path "
                         "estimator with another seed; takes about as long as rendering them by it");
  add_number(*render, "--true-error-spp", options->true_error_spp, {2, 65536},
             "samples per pixel of these references")
      ->capture_default_str()
      ->needs(true_error);
  render->add_option(
      "--slurm", options->slurm,
      "render nothing but samples for about a minute, and write a Slurm job that makes the set of --out: an "
      "array of truths, an array of elements, a job that joins; the folder must be seen by all machines");
  render->add_option("--parallel", options->parallel,
                     "the same for GNU parallel, on this machine or over ssh");
  add_number(*render, "--elements", options->elements, {1, most_elements},
             "pieces that the stimuli of such a job are cut into (default: of ten minutes each)");
  CLI::Option* job =
      render->add_option("--job", options->job, "folder of the job that --element is a piece of");
  CLI::Option* element =
      render->add_option("--element", options->element,
                         "do one piece of a job: truth-N, stimuli-N or join (its scripts do this)");
  element->needs(job);
  job->needs(element);
  CLI::Option* status = render->add_option(
      "--status", options->status,
      "render nothing: say what of a job's set is done, running, failed and left, from any machine");
  render->add_option("--html", options->html, "write what --status says as a page")->needs(status);
  render->add_flag("--dry-run", options->dry_run, "list the stimulus ids and stop");
  group_options(*render,
                {{"Many machines", {"--slurm", "--parallel", "--elements", "--status", "--html", "--shard"}},
                 {"A job's scripts", {"--job", "--element"}},
                 {"Evidence", {"--true-error", "--true-error-spp", "--no-omit", "--layers"}}});
  render->callback([options] { run_render_or_complain(*options); });

  auto set = std::make_shared<std::string>();
  CLI::App* verify = app.add_subcommand("verify", "compare every file of a set with the manifest's hashes");
  verify->add_option("set", *set, "folder of the set")->required();
  verify->callback([set] { run_verify(*set); });
}

}  // namespace seamline::renderer
