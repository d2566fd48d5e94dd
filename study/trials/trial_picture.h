#pragma once
#include <array>

#include "stimuli/definition/parts/task_definition.h"
#include "study/placement/trial.h"
#include "study/trials/rendered_set.h"
#include "support/files/image.h"

namespace seamline::study {

/// The picture of a trial, or the first frame of its clip, as it goes to the screen: sRGB codes, 3 channels,
/// the size that the manifest says. Reads files and nothing else, so threads may load pictures ahead. Throws
/// InputError naming the file when it is missing, has other bytes than the set was rendered with or another
/// size, or the set has no reference of the scene.
[[nodiscard]] ByteImage load_trial_picture(const RenderedSet& set, const Trial& trial);

/// Whether the trial has a panorama for each eye.
[[nodiscard]] bool has_more_eyes(const RenderedSet& set, const Trial& trial);
/// All eyes' panoramas of such a trial, the left eye's on top.
[[nodiscard]] ByteImage load_all_eyes(const RenderedSet& set, const Trial& trial);

/// Grey between the two pictures of a pair.
inline constexpr int pair_gap_px = 24;

/// Width and height of what a trial shows at a time: a picture of the set, or two of them side by side.
/// Of a set whose conditions ask differently the largest.
[[nodiscard]] std::array<int, 2> shown_size_px(const RenderedSet& set);
[[nodiscard]] std::array<int, 2> shown_size_px(const RenderedSet& set, TaskKind kind);

/// The click map of a trial's picture: 1 channel, 0 background, objects from 1.
[[nodiscard]] ByteImage load_object_ids(const RenderedSet& set, const Trial& trial);

/// The choice that is right: the trial's own alternative, else the object, from 1, 0 when there is
/// none (`reference`).
[[nodiscard]] int right_object(const RenderedSet& set, const Trial& trial);

}  // namespace seamline::study
