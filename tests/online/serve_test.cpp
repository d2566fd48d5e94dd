// A study over HTTP: from enrolment to completion, and everything that is refused on the way.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <thread>

#include "serve_kill.h"
#include "study/log/log_admin.h"
#include "study/online/serving/nginx_configuration.h"
#include "study/online/serving/rate_limit.h"
#include "study/online/serving/tokens.h"
#include "tests/complaint.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::HasSubstr;
using testing::Not;

class ServeTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_http_server()) GTEST_SKIP() << "built without libmicrohttpd";
  }
  TemporaryFolder folder;
  RenderedSet set = write_set_of_text(folder / "set", online_study_text());
  fs::path log = folder / "log.sqlite";
  ServeRequest request{
      .folder = write_site(set, folder / "site"), .log = log, .set = folder / "set", .port = 0};

  /// Somebody who is enrolled, with their secret.
  struct Visitor {
    Page page;
    std::string secret;
  };
  Visitor visitor(HttpClient& client, std::uint64_t number, const std::string& token = {}) const {
    Visitor visitor{.page = {.set = &set, .number = number}, .secret = {}};
    const auto answer = client.enrol(visitor.page.enrol(), token);
    EXPECT_TRUE(answer && answer->status == 200) << (answer ? answer->body : "no answer");
    if (!answer || answer->status != 200) return visitor;
    visitor.page.code = answer->json().at("participant");
    visitor.page.slot = answer->json().at("slot");
    visitor.secret = answer->json().at("secret");
    EXPECT_EQ(answer->json().at("next_sequence"), 1);
    return visitor;
  }
};

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
    EXPECT_EQ(client.request("POST", "/api/messages", form, secret)->status, 401);
    EXPECT_EQ(client.request("GET", "/api/where", {}, secret)->status, 401);
    EXPECT_EQ(client.request("POST", "/api/next", {}, secret)->status, 401);
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

