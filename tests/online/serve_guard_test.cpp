// What a server takes from anybody: odd requests, other names, floods and slow clients are refused, and
// others are served on.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "serve_fixture.h"
#include "study/online/serving/rate_limit.h"

namespace seamline::study::online {
namespace {

using testing::HasSubstr;
using testing::Not;

class ServeGuard : public ServeTest {};

TEST_F(ServeGuard, OddRequestsAreRefusedAndOthersAreServedOn) {
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

TEST_F(ServeGuard, WhatTwoProgramsCouldReadInTwoWaysIsRefused) {
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
  // libmicrohttpd 0.9 leaves the same bytes of NUL LF as of CR LF: nothing else of the request changes.
  EXPECT_THAT(status_of(first + host + "X: a" + nul + "\nY: b\r\n\r\n"), testing::AnyOf(200, 400));
}

TEST_F(ServeGuard, NobodyReachesItUnderAnotherName) {
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

TEST_F(ServeGuard, OnlyFilesOfThePageAreSentAsTheyWere) {
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

TEST_F(ServeGuard, AParticipantStoresNoMoreThanTheirShare) {
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

TEST_F(ServeGuard, WhoAsksTooOftenWaits) {
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

TEST_F(ServeGuard, SlowClientsAreShutOutAndKeepNobodyWaiting) {
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

}  // namespace
}  // namespace seamline::study::online
