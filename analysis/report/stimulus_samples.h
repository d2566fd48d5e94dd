#pragma once
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "analysis/analysis.h"
#include "stimuli/support/image.h"

namespace seamline::analysis {

/// A cut-out of one image, as a PNG file's bytes.
struct SampleImage {
  std::string label;  ///< "4096", or "reference"
  std::string stimulus_id;
  std::string png;
  int width_px = 0, height_px = 0;
};

/// One row of the paper's Fig. 3: one object under one artifact at falling widths, the reference first.
struct SampleRow {
  Artifact artifact = Artifact::none;
  std::string scene, object;
  std::vector<SampleImage> images;
};

/// The rows, or a sentence that says why there are none.
using StimulusSamples = std::variant<std::vector<SampleRow>, std::string>;

/// Cuts samples out of the set that the log names: for each artifact its left object, around the object's own
/// pixels in the object-id image with room for shadows. `scratch` is a folder that may be written to.
[[nodiscard]] StimulusSamples sample_stimuli(const Analysis& analysis, const std::filesystem::path& scratch);

struct Rectangle {
  int x = 0, y = 0, width_px = 0, height_px = 0;
};

/// The square around the pixels of `id` with half its size as margin on each side, at least 5/24 of the
/// width, inside the picture; the whole picture when no pixel has that id.
[[nodiscard]] Rectangle crop_around(const ByteImage& object_ids, int id);

}  // namespace seamline::analysis
