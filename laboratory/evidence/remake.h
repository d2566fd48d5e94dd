#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "laboratory/evidence/evidence_page.h"

namespace seamline::laboratory {

struct RemakeOptions {
  std::filesystem::path out;         ///< a folder for each page is made in it
  bool small = false;                ///< shows in seconds that the page can be remade, not its numbers
  std::filesystem::path pages = {};  ///< documentation/evidence/ of the source, to be renewed; or none
  std::function<void(const std::string&)> said = [](const std::string&) {};  ///< hears each step that begins
};

/// Why a page cannot be remade here, as a part of a sentence; empty where it can.
[[nodiscard]] std::string missing_of(const EvidencePage& page, bool small);

/// Runs the steps of a page that have not been run by this version on this machine, and writes
/// OUT/PAGE/PAGE.md: version, machine, commands, figures and tables. Returns its path. Throws InputError
/// where a step failed (what it printed is kept) or something that it needs is not there, Interrupted where
/// the person stopped it: the same call goes on with the step that was running.
std::filesystem::path remake_evidence(const EvidencePage& page, const RemakeOptions& options);

/// Computes the page's tables from the files that are in PAGES/PAGE, and writes them, and the marked parts of
/// PAGES/PAGE.md, whose path is returned. Throws InputError where the page is not there or names a file that
/// is not.
std::filesystem::path renew_evidence(const EvidencePage& page, const std::filesystem::path& pages);

}  // namespace seamline::laboratory