TEST_F(ServeTest, OddRequestsAreRefusedAndOthersAreServedOn) {
  ServerProcess server(request);
  const std::string host = "Host: localhost\r\n";
  const auto status_of = [&](const std::string& bytes) {
    HttpClient client(server.port(), 3000);
    const auto answer = client.exchange(bytes);
    return answer ? answer->status : 0;
  };
  const std::vector<std::pair<std::string, std::set<int>>> odd = {
      {"GET / HTTP/1.1\r\n\r\n", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "\r\n", {411}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: 2\r\nContent-Length: 2\r\n\r\n{}", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: 2\r\nContent-Length: 3\r\n\r\n{}", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: +2\r\n\r\n{}", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: 0x2\r\n\r\n{}", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: 02\r\n\r\n{}", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: 2, 2\r\n\r\n{}", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: -1\r\n\r\n", {400}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: 99999999999999999999\r\n\r\n", {400, 413}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Length: 1048577\r\n\r\n", {413}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Transfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n",
       {501}},
      {"POST /api/enrol HTTP/1.1\r\n" + host +
           "Content-Length: 2\r\nTransfer-Encoding: chunked\r\n\r\n2\r\n{}\r\n0\r\n\r\n",
       {400, 501}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Content-Encoding: gzip\r\nContent-Length: 2\r\n\r\n{}",
       {415}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Expect: 100-continue\r\nContent-Length: 2\r\n\r\n{}", {417}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Origin: http://evil.example\r\nContent-Length: 2\r\n\r\n{}",
       {403}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Origin: null\r\nContent-Length: 2\r\n\r\n{}", {403}},
      {"POST /api/enrol HTTP/1.1\r\n" + host + "Origin: http://localhost\r\nContent-Length: 2\r\n\r\n{}",
       {400}},
      {"GET / HTTP/1.1\r\n" + host + host + "\r\n", {400}},
      {"GET / HTTP/1.1\r\n" + host + "Content-Length: 2\r\n\r\n{}", {400}},
      {"GET /api/where HTTP/1.1\r\n" + host + "Authorization: Basic eDp5\r\n\r\n", {401}},
      {"GET /api/where HTTP/1.1\r\n" + host + "Authorization: Bearer x\r\nAuthorization: Bearer y\r\n\r\n",
       {400}},
      {"GET /api/messages HTTP/1.1\r\n" + host + "\r\n", {405}},
      {"DELETE / HTTP/1.1\r\n" + host + "\r\n", {405}},
      {"TRACE / HTTP/1.1\r\n" + host + "\r\n", {405}},
      {"POST / HTTP/1.1\r\n" + host + "Content-Length: 0\r\n\r\n", {405}},
      {"GET /" + std::string(600, 'a') + " HTTP/1.1\r\n" + host + "\r\n", {404, 414}},
      {"GET /../set/manifest.json HTTP/1.1\r\n" + host + "\r\n", {404}},
      {"GET /%2e%2e/set/manifest.json HTTP/1.1\r\n" + host + "\r\n", {404}},
      {"GET //etc/passwd HTTP/1.1\r\n" + host + "\r\n", {404}},
      {"GET /pictures HTTP/1.1\r\n" + host + "\r\n", {404}},
      {"GET /index.html%00 HTTP/1.1\r\n" + host + "\r\n", {404}},
      {"GET /index%2Ehtml HTTP/1.1\r\n" + host + "\r\n", {404}},
      {"GET / HTTP/1.1\r\n" + host + "X: " + std::string(40000, 'x') + "\r\n\r\n", {431, 413, 400, 0}},
      {std::string("\x16\x03\x01\x02\x00\x01\x00\x01", 8) + "\r\n\r\n", {400, 0}},
      {"nonsense\r\n\r\n", {400, 0}}};
  for (const auto& [bytes, allowed] : odd)
    EXPECT_TRUE(allowed.contains(status_of(bytes))) << bytes.substr(0, 200) << " gave " << status_of(bytes);
  // A body that is longer than it says is another request, and is judged as one.
  HttpClient smuggler(server.port(), 3000);
  ASSERT_TRUE(smuggler.send("POST /api/enrol HTTP/1.1\r\n" + host +
                            "Content-Length: 2\r\n\r\n{}GET /health HTTP/1.1\r\n" + host + "\r\n"));
  EXPECT_EQ(smuggler.receive()->status, 400);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1);
  const std::string large(most_line_bytes + 1, ' ');
  EXPECT_EQ(client.request("POST", "/api/messages", large, one.secret)->status, 400);
  EXPECT_EQ(client.request("POST", "/api/messages", "\n\n", one.secret)->status, 400);
  EXPECT_EQ(client.request("POST", "/api/messages", "{\"a\":1}", one.secret)->status, 400);
  EXPECT_EQ(client.request("POST", "/api/messages", "\xFF", one.secret)->status, 400);
  EXPECT_EQ(client.request("POST", "/api/messages", lines_of(one.page.the_rest()), one.secret)->status, 200);
  EXPECT_EQ(server.end(SIGTERM), 0);
  const std::string said = server.rest();
  EXPECT_THAT(said, HasSubstr("refused: 400 /api/enrol"));
  EXPECT_THAT(said, Not(HasSubstr("passwd")));
}

