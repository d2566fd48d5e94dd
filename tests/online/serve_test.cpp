// A study over HTTP: from enrolment to completion.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "serve_fixture.h"
#include "study/log/log_admin.h"
#include "tests/complaint.h"

namespace seamline::study::online {
namespace {

using test::complaint_of;
using testing::HasSubstr;
using testing::Not;

TEST_F(ServeTest, FromEnrolmentToCompletion) {
  ServerProcess server(request);
  ASSERT_NE(server.port(), 0) << server.first_line();
  HttpClient client(server.port());
  EXPECT_EQ(client.request("GET", "/host.json")->json().at("kind"), "serve");
  EXPECT_EQ(client.request("GET", "/health")->json().at("participants"), 0);
  Visitor one = visitor(client, 1), two = visitor(client, 2);
  EXPECT_EQ(one.page.slot, 0);
  EXPECT_EQ(two.page.slot, 1);
  EXPECT_EQ(one.secret.size(), 64U);
  for (const Message& message : one.page.the_rest()) {
    const auto stored = client.request("POST", "/api/messages", message_line(message), one.secret);
    ASSERT_TRUE(stored);
    ASSERT_EQ(stored->status, 200) << stored->body;
    EXPECT_EQ(stored->json().at("stored"), nlohmann::json::array({message.id}));
  }
  const auto all = client.request("POST", "/api/messages", lines_of(two.page.the_rest()), two.secret);
  EXPECT_EQ(all->json().at("stored").size(), 57U);
  const auto where = client.request("GET", "/api/where", {}, two.secret)->json();
  EXPECT_EQ(where.at("participant"), two.page.code);
  EXPECT_EQ(where.at("answered").size(), 26U);
  EXPECT_EQ(where.at("completed"), true);
  EXPECT_EQ(where.at("form_done"), true);
  EXPECT_EQ(where.at("training_done"), 2);
  EXPECT_EQ(where.at("next_sequence"), 58);
  EXPECT_EQ(client.request("POST", "/api/next", {}, one.secret)->status, 400);  // orders are fixed
  const auto health = client.request("GET", "/health")->json();
  EXPECT_EQ(health.at("participants"), 2);
  EXPECT_EQ(health.at("answers"), 52);
  EXPECT_EQ(server.end(SIGTERM), 0);
  const std::string said = server.first_line() + server.rest();
  EXPECT_THAT(said, HasSubstr("stopped: 2 participants, 52 answers"));
  for (const std::string& private_text :
       {one.page.code, one.secret, std::string("127.0.0.1 "), std::string("Mozilla")})
    EXPECT_THAT(said, Not(HasSubstr(private_text)));
  const LogContents contents = read_log(log);
  EXPECT_EQ(contents.answers.size(), 48U);
  for (const ParticipantRecord& person : contents.participants) EXPECT_TRUE(person.completed);
  EXPECT_EQ(read_file(log).find(one.secret), std::string::npos);  // its hash alone
}

TEST_F(ServeTest, WhatWasSentBeforeIsAcknowledgedAgain) {
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1), same = visitor(client, 1);  // its first answer was lost on the way
  EXPECT_EQ(one.secret, same.secret);
  EXPECT_EQ(one.page.code, same.page.code);
  const Message form = one.page.form(), display = one.page.display();
  EXPECT_EQ(client.request("POST", "/api/messages", lines_of({form}), one.secret)->status, 200);
  const auto again = client.request("POST", "/api/messages", lines_of({form, display, form}), one.secret);
  EXPECT_EQ(again->status, 200);
  EXPECT_EQ(again->json().at("stored"), nlohmann::json::array({form.id, display.id, form.id}));
  Page enrolment{.set = &set, .number = 1};
  EXPECT_EQ(client.enrol(enrolment.enrol())->status, 409);  // they have begun
  Message changed = display;
  std::get<DisplayBody>(changed.body).mm_per_px = 9;
  const auto conflict = client.request("POST", "/api/messages", lines_of({changed}), one.secret);
  EXPECT_EQ(conflict->status, 409);
  EXPECT_TRUE(conflict->json().at("stored").empty());
  // What stands before a line that is refused is stored.
  const Message event = one.page.say(EventBody{.kind = "pause"});
  const auto half = client.request("POST", "/api/messages", lines_of({event}) + "{}\n", one.secret);
  EXPECT_EQ(half->status, 400);
  EXPECT_EQ(half->json().at("stored"), nlohmann::json::array({event.id}));
  // Its secret was used: the enrolment gives it to nobody again, also after a restart.
  EXPECT_EQ(server.end(SIGTERM), 0);
  ServerProcess later(request);
  HttpClient other(later.port());
  Page forged{.set = &set, .number = 1};
  EXPECT_EQ(other.enrol(forged.enrol())->status, 409);
  EXPECT_EQ(other.request("GET", "/api/where", {}, one.secret)->json().at("next_sequence"), 4);
}

TEST_F(ServeTest, NobodyReadsOrWritesForSomebodyElse) {
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1), two = visitor(client, 2);
  const std::string form = lines_of({one.page.form()});
  for (const std::string& secret :
       {std::string(64, '0'), two.secret.substr(0, 63) + (two.secret[63] == '0' ? "1" : "0")}) {
    EXPECT_EQ(client.request("POST", "/api/messages", form, secret)->status, 503);
    EXPECT_EQ(client.request("GET", "/api/where", {}, secret)->status, 503);
    EXPECT_EQ(client.request("POST", "/api/next", {}, secret)->status, 503);
  }
  EXPECT_EQ(client.request("POST", "/api/messages", form)->status, 401);
  const auto forged = client.request("POST", "/api/messages", form, two.secret);
  EXPECT_EQ(forged->status, 403);
  EXPECT_TRUE(forged->json().at("stored").empty());
  EXPECT_EQ(client.request("GET", "/api/where", {}, two.secret)->json().at("participant"), two.page.code);
  const auto untouched = client.request("GET", "/api/where", {}, one.secret)->json();
  EXPECT_EQ(untouched.at("next_sequence"), 1);
  EXPECT_EQ(untouched.at("form_done"), false);
}

