#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "stimuli/definition/stimulus.h"
#include "stimuli/pictures/seam_measure.h"
#include "support/text/csv.h"

namespace seamline::renderer {

/// One stimulus and its seam.
struct SeamRow {
  std::string id;
  Stimulus stimulus;
  SeamMeasure seam;
};

/// Means over the scenes and objects of one artifact at one level, at each of `seam_steps`.
struct SeamCell {
  Artifact artifact = Artifact::none;
  std::string condition;  ///< empty where the study has one
  double level = 0;
  std::array<double, seam_steps.size()> area_px = {}, widest_band_px = {};
};

struct SetSeams {
  std::string study_name;
  int width_px = 0, height_px = 0;
  double pixels_per_degree = 0;  ///< of the study's `[observer]`
  Quantity quantity = Quantity::depth_width_px;
  bool several_conditions = false;
  std::vector<SeamRow> rows;    ///< in the manifest's order
  std::vector<SeamCell> cells;  ///< by artifact and condition in the order of the study, levels rising

  [[nodiscard]] double degrees(double length_px) const { return length_px / pixels_per_degree; }
  [[nodiscard]] double square_degrees(double area_px) const { return degrees(degrees(area_px)); }
};

/// How far every stimulus of a rendered set differs from its reference (`measure_seams`), with progress on
/// standard error. Throws InputError when the folder holds no set, its study is not the one it was rendered
/// from, it holds no stimuli, or one of its pictures is not what the manifest says.
[[nodiscard]] SetSeams read_set_seams(const std::filesystem::path& set_folder);

/// One row a stimulus.
[[nodiscard]] CsvTable seams_table(const SetSeams& seams);

/// One row a cell, for people: areas as "px (square degrees)", bands as "px (degrees)".
[[nodiscard]] CsvTable seam_cells_table(const SetSeams& seams);

/// What the numbers are, in two sentences.
[[nodiscard]] std::string seams_meaning(const SetSeams& seams);

}  // namespace seamline::renderer
