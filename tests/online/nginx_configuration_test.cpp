// The file for nginx that `seamline serve --nginx` writes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "study/online/serving/nginx_configuration.h"
#include "study/online/serving/study_service.h"

namespace seamline::study::online {
namespace {

using testing::HasSubstr;
using testing::Not;

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
