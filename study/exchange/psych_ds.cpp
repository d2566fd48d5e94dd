#include <fmt/core.h>

#include <nlohmann/json.hpp>
#include <set>

#include "study/exchange/answer_tables.h"
#include "study/exchange/dataset.h"
#include "support/files/assets.h"
#include "support/text/csv.h"
#include "support/text/printable.h"

namespace seamline::study {
namespace {

using SchemaJson = nlohmann::ordered_json;

SchemaJson variable_json(const CsvColumn& column) {
  SchemaJson variable = {
      {"@type", "PropertyValue"}, {"name", clean_text(column.name)}, {"description", column.meaning}};
  if (!column.unit.empty()) variable["unitText"] = column.unit;
  return variable;
}

SchemaJson described(const std::string& name, const std::string& description) {
  return {{"@context", "https://schema.org/"},
          {"@type", "Dataset"},
          {"name", clean_text(name)},
          {"description", description}};
}

std::string json_text(const SchemaJson& json) {
  return json.dump(2, ' ', false, SchemaJson::error_handler_t::replace) + "\n";
}

}  // namespace

std::vector<DatasetFile> psych_ds_files(const LogContents& log, const std::optional<Anonymity>& anonymity) {
  std::vector<CsvTable> tables = answer_tables(log, anonymity);
  tables.pop_back();  // the dictionary: here it is in JSON
  SchemaJson whole =
      described(log.study_name,
                "Answers to pictures into which one object was inserted: which one, and how noticeable");
  whole["schemaVersion"] = "Psych-DS 1.0.0";
  SchemaJson all_variables = SchemaJson::array();
  std::set<std::string> known;
  std::vector<DatasetFile> files;
  for (const CsvTable& table : tables) {
    SchemaJson sidecar = described(fmt::format("{}: {}", log.study_name, table.name),
                                   "Columns of the table of the same name beside this file");
    SchemaJson variables = SchemaJson::array();
    for (const CsvColumn& column : table.columns) {
      variables.push_back(variable_json(column));
      if (known.insert(column.name).second) all_variables.push_back(variable_json(column));
    }
    sidecar["variableMeasured"] = std::move(variables);
    const std::string stem =
        fmt::format("data/study-{}_description-{}_data", file_label(log.study_name), file_label(table.name));
    files.push_back({stem + ".csv", csv_text(table)});
    files.push_back({stem + ".json", json_text(sidecar)});
  }
  whole["variableMeasured"] = std::move(all_variables);
  files.push_back({"dataset_description.json", json_text(whole)});
  files.push_back({"README.md", dataset_readme(log, "Psych-DS 1.0", anonymity)});
  files.push_back({"CHANGES.md", fmt::format("# 1.0.0\n\n- Written by Seamline {}.\n", program_version())});
  return files;
}

}  // namespace seamline::study
