#include "sets/set_records.h"

#include <fmt/core.h>

#include <map>
#include <nlohmann/json.hpp>

#include "raytracer/scene/gltf/gltf_load.h"
#include "raytracer/tracing/ray_device.h"
#include "stimuli/definition/clip_frames.h"
#include "support/files/assets.h"
#include "support/files/atomic_file.h"
#include "support/files/confined_path.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/text_bounds.h"

namespace seamline::renderer {
namespace fs = std::filesystem;
namespace {

using Json = nlohmann::ordered_json;

/// Hash of a scene file and of the buffer and picture files beside it that it names.
std::string scene_file_hash(const fs::path& path) {
  std::string hashes = sha256_of_file(path);
  for (const fs::path& file : files_named_by_gltf(path)) hashes += sha256_of_file(file);
  return hashes;
}

/// Hashes of files, each read once: the moments of a clip name the same ones.
struct SceneFileHashes {
  std::map<fs::path, std::string> known = {};

  const std::string& of(const fs::path& path, std::string (*hash)(const fs::path&)) {
    const auto [found, added] = known.try_emplace(path);
    if (added) found->second = hash(path);
    return found->second;
  }
};

std::string scene_inputs(const SceneDefinition& scene, SceneFileHashes& hashes) {
  std::string text = canonical_text(scene) + hashes.of(scene.path, scene_file_hash);
  for (const ObjectDefinition& object : scene.objects) text += hashes.of(object.path, scene_file_hash);
  if (scene.environment) text += hashes.of(scene.environment->path, sha256_of_file);
  return text;
}

/// Of a file of the set itself: one that a link leads out of it is made anew, in its place.
bool has_hash(const fs::path& set_folder, const std::string& name, const std::string& expected) {
  std::error_code error;
  const fs::path file = set_folder / name;
  return is_written_below(name) && fs::is_regular_file(file, error) && lies_below(file, set_folder) &&
         sha256_of_file(file) == expected;
}

/// A record whose inputs agree; a record that cannot be read counts as unfinished work.
std::optional<Json> read_record(const fs::path& path, const std::string& inputs) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  std::string text;
  try {
    text = read_file(path);
    require_bounded_json(text, path.string());
  } catch (const InputError&) {
    return std::nullopt;
  }
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("inputs") || json["inputs"] != inputs || !json.contains("record"))
    return std::nullopt;
  return json["record"];
}

bool have_hashes(const fs::path& set_folder, const std::vector<EyePicture>& eyes) {
  return std::all_of(eyes.begin(), eyes.end(),
                     [&](const EyePicture& eye) { return has_hash(set_folder, eye.image, eye.sha256); });
}

void write_record(const fs::path& path, const std::string& inputs, const Json& record) {
  const Json json = {{"inputs", inputs}, {"record", record}};
  write_file_atomically(path, json.dump(1) + "\n");
}

}  // namespace

namespace {

/// The running program's own bytes: a changed program renders its pictures anew.
std::string program_hash() {
  std::error_code error;
  const fs::path self = fs::read_symlink("/proc/self/exe", error);
  return error ? std::string() : sha256_of_file(self);
}

/// The depth map that a source reads; null: none.
const fs::path* file_of(const DepthSource& source) {
  if (const auto* panorama = std::get_if<PanoramaSource>(&source); panorama != nullptr && panorama->file)
    return &panorama->file->path;
  const auto* file = std::get_if<FileSource>(&source);
  return file != nullptr ? &file->path : nullptr;
}

std::string amount_of_work(const RenderSettings& settings) {
  const std::string amount =
      settings.error ? fmt::format("error {}", *settings.error) : fmt::format("spp {}", settings.spp);
  return fmt::format("{} {} not omitting [{}]", word(settings.estimator), amount, turned_off(settings.omit));
}

}  // namespace

InputHashes::InputHashes(const StudyDefinition& study, const RenderSettings& settings)
    : common_(fmt::format("seamline {} {} {} image {} {} {} seed {}", program_version(), program_hash(),
                          RayDevice::instruction_set(), study.width_px, study.height_px,
                          amount_of_work(settings), settings.seed)),
      mesh_(settings.mesh) {
  if (study.clip && settings.error) {  // frames are sampled alike, as all of them decide
    common_ += " " + canonical_text(*study.clip);
    for (const double level : study.level.values) common_ += fmt::format(" {}", level);
  }
  SceneFileHashes hashes;
  for (const SceneDefinition& truth : list_truths(study)) truths_[truth.truth] = scene_inputs(truth, hashes);
  for (const Stimulus& stimulus : list_stimuli(study)) {
    if (stimulus.depth.chain)
      for (const DepthSource& source : stimulus.depth.chain->sources)
        if (const fs::path* path = file_of(source); path != nullptr && !depth_files_.contains(*path))
          depth_files_.emplace(*path, sha256_of_file(*path));
    settings_.insert(isolation_and_mesh(stimulus));
    if (const auto captured = captured_scene(study, stimulus))
      captured_[stimulus_id(stimulus)] = " depth of " + canonical_text(*captured);
  }
}

