#include "commands/options/output_files.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "support/files/held/written_files.h"

namespace seamline {

void require_outputs(const CLI::App& command, std::initializer_list<const char*> outputs) {
  std::vector<OptionFile> written, read;
  for (const CLI::Option* option : command.get_options()) {
    if (option->count() == 0) continue;
    const std::string field = (option->get_positional() ? "" : "--") + option->get_single_name();
    const bool is_output = std::find(outputs.begin(), outputs.end(), field) != outputs.end();
    for (const std::string& value : option->results()) {
      std::error_code error;
      if (is_output)
        written.push_back({field, value});
      else if (std::filesystem::is_regular_file(value, error))
        read.push_back({field, value});
    }
  }
  require_outputs(written, read);
}

}  // namespace seamline