TEST_F(ServeTest, WhatTwoProgramsCouldReadInTwoWaysIsRefused) {
  ServerProcess server(request);
  const auto status_of = [&](const std::string& bytes) {
    HttpClient client(server.port(), 3000);
    const auto answer = client.exchange(bytes);
    return answer ? answer->status : 0;
  };
  const std::string nul(1, '\0'), first = "GET /health HTTP/1.1\r\n", host = "Host: localhost\r\n";
  for (const std::string& good :
       {first + host + "\r\n", first + "X:\r\n" + host + "\r\n", first + host + "X: a b\r\nY: c\r\n\r\n",
        "GET /health?a=b&c HTTP/1.1\r\n" + host + "\r\n", "GET /health? HTTP/1.1\r\n" + host + "\r\n"})
    EXPECT_EQ(status_of(good), 200) << good;
  for (const std::string& odd :
       {first + host + "X: a" + nul + "b\r\n\r\n", first + host + "X: a" + nul + "\r\n\r\n",
        first + host + "X" + nul + "Y: a\r\n\r\n",
        first + "Host: localhost" + nul + ".rebound.example\r\n\r\n",
        "GET /health" + nul + " HTTP/1.1\r\n" + host + "\r\n",
        "GET /health?a" + nul + " HTTP/1.1\r\n" + host + "\r\n",
        std::string("GET /health HTTP/1.1\nHost: localhost\n\n"), "GET /health HTTP/1.1\n" + host + "\r\n",
        first + "Host: localhost\n\r\n", first + host + "\n", first + host + "X: a\nY: b\r\n\r\n",
        first + host + "X: a\r\n folded: b\r\n\r\n", first + host + "X: a\rY: b\r\n\r\n"}) {
    const int status = status_of(odd);
    EXPECT_TRUE(status == 400 || status == 404 || status == 0) << status << ": " << odd;
  }
}

TEST_F(ServeTest, NobodyReachesItUnderAnotherName) {
  request.hosts = {"study.example.org"};
  ServerProcess server(request);
  const auto status_of = [&](const std::string& host, const std::string& path) {
    HttpClient client(server.port());
    const auto answer = client.exchange("GET " + path + " HTTP/1.1\r\n" + host + "\r\n");
    return answer ? answer->status : 0;
  };
  for (const char* own : {"localhost", "LOCALHOST:8080", "127.0.0.1", "127.0.0.1:8080", "192.168.1.20:80",
                          "[::1]:8080", "[::1]", "study.example.org", "Study.Example.ORG.:443"})
    EXPECT_EQ(status_of(std::string("Host: ") + own + "\r\n", "/"), 200) << own;
  for (const char* other :
       {"rebound.example", "rebound.example:8080", "localhost.rebound.example", "127.0.0.1.rebound.example",
        "study.example.org.rebound.example", "xstudy.example.org", "x", "[rebound.example]", "127.1", "[::1"})
    for (const char* path : {"/", "/study.json", "/health", "/api/where"})
      EXPECT_EQ(status_of(std::string("Host: ") + other + "\r\n", path), 421) << other << path;
  for (const char* none : {"", "Host:\r\n", "Host: \r\n", "Host: :80\r\n"})
    EXPECT_EQ(status_of(none, "/"), 400) << none;
  for (const char* wrong : {"", ".", "-a", "a b", "a;b", "a..b", "a/b", "a:80", "a\n"})
    EXPECT_FALSE(is_host_name(wrong)) << wrong;
}

TEST_F(ServeTest, OnlyFilesOfThePageAreSentAsTheyWere) {
  ServerProcess server(request);
  HttpClient client(server.port());
  for (const char* path : {"/", "/index.html", "/?token=abc"}) {
    const auto page = client.request("GET", path);
    EXPECT_EQ(page->status, 200);
    EXPECT_EQ(page->body, "<!doctype html><title>study</title>");
    EXPECT_THAT(page->head, HasSubstr("Content-Type: text/html; charset=utf-8"));
    EXPECT_THAT(page->head, HasSubstr("Content-Security-Policy: default-src 'none'"));
    EXPECT_THAT(page->head, HasSubstr("X-Content-Type-Options: nosniff"));
  }
  EXPECT_THAT(client.request("GET", "/seamline.js")->head, HasSubstr("text/javascript"));
  EXPECT_EQ(client.request("GET", "/files.json")->status, 200);
  const auto large = client.request("GET", "/pictures/large.png");
  EXPECT_EQ(large->body, std::string(3 << 20, 'p'));
  const std::size_t at = large->head.find("ETag: ");
  ASSERT_NE(at, std::string::npos);
  const std::string version = large->head.substr(at + 6, large->head.find("\r\n", at) - at - 6);
  ASSERT_TRUE(client.send("GET /pictures/large.png HTTP/1.1\r\nHost: localhost\r\nIf-None-Match: " + version +
                          "\r\n\r\n"));
  EXPECT_EQ(client.receive(false)->status, 304);
  ASSERT_TRUE(client.send("HEAD /pictures/large.png HTTP/1.1\r\nHost: localhost\r\n\r\n"));
  EXPECT_THAT(client.receive(false)->head, HasSubstr("Content-Length: 3145728"));
  // What is added to the folder, or changed in it, is not sent.
  write_file_atomically(folder / "site" / "new.html", "new");
  write_file_atomically(folder / "site" / "index.html", "changed");
  write_file_atomically(folder / "site" / "pictures" / "large.png", "changed");
  EXPECT_EQ(client.request("GET", "/new.html")->status, 404);
  EXPECT_EQ(client.request("GET", "/index.html")->body, "<!doctype html><title>study</title>");
  EXPECT_EQ(client.request("GET", "/pictures/large.png")->body, std::string(3 << 20, 'p'));
  server.end(SIGKILL);
  ServerProcess again(request);
  EXPECT_THAT(again.first_line(), HasSubstr("wanted the file that was exported"));
}

