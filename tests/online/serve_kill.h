// SIGKILL at random instants of a server whose participants go on: no answer that was acknowledged is lost,
// and none is stored twice.
#pragma once
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <atomic>
#include <map>
#include <new>

#include "study/log/log.h"
#include "support/arithmetic/random.h"
#include "tests/online/http_client.h"
#include "tests/online/served_study.h"

namespace seamline::study::online {

/// What participants and the one who kills know of each other.
struct KillGround {
  std::atomic<int> port = 0;
  std::atomic<bool> ends = false;
};

struct Acknowledged {
  std::int64_t person = 0;
  char code[24] = {};
  int trial_index = 0, chosen_index = 0, rating = 0;
  int tries = 0;
};

/// Sends until there is an answer that is no trouble of the server's.
template <class Send>
HttpAnswer until_answered(const KillGround& ground, HttpClient& client, int& tries, Send&& send) {
  for (tries = 1;; ++tries) {
    client.use_port(ground.port);
    const std::optional<HttpAnswer> answer = ground.port == 0 ? std::nullopt : send();
    if (answer && answer->status < 500) return *answer;
    ::usleep(3000);
  }
}

inline void take_part(const RenderedSet& set, const KillGround& ground, std::uint64_t person, int pipe_end) {
  HttpClient client(0, 2000);
  Page page{.set = &set, .number = person};
  const Message enrolment = page.enrol();
  int tries = 0;
  const HttpAnswer enrolled = until_answered(ground, client, tries, [&] { return client.enrol(enrolment); });
  if (enrolled.status != 200) throw std::runtime_error("not enrolled: " + enrolled.body);
  page.code = enrolled.json().at("participant");
  page.slot = enrolled.json().at("slot");
  std::string secret = enrolled.json().at("secret");
  for (const Message& message : page.the_rest()) {
    const HttpAnswer stored = until_answered(ground, client, tries, [&] {
      return client.request("POST", "/api/messages", message_line(message) + "\n", secret);
    });
    if (stored.status != 200) throw std::runtime_error("refused: " + stored.body);
    const auto* answer = std::get_if<AnswerBody>(&message.body);
    if (answer == nullptr) continue;
    Acknowledged said{.person = static_cast<std::int64_t>(person),
                      .trial_index = answer->trial_index,
                      .chosen_index = answer->answer.chosen_index,
                      .rating = answer->answer.rating,
                      .tries = tries};
    page.code.copy(said.code, sizeof said.code - 1);
    if (::write(pipe_end, &said, sizeof said) != sizeof said) ::_exit(3);
  }
}

inline void kill_servers(const std::string& study, int kills, int clients, std::uint64_t seed) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(folder / "set", study);
  const ServeRequest request{.folder = write_site(set, folder / "site"),
                             .log = folder / "log.sqlite",
                             .set = folder / "set",
                             .port = 0};
  void* shared =
      ::mmap(nullptr, sizeof(KillGround), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  ASSERT_NE(shared, MAP_FAILED);
  auto* ground = new (shared) KillGround;
  int ends[2] = {};
  ASSERT_EQ(::pipe2(ends, O_NONBLOCK), 0);
  ::fcntl(ends[1], F_SETFL, 0);
  ::fcntl(ends[1], F_SETPIPE_SZ, 1 << 20);
  std::vector<pid_t> people;
  for (int client = 0; client < clients; ++client) {
    const pid_t child = ::fork();
    if (child == 0) {
      ::close(ends[0]);
      try {
        for (std::uint64_t person = 1; !ground->ends; ++person)
          take_part(set, *ground, static_cast<std::uint64_t>(client) * 1'000'000 + person, ends[1]);
        ::_exit(0);
      } catch (const std::exception& error) {
        std::fprintf(stderr, "participant: %s\n", error.what());
      }
      ::_exit(2);
    }
    people.push_back(child);
  }
  ::close(ends[1]);
  std::map<std::pair<std::string, int>, std::pair<int, int>> accepted;
  int sent_again = 0;
  const auto collect = [&] {
    for (Acknowledged said; ::read(ends[0], &said, sizeof said) == sizeof said;) {
      const bool is_new =
          accepted.insert({{said.code, said.trial_index}, {said.chosen_index, said.rating}}).second;
      EXPECT_TRUE(is_new) << said.code << " trial " << said.trial_index;
      sent_again += said.tries > 1 ? 1 : 0;
    }
  };
  Random random(seed, 0);
  for (int kill = 0; kill < kills; ++kill) {
    ServerProcess server(request);
    ASSERT_NE(server.port(), 0) << server.first_line() << server.rest();
    ground->port = server.port();
    ::usleep(static_cast<unsigned>(kill % 4 == 0 ? random.below(8000) : random.below(160000)));
    (void)server.end(SIGKILL);
    collect();
  }
  {
    ServerProcess server(request);
    ASSERT_NE(server.port(), 0);
    ground->port = server.port();
    ground->ends = true;
    for (std::size_t left = people.size(); left > 0;) {
      collect();
      int status = 0;
      const pid_t ended = ::waitpid(-1, &status, WNOHANG);
      if (ended <= 0) {
        ::usleep(2000);
        continue;
      }
      ASSERT_NE(ended, server.process()) << "the server ended by itself";
      EXPECT_EQ(status, 0);
      --left;
    }
    EXPECT_EQ(server.end(SIGTERM), 0);
  }
  collect();
  ::close(ends[0]);
  const LogContents log = read_log(folder / "log.sqlite");
  std::map<std::pair<std::string, int>, std::pair<int, int>> stored;
  const auto add = [&](const auto& answer) {
    EXPECT_TRUE(
        stored.insert({{answer.participant, answer.trial_index}, {answer.chosen_index, answer.rating}})
            .second);
  };
  for (const Answer& answer : log.answers) add(answer);
  for (const CatchTrialAnswer& answer : log.catches) add(answer);
  EXPECT_EQ(stored, accepted);  // everybody came to an end, so nothing is stored that was not acknowledged
  for (const ParticipantRecord& person : log.participants) EXPECT_TRUE(person.completed) << person.code;
  std::printf("%d kills, %zu participants, %zu answers acknowledged, %zu stored, %d sent again\n", kills,
              log.participants.size(), accepted.size(), stored.size(), sent_again);
  EXPECT_GT(accepted.size(), static_cast<std::size_t>(kills));
  ::munmap(shared, sizeof(KillGround));
}

}  // namespace seamline::study::online
