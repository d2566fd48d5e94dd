#include "renderer/convergence_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>

#include "renderer/asset_root_option.h"
#include "renderer/convergence.h"
#include "stimuli/study_file.h"
#include "stimuli/support/error.h"

namespace seamline::renderer {
namespace {

struct ConvergenceOptions {
  std::string study, asset_root, only, out, size;
  std::vector<std::string> parts;
  std::vector<double> tolerances;
  int threads = 0, spp = 0;
  double seconds = 120;
};

/// "480x270".
void parse_size(const std::string& text, ConvergenceRequest& request) {
  if (text.empty()) return;
  constexpr int smallest_px = 8, largest_px = 16384;
  const std::size_t cross = text.find('x');
  const bool digits = cross != std::string::npos && cross > 0 && cross + 1 < text.size() &&
                      text.size() < 12 &&
                      text.find_first_not_of("0123456789", cross + 1) == std::string::npos &&
                      text.find_first_not_of("0123456789") == cross;
  if (digits) {
    request.width_px = std::stoi(text.substr(0, cross));
    request.height_px = std::stoi(text.substr(cross + 1));
  }
  const auto fits = [](int px) { return px >= smallest_px && px <= largest_px; };
  if (!digits || !fits(*request.width_px) || !fits(*request.height_px))
    throw input_error({.field = "--size",
                       .wanted = fmt::format("WxH with both from {} to {} px", smallest_px, largest_px),
                       .found = "\"" + text + "\""});
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
  parse_size(options.size, request);
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
  command->add_option("--parts", options->parts, "only these parts (default: all)")
      ->delimiter(',')
      ->check(CLI::IsMember({"samples", "mesh", "width", "compositing"}));
  command
      ->add_option("--tolerances", options->tolerances,
                   "of the depth mesh in `mesh`, besides the study's (default: 1e-2 to 1e-6)")
      ->delimiter(',')
      ->check(CLI::Range(1e-9, 0.5));
  command
      ->add_option("--seconds", options->seconds,
                   "about how long `samples` may take; `compositing` half as long; the others take what "
                   "they need")
      ->check(CLI::Range(0.1, 1e6))
      ->capture_default_str();
  command
      ->add_option("--spp", options->spp, "samples per pixel of `mesh` and `width`, instead of the study's")
      ->check(CLI::Range(2, 65536));
  command->add_option("--size", options->size, "WxH of the picture in pixels, instead of the study's");
  command->add_option("--threads", options->threads, "worker threads (default: all cores)")
      ->check(CLI::Range(1, 4096));
  command->callback([options] { run(*options); });
}

}  // namespace seamline::renderer