TEST_F(ServeTest, InvitationsAreGoodOnceEach) {
  request.tokens = folder / "tokens";
  const std::vector<std::string> tokens = make_tokens(2, request.tokens);
  const std::vector<std::string> more = make_tokens(1, request.tokens);
  EXPECT_EQ(read_token_hashes(request.tokens).size(), 3U);
  const std::string file = read_file(request.tokens);
  for (const std::string& token : tokens) {
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(file.find(token), std::string::npos);
  }
  const auto status = [&](HttpClient& client, std::uint64_t number, const std::string& token) {
    Page page{.set = &set, .number = number};
    return client.enrol(page.enrol(), token)->status;
  };
  ServerProcess server(request);
  HttpClient client(server.port());
  EXPECT_EQ(status(client, 1, ""), 403);
  EXPECT_EQ(status(client, 1, std::string(32, 'a')), 403);
  EXPECT_EQ(status(client, 1, tokens[0]), 200);
  EXPECT_EQ(status(client, 1, tokens[0]), 200);  // the same enrolment again
  EXPECT_EQ(status(client, 2, tokens[0]), 403);
  EXPECT_EQ(status(client, 2, tokens[1]), 200);
  EXPECT_EQ(server.end(SIGTERM), 0);
  const std::string code = read_log(log).participants.at(0).code;
  forget_participant(log, code);
  ServerProcess later(request);
  HttpClient other(later.port());
  EXPECT_EQ(status(other, 3, tokens[0]), 403);  // whoever was forgotten does not come again by it
  EXPECT_EQ(status(other, 3, more[0]), 200);
  later.end(SIGKILL);
  request.tokens.clear();
  ServerProcess open(request);
  HttpClient anybody(open.port());
  EXPECT_EQ(status(anybody, 4, more[0]), 400);
  EXPECT_EQ(status(anybody, 4, ""), 200);
  write_file_atomically(folder / "wrong", "no hash\n");
  EXPECT_THAT(complaint_of([&] { (void)read_token_hashes(folder / "wrong"); }),
              HasSubstr("the hash of an invitation"));
}

