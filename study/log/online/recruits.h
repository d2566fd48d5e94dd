#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "stimuli/definition/people/recruitment_definition.h"

namespace seamline::study {

/// Somebody who came from a panel.
struct Recruit {
  std::string code;                                     ///< in the log
  std::string person;                                   ///< by which they are known again; empty: nothing
  std::map<std::string, std::string> identifiers = {};  ///< of their link, by name
  std::optional<VisitOutcome> outcome = {};             ///< none: not at the end
  std::string completion_code = {};                     ///< that they were shown
  bool operator==(const Recruit&) const = default;
};

/// Who came from where: a SQLite file of its own beside the log (`recruits_file`), so that answers can be
/// copied, merged, exported and archived without a panel's identifiers, and these deleted without the answers
/// (`forget_identifiers`). For its owner alone. Every call is on the disk when it returns. Not for several
/// threads at once. Throws InputError when the file cannot be read or written, or is another one.
class Recruits {
 public:
  /// Opens or makes the file.
  explicit Recruits(const std::filesystem::path& log);
  ~Recruits();
  Recruits(const Recruits&) = delete;
  Recruits& operator=(const Recruits&) = delete;

  [[nodiscard]] std::optional<Recruit> of_person(const std::string& person);
  [[nodiscard]] std::optional<Recruit> of_code(const std::string& code);
  /// In place of whoever was known by the same person, code or both.
  void enter(const Recruit& recruit);
  void end(const std::string& code, VisitOutcome outcome, const std::string& completion_code);
  /// By code.
  [[nodiscard]] std::vector<Recruit> everybody();

 private:
  struct Tables;
  std::unique_ptr<Tables> tables_;
};

/// LOG-recruits.
[[nodiscard]] std::filesystem::path recruits_file(const std::filesystem::path& log);

/// Takes one out, and leaves no byte of them. False: there is no file, or nobody of that code in it.
bool forget_recruit(const std::filesystem::path& log, const std::string& code);

/// Deletes every identifier, and keeps codes and outcomes. Returns how many people had some.
int forget_identifiers(const std::filesystem::path& log);

/// Writes who came from where as CSV, for its owner alone: code, outcome, completion code and a column for
/// each identifier. Returns how many people.
int write_recruits(const std::filesystem::path& log, const std::filesystem::path& csv);

}  // namespace seamline::study
