#include "stimuli/support/temporary_folder.h"

#include <cstdlib>
#include <string>
#include <system_error>

#include "stimuli/support/error.h"

namespace seamline {

TemporaryFolder::TemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "seamline-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw input_error({.file = name, .wanted = "a place for temporary files", .found = "none"});
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace seamline