TEST_F(ServeTest, WhatIsDecidedBesideARunningServerCountsAtOnce) {
  request.tokens = folder / "tokens";
  const std::vector<std::string> before = make_tokens(2, request.tokens);
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1, before[0]);
  const std::vector<std::string> later = make_tokens(1, request.tokens);
  Visitor two = visitor(client, 2, later[0]);
  const auto enrol = [&](std::uint64_t number, const std::string& token) {
    return client.enrol(Page{.set = &set, .number = number}.enrol(), token)->status;
  };
  EXPECT_EQ(enrol(3, std::string(32, 'a')), 403);
  write_file_atomically(request.tokens, sha256(before[0]) + "\n" + sha256(later[0]) + "\n");
  EXPECT_EQ(enrol(3, before[1]), 403) << "an invitation that was taken back";
  write_file_atomically(request.tokens, "no hash\n");
  EXPECT_EQ(enrol(3, before[1]), 403) << "a file that cannot be read changes nothing";

  const auto send = [&](Visitor& who, const Message& message) {
    return client.request("POST", "/api/messages", lines_of({message}), who.secret);
  };
  EXPECT_EQ(send(one, one.page.form())->status, 200);
  EXPECT_EQ(send(two, two.page.form())->status, 200);
  exclude_participant(log, one.page.code);
  const auto refused = send(one, one.page.display());
  EXPECT_EQ(refused->status, 409);
  EXPECT_THAT(refused->body, HasSubstr("who is excluded"));
  EXPECT_EQ(send(two, two.page.display())->status, 200);
  EXPECT_EQ(server.end(SIGTERM), 0);
  EXPECT_THAT(server.rest(), HasSubstr("the invitations read before still count"));
}

