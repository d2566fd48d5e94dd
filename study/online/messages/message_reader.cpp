#include "study/online/messages/message_reader.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>

#include "study/log/log_writer.h"
#include "study/online/messages/strict_json.h"
#include "support/files/hash.h"
#include "support/text/error.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace {

constexpr std::size_t most_hash_bytes = 128, most_name_bytes = 200;
constexpr std::size_t most_detail_bytes = 4000;
constexpr std::int64_t most_px = 1'000'000;
constexpr double least_positive = std::numeric_limits<double>::min();

InputError refusal(const std::string& field, const std::string& wanted, std::string_view found) {
  return input_error({.field = field, .wanted = wanted, .found = "\"" + printable(found, 60) + "\""});
}

TrialKind kind_of_trial(const JsonFields& body) {
  const std::string& text = body.text("kind", 1, most_name_bytes);
  const std::optional<TrialKind> kind = trial_kind_from_word(text);
  if (!kind) throw refusal(body.path_of("kind"), "stimulus, attention or reference", text);
  return *kind;
}

PictureAnswer picture_answer(const JsonFields& body) {
  PictureAnswer answer{.kind = kind_of_trial(body),
                       .stimulus_id = body.text("stimulus_id", 1, most_name_bytes),
                       .chosen_index = static_cast<int>(body.whole("chosen_index", 1, most_objects_of_scene)),
                       .rating = static_cast<int>(body.whole("rating", 1, highest_rating)),
                       .choice_ns = body.whole("choice_ns", 0, most_time_ns)};
  answer.rating_ns = body.whole("rating_ns", answer.choice_ns, most_time_ns);
  if (body.has("position")) answer.position = static_cast<int>(body.whole("position", 0, slider_end));
  return answer;
}

EnrolBody enrol_body(const JsonValue& json) {
  const JsonFields body(json, "body",
                        {"slot", "consent_sha256", "accepted_unix_s", "user_agent", "origin", "pilot"});
  EnrolBody enrol{.slot = static_cast<int>(body.whole("slot", -1, most_trials)),
                  .consent_sha256 = body.text("consent_sha256", 1, most_hash_bytes),
                  .accepted_unix_s = body.whole("accepted_unix_s", 0, most_unix_s),
                  .user_agent = body.text("user_agent", 0, most_user_agent_bytes),
                  .pilot = body.flag("pilot")};
  if (!is_sha256(enrol.consent_sha256))
    throw refusal("body.consent_sha256", "64 hexadecimal digits in lower case", enrol.consent_sha256);
  const std::string& origin = body.text("origin", 1, most_name_bytes);
  for (const Origin known : every_web_origin)
    if (word(known) == origin) {
      enrol.origin = known;
      return enrol;
    }
  throw refusal("body.origin", "serve, static or jatos", origin);
}

FormBody form_body(const JsonValue& json) {
  const JsonFields body(json, "body", {"answers"});
  const JsonValue& answers = body.at("answers");
  if (answers.kind != JsonValue::Kind::array || answers.items.size() > most_form_answers)
    throw input_error({.field = "body.answers",
                       .wanted = fmt::format("an array of at most {} answers", most_form_answers),
                       .found = "something else"});
  FormBody form;
  for (const JsonValue& item : answers.items) {
    const JsonFields answer(item, fmt::format("body.answers[{}]", form.answers.size()), {"field", "value"});
    form.answers.push_back({.field = answer.text("field", 1, most_name_bytes),
                            .value = answer.any_text("value")});  // `fault_of` knows which are right
  }
  return form;
}

DisplayBody display_body(const JsonValue& json) {
  const JsonFields body(json, "body",
                        {"screen_width_px", "screen_height_px", "device_pixel_ratio", "viewport_width_px",
                         "viewport_height_px", "mm_per_px", "viewing_distance_mm", "pixels_per_degree",
                         "refresh_hz", "gamma_confirmed", "image_scale"});
  const auto px = [&](std::string_view key) { return static_cast<int>(body.whole(key, 0, most_px)); };
  return {.screen_width_px = px("screen_width_px"),
          .screen_height_px = px("screen_height_px"),
          .device_pixel_ratio = body.real("device_pixel_ratio", least_positive, 1000),
          .viewport_width_px = px("viewport_width_px"),
          .viewport_height_px = px("viewport_height_px"),
          .mm_per_px = body.real("mm_per_px", 0, 1000),
          .viewing_distance_mm = body.real("viewing_distance_mm", 0, 1e6),
          .pixels_per_degree = body.real("pixels_per_degree", 0, 1e6),
          .refresh_hz = body.real("refresh_hz", 0, 1e5),
          .gamma_confirmed = body.flag("gamma_confirmed"),
          .image_scale = body.real("image_scale", least_positive, 1000)};
}

TrainingBody training_body(const JsonValue& json) {
  const JsonFields body(
      json, "body",
      {"training_index", "kind", "stimulus_id", "chosen_index", "rating", "choice_ns", "rating_ns"},
      {"position"});
  return {.training_index = static_cast<int>(body.whole("training_index", 0, most_trials)),
          .answer = picture_answer(body)};
}

AnswerBody answer_body(const JsonValue& json) {
  const JsonFields body(json, "body",
                        {"trial_index", "kind", "stimulus_id", "chosen_index", "rating", "choice_ns",
                         "rating_ns", "image_scale"},
                        {"position"});
  return {.trial_index = static_cast<int>(body.whole("trial_index", 0, most_trials)),
          .answer = picture_answer(body),
          .image_scale = body.real("image_scale", least_positive, 1000)};
}

