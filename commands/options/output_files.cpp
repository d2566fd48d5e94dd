#include "commands/options/output_files.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "composites/objects/objects_file.h"
#include "raytracer/scene/gltf/gltf_load.h"
#include "support/files/held/written_files.h"
#include "support/text/error.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// Files that a table of objects names, and those that these name.
std::vector<fs::path> files_of_objects(const fs::path& file, const fs::path& asset_root) {
  std::vector<fs::path> named;
  try {
    named = renderer::files_named_by(renderer::read_objects_file(file, asset_root));
  } catch (const InputError&) {
    return {};  // whoever reads it says what is wrong with it
  }
  for (std::size_t i = 0, count = named.size(); i < count; ++i)
    for (const fs::path& inside : renderer::files_named_by_gltf(named[i])) named.push_back(inside);
  return named;
}

bool is_one_of(const std::string& field, std::initializer_list<const char*> options) {
  return std::find(options.begin(), options.end(), field) != options.end();
}

/// Every value of the options that were given, in their order.
std::vector<OptionFile> given_values(const CLI::App& command) {
  std::vector<OptionFile> given;
  for (const CLI::Option* option : command.get_options())
    if (option->count() > 0)
      for (const std::string& value : option->results())
        given.push_back({(option->get_positional() ? "" : "--") + option->get_single_name(), value});
  return given;
}

/// A file that is read, and those that it names.
void add_read(const CLI::App& command, const OptionFile& value, std::vector<OptionFile>& read) {
  read.push_back(value);
  const CLI::Option* root = command.get_option_no_throw("--asset-root");
  const fs::path asset_root = root != nullptr && root->count() > 0 ? root->as<std::string>() : std::string();
  for (const fs::path& named : value.field == "--objects" ? files_of_objects(value.path, asset_root)
                                                          : renderer::files_named_by_gltf(value.path))
    read.push_back({"one that " + value.field + " names", named});
}

}  // namespace

void require_outputs(const CLI::App& command, std::initializer_list<const char*> outputs,
                     std::initializer_list<const char*> made) {
  std::vector<OptionFile> written, read, made_files;
  for (const OptionFile& value : given_values(command)) {
    if (is_one_of(value.field, made)) made_files.push_back(value);
    if (is_one_of(value.field, outputs))
      written.push_back(value);
    else if (is_one_of(value.field, made) || is_file(value.path))
      add_read(command, value, read);
  }
  require_apart(made_files);
  require_outputs(written, read);
}

void require_outputs_in_folder(const CLI::App& command, std::initializer_list<const char*> files) {
  require_outputs_in_folder(command, std::vector<std::string>(files.begin(), files.end()));
}

void require_outputs_in_folder(const CLI::App& command, std::span<const std::string> files) {
  const std::string folder = command.get_option("--out")->as<std::string>();
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  std::vector<OptionFile> written, read;
  for (const std::string& file : files) written.push_back({"--out", fs::path(folder) / file});
  for (const OptionFile& value : given_values(command))
    if (is_file(value.path)) add_read(command, value, read);
  require_outputs(written, read);
}

}  // namespace seamline
