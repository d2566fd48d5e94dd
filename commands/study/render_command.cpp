#include "commands/study/render_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <set>
#include <tuple>

#include "commands/options/command_help.h"
#include "commands/study/render_options.h"
#include "raytracer/scene/truth_scene.h"
#include "sets/pages/errors_page.h"
#include "sets/pages/explain.h"
#include "sets/photographs/study_photographs.h"
#include "sets/set_errors.h"
#include "sets/true_error_set.h"
#include "stimuli/definition/clip_frames.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/depth_errors.h"
#include "stimuli/set/level_notes.h"
#include "stimuli/set/manifest_pictures.h"
#include "stimuli/set/set_study.h"
#include "stimuli/study_file/study_file.h"
#include "support/running/progress.h"
#include "support/text/counted.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

struct RenderCommand {
  RenderOptions render;
  std::string shard, true_error, photographs;
  int true_error_spp = 64;
  bool dry_run = false, explain = false, contact_sheet = false;
};

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

void list_ids(const StudyDefinition& study, const std::string& only) {
  for (const Stimulus& stimulus : list_stimuli(still_study(study)))
    if (const std::string id = stimulus_id(stimulus); matches_pattern(id, only)) fmt::print("{}\n", id);
}

void print_savings(const RenderSummary& summary) {
  for (const auto& [scene, savings] : summary.savings) fmt::print("{}", explain_savings(scene, savings));
  std::fflush(stdout);
}

/// What an estimator needs to see: its depth maps need not be there yet.
void run_photographs(const RenderOptions& options, const std::string& folder) {
  const StudyDefinition study = read_study(options.study, AssetCheck::all_but_depth, options.asset_root);
  if (study.clip)
    throw input_error(
        {.field = "--photographs", .wanted = "a study of stills", .found = "a study with [clip]"});
  PhotographsRequest request{.folder = folder, .only = options.only, .threads = options.threads};
  if (options.spp > 0) request.spp = options.spp;
  const int count = write_photographs(study, request);
  fmt::print("{}: {}, each with its true depth\n", folder, counted(count, "photograph"));
}

void run_render(const RenderCommand& options) {
  if (!options.photographs.empty()) return run_photographs(options.render, options.photographs);
  const StudyDefinition study = study_of(options.render);
  if (options.dry_run) return list_ids(study, options.render.only);
  if (options.render.set.empty() && !options.explain)
    throw input_error({.field = "--out",
                       .wanted = "a folder for the set (or --dry-run, or --explain)",
                       .found = "nothing"});
  RenderRequest request = request_of(options.render);
  request.contact_sheet = options.contact_sheet;
  if (!options.shard.empty()) std::tie(request.shard, request.shard_count) = shard_of(options.shard);
  if (study.clip && !options.true_error.empty())
    throw input_error(
        {.field = "--true-error", .wanted = "a study of stills", .found = "a study with [clip]"});
  if (options.explain) print_plan(still_study(study), request);
  if (options.render.set.empty()) return;
  const RenderSummary summary = render_and_say(study, request);
  if (options.explain) print_savings(summary);
  if (!options.true_error.empty())
    measure_true_errors(study, {.set_folder = options.render.set,
                                .pattern = options.true_error,
                                .spp = options.true_error_spp,
                                .threads = options.render.threads,
                                .mesh = request.mesh});
  say_of_whole_set(study, request, options.render.error);
}

void run_verify(const std::string& set) {
  const Manifest manifest = read_manifest(set);
  (void)study_of_set(set, manifest);
  check_manifest_pictures(set, manifest);
  check_clips(set);
  fmt::print("{}: {} and {} are as the manifest says\n", set,
             counted(manifest.stimuli.size(), "stimulus", "stimuli"),
             counted(manifest.references.size(), "reference"));
}

}  // namespace

RenderSummary render_and_say(const StudyDefinition& study, const RenderRequest& request) {
  RenderSummary summary = render_set(study, request);
  fmt::print(
      "{}: {} rendered, {} kept from before, {}\n", request.set_folder.string(),
      study.clip ? counted(summary.rendered, "frame") : counted(summary.rendered, "stimulus", "stimuli"),
      summary.already_finished, duration_text(summary.seconds));
  for (const std::string& note : summary.notes) fmt::print(stderr, "seamline: {}\n", note);
  std::fflush(stdout);
  return summary;
}

void say_of_whole_set(const StudyDefinition& study, const RenderRequest& request, double asked_error) {
  if (request.part != JobPart::whole && request.part != JobPart::join) return;
  write_errors_page(request.set_folder);
  if (asked_error > 0)
    for (const std::string& said : sentences_on_missed(read_set_errors(request.set_folder), asked_error))
      fmt::print("{}\n", said);
  for (const std::string& said : sentences_on_changes(read_set_errors(request.set_folder)))
    fmt::print("{}\n", said);
  for (const std::string& said : sentences_on_rare_light(read_set_errors(request.set_folder)))
    fmt::print("{}\n", said);
  for (const std::string& said : sentences_on_noisy_references(read_set_errors(request.set_folder)))
    fmt::print("{}\n", said);
  for (const std::string& said : notes_on_levels(study)) fmt::print("{}\n", said);
  const Manifest manifest = read_manifest(request.set_folder);
  for (const std::string& said : sentences(holes_of_set(manifest))) fmt::print("{}\n", said);
  for (const std::string& said : sentences(depth_errors_of_set(manifest))) fmt::print("{}\n", said);
}

void add_render_command(CLI::App& app) {
  const auto options = std::make_shared<RenderCommand>();
  CLI::App* render = app.add_subcommand("render", "render a study's stimuli into a set");
  add_render_options(*render, options->render);
  add_formed_text(*render, "--shard", options->shard, "I/N", "this process renders part I of N (by object)",
                  [](const std::string& text) { (void)shard_of(text); });
  render->add_flag("--contact-sheet", options->contact_sheet,
                   "also write one contact sheet for each artifact");
  render->add_flag("--explain", options->explain,
                   "print what is computed, what is left out and why; with --out also what that saved");
  CLI::Option* true_error =
      render->add_option("--true-error", options->true_error,
                         "then measure the true error of the stimuli whose id matches, against the path "
                         "estimator with another seed; takes about as long as rendering them by it");
  add_number(*render, "--true-error-spp", options->true_error_spp, {2, 65536},
             "samples per pixel of these references")
      ->capture_default_str()
      ->needs(true_error);
  render
      ->add_option("--photographs", options->photographs,
                   "render no stimuli: write to this folder what an estimator of depth needs to see, each "
                   "scene without one object as the study's depth camera sees it, with the camera and the "
                   "true depth")
      ->excludes("--out")
      ->excludes("--error");
  render->add_flag("--dry-run", options->dry_run, "list the stimulus ids and stop");
  group_options(*render, {{"Many processes", {"--shard"}},
                          {"Evidence", {"--true-error", "--true-error-spp", "--no-omit", "--layers"}}});
  render->callback([options] { run_render(*options); });

  auto set = std::make_shared<std::string>();
  CLI::App* verify = app.add_subcommand("verify", "compare every file of a set with the manifest's hashes");
  verify->add_option("set", *set, "folder of the set")->required();
  verify->callback([set] { run_verify(*set); });
}

}  // namespace seamline::renderer
