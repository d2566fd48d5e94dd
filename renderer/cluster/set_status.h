#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace seamline::renderer {

/// A process at work on a set, or one that ended otherwise than well.
struct ElementStatus {
  enum class State {
    running,
    failed,  ///< with a complaint
    died     ///< without one: its mark has not been renewed for `dead_after_s`
  };
  std::string name, host, complaint;
  State state = State::running;
  int done = 0, of = 0;
  double mark_age_s = 0;
};

/// How far each truth of a set is.
struct TruthStatus {
  std::string name;
  bool reference = false;  ///< finished
  int done = 0, of = 0;    ///< stimuli
};

/// How far a set is, from its folder alone.
struct SetStatus {
  std::string study;
  std::vector<TruthStatus> truths;
  std::vector<ElementStatus> elements;  ///< running, failed and dead ones, by name
  bool joined = false;                  ///< there is a manifest, and it lists every stimulus

  [[nodiscard]] int done() const;
  [[nodiscard]] int of() const;
};

/// Reads what renders left in `SET/records`; pictures are not looked at (`seamline verify` does that). A
/// record of other inputs counts as not done. Throws InputError when the folder is no set that a render of
/// this version has begun.
[[nodiscard]] SetStatus read_status(const std::filesystem::path& set_folder);

/// The status for a person, some lines.
[[nodiscard]] std::string status_text(const std::filesystem::path& set_folder, const SetStatus& status);

/// The same as a page that opens offline: a bar for each truth, and who is at work.
void write_status_page(const std::filesystem::path& file, const std::filesystem::path& set_folder,
                       const SetStatus& status);

}  // namespace seamline::renderer
