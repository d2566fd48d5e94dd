#pragma once
#include <filesystem>
#include <functional>
#include <string>

namespace seamline::study::online {

/// A session whose pictures another program shows.
struct AskRequest {
  std::filesystem::path source;  ///< a rendered set; or a study file, whose stimuli the other program makes
  std::filesystem::path log;     ///< made when it is missing
  std::string participant;       ///< code
  bool pilot = false;
};

/// The next line, without its end; false when there is none. And what takes a line.
using LineSource = std::function<bool(std::string&)>;
using LineSink = std::function<void(const std::string&)>;

/// Asks and is told, a line of JSON each (documentation/how-to/other_programs.md): writes the question that
/// is due, reads its answer, stores it, and goes on until the session is over or the lines end. Every answer
/// is on the disk before the next question is written, and an adaptive question before it is asked, so that
/// the same call goes on there. A line that is no answer is said to be so and asked for again. Throws
/// InputError as LogWriter does.
void ask(const AskRequest& request, const LineSource& hear_line, const LineSink& say_line);

}  // namespace seamline::study::online
