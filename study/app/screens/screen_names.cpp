#include "study/app/screens/screen_names.h"

#include "support/running/overloaded.h"

namespace seamline::study::app {

std::string screen_name(const Screen& screen) {
  return std::visit(
      Overloaded{
          [](const ConsentScreen&) { return "consent"; }, [](const FormScreen&) { return "form"; },
          [](const DisplayScreen&) { return "display"; },
          [](const InstructionScreen&) { return "instructions"; },
          [](const TrainingScreen&) { return "training"; }, [](const FeedbackScreen&) { return "feedback"; },
          [](const ReadyScreen&) { return "ready"; }, [](const TrialScreen&) { return "trial"; },
          [](const BreakScreen&) { return "break"; }, [](const BriefingScreen&) { return "briefing"; },
          [](const PauseScreen&) { return "pause"; }, [](const ThanksScreen&) { return "thanks"; },
          [](const DeclinedScreen&) { return "declined"; }, [](const StoppedScreen&) { return "stopped"; }},
      screen);
}

std::string phase_name(const Phase& phase) {
  return std::visit(
      Overloaded{[](const Grey&) { return "grey"; }, [](const AwaitingImage&) { return "awaiting"; },
                 [](const Viewing&) { return "viewing"; }, [](const Gap&) { return "gap"; },
                 [](const Choosing&) { return "choosing"; }, [](const Rating&) { return "rating"; },
                 [](const Storing&) { return "storing"; }, [](const OnBreak&) { return "break"; },
                 [](const Briefing&) { return "briefing"; }, [](const Done&) { return "done"; }},
      phase);
}

bool is_pausable(const Screen& screen) {
  return std::visit(
      Overloaded{[](const ConsentScreen&) { return false; }, [](const FormScreen&) { return false; },
                 [](const DisplayScreen&) { return false; }, [](const InstructionScreen&) { return true; },
                 [](const TrainingScreen&) { return true; }, [](const FeedbackScreen&) { return true; },
                 [](const ReadyScreen&) { return true; }, [](const TrialScreen&) { return true; },
                 [](const BreakScreen&) { return true; }, [](const BriefingScreen&) { return true; },
                 [](const PauseScreen&) { return false; }, [](const ThanksScreen&) { return false; },
                 [](const DeclinedScreen&) { return false; }, [](const StoppedScreen&) { return false; }},
      screen);
}

}  // namespace seamline::study::app
