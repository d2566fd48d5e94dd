#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "sets/sharing/set_running.h"

namespace seamline::renderer {

/// How far each truth of a set is.
struct TruthStatus {
  std::string name;
  bool reference = false;  ///< finished
  int done = 0, of = 0;    ///< stimuli
};

/// How far a set is, from its folder alone.
struct SetStatus {
  std::string study;
  std::string job;  ///< folder of the job that makes it; empty where none does, or a list does not say
  std::vector<TruthStatus> truths;
  std::vector<FoundMark> marks;  ///< of pieces at work, and of those that ended otherwise than well
  bool by_job = true;            ///< false: rendered by one process or by shards, which leave no marks
  bool joined = false;           ///< there is a manifest, and it lists every stimulus

  [[nodiscard]] int done() const;
  [[nodiscard]] int of() const;
};

/// Reads what renders left in `SET/records`; pictures are not looked at (`seamline verify` does that). A
/// record of other inputs counts as not done. Throws InputError when the folder is no set that a job of this
/// version makes and has no manifest either.
[[nodiscard]] SetStatus read_status(const std::filesystem::path& set_folder);

/// The status for a person, some lines.
[[nodiscard]] std::string status_text(const std::filesystem::path& set_folder, const SetStatus& status);

/// The same as a page that opens offline: a bar for each truth, and who is at work.
void write_status_page(const std::filesystem::path& file, const std::filesystem::path& set_folder,
                       const SetStatus& status);

}  // namespace seamline::renderer
