#include "analysis/report/json/report_json.h"

#include "analysis/report/json/json_values.h"
#include "support/files/assets.h"

namespace seamline::analysis {

namespace {

using Json = nlohmann::ordered_json;

struct CellJson {
  Json operator()(std::monostate) const { return nullptr; }
  Json operator()(const std::string& text) const { return text; }
  Json operator()(double number) const { return json_number(number); }
  Json operator()(std::int64_t number) const { return number; }
};

/// One line a row: easy to read, to compare and to cut.
std::string rows_text(const CsvTable& table) {
  std::string text;
  for (const std::vector<CsvValue>& row : table.rows) {
    Json json = Json::object();
    for (std::size_t i = 0; i < row.size(); ++i) json[table.columns[i].name] = std::visit(CellJson{}, row[i]);
    text +=
        (text.empty() ? "\n      " : ",\n      ") + json.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
  return text.empty() ? "[]" : "[" + text + "\n    ]";
}

}  // namespace

std::string report_json(const Analysis& analysis, const MethodsText& methods,
                        const std::vector<CsvTable>& tables) {
  Json head;
  head["format"] = report_format;
  head["version"] = report_version;
  head["program_version"] = program_version();
  head["study"] = {{"name", analysis.log.study_name}, {"hash", analysis.log.study_hash}};
  head["set"] = {{"hash", analysis.log.set_hash}};
  head["source"] = source_text(analysis);
  head["seed"] = analysis.resampling.seed;
  head["notes"] = analysis.notes;
  head["methods"] = methods.paragraphs;
  head["references"] = methods.references;
  std::string text = head.dump(2, ' ', false, Json::error_handler_t::replace);
  text.erase(text.rfind('\n'));  // the closing brace: tables follow
  text += ",\n  \"tables\": {";
  for (std::size_t i = 0; i < tables.size(); ++i)
    text += (i == 0 ? "\n    \"" : ",\n    \"") + tables[i].name + "\": " + rows_text(tables[i]);
  return text + "\n  }\n}\n";
}

}  // namespace seamline::analysis
