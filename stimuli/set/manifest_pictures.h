#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/set/manifest.h"
#include "support/files/image.h"

namespace seamline::inline stimuli {

/// A picture that a manifest names, relative to the set's folder: the SHA-256 of its bytes, and its shape.
struct ManifestPicture {
  std::string file;
  std::string sha256;
  int width_px = 0, height_px = 0;
  int channels = 3;  ///< 1: a click map

  bool operator==(const ManifestPicture&) const = default;
};

[[nodiscard]] ManifestPicture stimulus_picture(const Manifest& manifest, const ManifestStimulus& stimulus);
[[nodiscard]] ManifestPicture reference_picture(const Manifest& manifest, const ManifestReference& reference);
[[nodiscard]] ManifestPicture click_map_picture(const Manifest& manifest, const ManifestReference& reference);

/// The reference of a stimulus: its scene in the light of its condition. Throws InputError naming the
/// manifest of `set_folder` when there is none.
[[nodiscard]] const ManifestReference& reference_of(const std::filesystem::path& set_folder,
                                                    const Manifest& manifest, const Stimulus& stimulus);

/// Identity of what people are shown: the SHA-256 of the picture's file; where each eye has a panorama, of
/// the hashes of all of them, from the left to the right, one a line.
[[nodiscard]] std::string shown_sha256(const ManifestStimulus& record);

/// Every picture of a set: references, their click maps, stimuli; each once.
[[nodiscard]] std::vector<ManifestPicture> manifest_pictures(const Manifest& manifest);

/// Where a file is that the manifest names. Everything that opens one asks here: throws InputError when a
/// link leads out of the set's folder, because a set may have come from somebody else.
[[nodiscard]] std::filesystem::path path_in_set(const std::filesystem::path& set_folder,
                                                const std::string& name);

/// Throws InputError unless the file is there, has the bytes that the set was rendered with, and its header
/// says that it is a picture of the wanted shape.
void check_manifest_picture(const std::filesystem::path& set_folder, const ManifestPicture& wanted);

/// The picture, after `check_manifest_picture`: what all readers of a set's pictures may rely on.
[[nodiscard]] ByteImage read_manifest_picture(const std::filesystem::path& set_folder,
                                              const ManifestPicture& wanted);

/// The left eye's panorama and below it those of the other eyes; without others the picture itself.
[[nodiscard]] ByteImage read_all_eyes(const std::filesystem::path& set_folder, const ManifestPicture& left,
                                      const std::vector<EyePicture>& more_eyes);

/// Throws InputError naming the first picture of the set that is not there or has another shape than the
/// manifest says. Reads no more than headers: thousands take a tenth of a second.
void check_manifest_shapes(const std::filesystem::path& set_folder, const Manifest& manifest);

/// check_manifest_picture for every picture of the set, on all cores.
void check_manifest_pictures(const std::filesystem::path& set_folder, const Manifest& manifest);

}  // namespace seamline::inline stimuli
