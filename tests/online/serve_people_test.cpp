// Who may take part in a study over HTTP: invitations, and people who are excluded or forgotten.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "serve_fixture.h"
#include "study/log/log_admin.h"
#include "study/online/serving/tokens.h"
#include "tests/complaint.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;
using test::complaint_of;
using testing::HasSubstr;

class ServePeople : public ServeTest {};

TEST_F(ServePeople, InvitationsAreGoodOnceEach) {
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

TEST_F(ServePeople, WhatIsDecidedBesideARunningServerCountsAtOnce) {
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

TEST_F(ServePeople, WhoeverWasForgottenOrExcludedIsToldWhy) {
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = visitor(client, 1), two = visitor(client, 2);
  const auto asks = [](HttpClient& asking, Visitor& who) {
    return asking.request("POST", "/api/messages", lines_of({who.page.form()}), who.secret)->json();
  };
  exclude_participant(log, two.page.code);
  EXPECT_EQ(asks(client, two).at("reason"), "excluded");
  // Nobody was deleted: somebody whom this log does not know answered into another one, and may wait for it.
  const auto stranger = client.request("GET", "/api/where", {}, std::string(64, 'a'));
  EXPECT_EQ(stranger->status, 503);
  EXPECT_FALSE(stranger->json().contains("reason"));
  EXPECT_EQ(server.end(SIGTERM), 0);
  forget_participant(log, one.page.code);
  ServerProcess later(request);
  HttpClient again(later.port());
  EXPECT_EQ(asks(again, one).at("reason"), "forgotten");
  EXPECT_EQ(again.request("GET", "/api/where", {}, one.secret)->json().at("reason"), "forgotten");
  EXPECT_FALSE(again.request("POST", "/api/messages", "{}", one.secret)->json().contains("stored"));
}

TEST_F(ServePeople, ACodeIsKeptBesideItsInvitationWhereThatIsAskedFor) {
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

}  // namespace
}  // namespace seamline::study::online
