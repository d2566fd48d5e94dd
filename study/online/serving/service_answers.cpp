#include "study/online/serving/service_answers.h"

#include "support/files/hash.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace {

using Json = nlohmann::ordered_json;

int status_of(RefusalKind kind) {
  switch (kind) {
    case RefusalKind::wrong:
      return 400;
    case RefusalKind::unknown:
      return 403;
    case RefusalKind::conflict:
      return 409;
    case RefusalKind::excluded:
      return 409;
    case RefusalKind::too_much:
      return 413;
    case RefusalKind::failed:
      return 503;
  }
  return 500;
}

std::string reason_of(RefusalKind kind) {
  return kind == RefusalKind::excluded ? "excluded" : "";
}

}  // namespace

HttpResponse json_answer(const Json& json, int status) {
  return {.status = status, .body = json.dump(-1, ' ', false, Json::error_handler_t::replace)};
}

HttpResponse error_answer(int status, const std::string& sentence, const std::string& reason) {
  Json json;
  json["error"] = printable(sentence);
  if (!reason.empty()) json["reason"] = reason;
  return json_answer(json, status);
}

HttpResponse error_answer(const Refusal& refusal) {
  return error_answer(status_of(refusal.kind()), refusal.what(), reason_of(refusal.kind()));
}

Json json_of_end(const std::optional<VisitEnd>& end) {
  if (!end) return {{"outcome", nullptr}};
  return {{"outcome", word(end->outcome)}, {"code", end->code}, {"link", end->link}};
}

HttpResponse error_answer(const NoEntry& no) {
  Json json = {{"error", printable(no.what())}, {"reason", no.reason()}};
  if (no.end()) json["end"] = json_of_end(no.end());
  return json_answer(json, status_of(no.kind()));
}

HttpResponse nobody_answer(const std::string& secret, bool anybody_was_deleted) {
  if (is_sha256(secret) && !anybody_was_deleted)  // a secret has its form: 64 hexadecimal digits
    return error_answer(
        503, "Authorization: the server's log knows nobody of this secret; is it the study's log?");
  return error_answer(401, "No participant has this secret.", is_sha256(secret) ? "forgotten" : "");
}

HttpResponse messages_answer(const std::vector<std::string>& stored, const Refusal* refusal) {
  Json json;
  if (refusal != nullptr) json["error"] = printable(refusal->what());
  if (refusal != nullptr && !reason_of(refusal->kind()).empty()) json["reason"] = reason_of(refusal->kind());
  json["stored"] = stored;
  return json_answer(json, refusal == nullptr ? 200 : status_of(refusal->kind()));
}

}  // namespace seamline::study::online
