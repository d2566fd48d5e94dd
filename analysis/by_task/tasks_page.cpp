#include "analysis/by_task/tasks_page.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <nlohmann/json.hpp>

#include "analysis/report/page/page_style.h"
#include "support/files/atomic_file.h"
#include "support/text/html.h"

namespace seamline::analysis {

std::filesystem::path write_tasks_page(const std::filesystem::path& folder, const std::string& study_name,
                                       const std::vector<TaskReport>& reports) {
  nlohmann::ordered_json tasks = nlohmann::ordered_json::array();
  std::string sections;
  for (const TaskReport& report : reports) {
    tasks.push_back({{"report", report.folder},
                     {"conditions", report.conditions},
                     {"thresholds",
                      nlohmann::ordered_json::parse(read_file(folder / report.folder / "thresholds.json"))}});
    sections += fmt::format(
        "<h2>{}</h2>\n<p>Conditions: {}. <a href=\"{}/report.html\">Report of this task</a>.</p>\n"
        "<pre>{}</pre>\n",
        html_escape(report.question), html_escape(fmt::format("{}", fmt::join(report.conditions, ", "))),
        report.folder, html_escape(report.table));
  }
  const std::string json =
      nlohmann::ordered_json{{"format", "seamline thresholds of tasks 1"}, {"tasks", std::move(tasks)}}.dump(
          1);
  write_file_atomically(folder / "thresholds.json", json + "\n", Readers::owner);
  const std::filesystem::path page = folder / "report.html";
  write_file_atomically(
      page,
      fmt::format("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{0}</title>"
                  "<meta name=\"viewport\" content=\"width=device-width\">{1}</head>\n<body><main>\n"
                  "<h1>{0}</h1>\n<p>The conditions of this study ask {2} different questions. Each question "
                  "has its own chance and its own scale, so that each has its own report.</p>\n{3}</main>"
                  "</body></html>\n",
                  html_escape(study_name), page_style(), reports.size(), sections),
      Readers::owner);
  return page;
}

}  // namespace seamline::analysis
