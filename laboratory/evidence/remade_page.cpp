#include "laboratory/evidence/remade_page.h"

#include <fmt/format.h>

#include "support/files/atomic_file.h"
#include "support/text/csv_read.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_rows_shown = 40;

std::string table_line(const std::vector<std::string>& cells) {
  return fmt::format("| {} |\n", fmt::join(cells, " | "));
}

std::string shown_table(const std::string& name, const fs::path& file) {
  const std::string text = read_file(file);
  const std::vector<std::string> columns = read_csv_header(file.string(), text).names;
  std::string lines;
  std::size_t rows = 0;
  read_csv(file.string(), text, columns, [&](const CsvRow& row) {
    if (++rows <= most_rows_shown) lines += table_line(row.values);
  });
  if (rows > most_rows_shown) return fmt::format("{} rows: [{}]({})\n\n", rows, name, name);
  return table_line(columns) + table_line(std::vector<std::string>(columns.size(), "---")) + lines + "\n";
}

std::string shown_file(const std::string& name, const fs::path& folder) {
  const fs::path file = folder / name;
  if (name.ends_with(".svg")) return fmt::format("![{0}]({0})\n\n", name);
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

}  // namespace

std::string remade_page(const EvidencePage& page, bool small, const std::vector<StepRecord>& records,
                        const fs::path& folder) {
  std::string text =
      fmt::format("# Evidence: {}\n\n{}.\n\nMade by {}, with\n\n```\nseamline lab evidence {}{}\n```\n\n",
                  page.name, page.shows, made_by(), page.name, small ? " --small" : "");
  text += small ? "This is the small form. It shows that the page can be remade; its numbers are rough.\n\n"
                : fmt::format("It takes about {} on two cores.\n\n", page.takes);
  std::error_code error;
  std::vector<std::string> shown;
  for (const EvidenceFigure& figure : page.figures)
    shown.push_back(fs::path(figure.table).replace_extension(".svg").string());
  shown.insert(shown.end(), page.shown.begin(), page.shown.end());
  for (const std::string& name : shown)
    if (fs::exists(folder / name, error)) text += shown_file(name, folder);
  for (const StepRecord& record : records) text += shown_output(record);
  text += "## Steps\n\n";
  for (const StepRecord& record : records)
    text += fmt::format("- {0}: `{1}` ([printed]({0}.txt))\n", record.step.name, record.step.command);
  return text;
}

}  // namespace seamline::laboratory
