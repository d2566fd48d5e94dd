#pragma once
#include <string>

#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::study::online {

/// Why a message is not stored.
enum class RefusalKind {
  wrong,     ///< it is not what a page of this study sends
  unknown,   ///< nobody has this code or secret
  conflict,  ///< it contradicts what is stored
  excluded,  ///< the study has ended for this participant
  too_much,  ///< the participant has stored as much as anybody may
  failed     ///< the log could not take it; the same message may come again
};

/// A message that is not stored, with one sentence; nothing of it is in the log.
class Refusal : public InputError {
 public:
  Refusal(RefusalKind kind, const Complaint& complaint) : InputError(input_error(complaint)), kind_(kind) {}
  [[nodiscard]] RefusalKind kind() const { return kind_; }

 private:
  RefusalKind kind_;
};

inline Refusal conflict(const std::string& field, const std::string& wanted, const std::string& found) {
  return {RefusalKind::conflict, {.field = field, .wanted = wanted, .found = found}};
}

inline Refusal wrong(const std::string& field, const std::string& wanted, const std::string& found) {
  return {RefusalKind::wrong, {.field = field, .wanted = wanted, .found = found}};
}

/// What a message said, as a sentence may show it.
inline std::string in_quotes(const std::string& text) {
  return "\"" + printable(text, 60) + "\"";
}

}  // namespace seamline::study::online
