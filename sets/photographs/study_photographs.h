#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "stimuli/definition/study_definition.h"

namespace seamline::renderer {

/// What `render STUDY --photographs DIR` asks for.
struct PhotographsRequest {
  std::filesystem::path folder;
  std::string only = {};        ///< a pattern of their names; empty: all
  std::optional<int> spp = {};  ///< none: the study's
  int threads = 0;              ///< 0: one for each core
};

/// Writes what an estimator of depth needs to see: for each scene (each of its lights) and each object, the
/// scene with all objects but that one, as each of the study's depth cameras sees it, in the pixels of its
/// depth map.
///
///     NAME.png         sRGB codes, at the scene's exposure; every path traced to its end
///     NAME.toml        the camera (documentation/how-to/registration.md); not of panoramas
///     NAME-depth.pfm   true distances in metres, by the source's convention, to align with and to judge by
///     NAME-right.png   of stereo: what its right camera sees
///
/// NAME is SCENE-OBJECT, with the condition's name behind it where the study has several depth cameras.
/// Returns how many photographs there are. Throws InputError where the study's files are wrong, or where no
/// name matches `only`.
int write_photographs(const StudyDefinition& study, const PhotographsRequest& request);

}  // namespace seamline::renderer
