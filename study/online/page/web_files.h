#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace seamline::study::online {

/// A file of an exported page as `files.json` lists it: who serves the folder serves nothing else.
struct WebFile {
  std::int64_t bytes = 0;
  std::string sha256;
};

/// The files of a page that is being written, by name: relative, `/` between folders.
class WebFiles {
 public:
  /// `folder` exists and is empty.
  explicit WebFiles(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Writes a file, once. Throws InputError when it cannot be written.
  void add(const std::string& name, std::string_view bytes);

  /// Adds `FOLDER/<first 24 digits of the bytes' SHA-256>ENDING` unless it is there, and returns its name:
  /// what is the same is there once, and the name says nothing else about it.
  [[nodiscard]] std::string add_by_content(const std::string& folder, std::string_view bytes,
                                           const std::string& ending);

  /// Everything in the folder bears the time of this call: hosts say when a file was last changed, and that
  /// would be the order in which pictures were made.
  void give_one_time() const;

  [[nodiscard]] const std::map<std::string, WebFile>& files() const { return files_; }

  /// `files.json`: every file with its size and SHA-256, in the order of their names.
  [[nodiscard]] std::string index_text() const;

 private:
  std::filesystem::path folder_;
  std::map<std::string, WebFile> files_;
};

}  // namespace seamline::study::online
