#pragma once
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <shared_mutex>
#include <string>

#include "study/online/intake/intake.h"
#include "study/online/messages/message_reader.h"
#include "study/online/serving/log_thread.h"
#include "study/online/serving/rate_limit.h"
#include "study/online/serving/recruitment_desk.h"
#include "study/online/serving/site_files.h"
#include "study/online/serving/tokens.h"
#include "study/online/serving/watch.h"

namespace seamline::study::online {

/// How much one participant, and one address, may ask.
struct ServiceLimits {
  RequestRate participant = {.a_second = 20, .at_once = 200};
  RequestRate address = {.a_second = 400, .at_once = 4000};  ///< many people may share one
  RequestRate newcomers = {.a_second = 5, .at_once = 100};   ///< of an address
  std::int64_t most_participants = 100'000;
  Intake::Quota stored = {};  ///< of a participant
};

/// Who helps a server, where the study or the experimenter asks for it; null: nobody. All must live longer.
struct ServiceHelpers {
  Invitations* invitations = nullptr;  ///< null: nobody needs one
  RecruitmentDesk* desk = nullptr;     ///< null: nobody is matched or sent back
  const Watch* watch = nullptr;        ///< null: there is no experimenter's page
};

/// What the server answers: the page's files, the requests of a participant and of the experimenter
/// (documentation/how-to/online.md). Everything that asks the log goes through `LogThread`; the rest is
/// answered at once.
class StudyService {
 public:
  /// Site and intake must live longer, too.
  StudyService(const SiteFiles& site, Intake& intake, const ServiceHelpers& helpers,
               const ServiceLimits& limits = {});

  /// Refuses what needs no look at a body: whoever has no secret sends none.
  [[nodiscard]] std::optional<HttpResponse> admit(const RequestHead& head);
  [[nodiscard]] std::optional<HttpResponse> now(const HttpRequest& request);
  void later(HttpRequest request, Reply reply);
  /// Stores what has come in. Nothing may come after.
  void finish() { log_.finish(); }

  [[nodiscard]] std::int64_t participants() const { return participants_; }
  [[nodiscard]] std::int64_t answers() const { return answers_; }
  [[nodiscard]] std::int64_t transactions() const { return log_.transactions(); }

 private:
  HttpResponse file(const HttpRequest& request) const;
  HttpResponse health() const;
  [[nodiscard]] bool may_ask(const HttpRequest& request, const std::string& code);
  [[nodiscard]] std::string code_of(const std::string& secret);
  void enrol(const HttpRequest& request, const Reply& reply);
  void decline(const EnrolRequest& wanted, const Reply& reply);
  void take_messages(const std::string& code, std::string body, const Reply& reply);
  /// False: it was stored before.
  bool take(Intake& intake, const Message& message);

  const SiteFiles& site_;
  Invitations* invitations_;
  RecruitmentDesk* desk_;
  const Watch* watch_;
  ServiceLimits limits_;
  RateLimit participant_rate_, address_rate_, newcomer_rate_;
  std::shared_mutex secrets_lock_;
  std::map<std::string, std::string> code_of_secret_;  ///< by hash
  std::map<std::string, std::string> fresh_secrets_;   ///< by id of the enrolment, until its secret is used
  std::map<std::string, std::string> fresh_id_;        ///< by code
  bool anybody_was_deleted_ = false;  ///< of the log, before this server began: `log forget` needs it alone
  std::atomic<std::int64_t> participants_ = 0, answers_ = 0;
  LogThread log_;
};

/// The path of a request as it may stand in a log line: one of ours, or "other".
[[nodiscard]] std::string loggable_path(const std::string& path);

}  // namespace seamline::study::online
