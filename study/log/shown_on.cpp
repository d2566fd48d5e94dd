#include "study/log/shown_on.h"

#include "study/log/log_database.h"
#include "study/log/log_values.h"

namespace seamline::study {

std::map<std::string, ShownOn> read_displays(const std::filesystem::path& log) {
  SQLite::Database database = open_log_database(log, LogAccess::read);
  return with_log_errors(log, [&] {
    SQLite::Statement row(database, R"sql(
        SELECT code, mode_width_px, mode_height_px, viewing_distance_mm, pixels_per_degree
        FROM displays JOIN sessions USING (session) JOIN participants USING (participant)
        ORDER BY session)sql");
    const LogValues values(row, log, "displays");
    std::map<std::string, ShownOn> displays;
    constexpr double most = 1e9;
    while (row.executeStep())
      displays[values.code(0)] = {.mode_width_px = values.number(1, 0),
                                  .mode_height_px = values.number(2, 0),
                                  .viewing_distance_mm = values.real(3, 0, most),
                                  .pixels_per_degree = values.real(4, 0, most)};
    return displays;
  });
}

}  // namespace seamline::study
