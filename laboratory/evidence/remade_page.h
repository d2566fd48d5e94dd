#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "laboratory/evidence/evidence_page.h"

namespace seamline::laboratory {

/// A step with what it printed.
struct StepRecord {
  EvidenceStep step;
  std::string printed;
};

/// "seamline VERSION on PROCESSOR, N threads".
[[nodiscard]] std::string made_by();

/// The tables and figures of a page, those that are computed first.
[[nodiscard]] std::vector<std::string> shown_files(const EvidencePage& page);

/// The page as Markdown: who made it, by which commands, figures, tables and what the steps printed. Tables
/// of more than forty rows are links. `folder` holds what the steps wrote.
[[nodiscard]] std::string remade_page(const EvidencePage& page, bool small,
                                      const std::vector<StepRecord>& records,
                                      const std::filesystem::path& folder);

}  // namespace seamline::laboratory
