#include "study/online/messages/message_writer.h"

#include <nlohmann/json.hpp>

#include "support/files/hash.h"
#include "support/running/overloaded.h"

namespace seamline::study::online {
namespace {

using Json = nlohmann::ordered_json;

void put(Json& json, const PictureAnswer& answer) {
  json["kind"] = word(answer.kind);
  json["stimulus_id"] = answer.stimulus_id;
  json["chosen_index"] = answer.chosen_index;
  json["rating"] = answer.rating;
  json["choice_ns"] = answer.choice_ns;
  json["rating_ns"] = answer.rating_ns;
  if (answer.position >= 0) json["position"] = answer.position;
}

Json body_json(const MessageBody& body) {
  return std::visit(Overloaded{[](const EnrolBody& enrol) -> Json {
                                 return {{"slot", enrol.slot},
                                         {"consent_sha256", enrol.consent_sha256},
                                         {"accepted_unix_s", enrol.accepted_unix_s},
                                         {"user_agent", enrol.user_agent},
                                         {"origin", word(enrol.origin)},
                                         {"pilot", enrol.pilot}};
                               },
                               [](const DeclineBody&) { return Json::object(); },
                               [](const BeginBody& begin) -> Json {
                                 return {{"user_agent", begin.user_agent}};
                               },
                               [](const FormBody& form) {
                                 Json answers = Json::array();
                                 for (const FormAnswer& answer : form.answers)
                                   answers.push_back({{"field", answer.field}, {"value", answer.value}});
                                 Json json;
                                 json["answers"] = std::move(answers);
                                 return json;
                               },
                               [](const DisplayBody& display) -> Json {
                                 return {{"screen_width_px", display.screen_width_px},
                                         {"screen_height_px", display.screen_height_px},
                                         {"device_pixel_ratio", display.device_pixel_ratio},
                                         {"viewport_width_px", display.viewport_width_px},
                                         {"viewport_height_px", display.viewport_height_px},
                                         {"mm_per_px", display.mm_per_px},
                                         {"viewing_distance_mm", display.viewing_distance_mm},
                                         {"pixels_per_degree", display.pixels_per_degree},
                                         {"refresh_hz", display.refresh_hz},
                                         {"gamma_confirmed", display.gamma_confirmed},
                                         {"image_scale", display.image_scale}};
                               },
                               [](const TrainingBody& training) {
                                 Json json;
                                 json["training_index"] = training.training_index;
                                 put(json, training.answer);
                                 return json;
                               },
                               [](const AnswerBody& answer) {
                                 Json json;
                                 json["trial_index"] = answer.trial_index;
                                 put(json, answer.answer);
                                 json["image_scale"] = answer.image_scale;
                                 return json;
                               },
                               [](const EventBody& event) {
                                 Json json;
                                 json["monotonic_ns"] = event.monotonic_ns;
                                 json["kind"] = event.kind;
                                 json["trial_index"] = event.trial_index ? Json(*event.trial_index) : Json();
                                 json["detail"] = event.detail;
                                 return json;
                               },
                               [](const CompletionBody&) { return Json::object(); }},
                    body);
}

}  // namespace

std::string_view kind_word(const MessageBody& body) {
  return std::visit(Overloaded{[](const EnrolBody&) { return std::string_view("enrol"); },
                               [](const DeclineBody&) { return std::string_view("decline"); },
                               [](const BeginBody&) { return std::string_view("begin"); },
                               [](const FormBody&) { return std::string_view("form"); },
                               [](const DisplayBody&) { return std::string_view("display"); },
                               [](const TrainingBody&) { return std::string_view("training"); },
                               [](const AnswerBody&) { return std::string_view("answer"); },
                               [](const EventBody&) { return std::string_view("event"); },
                               [](const CompletionBody&) { return std::string_view("completion"); }},
                    body);
}

std::string message_line(const Message& message) {
  Json json;
  json["format"] = message_format;
  json["study_hash"] = message.study_hash;
  json["set_hash"] = message.set_hash;
  json["participant"] = message.participant;
  json["sequence"] = message.sequence;
  json["id"] = message.id;
  json["kind"] = kind_word(message.body);
  json["body"] = body_json(message.body);
  return json.dump();
}

std::string content_sha256(const Message& message) {
  Message said = message;
  said.participant.clear();
  if (auto* enrol = std::get_if<EnrolBody>(&said.body); enrol != nullptr && enrol->origin == Origin::serve)
    enrol->slot = -1;
  return sha256(message_line(said));
}

}  // namespace seamline::study::online
