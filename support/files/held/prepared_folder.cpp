#include "support/files/held/prepared_folder.h"

#include <unistd.h>

#include "support/files/atomic_file.h"

namespace seamline {
namespace fs = std::filesystem;

PreparedFolder::PreparedFolder(const fs::path& folder) {
  std::error_code error;
  for (fs::path path = folder; !path.empty() && !fs::exists(path, error); path = path.parent_path())
    made_.push_back(path);
  prepare_output_folder(folder);
}

PreparedFolder::~PreparedFolder() {
  for (const fs::path& path : made_) ::rmdir(path.c_str());  // fails where anything is in it
}

}  // namespace seamline
