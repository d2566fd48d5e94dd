#pragma once
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "analysis/log_analysis/analysis.h"
#include "support/files/image.h"

namespace seamline::analysis {

/// A cut-out of one image, as a PNG file's bytes.
struct SampleImage {
  std::string label;  ///< "4096", or "reference"
  std::string stimulus_id;
  std::string png;      ///< empty when the picture cannot be shown
  std::string trouble;  ///< why not, a sentence
  int width_px = 0, height_px = 0;
};

/// One row of the paper's Fig. 3: one object under one artifact from the least to the most noticeable level,
/// the reference first.
struct SampleRow {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  std::string scene, object;
  std::vector<SampleImage> images;
  std::string trouble;  ///< why there are no images, a sentence
};

/// The rows, or a sentence that says why there are none.
using StimulusSamples = std::variant<std::vector<SampleRow>, std::string>;

/// Cuts samples out of the set that the log names: for each artifact its left object, around the object's own
/// pixels in the object-id image with room for shadows. Only pictures that are what the manifest says are
/// shown: another one leaves its place empty, with the reason. `scratch` is a folder that may be written to.
[[nodiscard]] StimulusSamples sample_stimuli(const Analysis& analysis, const std::filesystem::path& scratch);

/// What a reader must know about the samples: a sentence that says how many pictures of the set are not shown
/// and why the first is not; nothing when all are.
[[nodiscard]] std::vector<std::string> notes_on(const StimulusSamples& samples);

/// What a reader must know about the depth of the set that the log names: how many holes it has at each
/// level. Nothing where no sensor measured it, or the set is not there any more.
[[nodiscard]] std::vector<std::string> notes_on_depth(const study::LogContents& log);

struct Rectangle {
  int x = 0, y = 0, width_px = 0, height_px = 0;
};

/// The square around the pixels of `id` with half its size as margin on each side, at least 5/24 of the
/// width, inside the picture; the whole picture when no pixel has that id.
[[nodiscard]] Rectangle crop_around(const ByteImage& object_ids, int id);

}  // namespace seamline::analysis
