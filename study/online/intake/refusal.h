#pragma once
#include "support/text/error.h"

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

}  // namespace seamline::study::online
