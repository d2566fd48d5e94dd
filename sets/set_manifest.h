#pragma once
#include <cstddef>
#include <filesystem>
#include <map>
#include <string>

#include "sets/render_plan.h"
#include "sets/set_records.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// What a set is rendered from, and what of it is finished.
struct SetState {
  const StudyDefinition& study;
  const RenderSettings& settings;
  const InputHashes& hashes;
  const SetRecords& records;
  const std::string& identity;  ///< the study's hash in the manifest (`identity_in`)
};

/// The manifest of what is finished, in the study's order, with what was left out for it. `lights` holds
/// the facts of scenes loaded so far; those of scenes that were finished earlier are added.
[[nodiscard]] Manifest set_manifest(const SetState& set, std::map<std::string, LightFacts>& lights);

/// Whether a folder has a set, or one that a render began: a manifest, or something in `records`.
[[nodiscard]] bool is_begun_set(const std::filesystem::path& folder);

/// Throws InputError unless a set may be rendered into the folder: it is not there, has nothing but empty
/// folders, or is a begun set.
void require_set_folder(const std::filesystem::path& folder);

/// How many stimuli the manifest in a folder lists; 0 where there is none. Throws InputError for a set of
/// another study.
[[nodiscard]] std::size_t stimuli_listed(const std::filesystem::path& set_folder,
                                         const StudyDefinition& study);

}  // namespace seamline::renderer
