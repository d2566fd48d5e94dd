#pragma once
#include <filesystem>
#include <string>

namespace seamline::renderer {

/// This process' part in rendering a set. Processes that render with the same inputs (shards, or the same
/// command twice) share a set; one with other inputs would write other pictures under the same names, and is
/// refused. `SET/records/rendered-with` holds the hash of the inputs and a lock that everybody shares who
/// renders with them; the kernel frees it when the process ends, however it ends. Where the file system knows
/// no locks nothing is refused.
class SetClaim {
 public:
  /// Throws InputError when somebody is rendering the set with other inputs, or the file cannot be written.
  SetClaim(const std::filesystem::path& set_folder, const std::string& inputs);
  ~SetClaim();
  SetClaim(const SetClaim&) = delete;
  SetClaim& operator=(const SetClaim&) = delete;

 private:
  int descriptor_ = -1;
};

}  // namespace seamline::renderer
