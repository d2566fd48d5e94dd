// A server under a thousand kills, a thousand participants, and clients that mean it ill; prints what it
// measured.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <barrier>
#include <chrono>
#include <fstream>
#include <thread>

#include "serve_kill.h"

namespace seamline::study::online {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

TEST(ServeFull, AThousandKills) {
  kill_servers(online_study_text("64"), 1000, 4, 7);
}

struct Served {
  TemporaryFolder folder;
  RenderedSet set =
      write_set_of_text(folder / "set", online_study_text("64, 128, 256, 512, 1024, 2048, 4096"));
  ServeRequest request{.folder = write_site(set, folder / "site"),
                       .log = folder / "log.sqlite",
                       .set = folder / "set",
                       .port = 0};
};

double memory_mb(pid_t process, const std::string& which) {
  std::ifstream status("/proc/" + std::to_string(process) + "/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with(which)) return std::stod(line.substr(which.size() + 1)) / 1024;
  return 0;
}

double processor_s(pid_t process) {
  std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
  std::string field;
  double ticks = 0;
  for (int i = 1; i <= 15 && stat >> field; ++i)
    if (i >= 14) ticks += std::stod(field);
  return ticks / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

/// Each of `people` gives `answers` answers, `pause` apart (0: as fast as they are acknowledged), all at
/// once.
void crowd(const char* name, int people, int answers, std::chrono::duration<double> pause) {
  Served served;
  served.request.service.participant = {.a_second = 1e6, .at_once = 1e6};
  ServerProcess server(served.request);
  ASSERT_NE(server.port(), 0) << server.first_line();
  const double idle_mb = memory_mb(server.process(), "VmRSS:");
  std::vector<std::vector<double>> latency_ms(static_cast<std::size_t>(people));
  std::atomic<int> failed = 0;
  std::barrier ready(people + 1);
  std::vector<std::thread> crowd;
  for (int person = 0; person < people; ++person)
    crowd.emplace_back([&, person] {
      HttpClient client(server.port(), 60000);
      Page page{.set = &served.set, .number = static_cast<std::uint64_t>(person + 1)};
      const auto enrolled = client.enrol(page.enrol());
      if (!enrolled || enrolled->status != 200) {
        ++failed;
        ready.arrive_and_wait();
        return;
      }
      page.code = enrolled->json().at("participant");
      page.slot = enrolled->json().at("slot");
      const std::string secret = enrolled->json().at("secret");
      const std::vector<Trial> order = page.order();
      std::vector<std::string> lines;
      for (int trial = 0; trial < answers; ++trial)
        lines.push_back(
            message_line(page.answer(order[static_cast<std::size_t>(trial)], page.answer_to(trial))) + "\n");
      Random random(static_cast<std::uint64_t>(person), 1);
      ready.arrive_and_wait();
      auto due = Clock::now() + std::chrono::duration_cast<Clock::duration>(pause * random.uniform());
      for (const std::string& line : lines) {
        if (pause.count() > 0) std::this_thread::sleep_until(due);
        due += std::chrono::duration_cast<Clock::duration>(pause);
        const auto begin = Clock::now();
        const auto stored = client.request("POST", "/api/messages", line, secret);
        if (!stored || stored->status != 200) ++failed;
        latency_ms[static_cast<std::size_t>(person)].push_back(
            std::chrono::duration<double, std::milli>(Clock::now() - begin).count());
      }
    });
  ready.arrive_and_wait();
  const auto begin = Clock::now();
  const double processor_before_s = processor_s(server.process());
  for (std::thread& one : crowd) one.join();
  const double seconds = std::chrono::duration<double>(Clock::now() - begin).count();
  const double used_s = processor_s(server.process()) - processor_before_s;
  std::vector<double> all;
  for (const auto& own : latency_ms) all.insert(all.end(), own.begin(), own.end());
  std::sort(all.begin(), all.end());
  const auto quantile = [&](double share) {
    return all[static_cast<std::size_t>(share * static_cast<double>(all.size() - 1))];
  };
  std::printf(
      "%s: %d participants, %zu answers in %.1f s (%.0f a second): latency 50%% %.1f ms, 95%% %.1f ms, 99%% "
      "%.1f ms, longest %.1f ms; memory %.1f MB (idle %.1f, peak %.1f); processor %.1f s\n",
      name, people, all.size(), seconds, static_cast<double>(all.size()) / seconds, quantile(0.5),
      quantile(0.95), quantile(0.99), all.back(), memory_mb(server.process(), "VmRSS:"), idle_mb,
      memory_mb(server.process(), "VmHWM:"), used_s);
  EXPECT_EQ(failed, 0);
  EXPECT_EQ(server.end(SIGTERM), 0);
  const LogContents log = read_log(served.request.log);
  EXPECT_EQ(log.answers.size() + log.catches.size(),
            static_cast<std::size_t>(people) * static_cast<std::size_t>(answers));
  EXPECT_EQ(log.participants.size(), static_cast<std::size_t>(people));
}

TEST(ServeFull, AThousandParticipantsAtOneAnswerInEightSeconds) {
  crowd("one answer in 8 s", 1000, 8, std::chrono::seconds(8));
}

TEST(ServeFull, AThousandParticipantsAsFastAsTheyCan) {
  crowd("as fast as they can", 1000, 40, std::chrono::seconds(0));
}

/// Random damage to good requests, thousands of them, while others take part.
TEST(ServeFull, ForgedAndDamagedRequestsDamageNothing) {
  Served served;
  served.request.service.participant = {.a_second = 1e6,
                                        .at_once = 1e6};  // their secret is in the forged ones
  ServerProcess server(served.request);
  ASSERT_NE(server.port(), 0);
  HttpClient good(server.port());
  Page page{.set = &served.set, .number = 1};
  const auto enrolled = good.enrol(page.enrol())->json();
  page.code = enrolled.at("participant");
  page.slot = enrolled.at("slot");
  const std::string secret = enrolled.at("secret");
  const std::vector<Message> messages = page.the_rest();
  Random random(3, 0);
  std::map<int, int> statuses;
  std::size_t sent = 0;
  for (int round = 0; round < 20000; ++round) {
    const Message& message = messages[static_cast<std::size_t>(random.below(messages.size()))];
    const std::string body = message_line(message) + "\n";
    std::string bytes = "POST /api/messages HTTP/1.1\r\nHost: localhost\r\nAuthorization: Bearer " + secret +
                        "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
    const std::uint64_t damages = 1 + random.below(4);
    for (std::uint64_t i = 0; i < damages; ++i) {
      const auto at = static_cast<std::size_t>(random.below(bytes.size()));
      switch (random.below(4)) {
        case 0:
          bytes[at] = static_cast<char>(random.below(256));
          break;
        case 1:
          bytes.erase(at, 1 + static_cast<std::size_t>(random.below(20)));
          break;
        case 2:
          bytes.insert(at, bytes.substr(static_cast<std::size_t>(random.below(bytes.size())), 30));
          break;
        default:
          std::swap(bytes[at], bytes[static_cast<std::size_t>(random.below(bytes.size()))]);
      }
      if (bytes.empty()) bytes = "x";
    }
    HttpClient bad(server.port(), 20);
    const auto answer = bad.exchange(bytes);
    ++statuses[answer ? answer->status : 0];
    if (round % 300 == 0 && sent < messages.size()) {
      const auto stored = good.request("POST", "/api/messages", message_line(messages[sent]), secret);
      ASSERT_TRUE(stored);
      // Damage that leaves a message what it was, or makes another possible one of it, may have come before.
      EXPECT_TRUE(stored->status == 200 || stored->status == 409) << stored->body;
      ++sent;
    }
  }
  for (const auto& [status, times] : statuses) std::printf("%d: %d times\n", status, times);
  EXPECT_EQ(statuses.count(500), 0U);
  EXPECT_EQ(good.request("GET", "/health")->status, 200);
  EXPECT_EQ(server.end(SIGTERM), 0);
  const LogContents log = read_log(served.request.log);  // sound
  EXPECT_EQ(log.participants.size(), 1U);
}

}  // namespace
}  // namespace seamline::study::online
