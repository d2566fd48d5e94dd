#pragma once
#include <fmt/core.h>

#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"
#include "stimuli/set/manifest.h"
#include "stimuli/study_file/study_file.h"
#include "study/trials/rendered_set.h"
#include "support/files/atomic_file.h"
#include "support/files/temporary_folder.h"

namespace seamline::study {

/// `objects`: of each scene, at most eight.
inline std::string study_text(const std::string& name, const std::string& widths_px, int objects = 3) {
  std::string text = fmt::format(
      "format = \"seamline study 1\"\nname = \"{}\"\nseed = 7\ndepth_width_px = [{}]\n"
      "[session]\nbreak_every_trials = 5\n",
      name, widths_px);
  const auto scene = [&](const char* scene_name, const char* artifacts) {
    text += fmt::format("[[scene]]\nname = \"{}\"\nfile = \"none.glb\"\nartifacts = [{}]\n", scene_name,
                        artifacts);
    const std::vector<const char*> names = {"left",  "middle", "right",   "fourth",
                                            "fifth", "sixth",  "seventh", "eighth"};
    for (int object = 0; object < objects; ++object)
      text += fmt::format("[[scene.object]]\nname = \"{}\"\nfile = \"none.glb\"\n",
                          names.at(static_cast<std::size_t>(object)));
  };
  scene("bedroom", "\"receiver\"");
  scene("gazebo", "\"shadow\", \"overlap\"");
  scene("atrium", "\"occlusion\"");
  return text;
}

inline constexpr const char* paper_widths_px = "64, 128, 256, 512, 1024, 2048, 4096";

/// Writes a study file into a set's folder, and makes the manifest of all its stimuli; neither pictures nor
/// the manifest's file.
inline Manifest begin_set_of_text(const std::filesystem::path& folder, const std::string& text) {
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / "study.toml", text);
  const StudyDefinition study = read_study(folder / "study.toml", AssetCheck::not_needed);
  Manifest manifest;
  manifest.study_name = study.name;
  manifest.study_hash = study_hash(study);
  manifest.width_px = study.width_px;
  manifest.height_px = study.height_px;
  for (const Stimulus& stimulus : list_stimuli(study)) {
    ManifestStimulus record;
    record.id = stimulus_id(stimulus);
    record.stimulus = stimulus;
    record.image = record.id + ".png";
    record.sha256 = std::string(64, '0');
    manifest.stimuli.push_back(record);
  }
  return manifest;
}

/// Writes a set of a study file as `render` would, without images.
inline RenderedSet write_set_of_text(const std::filesystem::path& folder, const std::string& text) {
  write_manifest(folder, begin_set_of_text(folder, text));
  return load_rendered_set(folder);
}

/// The same of `study_text`: 12 stimuli a width. The paper's widths make its 84.
inline RenderedSet write_set(const std::filesystem::path& folder, const std::string& widths_px = "64, 512",
                             const std::string& name = "tiny") {
  return write_set_of_text(folder, study_text(name, widths_px));
}

}  // namespace seamline::study
