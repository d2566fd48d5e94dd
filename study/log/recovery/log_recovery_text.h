#pragma once
#include <filesystem>
#include <string>

#include "study/log/recovery/log_recovery.h"

namespace seamline::study {

/// A recovery in words: what was saved, and what is lost of whom.
[[nodiscard]] std::string recovery_text(const LogRecovery& recovery, const std::filesystem::path& damaged,
                                        const std::filesystem::path& out);

}  // namespace seamline::study
