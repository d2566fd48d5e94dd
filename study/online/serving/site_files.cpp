#include "study/online/serving/site_files.h"

#include <fcntl.h>
#include <fmt/core.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <utility>

#include "study/log/origin.h"
#include "study/online/messages/message.h"
#include "study/online/messages/message_reader.h"
#include "study/online/messages/strict_json.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/printable.h"
#include "support/text/request_name.h"

namespace seamline::study::online {
namespace fs = std::filesystem;
namespace {

constexpr std::int64_t most_remembered_bytes = std::int64_t{1}
                                               << 20;  ///< larger files are sent from the disk
constexpr int deepest = 32;
constexpr std::size_t most_values = 2'000'000;

/// An open file that is closed with the last answer that sends it.
struct OpenFile : SentFile {
  OpenFile() = default;
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() {
    if (descriptor >= 0) ::close(descriptor);
  }
};

std::string content_type_of(const std::string& name) {
  constexpr std::array<std::pair<const char*, const char*>, 10> types = {
      {{".html", "text/html; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".json", "application/json; charset=utf-8"},
       {".png", "image/png"},
       {".svg", "image/svg+xml"},
       {".ttf", "font/ttf"},
       {".woff2", "font/woff2"},
       {".txt", "text/plain; charset=utf-8"},
       {".md", "text/plain; charset=utf-8"}}};
  for (const auto& [ending, type] : types)
    if (name.ends_with(ending)) return type;
  return "application/octet-stream";
}

std::shared_ptr<const SentFile> read_sent_file(const fs::path& path, const std::string& name,
                                               std::int64_t wanted_bytes, const std::string& wanted_sha256) {
  auto file = std::make_shared<OpenFile>();
  file->content_type = content_type_of(name);
  file->version = "\"" + wanted_sha256.substr(0, 32) + "\"";
  file->size_bytes = wanted_bytes;
  std::error_code error;
  const std::uintmax_t found_bytes = fs::file_size(path, error);  // too many are not even read
  const bool too_many = !error && found_bytes > static_cast<std::uintmax_t>(wanted_bytes);
  std::string bytes = too_many ? std::string() : read_file(path, wanted_bytes);
  if (too_many || static_cast<std::int64_t>(bytes.size()) != wanted_bytes || sha256(bytes) != wanted_sha256)
    throw input_error({.file = path.string(),
                       .wanted = "the file that was exported (export it again)",
                       .found = "another one"});
  if (wanted_bytes <= most_remembered_bytes) {
    file->bytes = std::move(bytes);
    return file;
  }
  // Exported files are replaced, not written into, so the open one stays what was hashed.
  file->descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file->descriptor < 0)
    throw input_error(
        {.file = path.string(), .wanted = "a file that can be opened", .found = std::strerror(errno)});
  return file;
}

const JsonValue* member_of(const JsonValue& object, const std::string& key) {
  const auto found = std::find(object.keys.begin(), object.keys.end(), key);
  if (object.kind != JsonValue::Kind::object || found == object.keys.end()) return nullptr;
  return &object.items[static_cast<std::size_t>(found - object.keys.begin())];
}

const JsonValue& field(const JsonValue& object, const std::string& key, JsonValue::Kind kind,
                       const fs::path& file) {
  if (const JsonValue* value = member_of(object, key); value != nullptr && value->kind == kind) return *value;
  throw input_error({.file = file.string(),
                     .field = key,
                     .wanted = "a file that seamline export web wrote",
                     .found = "none or something else"});
}

std::string text_of(const JsonValue& object, const std::string& key, const fs::path& file) {
  return field(object, key, JsonValue::Kind::text, file).text;
}

JsonValue read_json(const fs::path& file) {
  return read_strict_json(read_file(file), file.string(), deepest, most_values);
}

void read_study(const fs::path& file, SiteFiles& site) {
  const JsonValue study = read_json(file);
  using Kind = JsonValue::Kind;
  if (text_of(study, "format", file) != message_format)
    throw input_error({.file = file.string(),
                       .field = "format",
                       .wanted = fmt::format("\"{}\"", message_format),
                       .found = "\"" + printable(text_of(study, "format", file), 40) + "\""});
  // Older pages do not say who hosts them, and ask.
  const JsonValue* host = member_of(study, "host");
  if (host != nullptr && host->text != word(Origin::serve))
    throw input_error({.file = file.string(),
                       .field = "host",
                       .wanted = "\"serve\" (export the page with " + request_name("serve") + ")",
                       .found = "\"" + printable(host->text, 40) + "\""});
  if (const JsonValue* name = member_of(study, "study_name")) site.study_name = name->text;
  site.study_hash = text_of(study, "study_hash", file);
  site.set_hash = text_of(study, "set_hash", file);
  site.slots = static_cast<int>(
      std::clamp<std::int64_t>(field(study, "slots", Kind::whole, file).whole, 0, 1'000'000));
  site.pilot = field(study, "pilot", Kind::boolean, file).boolean;
  site.adaptive = field(study, "adaptive", Kind::boolean, file).boolean;
  if (const JsonValue* recruitment = member_of(study, "recruitment"); recruitment != nullptr) {
    site.recruited = true;
    for (const JsonValue& name : field(*recruitment, "identifiers", Kind::array, file).items)
      site.identifiers.push_back(name.text);
  }
  for (const JsonValue& stimulus : field(study, "stimuli", Kind::array, file).items)
    site.picture_of["stimulus " + text_of(stimulus, "id", file)] = text_of(stimulus, "file", file);
  for (const JsonValue& one : field(study, "catches", Kind::array, file).items)
    site.picture_of[text_of(one, "kind", file) + " " + text_of(one, "stimulus_id", file)] =
        text_of(one, "picture", file);
}

}  // namespace

SiteFiles read_site_files(const fs::path& folder) {
  const fs::path list = folder / "files.json";
  if (std::error_code error; !fs::exists(list, error))
    throw input_error({.file = folder.string(),
                       .wanted = "a folder that seamline export web wrote",
                       .found = fs::is_directory(folder, error) ? "one without files.json" : "none"});
  const JsonValue listed = read_json(list);
  SiteFiles site;
  for (const JsonValue& entry : field(listed, "files", JsonValue::Kind::array, list).items) {
    const std::string name = text_of(entry, "name", list), hash = text_of(entry, "sha256", list);
    const std::int64_t bytes = field(entry, "bytes", JsonValue::Kind::whole, list).whole;
    const std::string path = "/" + name;
    if (!is_sha256(hash))
      throw input_error(
          {.file = list.string(), .field = "sha256", .wanted = "a hash", .found = printable(hash, 80)});
    site.by_path[path] =
        read_sent_file(path_below(folder, name, {.file = list.string(), .field = "name"}), name, bytes, hash);
  }
  const std::string own = read_file(list);
  site.by_path["/files.json"] =
      read_sent_file(list, "files.json", static_cast<std::int64_t>(own.size()), sha256(own));
  if (!site.by_path.contains("/index.html") || !site.by_path.contains("/study.json"))
    throw input_error(
        {.file = list.string(), .wanted = "index.html and study.json among the files", .found = "none"});
  site.by_path["/"] = site.by_path["/index.html"];
  read_study(folder / "study.json", site);
  return site;
}

}  // namespace seamline::study::online