TEST_F(ServeTest, NoReplyTellsTheRightAnswer) {
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1);
  Message guess = one.page.answer(0);
  std::set<std::string> replies;
  for (const ManifestStimulus& stimulus : set.manifest.stimuli) {
    std::get<AnswerBody>(guess.body).answer.stimulus_id = stimulus.id;
    const auto reply = client.request("POST", "/api/messages", lines_of({guess}), one.secret);
    EXPECT_EQ(reply->status, 409) << stimulus.id;
    std::string body = reply->body;
    if (const std::size_t at = body.find(stimulus.id); at != std::string::npos)
      body.replace(at, stimulus.id.size(), "GUESS");
    replies.insert(body);
  }
  EXPECT_EQ(replies.size(), 1U);
  EXPECT_EQ(client.request("GET", "/api/where", {}, one.secret)->json().at("next_sequence"), 1);
  server.end(SIGKILL);
  // A page of the version before, whose names are the set's: its people would tell each other.
  std::string study = read_file(folder / "site" / "study.json"),
              list = read_file(folder / "site" / "files.json");
  const std::string hash = sha256(study), bytes = std::to_string(study.size());
  const std::string name = ShownNames(set).name_of({.stimulus = 0}), id = set.manifest.stimuli[0].id;
  study.replace(study.find(name), name.size(), id);
  list.replace(list.find(hash), hash.size(), sha256(study));
  list.replace(list.find("\"bytes\":" + bytes), 8 + bytes.size(),
               "\"bytes\":" + std::to_string(study.size()));
  write_file_atomically(folder / "site" / "study.json", study);
  write_file_atomically(folder / "site" / "files.json", list);
  EXPECT_THAT(ServerProcess(request).first_line(), HasSubstr("export the page again"));
}