std::string InputHashes::isolation_and_mesh(const Stimulus& stimulus) const {
  std::string text = fmt::format("{} {} {}", word(stimulus.isolation),
                                 word(mesh_.value_or(stimulus.depth.mesh)), stimulus.depth.mesh_tolerance);
  if (stimulus.depth.mitigation != Mitigation{}) text += " " + canonical_text(stimulus.depth.mitigation);
  if (stimulus.depth.pipeline != Pipeline{}) text += " pipeline " + canonical_text(stimulus.depth.pipeline);
  if (stimulus.depth.albedo != MeshAlbedo::constant)
    text += fmt::format(" mesh albedo {}", word(stimulus.depth.albedo));
  if (!stimulus.depth.chain) return text;
  text += " " + canonical_text(stimulus.depth.chain);
  for (const DepthSource& source : stimulus.depth.chain->sources)
    if (const fs::path* path = file_of(source)) text += " " + depth_files_.at(*path);
  return text;
}

std::string InputHashes::of_stimulus(const Stimulus& stimulus) const {
  const std::string id = stimulus_id(stimulus);
  const auto captured = captured_.find(id);
  return sha256(fmt::format("{} {} {} {}{}", common_, isolation_and_mesh(stimulus), id,
                            truths_.at(truth_of(stimulus)),
                            captured == captured_.end() ? std::string() : captured->second));
}

std::string InputHashes::of_reference(const std::string& truth) const {
  return sha256(fmt::format("{} reference {}", common_, truths_.at(truth)));
}

std::string InputHashes::of_set() const {
  std::string text = common_;
  for (const std::string& settings : settings_) text += " " + settings;
  for (const auto& [name, inputs] : truths_) text += " " + name + " " + inputs;
  return sha256(text);
}

SetRecords::SetRecords(fs::path set_folder) : set_folder_(std::move(set_folder)) {}

std::optional<ManifestStimulus> SetRecords::finished(const std::string& id, const std::string& inputs) const {
  const fs::path path = set_folder_ / "records" / (id + ".json");
  const std::optional<Json> json = read_record(path, inputs);
  if (!json) return std::nullopt;
  try {
    const ManifestStimulus record = stimulus_record_from_text(json->dump(), path.string());
    if (has_hash(set_folder_, record.image, record.sha256) && have_hashes(set_folder_, record.more_eyes))
      return record;
  } catch (const InputError&) {
    // a damaged record is unfinished work
  }
  return std::nullopt;
}

void SetRecords::finish(const ManifestStimulus& record, const std::string& inputs) const {
  write_record(set_folder_ / "records" / (record.id + ".json"), inputs,
               Json::parse(stimulus_record_text(record)));
}

std::optional<ManifestReference> SetRecords::finished_reference(const std::string& truth,
                                                                const std::string& inputs) const {
  const std::optional<Json> json =
      read_record(set_folder_ / "records" / ("reference-" + truth + ".json"), inputs);
  if (!json) return std::nullopt;
  ManifestReference reference{
      .truth = truth, .image = {}, .object_ids = {}, .image_sha256 = {}, .object_ids_sha256 = {}};
  try {
    reference.image = json->at("image").get<std::string>();
    reference.object_ids = json->at("object_ids").get<std::string>();
    reference.image_sha256 = json->at("image_sha256").get<std::string>();
    reference.object_ids_sha256 = json->at("object_ids_sha256").get<std::string>();
    for (const auto& [key, eyes] : {std::pair("more_eyes", &reference.more_eyes),
                                    std::pair("more_object_ids", &reference.more_object_ids)})
      if (json->contains(key))
        for (const Json& eye : json->at(key))
          eyes->push_back({eye.at("image").get<std::string>(), eye.at("sha256").get<std::string>()});
  } catch (const Json::exception&) {
    return std::nullopt;  // a damaged record is unfinished work
  }
  const bool whole = has_hash(set_folder_, reference.image, reference.image_sha256) &&
                     has_hash(set_folder_, reference.object_ids, reference.object_ids_sha256) &&
                     have_hashes(set_folder_, reference.more_eyes) &&
                     have_hashes(set_folder_, reference.more_object_ids);
  return whole ? std::optional(reference) : std::nullopt;
}

void SetRecords::finish_reference(const ManifestReference& reference, const std::string& inputs) const {
  Json json = {{"image", reference.image},
               {"object_ids", reference.object_ids},
               {"image_sha256", reference.image_sha256},
               {"object_ids_sha256", reference.object_ids_sha256}};
  for (const auto& [key, eyes] : {std::pair("more_eyes", &reference.more_eyes),
                                  std::pair("more_object_ids", &reference.more_object_ids)})
    for (const EyePicture& eye : *eyes) json[key].push_back({{"image", eye.image}, {"sha256", eye.sha256}});
  write_record(set_folder_ / "records" / ("reference-" + reference.truth + ".json"), inputs, json);
}

}  // namespace seamline::renderer
