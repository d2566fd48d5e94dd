#include "commands/answers/export_command.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "commands/options/command_help.h"
#include "stimuli/set/clip_video.h"
#include "study/exchange/export_tables.h"
#include "study/online/page/web_export.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::study::online {
namespace {

constexpr double most_slots = 9999;
constexpr int usual_k = 5;

struct ExportOptions {
  std::string source;
  std::string web, csv, psych_ds, bids, y4m;
  std::optional<int> slots, k;
  bool serve = false, jatos = false, pilot = false, anonymise = false;
};

void run_tables(const ExportOptions& options, const std::string& folder, TableLayout layout) {
  const TableSummary summary = export_tables(
      {.log = options.source,
       .out_folder = folder,
       .anonymise_k = options.anonymise ? std::optional(options.k.value_or(usual_k)) : std::nullopt,
       .layout = layout});
  fmt::print("{}: {} answers of {} participants\n", folder, summary.answers, summary.participants);
  if (!summary.anonymity) return;
  const Anonymity& anonymity = *summary.anonymity;
  for (const GroupedField& field : summary.fields)
    fmt::print("  {}: every answer is shared by at least {}{}{}\n", field.field, field.smallest_group,
               field.withheld_answers > 0 ? fmt::format(", {} withheld", field.withheld_answers) : "",
               field.withheld ? " (so few people that none is kept)" : "");
  if (summary.smallest_group > 0)
    fmt::print("  whole rows of the table of participants: the smallest group is {}\n",
               summary.smallest_group);
  if (anonymity.left_out_people > 0)
    fmt::print(
        "  left out: {} people, since fewer than {} have finished, been excluded or made a trial run as they "
        "have\n",
        anonymity.left_out_people, anonymity.k);
  if (anonymity.unfinished_people > 0)
    fmt::print("  left out: the answers of {} people who did not finish, which would tell their order\n",
               anonymity.unfinished_people);
  if (!anonymity.keeps_origin)
    fmt::print("  left out: how people came (origin), since fewer than {} came one of the ways\n",
               anonymity.k);
}

void run_export(const ExportOptions& options, const OtherPage& other) {
  std::vector<std::string> asked;
  for (const auto& [folder, flag] : {std::pair(options.web, "--web"), std::pair(options.csv, "--csv"),
                                     std::pair(options.psych_ds, "--psych-ds"),
                                     std::pair(options.bids, "--bids"), std::pair(options.y4m, "--y4m")})
    if (!folder.empty()) asked.emplace_back(flag);
  if (other.is_asked()) asked.push_back(other.flag);
  if (asked.size() != 1)
    throw input_error(
        {.field = "seamline export",
         .wanted =
             fmt::format("--web DIR or --y4m DIR with a set, {} DIR with a set or a scene, or one of --csv, "
                         "--psych-ds and --bids DIR with a log",
                         other.flag),
         .found = asked.empty() ? "nothing to write" : fmt::format("{}", fmt::join(asked, " and "))});
  if (options.anonymise && (!options.web.empty() || !options.y4m.empty() || other.is_asked()))
    throw input_error({.field = "--anonymise", .wanted = "a log's tables to write", .found = asked.front()});
  if (other.is_asked()) return other.write(options.source);
  if (!options.y4m.empty()) {
    const int written = write_videos(options.source, options.y4m);
    return fmt::print("{}: {} videos\n", options.y4m, written);
  }
  if (!options.csv.empty()) return run_tables(options, options.csv, TableLayout::plain);
  if (!options.psych_ds.empty()) return run_tables(options, options.psych_ds, TableLayout::psych_ds);
  if (!options.bids.empty()) return run_tables(options, options.bids, TableLayout::bids);
  const WebSummary summary = export_web({.set_folder = options.source,
                                         .out_folder = options.web,
                                         .slots = options.slots,
                                         .host = options.serve   ? Origin::serve
                                                 : options.jatos ? Origin::jatos
                                                                 : Origin::static_host,
                                         .pilot = options.pilot});
  fmt::print("{}: {} files, {:.1f} MB, {} pictures, {}\n", options.web, summary.files,
             static_cast<double>(summary.bytes) / 1e6, summary.pictures,
             summary.adaptive ? std::string("trials placed by `seamline serve`")
                              : fmt::format("{} orders", summary.slots));
  if (!summary.drafts.empty())
    fmt::print("machine drafts, to be checked by a speaker: {}\n", fmt::join(summary.drafts, ", "));
  if (summary.guessable_orders)
    fmt::print(
        "The orders follow from the study's seed, which is short enough to be found by trying: then two files "
        "of orders/ tell which picture is which stimulus. Against people who would, render the set with a "
        "seed of 15 digits that nobody knows.\n");
}

}  // namespace

void add_export_command(CLI::App& app, const AddOtherPage& add_other_page) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App* command =
      app.add_subcommand("export", "a study as a page for browsers, a log as tables, a scene in X3D");
  command
      ->add_option(
          "source", options->source,
          "folder of the rendered set for --web, --y4m and --x3d (there also a scene: .glb, .gltf or "
          "builtin:NAME), else the log, LOG.sqlite")
      ->required();
  CLI::Option* web = command->add_option(
      "--web", options->web,
      "folder for the page, for a host of files unless --serve or --jatos is said; whole or not at all");
  command->add_option("--csv", options->csv,
                      "folder for tables: answers, catch answers, participants, dictionary");
  command->add_option("--psych-ds", options->psych_ds,
                      "folder for the same tables in the layout of Psych-DS");
  command->add_option("--bids", options->bids,
                      "folder for the same answers in the layout of BIDS (behaviour)");
  command->add_option("--y4m", options->y4m,
                      "folder for a set's clips as uncompressed video, for programs that measure video");
  CLI::Option* anonymise =
      command->add_flag("--anonymise", options->anonymise,
                        "of tables: new codes, times to a tenth of a second, nothing that tells who came "
                        "when, rows of people grouped");
  add_number(*command, "--k", options->k, {2, 1000}, "of --anonymise: the smallest group (else 5)")
      ->needs(anonymise);
  add_number(*command, "--slots", options->slots, {1, most_slots},
             "orders to plan (the study's session.orders, else 200)")
      ->needs(web);
  CLI::Option* serve = command->add_flag("--serve", options->serve,
                                         "`seamline serve` will host it, which an adaptive study needs");
  serve->needs(web);
  command->add_flag("--jatos", options->jatos, "JATOS will host it")->needs(web)->excludes(serve);
  command->add_flag("--pilot", options->pilot, "everybody is a trial run, and may see the shipped consent")
      ->needs(web);
  const OtherPage other = add_other_page(*command);
  group_options(*command, {{"A page in X3D",
                            {"--x3d",      "--stimulus", "--asset-root",  "--object", "--position",
                             "--rotation", "--scale",    "--height",      "--at",     "--look-at",
                             "--fov",      "--size",     "--environment", "--to-sun", "--sun-irradiance",
                             "--bounces",  "--albedo",   "--exposure",    "--user",   "--spp",
                             "--seed"}}});
  command->callback([options, other] { run_export(*options, other); });
}

}  // namespace seamline::study::online