TEST_F(ServeTest, AnAdaptiveStudyIsPlacedByTheServer) {
  std::string text = online_study_text("64, 128, 256, 512, 1024", "");
  text.insert(text.find("seed ="), "procedure = \"quest_plus\"\n");
  text.insert(text.find("[session]"), "[quest_plus]\nmax_shows_per_image = 3\nmax_trials = 6\n");
  const RenderedSet adaptive = write_set_of_text(folder / "adaptive", text);
  request.folder = write_site(adaptive, folder / "adaptive-site");
  request.set = folder / "adaptive";
  ServerProcess server(request);
  ASSERT_NE(server.port(), 0) << server.first_line();
  HttpClient client(server.port());
  Page page{.set = &adaptive, .number = 1};
  const auto enrolled = client.enrol(page.enrol())->json();
  page.code = enrolled.at("participant");
  const std::string secret = enrolled.at("secret");
  int answered = 0;
  for (;; ++answered) {
    const auto next = client.request("POST", "/api/next", {}, secret)->json();
    if (next.contains("done")) break;
    const auto trial = next.at("trial");
    EXPECT_EQ(client.request("POST", "/api/next", {}, secret)->json().at("trial"), trial);
    EXPECT_EQ(trial.at("trial_index"), answered);
    EXPECT_THAT(trial.at("picture").get<std::string>(), HasSubstr("pictures/"));
    PictureAnswer answer = page.picture_answer({}, page.answer_to(answered));
    answer.kind = trial_kind_from_word(trial.at("kind").get<std::string>()).value();
    answer.stimulus_id = trial.at("stimulus_id");
    const Message message = page.say(AnswerBody{.trial_index = answered, .answer = answer});
    ASSERT_EQ(client.request("POST", "/api/messages", lines_of({message}), secret)->status, 200);
    ASSERT_LT(answered, 100);
  }
  EXPECT_GT(answered, 10);
  const Message completion = page.say(CompletionBody{});
  EXPECT_EQ(client.request("POST", "/api/messages", lines_of({completion}), secret)->status, 200);
  EXPECT_EQ(client.request("GET", "/api/where", {}, secret)->json().at("completed"), true);
}

TEST_F(ServeTest, ADeclineIsAFactAlone) {
  ServerProcess server(request);
  HttpClient client(server.port());
  Page page{.set = &set, .number = 1};
  const Message decline = page.say(DeclineBody{});
  for (int i = 0; i < 2; ++i) {
    const auto answer = client.enrol(decline);
    EXPECT_EQ(answer->status, 200);
    EXPECT_EQ(answer->body, "{}");
  }
  EXPECT_EQ(server.end(SIGINT), 0);
  EXPECT_EQ(read_log(log).declined_visits, 1);
}

TEST_F(ServeTest, WhatDoesNotBelongTogetherIsNotServed) {
  const auto said = [&](const ServeRequest& wrong) {
    ServerProcess server(wrong);
    EXPECT_EQ(server.port(), 0);
    return server.first_line();
  };
  ServeRequest wrong = request;
  wrong.set.clear();
  EXPECT_THAT(said(wrong), HasSubstr("set: wanted the rendered set"));
  (void)write_set_of_text(folder / "other", online_study_text("64, 1024"));
  wrong.set = folder / "other";
  const std::string other = said(wrong), name = "of study \"" + set.study.name + "\"";
  EXPECT_THAT(other, testing::AllOf(HasSubstr("study_hash"),
                                    HasSubstr(name + ", set " + wrong.set.string() + ", found")));
  EXPECT_THAT(other.substr(other.find(", found")), HasSubstr(name));
  wrong = request;
  wrong.folder = folder / "nowhere";
  EXPECT_THAT(said(wrong), HasSubstr("wanted a folder that seamline export web wrote"));
  wrong = request;
  wrong.address = "everywhere";
  EXPECT_THAT(said(wrong), HasSubstr("listen: wanted"));
  ServerProcess first(request);
  ASSERT_NE(first.port(), 0);
  wrong = request;
  wrong.port = first.port();
  EXPECT_THAT(said(wrong), HasSubstr("a port that are free"));
  EXPECT_THAT(complaint_of([&] { forget_participant(log, "x"); }), HasSubstr("in use"));
}

TEST_F(ServeTest, AStopAnswersWhatHasComeIn) {
  ServerProcess server(request);
  HttpClient second(server.port());
  Visitor two = visitor(second, 2);
  ASSERT_TRUE(
      second.send("POST /api/messages HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer " + two.secret +
                  "\r\nContent-Length: " + std::to_string(lines_of({two.page.form()}).size()) + "\r\n\r\n"));
  second.wait_until_read();
  ::kill(server.process(), SIGTERM);
  --two.page.sequence;
  ASSERT_TRUE(second.send(lines_of({two.page.form()})));
  const auto answer = second.receive();
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 200);
  EXPECT_EQ(server.end(0), 0);
}

TEST_F(ServeTest, AKilledServerLosesNothingItAcknowledged) {
  kill_servers(online_study_text("64"), 8, 3, 1);
}

}  // namespace
}  // namespace seamline::study::online
