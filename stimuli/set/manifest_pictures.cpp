#include "stimuli/set/manifest_pictures.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "support/files/confined_path.h"
#include "support/files/hash.h"
#include "support/running/parallel.h"
#include "support/text/error.h"

namespace seamline::inline stimuli {
namespace fs = std::filesystem;
namespace {

fs::path existing(const fs::path& set_folder, const std::string& file) {
  const fs::path path = path_in_set(set_folder, file);
  std::error_code error;
  if (fs::is_regular_file(path, error)) return path;
  throw input_error(
      {.file = path.string(),
       .wanted = "the picture that the set was rendered with (the same `seamline render` makes it again)",
       .found = "no such file"});
}

void check_bytes(const fs::path& path, const std::string& sha256) {
  if (const std::string found = sha256_of_file(path); found != sha256)
    throw input_error({.file = path.string(),
                       .wanted = "the picture that the set was rendered with, hash " + sha256.substr(0, 16) +
                                 "... (the same `seamline render` makes it again)",
                       .found = "other bytes, hash " + found.substr(0, 16) + "..."});
}

void check_shape(const fs::path& path, const ManifestPicture& wanted, const PictureShape& found) {
  const PictureShape right{wanted.width_px, wanted.height_px, wanted.channels};
  if (found == right) return;
  const auto text = [](const PictureShape& shape) {
    return fmt::format("{} x {} pixels with {} channels", shape.width_px, shape.height_px, shape.channels);
  };
  throw input_error(
      {.file = path.string(), .wanted = text(right) + ", as in the manifest", .found = text(found)});
}

/// What a stimulus is compared with are the pictures of its scene: others would be checked by nobody.
void check_references(const fs::path& set_folder, const Manifest& manifest) {
  for (std::size_t i = 0; i < manifest.stimuli.size(); ++i) {
    const ManifestStimulus& stimulus = manifest.stimuli[i];
    const ManifestReference& reference = reference_of(set_folder, manifest, stimulus.stimulus);
    const auto check = [&](const char* key, const std::string& wanted, const std::string& found) {
      if (found != wanted)
        throw input_error({.file = (set_folder / "manifest.json").string(),
                           .field = fmt::format("stimuli[{}].{}", i, key),
                           .wanted = "\"" + wanted + "\", as in references",
                           .found = "\"" + found + "\""});
    };
    check("reference", reference.image, stimulus.reference);
    check("object_ids", reference.object_ids, stimulus.object_ids);
  }
}

}  // namespace

ManifestPicture stimulus_picture(const Manifest& manifest, const ManifestStimulus& stimulus) {
  return {stimulus.image, stimulus.sha256, manifest.width_px, manifest.height_px, 3};
}

ManifestPicture reference_picture(const Manifest& manifest, const ManifestReference& reference) {
  return {reference.image, reference.image_sha256, manifest.width_px, manifest.height_px, 3};
}

ManifestPicture click_map_picture(const Manifest& manifest, const ManifestReference& reference) {
  return {reference.object_ids, reference.object_ids_sha256, manifest.width_px, manifest.height_px, 1};
}

const ManifestReference& reference_of(const fs::path& set_folder, const Manifest& manifest,
                                      const Stimulus& stimulus) {
  for (const ManifestReference& reference : manifest.references)
    if (reference.truth == truth_of(stimulus)) return reference;
  throw input_error({.file = (set_folder / "manifest.json").string(),
                     .field = "references",
                     .wanted = "a reference of the scene " + truth_of(stimulus),
                     .found = "none"});
}

std::string shown_sha256(const ManifestStimulus& record) {
  if (record.more_eyes.empty()) return record.sha256;
  std::string hashes = record.sha256 + "\n";
  for (const EyePicture& eye : record.more_eyes) hashes += eye.sha256 + "\n";
  return sha256(hashes);
}

std::vector<ManifestPicture> manifest_pictures(const Manifest& manifest) {
  std::vector<ManifestPicture> files;
  const auto add_eyes = [&](const std::vector<EyePicture>& eyes, int channels) {
    for (const EyePicture& eye : eyes)
      files.push_back({eye.image, eye.sha256, manifest.width_px, manifest.height_px, channels});
  };
  for (const ManifestReference& reference : manifest.references) {
    files.push_back(reference_picture(manifest, reference));
    files.push_back(click_map_picture(manifest, reference));
    add_eyes(reference.more_eyes, 3);
    add_eyes(reference.more_object_ids, 1);
  }
  for (const ManifestStimulus& stimulus : manifest.stimuli) {
    files.push_back(stimulus_picture(manifest, stimulus));
    add_eyes(stimulus.more_eyes, 3);
  }
  const auto less = [](const ManifestPicture& a, const ManifestPicture& b) {
    return std::tie(a.file, a.sha256, a.channels) < std::tie(b.file, b.sha256, b.channels);
  };
  std::sort(files.begin(), files.end(), less);
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

fs::path path_in_set(const fs::path& set_folder, const std::string& name) {
  return path_below(set_folder, name, {.file = (set_folder / "manifest.json").string(), .field = "files"});
}

void check_manifest_picture(const fs::path& set_folder, const ManifestPicture& wanted) {
  const fs::path path = existing(set_folder, wanted.file);
  check_bytes(path, wanted.sha256);
  check_shape(path, wanted, picture_shape(path));
}

ByteImage read_manifest_picture(const fs::path& set_folder, const ManifestPicture& wanted) {
  const fs::path path = existing(set_folder, wanted.file);
  check_bytes(path, wanted.sha256);
  ByteImage image = read_bytes_image(path);
  check_shape(path, wanted, {image.width_px, image.height_px, image.channels});
  return image;
}

ByteImage read_all_eyes(const fs::path& set_folder, const ManifestPicture& left,
                        const std::vector<EyePicture>& more_eyes) {
  ByteImage all = read_manifest_picture(set_folder, left);
  for (const EyePicture& eye : more_eyes) {
    const ByteImage one = read_manifest_picture(
        set_folder, {eye.image, eye.sha256, left.width_px, left.height_px, left.channels});
    all.values.insert(all.values.end(), one.values.begin(), one.values.end());
    all.height_px += one.height_px;
  }
  return all;
}

void check_manifest_shapes(const fs::path& set_folder, const Manifest& manifest) {
  check_references(set_folder, manifest);
  for (const ManifestPicture& wanted : manifest_pictures(manifest)) {
    const fs::path path = existing(set_folder, wanted.file);
    check_shape(path, wanted, picture_shape(path));
  }
}

void check_manifest_pictures(const fs::path& set_folder, const Manifest& manifest) {
  check_references(set_folder, manifest);
  const std::vector<ManifestPicture> files = manifest_pictures(manifest);
  run_parallel(static_cast<int>(files.size()), 0,
               [&](int index) { check_manifest_picture(set_folder, files[index]); });
}

}  // namespace seamline::inline stimuli
