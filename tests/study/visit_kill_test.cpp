#include "visit_kill.h"

namespace seamline::study {
namespace {

TEST(VisitKill, NothingAcceptedIsLostOrDoubledAfter20Kills) {
  kill_visits(kill_study_text(), 20, 5, 5);
}

}  // namespace
}  // namespace seamline::study
