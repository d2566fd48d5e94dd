// What a page says: every value survives being written and read, and everything odd is refused in a sentence.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "online_people.h"
#include "study/online/messages/message_reader.h"
#include "support/text/error.h"
#include "tests/complaint.h"

namespace seamline::study::online {
namespace {

using test::complaint_of;
using testing::HasSubstr;

Message message_of(MessageBody body) {
  return {.study_hash = std::string(64, 'a'),
          .set_hash = std::string(64, 'b'),
          .participant = "w-abcdefgh",
          .sequence = 7,
          .id = uuid_of(1, 2),
          .body = std::move(body)};
}

const PictureAnswer some_answer = {.kind = TrialKind::attention,
                                   .stimulus_id = "bedroom-receiver-left-0064",
                                   .chosen_index = 3,
                                   .rating = 4,
                                   .choice_ns = 123456789012,
                                   .rating_ns = 223456789012};

std::vector<Message> one_of_each() {
  std::vector<Message> all = {
      message_of(EnrolBody{.slot = 3,
                           .consent_sha256 = std::string(64, 'c'),
                           .accepted_unix_s = 1700000000,
                           .user_agent = "Mozilla/5.0 \"quoted\" \\ ünïcode 日本",
                           .origin = Origin::jatos,
                           .pilot = true}),
      message_of(BeginBody{.user_agent = ""}),
      message_of(FormBody{.answers = {{"age", "30"}, {"gender", ""}}}),
      message_of(DisplayBody{.screen_width_px = 3840,
                             .screen_height_px = 2160,
                             .device_pixel_ratio = 1.1000000238418579,
                             .mm_per_px = 0.1 + 0.2,
                             .refresh_hz = 59.94,
                             .gamma_confirmed = true,
                             .image_scale = 0.3333333333333333}),
      message_of(TrainingBody{.training_index = 1, .answer = some_answer}),
      message_of(AnswerBody{.trial_index = 12, .answer = some_answer, .image_scale = 2}),
      message_of(EventBody{.monotonic_ns = 5, .kind = "zoom", .detail = "1.25"}),
      message_of(EventBody{.monotonic_ns = 5, .kind = "shown", .trial_index = 0}),
      message_of(CompletionBody{})};
  all.push_back(message_of(DeclineBody{}));
  all.back().participant.clear();
  all.push_back(message_of(EnrolBody{.consent_sha256 = std::string(64, 'c')}));
  all.back().participant.clear();
  return all;
}

TEST(OnlineMessage, IsReadAsItWasWritten) {
  for (const Message& message : one_of_each()) {
    const std::string line = message_line(message);
    EXPECT_EQ(line.find('\n'), std::string::npos);
    EXPECT_EQ(read_message(line), message) << line;
    EXPECT_EQ(message_line(read_message(line)), line);
  }
}

TEST(OnlineMessage, EveryByteLessIsRefused) {
  for (const Message& message : one_of_each()) {
    const std::string line = message_line(message);
    for (std::size_t bytes = 0; bytes < line.size(); ++bytes)
      EXPECT_THROW((void)read_message(line.substr(0, bytes)), InputError) << line.substr(0, bytes);
  }
}

/// A line with one text in the place of another.
std::string with(const std::string& from, const std::string& to,
                 const Message& message = message_of(AnswerBody{.trial_index = 12, .answer = some_answer})) {
  std::string line = message_line(message);
  const std::size_t at = line.find(from);
  if (at == std::string::npos) throw std::runtime_error("the line has no " + from);
  return line.replace(at, from.size(), to);
}

TEST(OnlineMessage, WhatIsOddIsRefusedInOneSentence) {
  const std::string plain = message_line(message_of(AnswerBody{.trial_index = 12, .answer = some_answer}));
  const std::vector<std::pair<std::string, std::string>> odd = {
      {"", "message"},
      {"null", "an object"},
      {plain + plain, "something else"},
      {plain + "x", "something else"},
      {"\xEF\xBB\xBF" + plain, "byte order mark"},
      {with("\"rating\":4", "\"rating\":4,\"rating\":1"), "twice"},
      {with("\"rating\":4", "\"rating\":4,\"more\":1"), "known keys only"},
      {with(",\"rating\":4", ""), "body.rating: wanted a value"},
      {with("\"rating\":4", "\"rating\":5"), "a whole number from 1 to 4"},
      {with("\"rating\":4", "\"rating\":0"), "a whole number"},
      {with("\"rating\":4", "\"rating\":4.0"), "a whole number"},
      {with("\"rating\":4", "\"rating\":4e0"), "a whole number"},
      {with("\"rating\":4", "\"rating\":\"4\""), "a whole number"},
      {with("\"rating\":4", "\"rating\":true"), "a whole number"},
      {with("\"rating\":4", "\"rating\":null"), "a whole number"},
      {with("\"rating\":4", "\"rating\":04"), "something else"},
      {with("\"rating\":4", "\"rating\":+4"), "something else"},
      {with("\"rating\":4", "\"rating\":NaN"), "something else"},
      {with("\"trial_index\":12", "\"trial_index\":-0"), "minus before zero"},
      {with("\"trial_index\":12", "\"trial_index\":-1"), "from 0 to"},
      {with("\"trial_index\":12", "\"trial_index\":99999999999999999999"), "trial_index"},
      {with("\"image_scale\":1.0", "\"image_scale\":1e999"), "something else"},
      {with("\"image_scale\":1.0", "\"image_scale\":0"), "a number from"},
      {with("\"image_scale\":1.0", "\"image_scale\":-0.0"), "minus before zero"},
      {with("\"rating_ns\":223456789012", "\"rating_ns\":1"), "rating_ns"},
      {with("\"kind\":\"attention\"", "\"kind\":\"other\""), "stimulus, attention or reference"},
      {with("\"kind\":\"answer\"", "\"kind\":\"shout\""), "wanted enrol"},
      {with("\"kind\":\"answer\"", "\"kind\":\"form\""), "known keys only"},
      {with("seamline-online-1", "seamline-online-2"), "format"},
      {with("w-abcdefgh", "w abcdefgh"), "participant"},
      {with("w-abcdefgh", ""), "participant"},
      {with("w-abcdefgh", std::string(65, 'a')), "participant"},
      {with("\"id\":\"", "\"id\":\"x"), "UUID"},
      {with("-4", "-1"), "UUID"},
      {with("bedroom", "bed\\u0000room"), "control characters"},
      {with("bedroom", "bed\\nroom"), "control characters"},
      {with("bedroom", "\xFF"), "no UTF-8"},
      {with("bedroom", "\xC0\x80"), "no UTF-8"},
      {with("bedroom", "\\ud800"), "something else"},
      {with("{\"trial_index\"", "[[[[[[[[[[{\"trial_index\""), "too many levels"},
      {std::string(most_line_bytes, ' ') + plain, "at most 65536 bytes"}};
  for (const auto& [line, said] : odd) {
    const std::string sentence = complaint_of([&] { (void)read_message(line); });
    EXPECT_THAT(sentence, HasSubstr(said)) << line.substr(0, 400);
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    EXPECT_LT(sentence.size(), 600U);
  }
}

TEST(OnlineMessage, ItsContentIsTheSameHoweverItWasSpacedAndWhoeverGaveItsCode) {
  Message sent = message_of(EnrolBody{.consent_sha256 = std::string(64, 'c')});
  sent.participant.clear();
  Message kept = sent;
  kept.participant = "s-abc";
  std::get<EnrolBody>(kept.body).slot = 4;
  EXPECT_EQ(content_sha256(sent), content_sha256(kept));
  std::string spaced = message_line(sent);
  for (std::size_t at = spaced.find("\":"); at != std::string::npos; at = spaced.find("\":", at + 3))
    spaced.insert(at + 2, " ");
  EXPECT_EQ(content_sha256(read_message(spaced)), content_sha256(sent));
  for (const Message& one : one_of_each())
    for (const Message& other : one_of_each()) {
      EXPECT_EQ(content_sha256(one) == content_sha256(other), one == other);
    }
  // A host of files gives no slot: there it is what the page drew.
  Message elsewhere =
      message_of(EnrolBody{.slot = 3, .consent_sha256 = std::string(64, 'c'), .origin = Origin::jatos});
  Message other = elsewhere;
  std::get<EnrolBody>(other.body).slot = 4;
  EXPECT_NE(content_sha256(elsewhere), content_sha256(other));
}

TEST(OnlineMessage, AnEnrolmentComesWithAnInvitationOrWithout) {
  Message message = message_of(EnrolBody{.consent_sha256 = std::string(64, 'c')});
  message.participant.clear();
  const std::string line = message_line(message);
  EXPECT_EQ(read_enrol_request("{\"token\":null,\"message\":" + line + "}").message, message);
  EXPECT_EQ(read_enrol_request("{\"token\":\"abc\",\"message\":" + line + "}").token, "abc");
  for (const std::string& wrong :
       {line, "{\"message\":" + line + "}", "{\"token\":7,\"message\":" + line + "}",
        "{\"token\":\"\",\"message\":" + line + "}",
        "{\"token\":null,\"message\":" + message_line(message_of(CompletionBody{})) + "}"})
    EXPECT_THROW((void)read_enrol_request(wrong), InputError) << wrong;
}

}  // namespace
}  // namespace seamline::study::online
