#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>

#include "study/observers/observer.h"

namespace seamline::study {

/// What `seamline study SET --log LOG --observer KIND --count N --seed S` asks for.
struct SimulationRequest {
  std::filesystem::path set_folder = {};
  std::filesystem::path log = {};
  ObserverKind observer = ObserverKind::threshold;
  std::optional<double> image_gain = {};  ///< of `image`, instead of the study's
  int count = 20;                         ///< participants sim-0001 to sim-N
  std::uint64_t seed = 1;                 ///< same seed, same answers, on every machine
};

struct SimulationSummary {
  int participants_run = 0;       ///< by this call, to their end
  int participants_complete = 0;  ///< were so before (or are excluded), and were left alone
  std::int64_t answers_added = 0;
  int tracks_on_edge = 0;  ///< adaptive tracks of this call whose threshold leans on the edge of the grid
};

/// Runs simulated participants through the same trials, session and log as people. Running it again adds what
/// is missing and nothing else: completed participants are left alone, and a participant's answers depend on
/// nothing but the seed, the participant's number and the set. So a transaction holds 25 participants, not
/// one answer as for people: what a crash loses of simulated participants the next run makes again, bit for
/// bit. Throws InputError as load_rendered_set and LogWriter do, before the log is begun where the set is at
/// fault; Interrupted after Ctrl-C, with whole participants kept.
SimulationSummary run_simulated_study(const SimulationRequest& request);

}  // namespace seamline::study
