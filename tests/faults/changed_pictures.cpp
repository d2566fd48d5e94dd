// A picture of the set is changed, cut short or gone after the log was made.
#include <fmt/core.h>

#include <fstream>

#include "lab.h"
#include "support/arithmetic/random.h"

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

enum class Change { flipped_bit, truncated, removed };

std::string change(const fs::path& file, Change how, Random& random) {
  const auto bytes = static_cast<std::uint64_t>(fs::file_size(file));
  switch (how) {
    case Change::flipped_bit: {
      const auto at = static_cast<std::streamoff>(random.below(bytes));
      std::fstream stream(file, std::ios::in | std::ios::out | std::ios::binary);
      stream.seekg(at);
      const int byte = stream.get() ^ (1 << random.below(8));
      stream.seekp(at);
      stream.put(static_cast<char>(byte));
      return fmt::format("a bit of byte {} flipped", at);
    }
    case Change::truncated: {
      const std::uint64_t left = random.below(bytes);
      fs::resize_file(file, left);
      return fmt::format("cut to {} bytes", left);
    }
    case Change::removed:
      fs::remove(file);
      return "removed";
  }
  return "";
}

}  // namespace

Tally change_pictures(Lab& lab) {
  Tally tally{.fault = "picture changed, cut or gone after the log"};
  Random random(lab.seed, 4);
  const fs::path set = lab.folder / "changed" / "set", log = lab.folder / "changed" / "log.sqlite";
  fs::remove_all(set.parent_path());
  fs::create_directories(set.parent_path());
  fs::copy(lab.set, set, fs::copy_options::recursive);
  const Arguments session = {lab.program,  "study",   set,       "--log", log,
                             "--observer", "perfect", "--count", "2"};
  lab.completes(tally.fault, run(session));
  const std::vector<std::string> rows = rows_of(log);
  std::vector<std::string> pictures;
  for (const auto& [name, bytes] : lab.set_files)
    if (name.ends_with(".png")) pictures.push_back(name);
  for (int at = 0; at < lab.tries(1, 2 * static_cast<int>(pictures.size())); ++at) {
    const std::string& name = pictures[random.below(pictures.size())];
    const std::string how = change(set / name, static_cast<Change>(at % 3), random);
    for (const Arguments& command : {Arguments{lab.program, "verify", set}, session}) {
      const Ending ending = run(command);
      const std::string what = fmt::format("{} with {} {}", command[1], name, how);
      if (lab.refuses(what, ending) && ending.output.find(name) == std::string::npos)
        lab.complain(what + ": the sentence does not name the file", ending);
    }
    ++tally.tries;
    tally.committed += static_cast<std::int64_t>(rows.size());
    tally.lost += missing(rows, rows_of(log));
    rerun_render(lab, set, tally);
    lab.completes("study after the picture was rendered again", run(session));
  }
  return tally;
}

}  // namespace seamline::faults
