#pragma once
#include <gtest/gtest.h>

#include "serve_kill.h"

/// A served study and its visitors.
namespace seamline::study::online {

class ServeTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!has_http_server()) GTEST_SKIP() << "built without libmicrohttpd";
  }
  TemporaryFolder folder;
  RenderedSet set = write_set_of_text(folder / "set", online_study_text());
  std::filesystem::path log = folder / "log.sqlite";
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

}  // namespace seamline::study::online
