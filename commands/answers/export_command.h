#pragma once
#include <functional>
#include <string>

namespace CLI {
class App;
}

namespace seamline::study::online {

/// A page that `export` offers, too, made by a part of the house at which study/ does not look.
struct OtherPage {
  std::string flag;  ///< its option, e.g. "--x3d"
  std::function<bool()> is_asked;
  std::function<void(const std::string& source)> write;
};
/// Adds its options to the command.
using AddOtherPage = std::function<OtherPage(CLI::App& command)>;

/// Adds `export` to the program.
void add_export_command(CLI::App& app, const AddOtherPage& add_other_page);

}  // namespace seamline::study::online
