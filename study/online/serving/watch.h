#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "study/online/intake/intake.h"
#include "study/online/serving/http_request.h"
#include "study/online/serving/recruitment_desk.h"
#include "study/online/serving/tokens.h"

namespace seamline::study::online {

/// The experimenter's page: who is on, how far, what was refused, how much room is left. Behind a secret of
/// its own; without identifiers of a panel.
class Watch {
 public:
  /// Reads the page, and the secret's file (made where it is missing). `refused`: how often each kind of
  /// request was refused since the server began ("429 /api/enrol"). Throws InputError when either cannot be
  /// read.
  Watch(const std::filesystem::path& secret_file, std::filesystem::path log,
        std::function<std::map<std::string, int>()> refused);

  [[nodiscard]] bool is_key(const std::string& secret) const;
  [[nodiscard]] std::shared_ptr<const SentFile> page() const { return page_; }
  /// As JSON. Asked from the thread that writes the log. `desk` and `invitations` may be null.
  [[nodiscard]] std::string facts_text(Intake& intake, const RecruitmentDesk* desk,
                                       const Invitations* invitations) const;

 private:
  std::string key_sha256_;
  std::filesystem::path log_;
  std::function<std::map<std::string, int>()> refused_;
  std::shared_ptr<const SentFile> page_;
};

}  // namespace seamline::study::online
