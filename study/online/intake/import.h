#pragma once
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "study/log/origin.h"
#include "study/trials/rendered_set.h"

namespace seamline::study::online {

/// What files held of one participant, and how far they are in the log now.
struct ImportedPerson {
  std::string code;
  Origin origin = Origin::static_host;
  int stored = 0;                         ///< messages of theirs that are new in the log
  int known = 0;                          ///< that it had before, or that the files hold twice
  std::vector<std::string> refused = {};  ///< a sentence for each message that was left out
  std::vector<std::int64_t> gaps = {};    ///< numbers of messages that are in neither
  int answered = 0, trials = 0;
  bool completed = false;
};

struct ImportReport {
  int files = 0, messages = 0;
  int declined = 0;                         ///< new in the log
  std::vector<ImportedPerson> people = {};  ///< in the order in which they consented
  std::vector<std::string> cut_files = {};  ///< whose last message ends in the middle, which was left out
  std::vector<std::string> foreign = {};    ///< a sentence for each stretch that was left out as foreign
};

/// What becomes of that which is no message of this study and set: other components' results, another
/// study's.
enum class Foreign { ends_the_import, left_out };

/// Stores what files of messages say (results of JATOS, as text or as its archives; downloads of a page on a
/// host of files) into a log, all in one transaction; a log is made where there is none. What is stored
/// already is recognised, so that importing again changes nothing, and a file that was missing fills the
/// gaps. Throws InputError, with nothing stored, when a file cannot be read, or holds something foreign that
/// is not to be left out.
[[nodiscard]] ImportReport import_messages(const RenderedSet& set, const std::filesystem::path& log,
                                           const std::vector<std::filesystem::path>& files,
                                           Foreign foreign = Foreign::ends_the_import);

/// The report in words, a line for each participant.
[[nodiscard]] std::string import_text(const ImportReport& report, const std::filesystem::path& log);

/// The set that a log names, or the one that is given (`given` may be empty). Throws InputError when there is
/// neither, or it is not the log's.
[[nodiscard]] RenderedSet set_for_log(const std::filesystem::path& log, const std::filesystem::path& given);

}  // namespace seamline::study::online
