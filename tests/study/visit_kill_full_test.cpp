// By hand: minutes, not seconds.
#include "visit_kill.h"

namespace seamline::study {
namespace {

TEST(VisitKillFull, NothingAcceptedIsLostOrDoubledAfter200Kills) {
  kill_visits(kill_study_text(), 200, 6, 100);
}

TEST(VisitKillFull, NorInAnAdaptiveStudyAfter200Kills) {
  std::string text = kill_study_text();
  text.insert(text.find("[session]"), "procedure = \"quest_plus\"\n");
  kill_visits(text + "[quest_plus]\nmax_shows_per_image = 3\nmax_trials = 9\n", 200, 7, 100);
}

}  // namespace
}  // namespace seamline::study
