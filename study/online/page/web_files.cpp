#include "study/online/page/web_files.h"

#include <chrono>
#include <nlohmann/json.hpp>

#include "study/online/page/web_format.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"

namespace seamline::study::online {
namespace fs = std::filesystem;

void WebFiles::add(const std::string& name, std::string_view bytes) {
  const fs::path path = folder_ / name;
  fs::create_directories(path.parent_path());
  write_unpublished_file(path, bytes);
  files_[name] = {.bytes = static_cast<std::int64_t>(bytes.size()), .sha256 = sha256(bytes)};
}

std::string WebFiles::add_by_content(const std::string& folder, std::string_view bytes,
                                     const std::string& ending) {
  constexpr std::size_t digits = 24;
  const std::string name = folder + "/" + sha256(bytes).substr(0, digits) + ending;
  if (!files_.contains(name)) add(name, bytes);
  return name;
}

void WebFiles::give_one_time() const {
  const auto now = std::chrono::floor<std::chrono::seconds>(fs::file_time_type::clock::now());
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder_))
    fs::last_write_time(entry.path(), now);
  fs::last_write_time(folder_, now);
}

std::string WebFiles::index_text() const {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const auto& [name, file] : files_)
    list.push_back({{"name", name}, {"bytes", file.bytes}, {"sha256", file.sha256}});
  return nlohmann::ordered_json{{"format", web_format}, {"files", list}}.dump(1) + "\n";
}

}  // namespace seamline::study::online
