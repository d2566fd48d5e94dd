#include "support/files/held/written_files.h"

#include <cerrno>
#include <cstring>

#include "support/files/atomic_file.h"
#include "support/text/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

InputError bad_output(const OptionFile& output, const std::string& wanted, const std::string& found) {
  return input_error({.file = output.path.string(), .field = output.field, .wanted = wanted, .found = found});
}

/// Also of files that are not there yet: whole paths, since what is not there stays as it was given.
bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code error;
  if (fs::equivalent(one, other, error) && !error) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(one), error);
  if (error) return false;
  const fs::path second = fs::weakly_canonical(fs::absolute(other), error);
  return !error && first == second;
}

void require_place(const OptionFile& output) {
  std::error_code error;
  if (fs::is_directory(output.path, error)) throw bad_output(output, "a name for a file", "a folder");
  const fs::path folder = output.path.has_parent_path() ? output.path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, error))
    throw bad_output(output, "a place that can be written to", std::strerror(ENOENT));
  prepare_output_folder(folder);
}

}  // namespace

void require_outputs(std::span<const OptionFile> outputs, std::span<const OptionFile> inputs) {
  for (const OptionFile& output : outputs)
    for (const OptionFile& input : inputs)
      if (is_same_file(output.path, input.path))
        throw bad_output(output, "another file than " + input.field + ", which would be lost", "the same");
  require_apart(outputs);
  for (const OptionFile& output : outputs) require_place(output);
}

void require_apart(std::span<const OptionFile> files) {
  for (std::size_t i = 0; i < files.size(); ++i)
    for (const OptionFile& other : files.first(i))
      if (is_same_file(files[i].path, other.path))
        throw bad_output(files[i], "another file than " + other.field, "the same");
}

}  // namespace seamline
