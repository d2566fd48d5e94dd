#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace seamline::laboratory {

// Pages of documentation/evidence/: sentences by people, tables by the command. A line
//   <!-- coverage/by_people.csv -->
// stands before a table (up to the next empty line) that is this file. Where the file is made.csv, a sentence
// stands there: who made the page, when, and how long it took.

/// A step that was run: a row of made.csv.
struct MadeStep {
  std::string step, date, seamline, processor, threads;
  double processor_s = 0;  ///< of all threads; 0 where nobody noted it
};

/// Reads and writes made.csv; a file that is not there has no steps.
[[nodiscard]] std::vector<MadeStep> read_made(const std::filesystem::path& file);
[[nodiscard]] std::string made_csv(const std::vector<MadeStep>& steps);

/// The files that are named by the page's marks, in their order.
[[nodiscard]] std::vector<std::string> marks_of(const std::string& page);

/// The page with each marked part as its file has it. `folder` is that of the page, `name` the page's name.
/// Throws InputError where a file is not there.
[[nodiscard]] std::string with_marked_parts(const std::string& page, const std::string& name,
                                            const std::filesystem::path& folder);

/// Lines of tables (of the lines below their headings) that no mark stands before: what a page says by hand.
[[nodiscard]] std::vector<std::string> unmarked_tables(const std::string& page);

}  // namespace seamline::laboratory
