#pragma once
#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>

#include "scripted_person.h"
#include "study/running/visit_store.h"
#include "support/text/error.h"
#include "temporary_set.h"
#include "tests/complaint.h"

namespace seamline::study {

inline constexpr const char* own_consent = "[consent]\ntext = \"Our own text.\"\n";

inline std::string people_text(const std::string& more = "", const std::string& session = "") {
  std::string text = study_text("tiny", "64");
  text.insert(text.find("break_every"), session);
  return text + own_consent + "[catch]\nattention = 1\nreference = 1\n" + more;
}

class VisitStoreTest : public testing::Test {
 protected:
  TemporaryFolder folder;
  RenderedSet set = write_set_of_text(folder / "set", people_text());
  std::filesystem::path path = folder / "log.sqlite";

  /// Goes on until the wanted number of answers is stored, or the end.
  static Visit run(VisitStore& store, Visit visit, ScriptedPerson& person, int answers = 1000) {
    for (int i = 0; i < 10000 && !is_over(visit); ++i) {
      if (answered_trials(visit.session.trials) >= answers && on<TrialScreen>(visit)) break;
      visit = store.step(std::move(visit), person.act(visit));
    }
    return visit;
  }
  template <class Wanted>
  static bool on(const Visit& visit) {
    return std::holds_alternative<Wanted>(visit.screen);
  }
  static std::string complaint(const RenderedSet& set, const std::filesystem::path& log,
                               const Visitor& visitor) {
    return test::complaint_of([&] { const VisitStore store(set, log, visitor); });
  }
  [[nodiscard]] int count(const std::string& sql) const {
    SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
    return database.execAndGet(sql).getInt();
  }
};

}  // namespace seamline::study
