#pragma once
#include <filesystem>

#include "stimuli/definition/study_definition.h"
#include "stimuli/set/manifest.h"

namespace seamline::renderer {

/// Puts the frames of a study of clips together: a clip of every stimulus all of whose frames are rendered,
/// and of their references and click maps, below `clips/`, and the list of them (`clip_set.h`). Returns the
/// manifest, whose pictures are the clips' middle frames; the frames stay, for runs that go on. `of_frames`
/// is the manifest of `still_study(study)`.
[[nodiscard]] Manifest assemble_clips(const StudyDefinition& study, const std::filesystem::path& set_folder,
                                      const Manifest& of_frames);

}  // namespace seamline::renderer
