#pragma once
#include <filesystem>

#include "laboratory/evidence/evidence_page.h"

namespace seamline::laboratory {

struct RemakeOptions {
  std::filesystem::path out;  ///< a folder for each page is made in it
  bool small = false;         ///< shows in seconds that the page can be remade, not its numbers
};

/// Why a page cannot be remade here, as a part of a sentence; empty where it can.
[[nodiscard]] std::string missing_of(const EvidencePage& page, bool small);

/// Runs the steps of a page that have not been run by this version on this machine, and writes
/// OUT/PAGE/PAGE.md: version, machine, commands, figures and tables. Returns its path. Throws InputError
/// where a step failed (what it printed is kept) or something that it needs is not there, Interrupted where
/// the person stopped it: the same call goes on with the step that was running.
std::filesystem::path remake_evidence(const EvidencePage& page, const RemakeOptions& options);

}  // namespace seamline::laboratory
