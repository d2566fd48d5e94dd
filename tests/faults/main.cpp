// Tries faults on the program and prints one table:
//   seamline_faults [--quick | --load] PROGRAM [FOLDER [FIRST]]
// FIRST is the line of the table to begin with; --load measures instead how time and memory grow.
#include <fmt/core.h>

#include <cstdio>
#include <exception>
#include <iterator>
#include <string>

#include "damage.h"
#include "lab.h"
#include "load.h"

namespace {

using namespace seamline::faults;

void print_row(const Tally& tally) {
  fmt::print("{:<44} {:>6} {:>10} {:>6} {:>7} {:>6}  {}\n", tally.fault, tally.tries, tally.committed,
             tally.lost, tally.reruns, tally.equal, tally.note);
  std::fflush(stdout);
}

/// Nothing lost, and every rerun ended like an undisturbed run.
bool good(const Tally& tally) {
  return tally.lost == 0 && tally.equal == tally.reruns;
}

void print_damage(Lab& lab) {
  fmt::print("\n{:<20} {:>6} {:>8} {:>10} {:>9} {:>10} {:>8} {:>8} {:>8}\n", "damaged log", "tries",
             "refused", "unnoticed", "answers", "recovered", "no code", "changed", "nothing");
  for (const char* how : {"bit flipped", "page lost", "cut short"}) {
    const Damage damage = damage_log(lab, how);
    fmt::print("{:<20} {:>6} {:>8} {:>10} {:>9} {:>10} {:>8} {:>8} {:>8}\n", damage.what, damage.tries,
               damage.refused, damage.unnoticed, damage.answers, damage.recovered, damage.without_code,
               damage.changed, damage.nothing_recovered);
    std::fflush(stdout);
  }
}

constexpr Tally (*every_fault[])(Lab&) = {
    kill_render,     kill_study,      kill_analyze,   kill_upgrade,       limit_render,
    limit_study,     limit_analyze,   limit_upgrade,  small_disk,         small_disk_upgrade,
    change_pictures, renders_at_once, shards_at_once, containers_at_once, other_settings_at_once,
    studies_at_once, clock_set_back};

int try_all(Lab& lab, std::size_t first) {
  fmt::print("{:<44} {:>6} {:>10} {:>6} {:>7} {:>6}\n", "fault", "tries", "committed", "lost", "reruns",
             "equal");
  bool all_good = true;
  for (std::size_t i = first; i < std::size(every_fault); ++i) try {
      const Tally tally = every_fault[i](lab);
      if (tally.tries > 0 || !tally.note.empty()) print_row(tally);
      all_good = all_good && good(tally);
    } catch (const std::exception& error) {
      lab.complaints.push_back(fmt::format("fault {}: {}", i + 1, error.what()));
    }
  print_damage(lab);
  for (const std::string& complaint : lab.complaints) fmt::print(stderr, "not as promised: {}\n", complaint);
  fmt::print("{}\n", all_good && lab.complaints.empty() ? "all as promised" : "NOT as promised");
  return all_good && lab.complaints.empty() ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::string(argv[1]) == "--quick";
  const bool load = argc > 1 && std::string(argv[1]) == "--load";
  const int first = quick || load ? 2 : 1;
  if (argc <= first) {
    fmt::print(stderr, "usage: seamline_faults [--quick | --load] PROGRAM [FOLDER [FIRST]]\n");
    return 2;
  }
  const std::filesystem::path program = std::filesystem::absolute(argv[first]);
  const std::filesystem::path folder =
      std::filesystem::absolute(argc > first + 1 ? argv[first + 1] : "test-output/faults");
  try {
    if (load) return measure_load(program, folder);
    Lab lab = open_lab(program, SEAMLINE_CLOCK_SHIM, folder, quick);
    return try_all(lab, argc > first + 2 ? std::stoul(argv[first + 2]) - 1 : 0);
  } catch (const std::exception& error) {
    fmt::print(stderr, "seamline_faults: {}\n", error.what());
    return 2;
  }
}
