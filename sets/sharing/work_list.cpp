#include "sets/sharing/work_list.h"

#include <nlohmann/json.hpp>

#include "support/files/atomic_file.h"
#include "support/text/error.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

fs::path list_path(const fs::path& set_folder) {
  return set_folder / "records" / "work.json";
}

}  // namespace

void write_work_list(const fs::path& set_folder, const WorkList& list) {
  // Lists, not tables: of 20,000 names each would be looked for among all before it.
  Json json = {
      {"study", list.study}, {"job", list.job}, {"stimuli", Json::array()}, {"references", Json::array()}};
  for (const auto& [id, inputs, truth] : list.stimuli) json["stimuli"].push_back({id, inputs, truth});
  for (const auto& [truth, inputs] : list.references) json["references"].push_back({truth, inputs});
  // A folder's name may be no text.
  const std::string text = json.dump(0, ' ', false, Json::error_handler_t::replace) + "\n";
  std::error_code error;
  const fs::path path = list_path(set_folder);
  if (fs::is_regular_file(path, error) && fs::file_size(path, error) == text.size() &&
      read_file(path) == text)
    return;
  write_file_atomically(path, text);
}

std::optional<WorkList> read_work_list(const fs::path& set_folder) {
  const fs::path path = list_path(set_folder);
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  const std::string text = read_file(path);
  require_bounded_json(text, path.string());
  const Json json = Json::parse(text, nullptr, false);
  WorkList list;
  try {
    list.study = json.at("study").get<std::string>();
    list.job = json.value("job", std::string());
    const auto word = [](const Json& row, std::size_t i) { return row.at(i).get<std::string>(); };
    for (const Json& row : json.at("stimuli"))
      list.stimuli.push_back({word(row, 0), word(row, 1), word(row, 2)});
    for (const Json& row : json.at("references")) list.references.push_back({word(row, 0), word(row, 1)});
  } catch (const Json::exception&) {
    throw input_error({.file = path.string(),
                       .wanted = "what a set is going to hold, as `seamline render` writes it",
                       .found = "something else"});
  }
  return list;
}

}  // namespace seamline::renderer
