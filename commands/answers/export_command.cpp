#include "commands/answers/answer_commands.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>
#include <ranges>
#include <string>

#include "commands/photographs/photograph_commands.h"
#include "stimuli/set/clip_video.h"
#include "study/exchange/export_tables.h"
#include "study/online/page/web_export.h"
#include "support/text/counted.h"
#include "support/text/number_option.h"

namespace seamline::study::online {
namespace {

constexpr double most_slots = 9999;
constexpr int usual_k = 5;

struct WebOptions {
  std::string set, folder;
  std::optional<int> slots;
  bool serve = false, jatos = false, pilot = false;
};

struct TablesOptions {
  std::string log, folder, layout = "csv";
  std::optional<int> k;
  bool anonymise = false;
};

TableLayout layout_of(const std::string& word) {
  if (word == "psych-ds") return TableLayout::psych_ds;
  return word == "bids" ? TableLayout::bids : TableLayout::plain;
}

void run_tables(const TablesOptions& options) {
  const TableSummary summary = export_tables(
      {.log = options.log,
       .out_folder = options.folder,
       .anonymise_k = options.anonymise ? std::optional(options.k.value_or(usual_k)) : std::nullopt,
       .layout = layout_of(options.layout)});
  fmt::print("{}: {} of {}\n", options.folder, counted(summary.answers, "answer"),
             counted(summary.participants, "participant"));
  if (!summary.anonymity) return;
  const Anonymity& anonymity = *summary.anonymity;
  const auto of_people = [](const GroupedField& field) { return field.smallest_group > 0; };
  if (!summary.fields.empty() && std::none_of(summary.fields.begin(), summary.fields.end(), of_people))
    fmt::print("  all participants are simulated: their answers to the form are kept as they are\n");
  for (const GroupedField& field : summary.fields | std::views::filter(of_people))
    fmt::print("  {}: every answer is shared by at least {}{}{}\n", field.field, field.smallest_group,
               field.withheld_answers > 0 ? fmt::format(", {} withheld", field.withheld_answers) : "",
               field.withheld ? " (so few people that none is kept)" : "");
  if (summary.smallest_group > 0)
    fmt::print("  whole rows of the table of participants: the smallest group is {}\n",
               summary.smallest_group);
  if (anonymity.left_out_people > 0)
    fmt::print(
        "  left out: {}, since fewer than {} have finished, been excluded or made a trial run as they have\n",
        counted(anonymity.left_out_people, "person", "people"), anonymity.k);
  if (anonymity.unfinished_people > 0)
    fmt::print("  left out: the answers of {} who did not finish, which would tell their order\n",
               counted(anonymity.unfinished_people, "person", "people"));
  if (!anonymity.keeps_origin)
    fmt::print("  left out: how people came (origin), since fewer than {} came one of the ways\n",
               anonymity.k);
}

void run_web(const WebOptions& options) {
  const WebSummary summary = export_web({.set_folder = options.set,
                                         .out_folder = options.folder,
                                         .slots = options.slots,
                                         .host = options.serve   ? Origin::serve
                                                 : options.jatos ? Origin::jatos
                                                                 : Origin::static_host,
                                         .pilot = options.pilot});
  fmt::print(
      "{}: {}, {:.1f} MB, {}, {}\n", options.folder, counted(summary.files, "file"), summary.bytes / 1e6,
      counted(summary.pictures, "picture"),
      summary.adaptive ? std::string("trials placed by `seamline serve`") : counted(summary.slots, "order"));
  if (!summary.drafts.empty())
    fmt::print("machine drafts, to be checked by a speaker: {}\n", fmt::join(summary.drafts, ", "));
  if (summary.guessable_orders)
    fmt::print(
        "The orders follow from the study's seed, which is short enough to be found by trying: then two files "
        "of orders/ tell which picture is which stimulus. Against people who would, render the set with a "
        "seed of 15 digits that nobody knows.\n");
}

void add_web(CLI::App& group) {
  const auto options = std::make_shared<WebOptions>();
  CLI::App* command = group.add_subcommand("web", "a set as a page for browsers");
  command->add_option("set", options->set, "folder of the rendered set")->required();
  command
      ->add_option("folder", options->folder,
                   "folder for the page, for a host of files unless --serve or --jatos is said; whole or not "
                   "at all")
      ->required();
  add_number(*command, "--slots", options->slots, {1, most_slots},
             "orders to plan (the study's session.orders, else 200)");
  CLI::Option* serve = command->add_flag("--serve", options->serve,
                                         "`seamline serve` will host it, which an adaptive study needs");
  command->add_flag("--jatos", options->jatos, "JATOS will host it")->excludes(serve);
  command->add_flag("--pilot", options->pilot, "everybody is a trial run, and may see the shipped consent");
  command->callback([options] { run_web(*options); });
}

void add_tables(CLI::App& group) {
  const auto options = std::make_shared<TablesOptions>();
  CLI::App* command = group.add_subcommand("tables", "a log as tables: answers, people, dictionary");
  command->add_option("log", options->log, "the log, LOG.sqlite")->required();
  command->add_option("folder", options->folder, "folder for the tables")->required();
  command
      ->add_option("--layout", options->layout,
                   "csv; or the same tables as Psych-DS or BIDS (behaviour) lay them out")
      ->check(CLI::IsMember({"csv", "psych-ds", "bids"}))
      ->capture_default_str();
  CLI::Option* anonymise =
      command->add_flag("--anonymise", options->anonymise,
                        "new codes, times to a tenth of a second, nothing that tells who came when, rows of "
                        "people grouped");
  add_number(*command, "--k", options->k, {2, 1000}, "of --anonymise: the smallest group (else 5)")
      ->needs(anonymise);
  command->callback([options] { run_tables(*options); });
}

void add_video(CLI::App& group) {
  struct VideoOptions {
    std::string set, folder;
  };
  const auto options = std::make_shared<VideoOptions>();
  CLI::App* command =
      group.add_subcommand("video", "a set's clips as uncompressed video, for programs that measure video");
  command->add_option("set", options->set, "folder of the rendered set")->required();
  command->add_option("folder", options->folder, "folder for the videos, .y4m")->required();
  command->callback([options] {
    fmt::print("{}: {}\n", options->folder, counted(write_videos(options->set, options->folder), "video"));
  });
}

}  // namespace

void add_export_command(CLI::App& app) {
  CLI::App* group =
      app.add_subcommand("export", "a set as web page or video, a log as tables, a scene as x3d");
  group->require_subcommand(1);
  add_web(*group);
  add_tables(*group);
  add_video(*group);
  renderer::add_x3d_command(*group);
}

}  // namespace seamline::study::online
