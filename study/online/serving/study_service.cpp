#include "study/online/serving/study_service.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "study/online/messages/message_reader.h"
#include "study/online/serving/service_answers.h"
#include "study/online/serving/tokens.h"
#include "support/files/hash.h"

namespace seamline::study::online {
namespace {

using Json = nlohmann::ordered_json;

HttpResponse no_experimenter() {
  return error_answer(401, "This is not the experimenter's secret.");
}

/// The lines of a body; the last one need not end. Throws Refusal at the first that is no message, which
/// `fault` keeps: those before it may be stored.
std::vector<Message> read_lines(const std::string& body, std::optional<Refusal>& fault) {
  std::vector<Message> messages;
  for (std::size_t at = 0; at < body.size();) {
    const std::size_t end = std::min(body.find('\n', at), body.size());
    const std::string_view line = std::string_view(body).substr(at, end - at);
    at = end + 1;
    if (line.empty()) continue;
    try {
      messages.push_back(read_message(line));
    } catch (const InputError& wrong) {
      fault.emplace(RefusalKind::wrong, Complaint{.field = wrong.what()});
      return messages;
    }
  }
  if (messages.empty())
    fault.emplace(RefusalKind::wrong, Complaint{.wanted = "lines of messages", .found = "none"});
  return messages;
}

bool is_api(const std::string& path) {
  return path == "/api/enrol" || path == "/api/messages" || path == "/api/where" || path == "/api/next" ||
         path == "/api/end" || path == "/api/watch";
}

std::string method_of(const std::string& path) {
  return path == "/api/where" || path == "/api/end" || path == "/api/watch" ? "GET" : "POST";
}

}  // namespace

std::string loggable_path(const std::string& path) {
  return is_api(path) || path == "/health" || path == "/host.json" || path == "/" ? path : "other";
}

StudyService::StudyService(const SiteFiles& site, Intake& intake, const ServiceHelpers& helpers,
                           const ServiceLimits& limits)
    : site_(site),
      invitations_(helpers.invitations),
      desk_(helpers.desk),
      watch_(helpers.watch),
      limits_(limits),
      participant_rate_(limits.participant),
      address_rate_(limits.address),
      newcomer_rate_(limits.newcomers),
      code_of_secret_(intake.secrets()),
      anybody_was_deleted_(intake.counts().deletions > 0),
      participants_(intake.counts().participants),
      answers_(intake.counts().answers),
      log_(intake) {}

HttpResponse StudyService::file(const HttpRequest& request) const {
  if (watch_ != nullptr && request.head.path == "/watch") return {.status = 200, .file = watch_->page()};
  const auto found = site_.by_path.find(request.head.path);
  if (found == site_.by_path.end()) return error_answer(404, "No such path.");
  if (request.head.known_version == found->second->version) return {.status = 304};
  return {.status = 200, .file = found->second};
}

HttpResponse StudyService::health() const {
  return json_answer(
      {{"status", "ok"}, {"participants", participants_.load()}, {"answers", answers_.load()}});
}

std::string StudyService::code_of(const std::string& secret) {
  if (secret.empty()) return {};
  const std::string hash = sha256(secret);  // what is compared says nothing of the secret
  const std::shared_lock guard(secrets_lock_);
  const auto found = code_of_secret_.find(hash);
  return found == code_of_secret_.end() ? std::string() : found->second;
}

bool StudyService::may_ask(const HttpRequest& request, const std::string& code) {
  const auto time = RateLimit::Clock::now();
  if (!request.address.empty() && !address_rate_.allows(request.address, time)) return false;
  return code.empty() || participant_rate_.allows(code, time);
}

std::optional<HttpResponse> StudyService::admit(const RequestHead& head) {
  if (!is_api(head.path))
    return head.method == "POST" ? std::optional(error_answer(405, "Pages and files are read with GET."))
                                 : std::nullopt;
  if (head.method != method_of(head.path)) return error_answer(405, "This path does not take this method.");
  if (head.path == "/api/enrol")
    return head.content_bytes > static_cast<std::int64_t>(most_line_bytes)
               ? std::optional(error_answer(413, "The body has more than 65536 bytes."))
               : std::nullopt;
  if (head.path == "/api/watch")
    return watch_ == nullptr || !watch_->is_key(head.secret) ? std::optional(no_experimenter())
                                                             : std::nullopt;
  return code_of(head.secret).empty() ? std::optional(nobody_answer(head.secret, anybody_was_deleted_))
                                      : std::nullopt;
}

std::optional<HttpResponse> StudyService::now(const HttpRequest& request) {
  const std::string& path = request.head.path;
  if (!is_api(path)) {
    if (!may_ask(request, {})) return error_answer(429, "Too many requests a second.");
    if (path == "/health") return health();
    if (path == "/host.json") return json_answer({{"kind", "serve"}});
    return file(request);
  }
  if (path == "/api/enrol") {
    const bool newcomer =
        request.address.empty() || newcomer_rate_.allows(request.address, RateLimit::Clock::now());
    if (!newcomer || !may_ask(request, {})) return error_answer(429, "Too many requests a second.");
    return std::nullopt;
  }
  if (path == "/api/watch" && (watch_ == nullptr || !watch_->is_key(request.head.secret)))
    return no_experimenter();
  const std::string code = path == "/api/watch" ? "the experimenter" : code_of(request.head.secret);
  if (code.empty()) return nobody_answer(request.head.secret, anybody_was_deleted_);
  if (!may_ask(request, code)) return error_answer(429, "Too many requests a second.");
  return std::nullopt;
}

void StudyService::later(HttpRequest request, Reply reply) {
  const std::string& path = request.head.path;
  if (path == "/api/enrol") return enrol(request, reply);
  if (path == "/api/watch")
    return log_.add(
        [this](Intake& intake) -> HttpResponse {
          return {.status = 200, .body = watch_->facts_text(intake, desk_, invitations_)};
        },
        std::move(reply));
  const std::string code = code_of(request.head.secret);
  if (path == "/api/messages") return take_messages(code, std::move(request.body), reply);
  if (path == "/api/end")
    return log_.add(
        [this, code](Intake&) -> HttpResponse {
          return json_answer(json_of_end(desk_ == nullptr ? std::nullopt : desk_->end_of(code)));
        },
        std::move(reply));
  const bool next = path == "/api/next";
  log_.add(
      [this, code, next](Intake& intake) -> HttpResponse {
        try {
          if (!next) {
            const Whereabouts at = intake.where(code);
            return json_answer({{"participant", at.participant},
                                {"slot", at.slot},
                                {"answered", at.answered},
                                {"form_done", at.form_done},
                                {"training_done", at.training_done},
                                {"completed", at.completed},
                                {"next_sequence", at.next_sequence}});
          }
          const std::optional<std::pair<int, Trial>> due = intake.next_trial(code);
          if (!due) return json_answer({{"done", true}});
          const std::string kind(word(due->second.kind));
          const std::string id = intake.names().name_of(due->second);
          const auto file_of = [&](const Trial& shown) {
            const auto picture =
                site_.picture_of.find(std::string(word(shown.kind)) + " " + intake.names().name_of(shown));
            return picture == site_.picture_of.end() ? std::string() : picture->second;
          };
          Json pictures = Json::array();
          for (const Trial& shown : intake.pictures_of(due->second)) pictures.push_back(file_of(shown));
          const std::optional<Trial> mask = intake.mask_of(due->second);
          if (mask) pictures.push_back(file_of(*mask));
          if (std::find(pictures.begin(), pictures.end(), "") != pictures.end())
            return error_answer(500, "The page has no such picture.");
          Json trial = {{"trial_index", due->first},
                        {"kind", kind},
                        {"stimulus_id", id},
                        {"picture", pictures.front()}};
          if (mask) {
            trial["mask"] = pictures.back();
            pictures.erase(pictures.size() - 1);
          }
          if (pictures.size() > 1) trial["pictures"] = pictures;
          Json json;
          json["trial"] = std::move(trial);
          return json_answer(json);
        } catch (const Refusal& refusal) {
          return error_answer(refusal);
        }
      },
      std::move(reply));
}

void StudyService::enrol(const HttpRequest& request, const Reply& reply) {
  EnrolRequest wanted;
  try {
    wanted = read_enrol_request(request.body);
  } catch (const InputError& wrong) {
    return reply(error_answer(400, wrong.what()));
  }
  const std::string token = wanted.token.empty() ? std::string() : sha256(wanted.token);
  if (invitations_ == nullptr && !token.empty())
    return reply(error_answer(400, "This server asks for no token."));
  if (desk_ == nullptr && !wanted.identifiers.empty())
    return reply(error_answer(400, "The study has no [recruitment], so it takes no identifiers."));
  if (invitations_ != nullptr && !invitations_->has(token))
    return reply(error_answer(403, "The link has no invitation to this study."));
  if (std::holds_alternative<DeclineBody>(wanted.message.body)) return decline(wanted, reply);
  if (std::get<EnrolBody>(wanted.message.body).pilot != site_.pilot)
    return reply(error_answer(400, "body.pilot is not what the page was exported with."));
  if (participants_ >= limits_.most_participants)
    return reply(error_answer(503, "As many participants as there may be have begun."));
  std::string secret;
  {
    const std::shared_lock guard(secrets_lock_);
    const auto fresh = fresh_secrets_.find(wanted.message.id);
    if (fresh != fresh_secrets_.end()) secret = fresh->second;
  }
  if (secret.empty()) secret = random_secret();
  const GivenIdentity given{.code = "s-" + random_letters(),
                            .secret_sha256 = sha256(secret),
                            .token_sha256 = token,
                            .slots = site_.slots};
  auto enrolled = std::make_shared<std::optional<EnrolledPerson>>();
  log_.add(
      [message = wanted.message, identifiers = wanted.identifiers, given, secret, enrolled,
       invitations = invitations_, desk = desk_](Intake& intake) -> HttpResponse {
        enrolled->reset();
        try {
          if (desk != nullptr) desk->check_entry(intake, message, identifiers);
          *enrolled = intake.enrol(message, given);
          if (desk != nullptr) desk->enter((*enrolled)->code, identifiers);
          // Before the commit: a code without a participant is nobody's, a participant without one is not
          // found.
          if (invitations != nullptr) invitations->note(given.token_sha256, (*enrolled)->code);
          return json_answer({{"participant", (*enrolled)->code},
                              {"slot", (*enrolled)->slot},
                              {"secret", secret},
                              {"next_sequence", (*enrolled)->next_sequence}});
        } catch (const NoEntry& no) {
          return error_answer(no);
        } catch (const Refusal& refusal) {
          return error_answer(refusal);
        }
      },
      [this, reply, enrolled, given, secret, id = wanted.message.id](HttpResponse response) {
        if (response.status == 200 && *enrolled) {  // it is on the disk
          const std::unique_lock guard(secrets_lock_);
          const std::string& code = (*enrolled)->code;
          std::erase_if(code_of_secret_,
                        [&](const auto& one) { return one.second == code && !(*enrolled)->is_new; });
          code_of_secret_[given.secret_sha256] = code;
          fresh_secrets_[id] = secret;
          fresh_id_[code] = id;
          participants_ += (*enrolled)->is_new ? 1 : 0;
        }
        reply(std::move(response));
      });
}

void StudyService::decline(const EnrolRequest& wanted, const Reply& reply) {
  log_.add(
      [message = wanted.message, identifiers = wanted.identifiers,
       desk = desk_](Intake& intake) -> HttpResponse {
        try {
          (void)intake.take(message);
          return json_answer(desk == nullptr ? Json::object() : json_of_end(desk->decline(identifiers)));
        } catch (const Refusal& refusal) {
          return error_answer(refusal);
        }
      },
      reply);
}

bool StudyService::take(Intake& intake, const Message& message) {
  if (desk_ != nullptr && desk_->was_sent_away(message.participant) && intake.sender_of(message.id).empty())
    throw Refusal(RefusalKind::excluded, {.field = "participant",
                                          .wanted = "one who takes part",
                                          .found = "one whose visit ended after the form"});
  if (!intake.take(message)) return false;
  if (desk_ == nullptr) return true;
  if (const auto* form = std::get_if<FormBody>(&message.body))
    desk_->after_form(intake, message.participant, form->answers);
  if (std::holds_alternative<CompletionBody>(message.body))
    desk_->after_completion(intake, message.participant);
  return true;
}

void StudyService::take_messages(const std::string& code, std::string body, const Reply& reply) {
  std::optional<Refusal> fault;
  std::vector<Message> messages = read_lines(body, fault);
  for (std::size_t i = 0; i < messages.size(); ++i) {
    if (messages[i].participant == code && !std::holds_alternative<EnrolBody>(messages[i].body)) continue;
    fault.emplace(
        RefusalKind::unknown,
        Complaint{.field = "participant", .wanted = "the one whose secret it is", .found = "another one"});
    messages.resize(i);
  }
  if (messages.empty()) return reply(messages_answer({}, &*fault));
  {
    const std::unique_lock guard(secrets_lock_);
    if (const auto fresh = fresh_id_.find(code);
        fresh != fresh_id_.end()) {  // whoever has the secret uses it
      fresh_secrets_.erase(fresh->second);
      fresh_id_.erase(fresh);
    }
  }
  auto answers = std::make_shared<std::int64_t>(0);
  log_.add(
      [this, messages = std::move(messages), fault, answers](Intake& intake) -> HttpResponse {
        *answers = 0;
        std::vector<std::string> stored;
        try {
          for (const Message& message : messages) {
            if (take(intake, message)) *answers += std::holds_alternative<AnswerBody>(message.body) ? 1 : 0;
            stored.push_back(message.id);
          }
        } catch (const Refusal& refusal) {
          return messages_answer(stored, &refusal);
        }
        return messages_answer(stored, fault ? &*fault : nullptr);
      },
      [this, reply, answers](HttpResponse response) {
        if (response.status != 503) answers_ += *answers;
        reply(std::move(response));
      });
}

}  // namespace seamline::study::online
