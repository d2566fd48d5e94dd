#pragma once
#include <string>

#include "stimuli/definition/stimulus.h"
#include "stimuli/set/manifest.h"

namespace seamline::test {

/// A manifest's record of the left object in a room.
inline ManifestStimulus record_of(Artifact artifact, const std::string& object, int width_px) {
  ManifestStimulus record;
  record.stimulus = {.scene = "room",
                     .artifact = artifact,
                     .object = object,
                     .object_index = 1,
                     .level = 1.0 * width_px,
                     .depth = {.width_px = width_px}};
  record.id = stimulus_id(record.stimulus);
  return record;
}

}  // namespace seamline::test
