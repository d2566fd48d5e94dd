// A log, as a SQLite file. The first byte says what the others are: a whole file; changes of single bytes of
// a good log (place in 3 bytes, value in 1), perhaps cut; or values written into its tables past their
// CHECKs.
#include <SQLiteCpp/SQLiteCpp.h>

#include <fstream>
#include <iterator>

#include "fuzz/fuzz_target.h"
#include "study/log/log.h"
#include "study/log/log_admin.h"
#include "study/log/log_database.h"

namespace seamline {
using namespace study;
namespace {

constexpr const char* rows = R"sql(
  INSERT INTO study VALUES (1, 'fuzz', 'h', 's', '/nowhere', 'format = "seamline study 1"', '0', 'depth_width_px', 'falls');
  INSERT INTO stimuli VALUES (0, 'room-shadow-a-0064', 'room', 'shadow', 'a', 2, 64, 0, '0', '', 64),
                             (1, 'room-overlap-b-0512', 'room', 'overlap', 'b', 3, 512, 0, '0', 'soft', 512);
  INSERT INTO participants VALUES (1, 'p01', 0, 0, 0, 1, NULL, NULL, NULL),
                                  (2, 'sim-1', 1, 0, 0, 1, 'threshold', 7, NULL);
  INSERT INTO sessions VALUES (1, 1, 100, 200, 0, 0, '0'), (2, 2, 100, 200, 0, 0, '0');
  INSERT INTO form_answers VALUES (1, 'age', '30');
  INSERT INTO trials VALUES (1, 0, 'stimulus', 0), (1, 1, 'attention', 1), (1, 2, 'reference', 0), (2, 0, 'stimulus', 1);
  INSERT INTO answers VALUES (1, 0, 1, 2, 4, 10, 20, 1.0), (1, 1, 1, 3, 1, 10, 20, 1.0), (1, 2, 1, 1, 2, 10, 20, 1.0),
                             (2, 0, 2, 3, 1, 0, 0, 1.0);
  INSERT INTO declines VALUES (1, 5);
  INSERT INTO deletions VALUES (1, 6, 7);
)sql";

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

const std::string& good_log() {
  static const std::string made = [] {
    const std::filesystem::path path = fuzz::folder() / "good.sqlite";
    {
      SQLite::Database database(path.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
      database.exec("PRAGMA page_size = 1024");
      database.exec(log_schema_sql());
      database.exec(rows);
    }
    return bytes_of(path);
  }();
  return made;
}

std::string patched(std::string_view changes) {
  std::string log = good_log();
  while (changes.size() >= 4) {
    const auto byte = [&](std::size_t at) {
      return static_cast<std::size_t>(static_cast<unsigned char>(changes[at]));
    };
    const std::size_t place = byte(0) | byte(1) << 8 | byte(2) << 16;
    log[place % log.size()] = changes[3];
    changes.remove_prefix(4);
  }
  if (changes.size() == 2) log.resize(log.size() * static_cast<unsigned char>(changes[0]) / 256);
  return log;
}

/// Every row that `read_log` reads, with values of its type that the tables would not let in.
constexpr const char* hostile_writes[] = {"UPDATE answers SET chosen_index = ?",
                                          "UPDATE answers SET rating = ?",
                                          "UPDATE answers SET choice_ns = ?",
                                          "UPDATE answers SET rating_ns = ?",
                                          "UPDATE answers SET image_scale = ?",
                                          "UPDATE stimuli SET object_index = ?",
                                          "UPDATE stimuli SET depth_width_px = ?",
                                          "UPDATE stimuli SET artifact = ?",
                                          "UPDATE stimuli SET condition = ?",
                                          "UPDATE stimuli SET level = ?",
                                          "UPDATE study SET quantity = ?",
                                          "UPDATE study SET noticeability = ?",
                                          "UPDATE trials SET kind = ?",
                                          "UPDATE participants SET code = ?",
                                          "UPDATE participants SET slot = ?",
                                          "UPDATE sessions SET last_unix_s = ?",
                                          "UPDATE participants SET observer = ?",
                                          "UPDATE participants SET seed = ?",
                                          "UPDATE participants SET image_gain = ?",
                                          "UPDATE OR IGNORE trials SET trial_index = ?",
                                          "UPDATE form_answers SET value = ?",
                                          "UPDATE study SET set_folder = ?",
                                          "UPDATE study SET study_text = ?"};

void write_past_checks(const std::filesystem::path& path, std::string_view values) {
  SQLite::Database database(path.string(), SQLite::OPEN_READWRITE);
  database.exec("PRAGMA ignore_check_constraints = ON; PRAGMA synchronous = OFF; PRAGMA journal_mode = OFF");
  while (values.size() >= 2) {
    const auto which = static_cast<unsigned char>(values[0]) % std::size(hostile_writes);
    const std::size_t bytes = std::min<std::size_t>(static_cast<unsigned char>(values[1]), values.size() - 2);
    const std::string value(values.substr(2, bytes));
    values.remove_prefix(2 + bytes);
    try {
      SQLite::Statement write(database, hostile_writes[which]);
      write.bind(1, value);  // STRICT turns it into the column's type, or refuses it
      write.exec();
    } catch (const SQLite::Exception&) {
      continue;
    }
  }
}

std::filesystem::path log_of(std::string_view input) {
  if (input.empty() || input.front() % 3 == 0)
    return fuzz::file_of("log.sqlite", input.substr(std::min<std::size_t>(1, input.size())));
  if (input.front() % 3 == 1) return fuzz::file_of("log.sqlite", patched(input.substr(1)));
  const std::filesystem::path path = fuzz::file_of("log.sqlite", good_log());
  write_past_checks(path, input.substr(1));
  return path;
}

}  // namespace
}  // namespace seamline

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace seamline;
  for (const char* suffix : {"-wal", "-shm", "-journal"})
    std::filesystem::remove(fuzz::folder() / (std::string("log.sqlite") + suffix));
  const std::filesystem::path path = log_of(fuzz::text_of(data, size));
  return fuzz::only_input_errors([&] {
    const LogContents log = read_log(path);
    for (const Answer& answer : log.answers)
      if (answer.chosen_index < 1 || answer.chosen_index > 3 || answer.rating < 1 || answer.rating > 4 ||
          answer.object_index < 1 || answer.object_index > 3 || answer.depth_width_px < 2 ||
          !(answer.level >= 0 && answer.level <= 16384))
        abort();
    if (status_text(log).empty()) abort();
  });
}