EventBody event_body(const JsonValue& json) {
  const JsonFields body(json, "body", {"monotonic_ns", "kind", "trial_index", "detail"});
  EventBody event{.monotonic_ns = body.whole("monotonic_ns", 0, most_time_ns),
                  .kind = body.text("kind", 1, most_name_bytes),
                  .detail = body.text("detail", 0, most_detail_bytes)};
  if (body.at("trial_index").kind != JsonValue::Kind::null)
    event.trial_index = static_cast<int>(body.whole("trial_index", 0, most_trials));
  return event;
}

void check_empty(const JsonValue& json) {
  const JsonFields body(json, "body", {});
}

MessageBody body_of(const std::string& kind, const JsonValue& json) {
  if (kind == "enrol") return enrol_body(json);
  if (kind == "form") return form_body(json);
  if (kind == "display") return display_body(json);
  if (kind == "training") return training_body(json);
  if (kind == "answer") return answer_body(json);
  if (kind == "event") return event_body(json);
  if (kind == "begin")
    return BeginBody{JsonFields(json, "body", {"user_agent"}).text("user_agent", 0, most_user_agent_bytes)};
  if (kind != "completion" && kind != "decline")
    throw refusal("kind", "enrol, decline, begin, form, display, training, answer, event or completion",
                  kind);
  check_empty(json);
  return kind == "completion" ? MessageBody(CompletionBody{}) : MessageBody(DeclineBody{});
}

void check_participant(const Message& message) {
  const bool may_be_nobody = std::holds_alternative<DeclineBody>(message.body) ||
                             (std::holds_alternative<EnrolBody>(message.body) &&
                              std::get<EnrolBody>(message.body).origin == Origin::serve);
  const bool must_be_nobody = std::holds_alternative<DeclineBody>(message.body);
  if (message.participant.empty() ? may_be_nobody : !must_be_nobody && is_code(message.participant)) return;
  throw refusal("participant",
                must_be_nobody ? "nobody" : "a code of 1 to 64 letters, digits, dots, dashes and underscores",
                message.participant);
}

bool is_hexadecimal(std::string_view text) {
  return text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

}  // namespace

bool is_uuid4(std::string_view text) {
  if (text.size() != 36) return false;
  for (const std::size_t dash : {8U, 13U, 18U, 23U})
    if (text[dash] != '-') return false;
  return is_hexadecimal(text.substr(0, 8)) && is_hexadecimal(text.substr(9, 4)) && text[14] == '4' &&
         is_hexadecimal(text.substr(14, 4)) &&
         std::string_view("89ab").find(text[19]) != std::string_view::npos &&
         is_hexadecimal(text.substr(19, 4)) && is_hexadecimal(text.substr(24));
}

namespace {

Message message_of(const JsonValue& json) {
  const JsonFields fields(
      json, "", {"format", "study_hash", "set_hash", "participant", "sequence", "id", "kind", "body"});
  if (const std::string& format = fields.text("format", 1, most_name_bytes); format != message_format)
    throw refusal("format", fmt::format("\"{}\"", message_format), format);
  Message message{.study_hash = fields.text("study_hash", 1, most_hash_bytes),
                  .set_hash = fields.text("set_hash", 1, most_hash_bytes),
                  .participant = fields.text("participant", 0, 64),
                  .sequence = fields.whole("sequence", 0, most_sequence),
                  .id = fields.text("id", 1, most_name_bytes),
                  .body = body_of(fields.text("kind", 1, most_name_bytes), fields.at("body"))};
  if (!is_uuid4(message.id)) throw refusal("id", "a UUID of version 4 in lower case", message.id);
  check_participant(message);
  return message;
}

JsonValue json_of(std::string_view text, const std::string& what) {
  if (text.size() > most_line_bytes)
    throw input_error({.field = what,
                       .wanted = fmt::format("at most {} bytes", most_line_bytes),
                       .found = fmt::format("{} bytes", text.size())});
  return read_strict_json(text, what);
}

}  // namespace

Message read_message(std::string_view line) {
  return message_of(json_of(line, "message"));
}

namespace {

std::map<std::string, std::string> identifiers_of(const JsonValue& json) {
  constexpr std::size_t most_identifiers = 20, most_identifier_bytes = 200;
  if (json.kind != JsonValue::Kind::object || json.keys.size() > most_identifiers)
    throw input_error(
        {.field = "identifiers", .wanted = "an object of at most 20 texts", .found = "another"});
  std::map<std::string, std::string> identifiers;
  for (std::size_t i = 0; i < json.keys.size(); ++i) {
    const JsonValue& value = json.items[i];
    const bool plain = value.kind == JsonValue::Kind::text && value.text.size() <= most_identifier_bytes &&
                       json.keys[i].size() <= most_name_bytes && printable(value.text, 1000) == value.text;
    if (!plain)
      throw refusal("identifiers", "texts of at most 200 bytes without control characters", json.keys[i]);
    if (!value.text.empty()) identifiers[json.keys[i]] = value.text;
  }
  return identifiers;
}

}  // namespace

EnrolRequest read_enrol_request(std::string_view text) {
  const JsonValue json = json_of(text, "request");
  const bool with = std::find(json.keys.begin(), json.keys.end(), "identifiers") != json.keys.end();
  const JsonFields fields = with ? JsonFields(json, "", {"token", "message", "identifiers"})
                                 : JsonFields(json, "", {"token", "message"});
  EnrolRequest request{.message = message_of(fields.at("message"))};
  if (with) request.identifiers = identifiers_of(fields.at("identifiers"));
  if (fields.at("token").kind != JsonValue::Kind::null)
    request.token = fields.text("token", 1, most_name_bytes);
  if (!std::holds_alternative<EnrolBody>(request.message.body) &&
      !std::holds_alternative<DeclineBody>(request.message.body))
    throw refusal("message.kind", "enrol or decline", kind_word(request.message.body));
  return request;
}

}  // namespace seamline::study::online
