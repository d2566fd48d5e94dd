#include "load.h"

#include <fmt/core.h>

#include <cstdio>

#include "process.h"
#include "tiny_study.h"

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

constexpr double megabyte_kb = 1024;
constexpr double largest_memory_mb = 1024;

/// Runs commands and remembers whether all of them went well.
class Measure {
 public:
  Ending of(const Arguments& command) {
    Ending ending = run(command);
    if (ending.status == 0 && memory_mb(ending) <= largest_memory_mb) return ending;
    good_ = false;
    fmt::print(stderr, "not as promised: {} ended with {} and took {:.0f} MB: {}\n", command[1],
               ending.status, memory_mb(ending), ending.output);
    return ending;
  }
  [[nodiscard]] static double seconds(const Ending& ending) {
    return 1e-6 * static_cast<double>(ending.duration_us);
  }
  [[nodiscard]] static double memory_mb(const Ending& ending) {
    return static_cast<double>(ending.peak_kb) / megabyte_kb;
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  bool good_ = true;
};

void answers_in_a_log(Measure& measure, const fs::path& program, const fs::path& folder) {
  const fs::path study =
      write_tiny_study(folder / "study", 4, R"("receiver", "shadow", "occlusion", "overlap")");
  const fs::path set = folder / "set";
  measure.of({program, "render", study, "--out", set});
  fmt::print("{:>8} {:>13} {:>13} {:>13} {:>20} {:>12}\n", "answers", "participants", "making, s",
             "analysis, s", "s a 10,000 answers", "memory, MB");
  for (const int participants : {261, 521, 1042, 2084}) {
    const fs::path log = folder / fmt::format("log-{}.sqlite", participants);
    const Ending made = measure.of({program, "study", set, "--log", log, "--observer", "threshold", "--count",
                                    std::to_string(participants)});
    const Ending analysed = measure.of({program, "analyze", log, "--out", folder / "report"});
    const int answers = participants * 48;
    fmt::print("{:>8} {:>13} {:>13.1f} {:>13.1f} {:>20.2f} {:>12.0f}\n", answers, participants,
               Measure::seconds(made), Measure::seconds(analysed), 1e4 * Measure::seconds(analysed) / answers,
               Measure::memory_mb(analysed));
    std::fflush(stdout);
  }
}

void stimuli_in_a_set(Measure& measure, const fs::path& program, const fs::path& folder) {
  fmt::print("\n{:<8} {:>8} {:>20} {:>20} {:>11} {:>22} {:>12}\n", "set of", "stimuli", "3 shards in all, s",
             "finished rerun, s", "verify, s", "opened, 1 person, s", "memory, MB");
  for (const int widths : {28, 1667}) {
    const fs::path study = write_tiny_study(folder / fmt::format("study-{}", widths), widths, "\"none\"");
    const fs::path set = folder / fmt::format("set-{}", widths), log = set / "log.sqlite";
    double rendering_s = 0;
    for (const char* shard : {"1/3", "2/3", "3/3"})
      rendering_s += Measure::seconds(measure.of({program, "render", study, "--out", set, "--shard", shard}));
    const Ending again = measure.of({program, "render", study, "--out", set});
    const Ending verified = measure.of({program, "verify", set});
    const Ending opened =
        measure.of({program, "study", set, "--log", log, "--observer", "perfect", "--count", "1"});
    fmt::print("{:<8} {:>8} {:>20.1f} {:>20.1f} {:>11.2f} {:>22.2f} {:>12.0f}\n", "pictures", 3 * widths,
               rendering_s, Measure::seconds(again), Measure::seconds(verified), Measure::seconds(opened),
               Measure::memory_mb(again));
    std::fflush(stdout);
  }
}

}  // namespace

int measure_load(const fs::path& program, const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
  Measure measure;
  answers_in_a_log(measure, program, folder);
  stimuli_in_a_set(measure, program, folder);
  return measure.good() ? 0 : 1;
}

}  // namespace seamline::faults
