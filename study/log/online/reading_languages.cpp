#include "study/log/online/reading_languages.h"

#include "study/log/log_database.h"
#include "support/text/printable.h"

namespace seamline::study {

std::map<std::string, std::string> reading_languages(const std::filesystem::path& log) {
  constexpr std::size_t longest_tag = 80;
  SQLite::Database database = open_log_database(log, LogAccess::read);
  return with_log_errors(log, [&] {
    std::map<std::string, std::string> languages;
    SQLite::Statement row(database, R"sql(
        SELECT code, detail FROM events JOIN sessions USING (session) JOIN participants USING (participant)
        WHERE kind = 'language' ORDER BY event)sql");
    while (row.executeStep())
      languages[printable(row.getColumn(0).getString(), longest_tag)] =
          printable(row.getColumn(1).getString(), longest_tag);
    return languages;
  });
}

}  // namespace seamline::study
