#include "commands/evidence/evidence_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>

#include "laboratory/evidence/remake.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;

struct EvidenceOptions {
  std::string page, out = "evidence", pages;
  bool small = false, tables = false;
};

fs::path made_page(const EvidencePage& page, const EvidenceOptions& options) {
  if (options.tables) return renew_evidence(page, options.pages);
  return remake_evidence(
      page, {.out = options.out,
             .small = options.small,
             .pages = options.pages,
             .said = [](const std::string& step) { fmt::print(stderr, "evidence {}\n", step); }});
}

void list_evidence() {
  fmt::print("{:20} {:12} {}\n", "page", "takes", "what it shows");
  for (const EvidencePage& page : evidence_pages()) {
    fmt::print("{:20} {:12} {}\n", page.name, page.takes, page.shows);
    if (!page.needs.empty()) fmt::print("{:33} needs {}\n", "", page.needs);
  }
  fmt::print(
      "\nseamline lab evidence PAGE remakes one page, seamline lab evidence all every page whose needs are met; "
      "--small shows in seconds that it can be done.\n");
}

void run_evidence(const EvidenceOptions& options) {
  if (options.page.empty()) return list_evidence();
  if (options.page != "all") {
    fmt::print("{}\n", made_page(evidence_page(options.page), options).string());
    return;
  }
  for (const EvidencePage& page : evidence_pages()) {
    const std::string missing = options.tables ? "" : missing_of(page, options.small);
    fmt::print("{}\n",
               missing.empty() ? made_page(page, options).string() : page.name + " is left out: " + missing);
    std::fflush(stdout);
  }
}

}  // namespace

void add_evidence_command(CLI::App& app) {
  const auto options = std::make_shared<EvidenceOptions>();
  CLI::App* command =
      app.add_subcommand("evidence", "remake the pages that show how far Seamline can be trusted");
  command->add_option("page", options->page,
                      "a page, or all; without it the pages are listed, and what they take");
  command
      ->add_option("--out", options->out,
                   "folder; each page has a folder in it, and a run that was stopped goes on there")
      ->capture_default_str();
  CLI::Option* small = command->add_flag("--small", options->small,
                                         "seconds instead of minutes and hours: whether it can be remade");
  CLI::Option* pages =
      command
          ->add_option(
              "--pages", options->pages,
              "folder of pages, as documentation/evidence: renew the page there, its tables and figures")
          ->excludes(small);
  command
      ->add_flag("--tables", options->tables,
                 "measure nothing: renew the pages of --pages from the tables that lie beside them")
      ->needs(pages);
  command->callback([options] { run_evidence(*options); });
}

}  // namespace seamline::laboratory
