// People whom a panel sends, over HTTP. The browser's side, and a stand-in for the panel, is
// tests/online/recruited.mjs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <thread>

#include "serve_fixture.h"
#include "study/log/log.h"
#include "study/log/log_admin.h"
#include "study/log/online/log_backup.h"
#include "study/log/online/recruits.h"
#include "study/online/serving/recruitment_desk.h"
#include "study/online/serving/systemd_unit.h"
#include "tests/complaint.h"

namespace seamline::study::online {
namespace {

using test::complaint_of;
using testing::HasSubstr;

/// The fixture's study with [recruitment], without rendering: it changes no hash.
class RecruitmentServeTest : public ServeTest {
 protected:
  void recruit(const std::string& more) {
    set = write_set_of_text(folder / "panel", online_study_text("64, 512", "[recruitment]\n" + more));
    request.folder = write_site(set, folder / "panel-site");
    std::string study = read_file(request.folder / "study.json");
    const std::string before = study;
    auto json = nlohmann::ordered_json::parse(study);
    json["recruitment"] = {{"identifiers", set.study.recruitment->identifiers}};
    study = json.dump();
    write_file_atomically(request.folder / "study.json", study);
    std::string list = read_file(request.folder / "files.json");
    list.replace(list.find(sha256(before)), 64, sha256(study));
    const std::string bytes = "\"bytes\":" + std::to_string(before.size());
    list.replace(list.find(bytes), bytes.size(), "\"bytes\":" + std::to_string(study.size()));
    write_file_atomically(request.folder / "files.json", list);
    request.set = folder / "panel";
  }
  static std::optional<HttpAnswer> enrol(HttpClient& client, const Message& message,
                                         const std::string& person) {
    return client.request("POST", "/api/enrol",
                          "{\"token\":null,\"identifiers\":{\"PID\":\"" + person +
                              "\"},\"message\":" + message_line(message) + "}");
  }
  /// Somebody let in, with their secret.
  Visitor sent(HttpClient& client, std::uint64_t number) const {
    Visitor visitor{.page = {.set = &set, .number = number}, .secret = {}};
    const auto answer = enrol(client, visitor.page.enrol(), "person " + std::to_string(number));
    EXPECT_TRUE(answer && answer->status == 200) << (answer ? answer->body : "no answer");
    if (!answer || answer->status != 200) return visitor;
    visitor.page.code = answer->json().at("participant");
    visitor.page.slot = answer->json().at("slot");
    visitor.secret = answer->json().at("secret");
    return visitor;
  }
  static nlohmann::json end_of(HttpClient& client, const Visitor& visitor) {
    return client.request("GET", "/api/end", {}, visitor.secret)->json();
  }
};

constexpr const char* panel_text =
    "identifiers = [\"PID\"]\nreturn_link = \"https://panel.example/back?cc={code}&who={PID}\"\n"
    "[recruitment.codes]\nfinished = \"OK-{random}\"\ndeclined = \"NO\"\nscreened_out = \"OUT\"\n"
    "[[recruitment.screen]]\nfield = \"age\"\nleast = 31\n";

TEST_F(RecruitmentServeTest, AVisitEndsWithItsOwnCodeAndWayBackAlsoAfterARestart) {
  recruit(panel_text);
  set.study.form.at(0).kind = NumberField{.least = 31, .most = 120};  // what the test's people enter
  std::string code;
  Visitor one;
  {
    ServerProcess server(request);
    ASSERT_NE(server.port(), 0) << server.first_line();
    HttpClient client(server.port());
    one = sent(client, 1);
    EXPECT_TRUE(end_of(client, one).at("outcome").is_null());
    EXPECT_EQ(client.request("POST", "/api/messages", lines_of(one.page.the_rest()), one.secret)->status,
              200);
    const nlohmann::json end = end_of(client, one);
    EXPECT_EQ(end.at("outcome"), "finished");
    code = end.at("code");
    EXPECT_TRUE(code.starts_with("OK-") && code.size() == 11) << code;
    EXPECT_EQ(end.at("link"), "https://panel.example/back?cc=" + code + "&who=person%201");
    Page other{.set = &set, .number = 2};
    const auto again = enrol(client, other.enrol(), "person 1");
    EXPECT_EQ(again->status, 403);
    EXPECT_EQ(again->json().at("reason"), "again");
    const auto without = client.enrol(Page{.set = &set, .number = 3}.enrol());
    EXPECT_EQ(without->json().at("reason"), "link");
    Page declining{.set = &set, .number = 4};
    const auto declined = enrol(client, declining.say(DeclineBody{}), "person 4");
    EXPECT_EQ(declined->json().at("code"), "NO");
    EXPECT_EQ(declined->json().at("link"), "https://panel.example/back?cc=NO&who=person%204");
    EXPECT_EQ(server.end(SIGTERM), 0);
    EXPECT_THAT(server.rest(), HasSubstr("https://panel.example"));
  }
  ServerProcess later(request);
  HttpClient client(later.port());
  EXPECT_EQ(end_of(client, one).at("code"), code);
  EXPECT_EQ(later.end(SIGTERM), 0);
  EXPECT_EQ(read_file(log).find("person 1"), std::string::npos);  // the log knows no panel
  EXPECT_EQ(Recruits(log).of_person("person 4"), std::nullopt);
  EXPECT_TRUE(forget_participant(log, one.page.code));
  EXPECT_TRUE(forget_recruit(log, one.page.code));
  EXPECT_EQ(read_file(recruits_file(log)).find("person 1"), std::string::npos);
}

TEST_F(RecruitmentServeTest, WhoIsScreenedOutStoresNoAnswer) {
  recruit(panel_text);
  ServerProcess server(request);
  HttpClient client(server.port());
  Visitor one = sent(client, 1);  // thirty years old
  EXPECT_EQ(client.request("POST", "/api/messages", lines_of({one.page.form()}), one.secret)->status, 200);
  EXPECT_EQ(end_of(client, one).at("outcome"), "screened_out");
  EXPECT_EQ(end_of(client, one).at("code"), "OUT");
  const auto refused = client.request("POST", "/api/messages", lines_of({one.page.answer(0)}), one.secret);
  EXPECT_EQ(refused->status, 409);
  EXPECT_EQ(refused->json().at("reason"), "excluded");
  EXPECT_EQ(client.request("GET", "/api/where", {}, one.secret)->json().at("answered").size(), 0U);
}

TEST_F(RecruitmentServeTest, APageOfOtherIdentifiersIsNotServed) {
  recruit("identifiers = [\"PID\"]\n");
  request.folder = write_site(set, folder / "old-site");
  EXPECT_THAT(ServerProcess(request).first_line(), HasSubstr("export the page again"));
}

TEST_F(ServeTest, IdentifiersWithoutRecruitmentAreRefused) {
  ServerProcess server(request);
  HttpClient client(server.port());
  Page page{.set = &set, .number = 1};
  const auto answer = client.request(
      "POST", "/api/enrol",
      "{\"token\":null,\"identifiers\":{\"PID\":\"a\"},\"message\":" + message_line(page.enrol()) + "}");
  EXPECT_EQ(answer->status, 400);
  EXPECT_FALSE(std::filesystem::exists(recruits_file(log)));
}

/// The desk by itself, with a clock of the test's.
TEST(RecruitmentDesk, TheDoorKeepsTheClosingDateAndThePlaces) {
  const TemporaryFolder folder;
  const RenderedSet set = write_set_of_text(
      folder / "set", online_study_text("64, 512",
                                        "[recruitment]\nmost_people = 2\nhold_min = 10\ncloses = "
                                        "\"2100-01-01 00:00\"\n[recruitment.codes]\nfull = \"F\"\n"));
  Intake intake(set, folder / "log.sqlite");
  const std::int64_t begin = now_unix_s();
  std::int64_t now = begin;
  RecruitmentDesk desk(*set.study.recruitment, folder / "log.sqlite", false, [&] { return now; });
  const auto come = [&](std::uint64_t number) -> std::string {
    std::string reason;
    intake.transaction([&] {
      Page page{.set = &set, .number = number};
      const Message message = page.enrol();
      try {
        desk.check_entry(intake, message, {});
      } catch (const NoEntry& no) {
        reason = no.reason() + " " + no.end()->code;
        return;
      }
      const EnrolledPerson person = intake.enrol(message, {.code = "s-" + std::to_string(number),
                                                           .secret_sha256 = sha256(std::to_string(number)),
                                                           .slots = 9});
      desk.enter(person.code, {});
    });
    return reason;
  };
  EXPECT_EQ(come(1), "");
  EXPECT_EQ(come(2), "");
  EXPECT_EQ(come(3), "full F");
  EXPECT_EQ(come(2), "");               // the same message again: they are in
  now = begin + std::int64_t{20} * 60;  // nobody was heard of for so long
  EXPECT_EQ(come(4), "");
  now = 4'102'444'800;  // the closing date itself
  EXPECT_EQ(come(5), "full F");
  EXPECT_EQ(desk.quotas(intake).at(0).most_people, 2);
}

TEST(RecruitmentDesk, IdentifiersGoWithoutTheAnswers) {
  const TemporaryFolder folder;
  {
    Recruits recruits(folder / "log.sqlite");
    recruits.enter(
        {.code = "s-1", .person = "p", .identifiers = {{"PID", "p"}, {"SESSION", "long session id"}}});
    recruits.end("s-1", VisitOutcome::finished, "OK");
  }
  EXPECT_EQ(forget_identifiers(folder / "log.sqlite"), 1);
  const Recruit left = *Recruits(folder / "log.sqlite").of_code("s-1");
  EXPECT_EQ(
      left,
      (Recruit{.code = "s-1", .person = "", .outcome = VisitOutcome::finished, .completion_code = "OK"}));
  EXPECT_EQ(read_file(recruits_file(folder / "log.sqlite")).find("long session id"), std::string::npos);
}

TEST_F(ServeTest, ABackupTakenWhilePeopleAnswerIsWhole) {
  ServerProcess server(request);
  std::atomic<bool> done = false;
  std::thread answering([&] {
    HttpClient client(server.port());
    for (std::uint64_t number = 1; number <= 6; ++number) {
      Visitor one = visitor(client, number);
      for (const Message& message : one.page.the_rest())
        (void)client.request("POST", "/api/messages", message_line(message), one.secret);
    }
    done = true;
  });
  HttpClient looking(server.port());
  int copies = 0;
  while (!done || copies == 0) {
    const std::int64_t before = looking.request("GET", "/health")->json().at("answers");
    const std::filesystem::path copy = folder / ("copy-" + std::to_string(++copies) + ".sqlite");
    back_up_log(log, copy);
    const std::int64_t after = looking.request("GET", "/health")->json().at("answers");
    const LogContents contents = read_log(copy);  // every row and page is checked
    const auto held = static_cast<std::int64_t>(contents.answers.size() + contents.catches.size());
    EXPECT_GE(held, before);  // what was acknowledged before the copy is in it
    EXPECT_LE(before, after);
  }
  answering.join();
  EXPECT_NE(complaint_of([&] { back_up_log(log, folder / "copy-1.sqlite"); }), "");
}

TEST(SystemdUnit, NamesTheCommandInWords) {
  const std::string unit = systemd_unit(
      {"/usr/bin/seamline", "serve", "/srv/50 % page", "--log", "/srv/log/a.sqlite"}, "/srv/log/a.sqlite");
  EXPECT_THAT(unit, HasSubstr("ExecStart=\"/usr/bin/seamline\" \"serve\" \"/srv/50 %% page\" \"--log\""));
  EXPECT_THAT(unit, HasSubstr("ReadWritePaths=\"/srv/log\"\n"));
}

}  // namespace
}  // namespace seamline::study::online
