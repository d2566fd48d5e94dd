#include "laboratory/evidence/marked_page.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <optional>
#include <sstream>

#include "laboratory/evidence/evidence_table.h"
#include "support/files/atomic_file.h"
#include "support/text/csv_read.h"
#include "support/text/error.h"
#include "support/text/number_option.h"

namespace seamline::laboratory {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> made_columns = {"step",      "date",    "seamline",
                                               "processor", "threads", "processor_s"};

/// The file that a line marks.
std::optional<std::string> mark_of(const std::string& line) {
  constexpr std::string_view begin = "<!-- ", end = ".csv -->";
  if (!line.starts_with(begin) || !line.ends_with(end)) return std::nullopt;
  return line.substr(begin.size(), line.size() - begin.size() - 4);
}

/// "50 seconds", "12 minutes", "1 hour 48 minutes".
std::string duration_text(double seconds) {
  const auto count = [](long number, const char* unit) {
    return fmt::format("{} {}{}", number, unit, number == 1 ? "" : "s");
  };
  if (seconds < 100) return count(std::max(1L, std::lround(seconds)), "second");
  const long minutes = std::lround(seconds / 60);
  if (minutes < 100) return count(minutes, "minute");
  return count(minutes / 60, "hour") + (minutes % 60 == 0 ? "" : " " + count(minutes % 60, "minute"));
}

/// Steps of one version and machine are one sentence.
std::string made_sentence(const std::string& name, const std::vector<MadeStep>& steps) {
  struct Run {
    double seconds = 0;
    std::string first, last;
  };
  std::vector<std::string> order;
  std::map<std::string, Run> runs;
  for (const MadeStep& step : steps) {
    const std::string by =
        fmt::format("seamline {} on {}, {} threads", step.seamline, step.processor, step.threads);
    if (!runs.contains(by)) {
      order.push_back(by);
      runs[by] = {.seconds = 0, .first = step.date, .last = step.date};
    }
    Run& run = runs[by];
    run.seconds += step.processor_s;
    run.first = std::min(run.first, step.date);
    run.last = std::max(run.last, step.date);
  }
  std::string text;
  for (const std::string& by : order) {
    const Run& run = runs[by];
    text += fmt::format("{}Made by `seamline lab evidence {}`: {} ({}{}){}.", text.empty() ? "" : " ", name,
                        by, run.first, run.first == run.last ? "" : " to " + run.last,
                        run.seconds > 0 ? ", " + duration_text(run.seconds) + " of processor time" : "");
  }
  return text + "\n";
}

bool is_rule_of_table(const std::string& line) {
  return line.starts_with("| -") || line.starts_with("|-") || line.starts_with("| :-");
}

}  // namespace

std::vector<MadeStep> read_made(const fs::path& file) {
  std::vector<MadeStep> steps;
  std::error_code error;
  if (!fs::exists(file, error)) return steps;
  read_csv(file.string(), read_file(file), made_columns, [&](const CsvRow& row) {
    const std::vector<std::string>& v = row.values;
    steps.push_back({v[0], v[1], v[2], v[3], v[4], v[5].empty() ? 0 : number_at(row, 5)});
  });
  return steps;
}

std::string made_csv(const std::vector<MadeStep>& steps) {
  TextTable table{.columns = made_columns, .rows = {}};
  for (const MadeStep& step : steps)
    table.rows.push_back({step.step, step.date, step.seamline, step.processor, step.threads,
                          step.processor_s > 0 ? fmt::format("{:.0f}", step.processor_s) : ""});
  return csv_of(table);
}

std::vector<std::string> marks_of(const std::string& page) {
  std::vector<std::string> marks;
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);)
    if (const std::optional<std::string> mark = mark_of(line)) marks.push_back(*mark);
  return marks;
}

std::string with_marked_parts(const std::string& page, const std::string& name, const fs::path& folder) {
  std::string text;
  std::istringstream lines(page);
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    inside = inside && !line.empty();
    if (inside) continue;
    text += line + "\n";
    const std::optional<std::string> mark = mark_of(line);
    if (!mark) continue;
    inside = true;
    const fs::path file = folder / *mark;
    text +=
        file.filename() == "made.csv" ? made_sentence(name, read_made(file)) : markdown_of(read_table(file));
  }
  return text;
}

std::vector<std::string> unmarked_tables(const std::string& page) {
  std::vector<std::string> found, last = {"", "", ""};
  std::istringstream lines(page);
  for (std::string line; std::getline(lines, line);) {
    last = {last[1], last[2], line};  // before the heading, the heading, its rule
    if (is_rule_of_table(line) && !mark_of(last[0])) found.push_back(last[1]);
  }
  return found;
}

}  // namespace seamline::laboratory
