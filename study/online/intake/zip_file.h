#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace seamline::study::online {

/// A file in a ZIP archive.
struct ZippedFile {
  std::string name;  ///< with folders, as the archive has it; never a place to write to
  std::string bytes;
};

/// Whether bytes begin as a ZIP archive does.
[[nodiscard]] bool is_zip(std::string_view bytes);

/// The files of an archive that `wanted` says yes to, in the archive's order: stored or deflated, with the
/// right CRC-32, together at most `limits::largest_text_file_bytes`. `archive` is what complaints name.
/// Throws InputError where the archive is damaged, encrypted or packed otherwise. (PKWARE's
/// APPNOTE.TXT, 4.3.)
[[nodiscard]] std::vector<ZippedFile> unzip(std::string_view bytes, const std::filesystem::path& archive,
                                            const std::function<bool(const std::string& name)>& wanted);

}  // namespace seamline::study::online
