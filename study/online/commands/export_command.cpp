#include "study/online/commands/export_command.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "study/online/page/web_export.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::study::online {
namespace {

constexpr double most_slots = 9999;

struct ExportOptions {
  std::string source;
  std::string web;
  std::optional<int> slots;
  bool serve = false, pilot = false;
};

void run_export(const ExportOptions& options) {
  if (options.web.empty())
    throw input_error({.field = "seamline export", .wanted = "--web DIR", .found = "nothing to write"});
  const WebSummary summary = export_web({.set_folder = options.source,
                                         .out_folder = options.web,
                                         .slots = options.slots,
                                         .serve = options.serve,
                                         .pilot = options.pilot});
  fmt::print("{}: {} files, {:.1f} MB, {} pictures, {}\n", options.web, summary.files,
             static_cast<double>(summary.bytes) / 1e6, summary.pictures,
             summary.adaptive ? std::string("trials placed by `seamline serve`")
                              : fmt::format("{} orders", summary.slots));
}

}  // namespace

void add_export_command(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command = app.add_subcommand("export", "Write a study as a page for browsers");
  command->add_option("source", options->source, "folder of the rendered set")->required();
  command->add_option(
      "--web", options->web,
      "folder for the page, for any static host, JATOS or `seamline serve`; whole or not at all");
  add_number(*command, "--slots", options->slots, {1, most_slots},
             "orders to plan (the study's session.orders, else 200)");
  command->add_flag("--serve", options->serve,
                    "only `seamline serve` will host it, which an adaptive study needs");
  command->add_flag("--pilot", options->pilot, "everybody is a trial run, and may see the shipped consent");
  command->callback([options] { run_export(*options); });
}

}  // namespace seamline::study::online
