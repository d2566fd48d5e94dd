#pragma once
#include <gtest/gtest.h>

#include <string>

#include "tests/online/http_client.h"
#include "tests/online/online_people.h"

namespace seamline::test {

/// A person in a browser, from consent to the last picture, at a server of this machine.
inline void answer_in_browser(study::online::Page page, int port, const std::string& invitation = {}) {
  using namespace study::online;
  HttpClient client(port);
  const auto enrolled = client.enrol(page.enrol(), invitation);
  ASSERT_TRUE(enrolled && enrolled->status == 200) << (enrolled ? enrolled->body : "no answer");
  page.code = enrolled->json().at("participant");
  page.slot = enrolled->json().at("slot");
  for (const Message& message : page.the_rest()) {
    const auto stored =
        client.request("POST", "/api/messages", message_line(message) + "\n", enrolled->json().at("secret"));
    ASSERT_TRUE(stored && stored->status == 200) << (stored ? stored->body : "no answer");
  }
}

}  // namespace seamline::test
