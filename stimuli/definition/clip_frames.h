#pragma once
#include <optional>
#include <vector>

#include "stimuli/definition/moving/clip_definition.h"
#include "stimuli/definition/stimulus.h"

namespace seamline::inline stimuli {

/// What is rendered for a study: the study itself, or, where it shows clips, a study of stills whose stimuli
/// are the frames. That one has each condition once for every frame, named `soft@012`, or `@012` where there
/// are no conditions. So a frame is rendered, recorded, shared out and resumed as any still is, and its truth
/// is named `bedroom@012`.
[[nodiscard]] StudyDefinition still_study(const StudyDefinition& study);
[[nodiscard]] bool is_of_frames(const StudyDefinition& study);

/// A clip that people are shown, and the stills that are its frames; one that looks like an earlier one is
/// that one.
struct Clip {
  Stimulus shown;
  std::vector<Stimulus> frames;
};

/// The clips of a study, in the order of `list_stimuli`.
[[nodiscard]] std::vector<Clip> list_clips(const StudyDefinition& study);

/// The scene of a clip at a time: that of a still. `level` says the speed where that is the study's level.
[[nodiscard]] SceneDefinition scene_at(SceneDefinition scene, const StudyDefinition& study, double level,
                                       double time_s);

/// The scene whose depth a stimulus of a study of frames has, where what is real stood elsewhere when that
/// was captured; else nothing, as for every other study.
[[nodiscard]] std::optional<SceneDefinition> captured_scene(const StudyDefinition& frames,
                                                            const Stimulus& stimulus);

/// The depth settings of a stimulus of a study of frames: a sensor's noise is new in every capture, and held
/// as long as that is. The first capture has the noise of a still. Those of every other study are as they
/// are.
[[nodiscard]] DepthSettings depth_of_frame(const StudyDefinition& study, const std::string& condition,
                                           DepthSettings depth, double level);

/// The scene of a condition of a study of frames: at the frame's time.
[[nodiscard]] SceneDefinition scene_of_frame(const StudyDefinition& frames, const std::string& condition,
                                             SceneDefinition scene, double level);

/// Every stimulus, also those of frames that look like another one. (stimulus.cpp)
[[nodiscard]] std::vector<Stimulus> list_every_stimulus(const StudyDefinition& study);

/// Leaves the first of the stimuli that have the same picture.
[[nodiscard]] std::vector<Stimulus> without_twins(const StudyDefinition& frames,
                                                  std::vector<Stimulus> stimuli);

}  // namespace seamline::inline stimuli
