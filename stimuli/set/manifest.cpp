#include "stimuli/set/manifest.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>

#include "stimuli/definition/parts/task_definition.h"
#include "stimuli/set/clip_set.h"
#include "stimuli/set/json_fields.h"
#include "stimuli/settings/study_settings.h"
#include "support/files/atomic_file.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/text_bounds.h"

namespace seamline::inline stimuli {
namespace {

constexpr int widest_depth_px = 16384;  ///< as in study files

/// Whether it says more than a depth width: sets of the first kind keep their bytes.
bool is_varied(const Stimulus& stimulus) {
  return stimulus.quantity != Quantity::depth_width_px || !stimulus.condition.empty() ||
         truth_of(stimulus) != stimulus.scene || stimulus.depth.chain.has_value() ||
         stimulus.depth.albedo != MeshAlbedo::constant || stimulus.depth.mitigation != Mitigation{} ||
         stimulus.depth.pipeline != Pipeline{};
}

/// Whole numbers are written as such, as they were when only these were allowed.
Json whole_where_whole(double value) {
  return value == std::trunc(value) ? Json(static_cast<std::int64_t>(value)) : Json(value);
}

/// Of panoramas for each eye only: other sets keep their bytes.
void add_eyes(const char* key, const std::vector<EyePicture>& eyes, Json& json) {
  for (const EyePicture& eye : eyes) json[key].push_back({{"image", eye.image}, {"sha256", eye.sha256}});
}

std::vector<EyePicture> read_eyes(const SetFields& fields, const char* key, const std::string& file) {
  std::vector<EyePicture> eyes;
  if (!fields.has(key)) return eyes;
  for (const Json& item : fields.array(key)) {
    const SetFields eye(item, file, std::string(key) + "[" + std::to_string(eyes.size()) + "].");
    eyes.push_back({eye.file_below("image"), eye.get<std::string>("sha256")});
  }
  return eyes;
}

Json to_json(const ManifestStimulus& record) {
  const Stimulus& stimulus = record.stimulus;
  Json json;
  json["id"] = record.id;
  json["scene"] = stimulus.scene;
  json["artifact"] = word(stimulus.artifact);
  json["object"] = stimulus.object;
  json["object_index"] = stimulus.object_index;
  json["condition"] = {{"depth_width_px", stimulus.depth.width_px},
                       {"depth_height_px", stimulus.depth.height_px()},
                       {"yaw_texels", whole_where_whole(stimulus.depth.yaw_texels)}};
  if (is_varied(stimulus)) {
    json["condition"]["name"] = stimulus.condition;
    json["condition"]["mesh"] = word(stimulus.depth.mesh);
    json["condition"]["mesh_tolerance"] = stimulus.depth.mesh_tolerance;
    if (stimulus.depth.chain) json["condition"]["depth"] = canonical_text(stimulus.depth.chain);
    if (stimulus.depth.albedo != MeshAlbedo::constant)
      json["condition"]["mesh_albedo"] = word(stimulus.depth.albedo);
    if (stimulus.depth.mitigation != Mitigation{})
      json["condition"]["mitigation"] = canonical_text(stimulus.depth.mitigation);
    if (stimulus.depth.pipeline != Pipeline{})
      json["condition"]["pipeline"] = canonical_text(stimulus.depth.pipeline);
    json["level"] = {{"quantity", facts(stimulus.quantity).key}, {"value", stimulus.level}};
    json["truth"] = truth_of(stimulus);
  }
  json["isolation"] = word(record.isolation);
  json["image"] = record.image;
  json["object_ids"] = record.object_ids;
  json["reference"] = record.reference;
  json["spp"] = record.spp;
  json["rays"] = record.rays;
  json["rmse"] = record.rmse ? Json(*record.rmse) : Json(nullptr);
  if (record.pipeline_error) json["pipeline_error"] = *record.pipeline_error;
  json["mesh"] = {{"triangles", record.mesh.triangles},
                  {"max_relative_error", record.mesh.max_relative_error}};
  if (const auto& sensor = record.mesh.sensor)
    json["mesh"]["sensor"] = {{"measured", sensor->measured},
                              {"holes", sensor->holes},
                              {"invented", sensor->invented},
                              {"outliers", sensor->outliers}};
  if (const auto& model = record.mesh.model)
    json["mesh"]["model"] = {{"planes", model->planes},
                             {"boxes", model->boxes},
                             {"explained_share", model->explained_share},
                             {"relative_residual", model->relative_residual}};
  if (const auto& error = record.mesh.depth_error)
    json["mesh"]["depth_error"] = {{"compared", error->compared},
                                   {"abs_rel", error->abs_rel},
                                   {"rmse_m", error->rmse_m},
                                   {"within_quarter", error->within_quarter}};
  json["tiny_denominators"] = {{"floored_pixels", record.tiny_denominators.floored_pixels},
                               {"clamped_pixels", record.tiny_denominators.clamped_pixels},
                               {"sealed_pixels", record.tiny_denominators.sealed_pixels},
                               {"not_finite_pixels", record.tiny_denominators.not_finite_pixels}};
  json["clipped_share"] = record.clipped_share;
  json["sha256"] = record.sha256;
  add_eyes("more_eyes", record.more_eyes, json);
  return json;
}

Artifact read_artifact(const SetFields& fields) {
  const auto text = fields.get<std::string>("artifact");
  const std::optional<Artifact> artifact = artifact_from_word(text);
  if (!artifact) throw fields.complaint("artifact", "a known artifact", "\"" + text + "\"");
  return *artifact;
}

/// A scene or an object, as study files name them: it stands in logs, reports and figures.
std::string read_name(const SetFields& fields, const char* key, bool may_be_empty = false) {
  const auto name = fields.get<std::string>(key);
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789_@";
  if ((name.empty() && !may_be_empty) || name.find_first_not_of(letters) != std::string::npos)
    throw fields.complaint(key, "lower-case letters, digits and _", "another name");
  return name;
}

int read_depth_width(const SetFields& condition) {
  const int width_px = condition.number("depth_width_px", 2, widest_depth_px);
  if (width_px % 2 != 0)
    throw condition.complaint("depth_width_px", "an even number", std::to_string(width_px));
  return width_px;
}

/// A scene's name, and what condition and level add to it; part of file names.
std::string read_truth(const SetFields& fields, const char* key) {
  const auto truth = fields.get<std::string>(key);
  constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyz0123456789_-@";
  if (truth.empty() || truth.size() > 200 || truth.find_first_not_of(letters) != std::string::npos)
    throw fields.complaint(key, "lower-case letters, digits, dashes and _", "another name");
  return truth;
}

/// A setting that is a word, as study files write it.
void read_choice(const SetFields& condition, const char* key, DepthSettings& depth) {
  const auto& choice = std::get<Choice<DepthSettings>>(setting<DepthSettings>(key).slot);
  const auto text = condition.get<std::string>(key);
  const auto found = std::find(choice.words.begin(), choice.words.end(), text);
  if (found == choice.words.end())
    throw condition.complaint(key, words_text(choice.words), "\"" + text + "\"");
  choice.choose(depth, static_cast<std::size_t>(found - choice.words.begin()));
}

/// What only sets with conditions or with other levels than widths say.
void read_varied(const SetFields& fields, const SetFields& condition, Stimulus& stimulus) {
  stimulus.condition = read_name(condition, "name", true);
  read_choice(condition, "mesh", stimulus.depth);
  stimulus.depth.mesh_tolerance = condition.real("mesh_tolerance", 0, 1);  // 0: a level, the full mesh
  if (condition.has("mesh_albedo")) read_choice(condition, "mesh_albedo", stimulus.depth);
  const SetFields level = fields.object("level");
  const auto quantity = quantity_from_key(level.get<std::string>("quantity"));
  if (!quantity)
    throw level.complaint("quantity", "a known quantity", "\"" + level.get<std::string>("quantity") + "\"");
  stimulus.quantity = *quantity;
  stimulus.level = level.real("value", facts(*quantity).least, facts(*quantity).most);
  stimulus.truth = read_truth(fields, "truth");
}

Stimulus read_stimulus(const SetFields& fields) {
  const SetFields condition = fields.object("condition");
  const int width_px = read_depth_width(condition);
  Stimulus stimulus{.scene = read_name(fields, "scene"),
                    .artifact = read_artifact(fields),
                    .object = read_name(fields, "object"),
                    .object_index = fields.number("object_index", 1, most_objects_of_scene),
                    .level = static_cast<double>(width_px),
                    .depth = {.width_px = width_px,
                              .yaw_texels = condition.real("yaw_texels", -widest_depth_px, widest_depth_px)}};
  stimulus.truth = stimulus.scene;
  if (fields.has("level")) read_varied(fields, condition, stimulus);
  return stimulus;
}

/// It becomes part of file names.
std::string read_id(const SetFields& fields) {
  const auto id = fields.get<std::string>("id");
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._-@";
  if (id.empty() || id.size() > 200 || id.front() == '.' ||
      id.find_first_not_of(letters) != std::string::npos)
    throw fields.complaint("id", "letters, digits, dots, dashes and underscores", "\"" + id + "\"");
  return id;
}

ManifestStimulus read_record(const SetFields& fields, const std::string& file) {
  ManifestStimulus record;
  record.id = read_id(fields);
  record.stimulus = read_stimulus(fields);
  const auto isolation = isolation_from_word(fields.get<std::string>("isolation"));
  if (!isolation) throw fields.complaint("isolation", "query or mask", fields.get<std::string>("isolation"));
  record.isolation = *isolation;
  record.stimulus.isolation = *isolation;
  record.image = fields.file_below("image");
  record.object_ids = fields.file_below("object_ids");
  record.reference = fields.file_below("reference");
  record.spp = fields.get<int>("spp");
  record.rays = fields.get<std::int64_t>("rays");
  const auto rmse = fields.get<Json>("rmse");
  if (rmse.is_number()) record.rmse = rmse.get<double>();
  if (fields.has("pipeline_error")) record.pipeline_error = fields.get<double>("pipeline_error");
  const SetFields mesh = fields.object("mesh");
  record.mesh = {.triangles = mesh.get<std::int64_t>("triangles"),
                 .max_relative_error = mesh.get<double>("max_relative_error")};
  if (mesh.has("sensor")) {
    const SetFields sensor = mesh.object("sensor");
    record.mesh.sensor = {.measured = sensor.get<std::int64_t>("measured"),
                          .holes = sensor.get<std::int64_t>("holes"),
                          .invented = sensor.get<std::int64_t>("invented"),
                          .outliers = sensor.get<std::int64_t>("outliers")};
  }
  if (mesh.has("model")) {
    const SetFields model = mesh.object("model");
    record.mesh.model = {.planes = model.get<int>("planes"),
                         .boxes = model.get<int>("boxes"),
                         .explained_share = model.get<double>("explained_share"),
                         .relative_residual = model.get<double>("relative_residual")};
  }
  if (mesh.has("depth_error")) {
    const SetFields error = mesh.object("depth_error");
    record.mesh.depth_error = {.compared = error.get<std::int64_t>("compared"),
                               .abs_rel = error.get<double>("abs_rel"),
                               .rmse_m = error.get<double>("rmse_m"),
                               .within_quarter = error.get<double>("within_quarter")};
  }
  const SetFields tiny = fields.object("tiny_denominators");
  record.tiny_denominators = {
      tiny.get<std::int64_t>("floored_pixels"), tiny.get<std::int64_t>("clamped_pixels"),
      tiny.get<std::int64_t>("sealed_pixels"), tiny.get<std::int64_t>("not_finite_pixels")};
  record.clipped_share = fields.get<double>("clipped_share");
  record.sha256 = fields.get<std::string>("sha256");
  record.more_eyes = read_eyes(fields, "more_eyes", file);
  return record;
}

Json to_json(const ManifestReference& reference) {
  Json json;
  json["scene"] = reference.truth;
  json["image"] = reference.image;
  json["object_ids"] = reference.object_ids;
  json["image_sha256"] = reference.image_sha256;
  json["object_ids_sha256"] = reference.object_ids_sha256;
  add_eyes("more_eyes", reference.more_eyes, json);
  add_eyes("more_object_ids", reference.more_object_ids, json);
  return json;
}

Json parse(const std::string& text, const std::string& file) {
  require_bounded_json(text, file);
  try {
    return Json::parse(text);
  } catch (const Json::parse_error& error) {
    throw input_error(
        {.file = file, .wanted = "JSON", .found = "something else at byte " + std::to_string(error.byte)});
  } catch (const Json::exception&) {
    throw input_error({.file = file, .wanted = "JSON with numbers of this machine", .found = "a larger one"});
  }
}

void check_version(const SetFields& fields) {
  const auto format = fields.get<std::string>("format");
  if (format != manifest_format)
    throw fields.complaint("format", std::string("\"") + manifest_format + "\"", "\"" + format + "\"");
  const int version = fields.get<int>("version");
  if (version != manifest_version && version != manifest_version_with_conditions &&
      version != manifest_version_with_clips)
    throw fields.complaint(
        "version",
        "version " + std::to_string(manifest_version) + " (render the set again with this program)",
        std::to_string(version));
}

/// The list of clips is a part of the manifest in a file of its own.
void check_clip_list(const SetFields& clips, const std::filesystem::path& set_folder) {
  std::error_code error;
  const std::filesystem::path path = set_folder / clip_set_file;
  if (!std::filesystem::exists(path, error) || sha256_of_file(path) != clips.get<std::string>("sha256"))
    throw clips.complaint("file", std::string(clip_set_file) + " as it was rendered", "none, or another one");
}

std::filesystem::path manifest_path(const std::filesystem::path& set_folder) {
  return set_folder / "manifest.json";
}

}  // namespace

Manifest read_manifest(const std::filesystem::path& set_folder) {
  const std::filesystem::path path = manifest_path(set_folder);
  if (!std::filesystem::exists(path))
    throw input_error(
        {.file = path.string(), .wanted = "a set rendered by `seamline render`", .found = "no such file"});
  const Json json = parse(read_file(path), path.string());
  const SetFields fields(json, path.string(), "");
  check_version(fields);
  if (fields.has("clips")) check_clip_list(fields.object("clips"), set_folder);
  Manifest manifest;
  const SetFields study = fields.object("study");
  manifest.study_name = study.get<std::string>("name");
  manifest.study_hash = study.get<std::string>("sha256");
  manifest.study_file = study.file_below("file");
  const SetFields program = fields.object("program");
  manifest.program_version = program.get<std::string>("version");
  manifest.instruction_set = program.get<std::string>("instruction_set");
  manifest.left_out = fields.get<std::vector<std::string>>("left_out");
  manifest.width_px = fields.number("width_px", 1, limits::largest_picture_side_px);
  manifest.height_px = fields.number("height_px", 1, limits::largest_picture_side_px);
  for (const Json& item : fields.array("references")) {
    const SetFields reference(item, path.string(),
                              "references[" + std::to_string(manifest.references.size()) + "].");
    manifest.references.push_back(
        {read_truth(reference, "scene"), reference.file_below("image"), reference.file_below("object_ids"),
         reference.get<std::string>("image_sha256"), reference.get<std::string>("object_ids_sha256"),
         read_eyes(reference, "more_eyes", path.string()),
         read_eyes(reference, "more_object_ids", path.string())});
  }
  std::set<std::string> ids;
  for (const Json& item : fields.array("stimuli")) {
    const SetFields record(item, path.string(), "stimuli[" + std::to_string(manifest.stimuli.size()) + "].");
    manifest.stimuli.push_back(read_record(record, path.string()));
    if (!ids.insert(manifest.stimuli.back().id).second)
      throw record.complaint("id", "an id that no other stimulus has", manifest.stimuli.back().id);
    if (manifest.stimuli.back().stimulus.quantity != level_quantity(manifest))
      throw record.complaint("level.quantity",
                             std::string(facts(level_quantity(manifest)).key) + ", as before",
                             std::string(facts(manifest.stimuli.back().stimulus.quantity).key));
  }
  return manifest;
}

void write_manifest(const std::filesystem::path& set_folder, const Manifest& manifest) {
  Json json;
  json["format"] = manifest_format;
  const bool varied = std::any_of(manifest.stimuli.begin(), manifest.stimuli.end(),
                                  [](const ManifestStimulus& one) { return is_varied(one.stimulus); });
  json["version"] = varied ? manifest_version_with_conditions : manifest_version;
  std::error_code error;
  if (std::filesystem::exists(set_folder / clip_set_file, error)) {
    json["version"] = manifest_version_with_clips;
    json["clips"] = {{"file", clip_set_file}, {"sha256", sha256_of_file(set_folder / clip_set_file)}};
  }
  json["study"] = {
      {"name", manifest.study_name}, {"sha256", manifest.study_hash}, {"file", manifest.study_file}};
  json["program"] = {{"version", manifest.program_version}, {"instruction_set", manifest.instruction_set}};
  json["left_out"] = manifest.left_out;
  json["width_px"] = manifest.width_px;
  json["height_px"] = manifest.height_px;
  json["references"] = Json::array();
  for (const ManifestReference& reference : manifest.references)
    json["references"].push_back(to_json(reference));
  json["stimuli"] = Json::array();
  for (const ManifestStimulus& record : manifest.stimuli) json["stimuli"].push_back(to_json(record));
  write_file_atomically(manifest_path(set_folder), json.dump(1) + "\n");
}

Quantity level_quantity(const Manifest& manifest) {
  return manifest.stimuli.empty() ? Quantity::depth_width_px : manifest.stimuli.front().stimulus.quantity;
}

std::string stimulus_record_text(const ManifestStimulus& record) {
  return to_json(record).dump();
}

ManifestStimulus stimulus_record_from_text(const std::string& text, const std::string& file) {
  const Json json = parse(text, file);
  return read_record(SetFields(json, file, ""), file);
}

std::string set_hash(const std::filesystem::path& set_folder) {
  return sha256_of_file(manifest_path(set_folder));
}

}  // namespace seamline::inline stimuli
