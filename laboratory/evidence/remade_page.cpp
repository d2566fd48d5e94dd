#include "laboratory/evidence/remade_page.h"

#include <fmt/format.h>

#include <algorithm>

#include "laboratory/evidence/evidence_table.h"
#include "support/files/atomic_file.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rows_shown = 40;

std::string shown_table(const std::string& name, const fs::path& file) {
  const TextTable table = read_table(file);
  if (table.rows.size() > most_rows_shown)
    return fmt::format("{} rows: [{}]({})\n\n", table.rows.size(), name, name);
  return markdown_of(table) + "\n";
}

std::string shown_file(const std::string& name, const fs::path& folder) {
  const fs::path file = folder / name;
  if (name.ends_with(".svg") || name.ends_with(".png")) return fmt::format("![{0}]({0})\n\n", name);
  if (name.ends_with(".csv")) return shown_table(name, file);
  return read_file(file) + "\n";
}

std::string shown_output(const StepRecord& record) {
  const bool was_left_out = record.printed.starts_with("left out");
  if (record.printed.empty() || (record.step.printed == Printed::progress && !was_left_out)) return "";
  const std::string heading = fmt::format("## {}\n\n", record.step.name);
  if (record.step.printed == Printed::markdown && !was_left_out) return heading + record.printed + "\n";
  return heading + "```text\n" + record.printed + (record.printed.ends_with('\n') ? "" : "\n") + "```\n\n";
}

/// What a table is computed from is not shown beside it.
bool is_source(const EvidencePage& page, const std::string& name) {
  return std::any_of(page.tables.begin(), page.tables.end(), [&](const EvidenceTable& table) {
    return std::any_of(table.from.begin(), table.from.end(),
                       [&](const TableSource& source) { return source.file == name; });
  });
}

}  // namespace

std::vector<std::string> shown_files(const EvidencePage& page) {
  std::vector<std::string> files;
  for (const EvidenceTable& table : page.tables) files.push_back(table.file);
  for (const PrintedTable& table : page.printed) files.push_back(table.file);
  for (const EvidenceFigure& figure : page.figures)
    files.push_back(fs::path(figure.table).replace_extension(".svg").string());
  files.insert(files.end(), page.shown.begin(), page.shown.end());
  return files;
}

std::string remade_page(const EvidencePage& page, bool small, const std::vector<StepRecord>& records,
                        const fs::path& folder) {
  std::string text =
      fmt::format("# Evidence: {}\n\n{}.\n\nMade by {}, with\n\n```\nseamline lab evidence {}{}\n```\n\n",
                  page.name, page.shows, made_by(), page.name, small ? " --small" : "");
  text += small ? "This is the small form. It shows that the page can be remade; its numbers are rough.\n\n"
                : fmt::format("It takes about {} of processor time.\n\n", page.takes);
  std::error_code error;
  std::vector<std::string> shown = shown_files(page);
  std::erase_if(shown,
                [&](const std::string& name) { return name.ends_with(".csv") && is_source(page, name); });
  for (const std::string& name : shown)
    if (fs::exists(folder / name, error)) text += shown_file(name, folder);
  for (const StepRecord& record : records) text += shown_output(record);
  text += "## Steps\n\n";
  for (const StepRecord& record : records)
    text += fmt::format("- {0}: `{1}` ([printed]({0}.txt))\n", record.step.name, record.step.command);
  return text;
}

}  // namespace seamline::laboratory
