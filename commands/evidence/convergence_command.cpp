#include "commands/evidence/evidence_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <tuple>

#include "commands/options/setting_option.h"
#include "commands/photographs/asset_root_option.h"
#include "laboratory/convergence/convergence.h"
#include "stimuli/study_file/study_file.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::renderer {
namespace {

struct ConvergenceOptions {
  std::string study, asset_root, only, out, size;
  std::vector<std::string> parts;
  std::vector<double> tolerances;
  int threads = 0, spp = 0;
  double seconds = 120;
};

/// Width and height, from "480x270".
std::pair<int, int> size_of(const std::string& text) {
  constexpr int smallest_px = 8, largest_px = 16384;
  const std::optional<std::pair<int, int>> size = whole_pair(text, 'x');
  const auto fits = [](int px) { return px >= smallest_px && px <= largest_px; };
  if (!size || !fits(size->first) || !fits(size->second))
    throw input_error({.field = "--size",
                       .wanted = fmt::format("WxH with both from {} to {} px", smallest_px, largest_px),
                       .found = "\"" + text + "\""});
  return *size;
}

void parse_parts(const std::vector<std::string>& words, ConvergenceRequest& request) {
  if (words.empty()) return;
  request.parts.clear();
  for (const ConvergencePart part : every_convergence_part)
    for (const std::string& text : words)
      if (text == word(part)) request.parts.insert(part);
}

void run(const ConvergenceOptions& options) {
  const StudyDefinition study = read_study(options.study, AssetCheck::must_exist, options.asset_root);
  ConvergenceRequest request{.only = options.only, .out = options.out, .threads = options.threads};
  request.seconds = options.seconds;
  if (options.spp > 0) request.spp = options.spp;
  if (!options.size.empty()) std::tie(request.width_px, request.height_px) = size_of(options.size);
  parse_parts(options.parts, request);
  if (!options.tolerances.empty()) request.tolerances = options.tolerances;
  fmt::print("{}", run_convergence(study, request));
}

}  // namespace

void add_convergence_command(CLI::App& app) {
  auto options = std::make_shared<ConvergenceOptions>();
  CLI::App* command =
      app.add_subcommand("convergence", "error against run time for one stimulus: figures and tables");
  command->add_option("study", options->study, "study file (.toml)")->required();
  add_asset_root_option(*command, options->asset_root);
  command->add_option("--only", options->only, "the stimulus id, or a pattern that matches one")->required();
  command->add_option("--out", options->out, "folder of the figures and tables; made when missing")
      ->required();
  command
      ->add_option("--parts", options->parts, "only these parts (default: samples, mesh, width, compositing)")
      ->delimiter(',')
      ->check(CLI::IsMember(option_words(every_convergence_part)));
  add_number(*command, "--tolerances", options->tolerances, {1e-9, 0.5},
             "of the depth mesh in `mesh`, besides the study's (default: 1e-2 to 1e-6)")
      ->delimiter(',');
  add_number(*command, "--seconds", options->seconds, {0.1, 1e6},
             "about how long `samples` may take; `compositing` half as long; the others take what they need")
      ->capture_default_str();
  add_number(*command, "--spp", options->spp, {2, 65536},
             "samples per pixel of `mesh`, `width`, `links` and `realtime`, instead of the study's");
  add_formed_text(*command, "--size", options->size, "WxH",
                  "of the picture in pixels, instead of the study's",
                  [](const std::string& text) { (void)size_of(text); });
  add_number(*command, "--threads", options->threads, {1, 4096}, "worker threads (default: all cores)");
  command->callback([options] { run(*options); });
}

}  // namespace seamline::renderer
