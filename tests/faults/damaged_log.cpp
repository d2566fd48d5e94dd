// Logs whose files were cut short, or lost bits or whole pages.
#include <fmt/core.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <sstream>

#include "compare.h"
#include "damage.h"
#include "support/arithmetic/random.h"

namespace seamline::faults {
namespace fs = std::filesystem;
namespace {

void overwrite(const fs::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

std::string flip_bit(std::string bytes, Random& random) {
  char& byte = bytes[random.below(bytes.size())];
  byte = static_cast<char>(byte ^ (1 << random.below(8)));
  return bytes;
}

std::string lose_page(std::string bytes, Random& random) {
  const std::uint64_t page = random.below(bytes.size() / page_bytes);
  std::fill_n(bytes.begin() + static_cast<std::ptrdiff_t>(page * page_bytes), page_bytes, '\0');
  return bytes;
}

std::string cut(const std::string& bytes, Random& random) {
  return bytes.substr(0, 1 + random.below(bytes.size() - 1));
}

/// Refused with a sentence, or done; never anything else.
bool is_refused(Lab& lab, const std::string& what, const Arguments& command) {
  const Ending ending = run(command);
  return ending.status != 0 && (lab.refuses(what, ending), true);
}

std::vector<std::string> rows_if_readable(const fs::path& log) {
  try {
    return rows_of(log);
  } catch (const std::exception&) {
    return {};
  }
}

/// What is saved is sound, says what is lost, and can be analysed; the damaged files stay as they are.
void recover(Lab& lab, const fs::path& log, Damage& damage, bool analyse) {
  const fs::path saved = lab.folder / "recovered.sqlite";
  remove_log(saved);
  const std::string before = bytes_of(log);
  Ending ending = run({lab.program, "log", "recover", log, saved});
  if (ending.status == 1 && ending.output.find("--set") != std::string::npos)
    ending = run({lab.program, "log", "recover", log, saved, "--set", lab.answered_set});
  if (bytes_of(log) != before) lab.complain(damage.what + ": recovery touched the damaged file", ending);
  if (ending.status != 0) {
    ++damage.nothing_recovered;
    if (lab.refuses(damage.what + ", log recover", ending) && fs::exists(saved))
      lab.complain(damage.what + ": a refused recovery left a file", ending);
    return;
  }
  if (!is_sound(saved)) lab.complain(damage.what + ": the recovered log is unsound", ending);
  const std::vector<std::string> answers = answers_of(saved);
  const std::int64_t gone = missing(lab.log_answers, answers);
  damage.recovered += static_cast<std::int64_t>(lab.log_answers.size()) - gone;
  const auto without_code = std::count_if(answers.begin(), answers.end(), [](const std::string& answer) {
    return answer.find("code=recovered-") != std::string::npos;
  });
  damage.without_code += without_code;
  damage.changed += missing(answers, lab.log_answers) - without_code;
  if (gone > 0 && ending.output.find("lost") == std::string::npos)
    lab.complain(damage.what + ": answers are lost and nothing says so", ending);
  if (!analyse || answers.empty()) return;
  const Ending report = run(lab.analyze_command(saved, lab.folder / "recovered-report"));
  if (report.status != 0) lab.refuses(damage.what + ", analyze of the recovered log", report);
}

}  // namespace

Damage damage_log(Lab& lab, const std::string& how) {
  Damage damage{.what = how};
  Random random(lab.seed, 100 + how.size());
  const fs::path log = lab.folder / "damaged.sqlite";
  const std::string whole = bytes_of(lab.log);
  for (int at = 0; at < lab.tries(1, 60); ++at) {
    remove_log(log);
    overwrite(log, how == "bit flipped" ? flip_bit(whole, random)
                   : how == "page lost" ? lose_page(whole, random)
                                        : cut(whole, random));
    ++damage.tries;
    damage.answers += static_cast<std::int64_t>(lab.log_answers.size());
    const bool refused = is_refused(lab, how + ", log status", {lab.program, "log", "status", log});
    damage.refused += refused ? 1 : 0;
    if (!refused && rows_if_readable(log) != lab.log_rows) ++damage.unnoticed;
    const bool now_and_then = at % 20 == 1;
    recover(lab, log, damage, now_and_then);
    if (now_and_then)
      is_refused(lab, how + ", analyze", lab.analyze_command(log, lab.folder / "damaged-report"));
    is_refused(lab, how + ", study",
               lab.study_command(log));  // the last: it writes into what it takes for whole
  }
  return damage;
}

}  // namespace seamline::faults
