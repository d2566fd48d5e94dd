#pragma once
#include <filesystem>
#include <string>

#include "stimuli/definition/study_definition.h"
#include "stimuli/set/manifest.h"

namespace seamline::study {

/// A rendered set, and the study it belongs to: all that a session needs, without the images.
struct RenderedSet {
  std::filesystem::path folder;  ///< absolute
  Manifest manifest;
  std::string set_hash;    ///< of the manifest's bytes
  StudyDefinition study;   ///< read from the copy in the set
  std::string study_text;  ///< that copy, as it is
};

/// Reads a set. Throws InputError when there is no manifest or study file, one of them is wrong, the set is
/// empty, or the study file is not the one that the set was rendered from.
[[nodiscard]] RenderedSet load_rendered_set(const std::filesystem::path& folder);

}  // namespace seamline::study
