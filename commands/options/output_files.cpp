#include "commands/options/output_files.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "raytracer/scene/gltf/gltf_uri.h"
#include "support/files/held/written_files.h"
#include "support/text/limits.h"

namespace seamline {
namespace fs = std::filesystem;
namespace {

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

/// The text of a file that may name others; of a .glb its JSON, which comes before megabytes of numbers.
std::string text_of(const fs::path& file) {
  std::error_code error;
  auto size = fs::file_size(file, error);
  if (error) return {};
  std::ifstream in(file, std::ios::binary);
  if (file.extension() == ".glb") {
    constexpr std::size_t length_at = 12, head_bytes = 20;  // glTF 2.0, section 4.4
    std::array<unsigned char, head_bytes> head{};
    if (!in.read(reinterpret_cast<char*>(head.data()), head_bytes)) return {};
    std::uintmax_t length = 0;
    for (std::size_t i = 4; i-- > 0;) length = 256 * length + head[length_at + i];
    size = std::min(size - head_bytes, length);
  }
  std::string text(size > limits::largest_scene_file_bytes ? 0 : size, ' ');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  return text;
}

/// Files that a scene or a table of objects names: what stands in quotes there, and is a file seen from its
/// folder. It is not parsed, since whoever reads it says what is wrong with it.
std::vector<fs::path> files_named_in(const fs::path& file) {
  const fs::path ending = file.extension();
  const bool is_table = ending == ".toml";
  if (!is_table && ending != ".gltf" && ending != ".glb") return {};
  const std::string text = text_of(file);
  constexpr std::size_t longest_name = 4096;
  std::vector<fs::path> named;
  for (std::size_t start = text.find('"'); start != std::string::npos; start = text.find('"', start + 1)) {
    const std::size_t end = text.find('"', start + 1);
    if (end == std::string::npos || end - start > longest_name) continue;
    const std::string name = text.substr(start + 1, end - start - 1);
    if (name.find('.') == std::string::npos || name.find('\0') != std::string::npos) continue;
    const fs::path path = file.parent_path() / (is_table ? name : renderer::file_of_uri(name));
    if (!is_file(path)) continue;
    named.push_back(path);
    if (is_table && path.extension() != ending)  // a table that names itself
      for (const fs::path& inside : files_named_in(path)) named.push_back(inside);
  }
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

void add_read(const OptionFile& value, std::vector<OptionFile>& read) {
  read.push_back(value);
  for (const fs::path& named : files_named_in(value.path))
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
      add_read(value, read);
  }
  require_apart(made_files);
  require_outputs(written, read);
}

void require_outputs_in_folder(const CLI::App& command, std::initializer_list<const char*> files) {
  const std::string folder = command.get_option("--out")->as<std::string>();
  std::error_code error;
  if (!fs::is_directory(folder, error)) return;
  std::vector<OptionFile> written, read;
  for (const char* file : files) written.push_back({"--out", fs::path(folder) / file});
  for (const OptionFile& value : given_values(command))
    if (is_file(value.path)) add_read(value, read);
  require_outputs(written, read);
}

}  // namespace seamline
