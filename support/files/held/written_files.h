#pragma once
#include <filesystem>
#include <span>
#include <string>

namespace seamline {

/// A file that a request reads or writes, and the option or setting that names it.
struct OptionFile {
  std::string field;
  std::filesystem::path path;
};

/// Before long work: every output can be written, and is none of the inputs and no other output, by whatever
/// names (links too). Leaves nothing behind. Inputs that are not there are left to their readers. Throws
/// InputError naming the output.
void require_outputs(std::span<const OptionFile> outputs, std::span<const OptionFile> inputs);

/// No two of these are one file, by whatever names.
void require_apart(std::span<const OptionFile> files);

}  // namespace seamline
