#pragma once
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "laboratory/evidence/evidence_table.h"

namespace seamline::laboratory {

// documentation/evidence/ as data: which commands remake the numbers of a page.

/// What a step prints: text for a block, Markdown for the page, or only what is of interest while it runs.
enum class Printed { text, markdown, progress };

/// A command of a page, as a shell would read it (no quotes; variables may stand before it). It runs in the
/// page's folder. Its first word is `seamline`, a program below `tests/` of the build, or a script below
/// `benchmarks/` of the source. `stimuli/NAME.toml` is a study that comes with Seamline, SEAMLINE the path of
/// the program, BUILD that of the build, SCENES that of the built-in scenes.
struct EvidenceStep {
  std::string name;  ///< what it printed is in NAME.txt
  std::string command;
  Printed printed = Printed::text;
};

/// Curves through the means of a table's column: x, y and the name of the curve are columns.
struct MeanCurves {
  std::string x, y, curve;
  std::string x_label, y_label;
};

/// A dot a row of a table, below one another: `labels` are columns, joined; a dotted line at `wanted`.
struct LabelledDots {
  std::vector<std::string> labels;
  std::string x, x_label;
  double wanted = 1;
};

/// A figure of a table that a step writes.
struct EvidenceFigure {
  std::string table;  ///< .csv; the figure has its name
  std::string heading;
  std::variant<MeanCurves, LabelledDots> of;
};

/// A page of documentation/evidence/.
struct EvidencePage {
  std::string name;   ///< of the page, and of the folder that the command writes
  std::string shows;  ///< one sentence
  std::string takes;  ///< processor time
  std::string needs;  ///< besides the installed program; may be empty
  std::vector<EvidenceStep> steps, small_steps;
  std::vector<std::string> shown = {};  ///< .svg, .csv and .md that the steps write, if they do
  std::vector<EvidenceFigure> figures = {};
  std::vector<PrintedTable> printed = {};
  std::vector<EvidenceTable> tables = {};  ///< after the printed ones, which they may be made from
};

/// What pages need besides an installed program.
inline constexpr const char* tests_needed = "a build with its tests: cmake --build build/release";
inline constexpr const char* python_needed = "the source, Python";

/// All that can be remade, in the order in which it is listed.
[[nodiscard]] std::span<const EvidencePage> evidence_pages();

/// Throws InputError naming the nearest page where there is none of that name.
[[nodiscard]] const EvidencePage& evidence_page(const std::string& name);

// Pages on what is computed from answers: thresholds, intervals, fits.

[[nodiscard]] EvidencePage coverage_page();
[[nodiscard]] EvidencePage replication_page();
[[nodiscard]] EvidencePage joint_model_page();
[[nodiscard]] EvidencePage statistics_page();

// Pages on pictures: their errors, told and true, and what is predicted from them.

[[nodiscard]] EvidencePage convergence_page();
[[nodiscard]] EvidencePage predictions_page();
[[nodiscard]] EvidencePage real_time_page();
[[nodiscard]] EvidencePage true_errors_page();

// Pages on what surrounds the pictures: plans of studies, depth cameras and things that rest, contact sheets.

[[nodiscard]] EvidencePage planning_page();
[[nodiscard]] EvidencePage depth_cameras_page();
[[nodiscard]] EvidencePage pictures_page();

}  // namespace seamline::laboratory
