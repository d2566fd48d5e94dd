#include "stimuli/set/clip_set.h"

#include "stimuli/set/json_fields.h"
#include "stimuli/set/manifest_pictures.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/text_bounds.h"

namespace seamline::inline stimuli {
namespace {

namespace fs = std::filesystem;

constexpr const char* clip_set_format = "seamline clips";
constexpr int clip_set_version = 1;

Json clip_records_json(const std::vector<ClipRecord>& records) {
  Json json = Json::array();
  for (const ClipRecord& one : records)
    json.push_back({{"name", one.name}, {"file", one.file}, {"sha256", one.sha256}});
  return json;
}

std::vector<ClipRecord> read_clip_records(const SetFields& fields, const char* key, const fs::path& path) {
  std::vector<ClipRecord> records;
  for (const Json& item : fields.array(key)) {
    const SetFields one(item, path.string(), std::string(key) + "[" + std::to_string(records.size()) + "].");
    records.push_back({one.get<std::string>("name"), one.file_below("file"), one.get<std::string>("sha256")});
  }
  return records;
}

}  // namespace

std::optional<ClipSet> read_clip_set(const fs::path& set_folder) {
  const fs::path path = set_folder / clip_set_file;
  std::error_code error;
  if (!fs::exists(path, error)) return std::nullopt;
  const std::string text = read_file(path_in_set(set_folder, clip_set_file));
  require_bounded_json(text, path.string());
  const Json json = Json::parse(text, nullptr, false);
  const SetFields fields(json, path.string(), "");
  if (fields.get<std::string>("format") != clip_set_format || fields.get<int>("version") != clip_set_version)
    throw fields.complaint("format", "\"seamline clips\" of version 1", "another");
  ClipSet clips{.frames = fields.number("frames", 1, 999),
                .frames_per_s = fields.real("frames_per_s", 1, 240),
                .loops = fields.get<std::string>("plays") == "loop",
                .stimuli = read_clip_records(fields, "stimuli", path),
                .references = read_clip_records(fields, "references", path),
                .click_maps = read_clip_records(fields, "click_maps", path)};
  return clips;
}

void write_clip_set(const fs::path& set_folder, const ClipSet& clips) {
  const Json json = {{"format", clip_set_format},
                     {"version", clip_set_version},
                     {"frames", clips.frames},
                     {"frames_per_s", clips.frames_per_s},
                     {"plays", clips.loops ? "loop" : "once"},
                     {"stimuli", clip_records_json(clips.stimuli)},
                     {"references", clip_records_json(clips.references)},
                     {"click_maps", clip_records_json(clips.click_maps)}};
  write_file_atomically(set_folder / clip_set_file, json.dump(1) + "\n");
}

void check_clips(const fs::path& set_folder) {
  const std::optional<ClipSet> clips = read_clip_set(set_folder);
  if (!clips) return;
  for (const auto* records : {&clips->stimuli, &clips->references, &clips->click_maps})
    for (const ClipRecord& one : *records)
      if (sha256_of_file(path_in_set(set_folder, one.file)) != one.sha256)
        throw input_error({.file = (set_folder / one.file).string(),
                           .wanted = "the clip that the set was rendered with",
                           .found = "other bytes"});
}

void refuse_clips(const fs::path& set_folder, const std::string& what) {
  if (read_clip_set(set_folder))
    throw input_error({.file = set_folder.string(),
                       .wanted = "a set of stills: " + what + " cannot show clips yet",
                       .found = "a set of clips (" + std::string(clip_set_file) + ")"});
}

}  // namespace seamline::inline stimuli
