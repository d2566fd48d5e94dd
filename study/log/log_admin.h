#pragma once
#include <filesystem>
#include <string>

#include "study/log/log.h"

namespace seamline::study {

/// Who has done what, as lines of text for people: `seamline log status LOG`.
[[nodiscard]] std::string status_text(const LogContents& log);

/// Excludes a participant: the answers stay in the log, marked, and the slot is free for another one.
/// Excluding twice changes nothing. Throws InputError when the code is not in the log.
void exclude_participant(const std::filesystem::path& log, const std::string& code);

/// Deletes every trace of a participant (rows, free pages, write-ahead log) and records that someone was
/// deleted, not who. Throws InputError, and deletes nothing, when the code is not in the log or another
/// program has the log open, since that program could bring pages of the participant back. Returns whether
/// they took part in a browser, and so may have come by an invitation.
bool forget_participant(const std::filesystem::path& log, const std::string& code);

/// Whether the log has this code. Throws InputError when it cannot be read.
[[nodiscard]] bool has_participant(const std::filesystem::path& log, const std::string& code);

}  // namespace seamline::study