TEST_F(ServeTest, AParticipantStoresNoMoreThanTheirShare) {
  request.service.stored = {.base_bytes = 100'000, .bytes_a_trial = 0};
  std::int64_t stored = 0;
  std::string last;
  Visitor one;
  for (int start = 0; start < 2; ++start) {  // what is stored counts after a restart, too
    ServerProcess server(request);
    HttpClient client(server.port());
    if (start == 0) one = visitor(client, 1);
    for (int i = 0; i < 40; ++i) {
      const Message event = one.page.say(EventBody{.kind = "note", .detail = std::string(3900, 'x')});
      const auto reply = client.request("POST", "/api/messages", lines_of({event}), one.secret);
      if (reply->status == 200) {
        stored += 3900 + 512;
        EXPECT_EQ(start, 0);
        continue;
      }
      EXPECT_EQ(reply->status, 413);
      last = reply->body;
      --one.page.sequence;
    }
    EXPECT_EQ(client.request("GET", "/api/where", {}, one.secret)->json().at("next_sequence"),
              one.page.sequence);
    Visitor other = visitor(client, static_cast<std::uint64_t>(2 + start));
    EXPECT_EQ(client.request("POST", "/api/messages", lines_of(other.page.the_rest()), other.secret)->status,
              200);
    EXPECT_EQ(server.end(SIGTERM), 0);
  }
  EXPECT_LE(stored, 100'000);
  EXPECT_GT(stored, 90'000);
  EXPECT_THAT(last, HasSubstr("messages: wanted at most 100000 bytes of a participant"));
}

TEST_F(ServeTest, WhoeverWasForgottenOrExcludedIsToldWhy) {
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1), two = visitor(client, 2);
  const auto asks = [](HttpClient& asking, Visitor& who) {
    return asking.request("POST", "/api/messages", lines_of({who.page.form()}), who.secret)->json();
  };
  exclude_participant(log, two.page.code);
  EXPECT_EQ(asks(client, two).at("reason"), "excluded");
  EXPECT_EQ(server.end(SIGTERM), 0);
  forget_participant(log, one.page.code);
  ServerProcess later(request);
  HttpClient again(later.port());
  EXPECT_EQ(asks(again, one).at("reason"), "forgotten");
  EXPECT_EQ(again.request("GET", "/api/where", {}, one.secret)->json().at("reason"), "forgotten");
  EXPECT_FALSE(again.request("POST", "/api/messages", "{}", one.secret)->json().contains("stored"));
}

TEST_F(ServeTest, ACodeIsKeptBesideItsInvitationWhereThatIsAskedFor) {
  request.tokens = folder / "tokens";
  request.codes = folder / "codes";
  const std::vector<std::string> tokens = make_tokens(3, request.tokens);
  std::string first, second;
  {
    ServerProcess server(request);
    HttpClient client(server.port());
    first = visitor(client, 1, tokens[0]).page.code;
    EXPECT_EQ(visitor(client, 1, tokens[0]).page.code, first);  // the same enrolment again
    second = visitor(client, 2, tokens[1]).page.code;
    EXPECT_EQ(server.end(SIGTERM), 0);
  }
  EXPECT_EQ(code_of_invitation(request.codes, tokens[0]), first);
  EXPECT_EQ(code_of_invitation(request.codes, "https://study.example.org/?token=" + tokens[1] + "#visit=2"),
            second);
  EXPECT_THAT(complaint_of([&] { (void)code_of_invitation(request.codes, tokens[2]); }),
              HasSubstr("wanted an invitation by which somebody came"));
  EXPECT_EQ(fs::status(request.codes).permissions(), fs::perms::owner_read | fs::perms::owner_write);
  const std::string kept = read_file(request.codes);
  for (const std::string& token : tokens) EXPECT_EQ(kept.find(token), std::string::npos);
  EXPECT_EQ(std::count(kept.begin(), kept.end(), '\n'), 2);
  const std::string in_log = read_file(log);
  EXPECT_EQ(in_log.find(sha256(tokens[0]) + " "), std::string::npos);

  // Where it cannot be kept nobody is enrolled: they may come again.
  write_file_atomically(request.codes, "something else\n");
  EXPECT_THAT(ServerProcess(request).first_line(),
              HasSubstr("codes:1: wanted the hash of an invitation and a code"));
  fs::remove(request.codes);
  ServerProcess server(request);
  HttpClient client(server.port());
  fs::create_directory(request.codes);
  EXPECT_EQ(client.enrol(Page{.set = &set, .number = 3}.enrol(), tokens[2])->status, 503);
  fs::remove(request.codes);
  (void)visitor(client, 3, tokens[2]);
  EXPECT_EQ(client.request("GET", "/health")->json().at("participants"), 3);
  EXPECT_EQ(read_log(log).participants.size(), 3U);
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
  EXPECT_THAT(said(wrong), HasSubstr("--set: wanted the rendered set"));
  (void)write_set_of_text(folder / "other", online_study_text("64, 1024"));
  wrong.set = folder / "other";
  EXPECT_THAT(said(wrong), HasSubstr("study_hash"));
  wrong = request;
  wrong.folder = folder / "nowhere";
  EXPECT_THAT(said(wrong), HasSubstr("wanted a folder that seamline export --web wrote"));
  wrong = request;
  wrong.address = "everywhere";
  EXPECT_THAT(said(wrong), HasSubstr("--listen"));
  ServerProcess first(request);
  ASSERT_NE(first.port(), 0);
  wrong = request;
  wrong.port = first.port();
  EXPECT_THAT(said(wrong), HasSubstr("a port that are free"));
  EXPECT_THAT(complaint_of([&] { forget_participant(log, "x"); }), HasSubstr("in use"));
}

TEST_F(ServeTest, WhoAsksTooOftenWaits) {
  RateLimit limit({.a_second = 10, .at_once = 3});
  const RateLimit::Clock::time_point begin = {};
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(limit.allows("one", begin));
  EXPECT_FALSE(limit.allows("one", begin));
  EXPECT_TRUE(limit.allows("two", begin));
  EXPECT_TRUE(limit.allows("one", begin + std::chrono::milliseconds(101)));
  EXPECT_FALSE(limit.allows("one", begin + std::chrono::milliseconds(101)));
  EXPECT_FALSE(limit.allows("one", begin));  // a clock that goes back gives nothing

  request.service.participant = {.a_second = 0.001, .at_once = 3};
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1), two = visitor(client, 2);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(client.request("GET", "/api/where", {}, one.secret)->status, 200);
  EXPECT_EQ(client.request("GET", "/api/where", {}, one.secret)->status, 429);
  EXPECT_EQ(client.request("GET", "/api/where", {}, two.secret)->status, 200);
}

TEST_F(ServeTest, SlowClientsAreShutOutAndKeepNobodyWaiting) {
  request.http.slow_s = 1;
  ServerProcess server(request);
  std::vector<std::unique_ptr<HttpClient>> slow;
  for (int i = 0; i < 200; ++i) {
    slow.push_back(std::make_unique<HttpClient>(server.port(), 8000));
    ASSERT_TRUE(slow.back()->send(
        i % 2 == 0 ? "GET / HTTP/1.1\r\nHost: localhost\r\nX-Slow: "
                   : "POST /api/enrol HTTP/1.1\r\nHost: localhost\r\nContent-Length: 100\r\n\r\n{"));
  }
  HttpClient client(server.port());
  Visitor one = visitor(client, 1);
  EXPECT_EQ(client.request("POST", "/api/messages", lines_of(one.page.the_rest()), one.secret)->status, 200);
  for (int byte = 0; byte < 8; ++byte) {  // a byte now and then keeps nothing open
    for (auto& one_of_them : slow) (void)one_of_them->send("x");
    ::usleep(400000);
    if (byte < 4) {
      EXPECT_EQ(client.request("GET", "/health")->status, 200);
    }
    client.close();
  }
  for (auto& one_of_them : slow) EXPECT_FALSE(one_of_them->receive());
  EXPECT_EQ(server.end(SIGTERM), 0);
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

TEST(Nginx, TheConfigurationIsForThePort) {
  const std::string text = nginx_configuration(8123);
  EXPECT_THAT(text, HasSubstr("server 127.0.0.1:8123;"));
  EXPECT_THAT(text, HasSubstr("client_max_body_size        1m;"));
  EXPECT_THAT(text, Not(testing::ContainsRegex("@[A-Z_]+@")));
}

// Sixty browsers ask for seven files each, over HTTP/2, where each file on its way is a connection of its
// address.
TEST(Nginx, AClassBehindOneAddressIsLetInAsTheServerLetsIt) {
  const std::string text = nginx_configuration(8123);
  const auto number_after = [&](const std::string& words) {
    const std::size_t at = text.find(words);
    EXPECT_NE(at, std::string::npos) << words;
    return std::atof(text.c_str() + at + words.size());
  };
  const ServiceLimits server;
  EXPECT_EQ(number_after("zone=seamline_requests:10m rate="), server.address.a_second);
  EXPECT_EQ(number_after("zone=seamline_requests burst="), server.address.at_once);
  EXPECT_EQ(number_after("zone=seamline_newcomers:10m rate="), server.newcomers.a_second);
  EXPECT_EQ(number_after("zone=seamline_newcomers burst="), server.newcomers.at_once);
  EXPECT_GE(number_after("limit_conn        seamline_connections "), 60 * 7);
  EXPECT_GE(server.address.at_once, 60 * 7);
  EXPECT_GE(server.newcomers.at_once, 60);
}

TEST(Nginx, TheConfigurationIsForTheHost) {
  const std::string text = nginx_configuration(8123, {"a.example.org", "b.example.org"});
  EXPECT_THAT(text, HasSubstr("server_name a.example.org b.example.org;"));
  EXPECT_THAT(text, HasSubstr("/etc/letsencrypt/live/a.example.org/"));
  EXPECT_THAT(text, Not(HasSubstr("study.example.org")));
  EXPECT_THAT(text, Not(testing::ContainsRegex("@[A-Z]")));
}

TEST(Nginx, NoServerOfItKeepsAddresses) {
  const std::string text = nginx_configuration(8123);
  std::size_t servers = 0;
  for (std::size_t at = text.find("\nserver {"); at != std::string::npos; ++servers) {
    const std::size_t next = text.find("\nserver {", at + 1);
    const std::string block = text.substr(at, next - at);
    EXPECT_THAT(block, testing::ContainsRegex("access_log (off|[^ ]+ seamline);"));
    EXPECT_THAT(block,
                testing::ContainsRegex("error_log +[^ ]+ emerg;"));  // lines of lesser trouble name clients
    at = next;
  }
  EXPECT_EQ(servers, 2U);
  const std::size_t format = text.find("log_format");
  EXPECT_THAT(text.substr(format, text.find(';', format) - format),
              Not(testing::ContainsRegex("remote|http_|request_uri|args|query")));
}

}  // namespace
}  // namespace seamline::study::online
