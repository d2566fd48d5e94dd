#pragma once
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "study/online/serving/http_request.h"

namespace seamline::study::online {

/// What a page that `seamline export web` wrote consists of, and what its study.json says.
struct SiteFiles {
  std::map<std::string, std::shared_ptr<const SentFile>>
      by_path;  ///< "/index.html", "/"; nothing else is sent
  std::string study_name, study_hash, set_hash;
  int slots = 0;  ///< orders that the page has
  bool pilot = false;
  bool adaptive = false;
  bool recruited = false;                         ///< of a study with [recruitment]
  std::vector<std::string> identifiers;           ///< that the page reads in the link
  std::map<std::string, std::string> picture_of;  ///< by "kind stimulus_id": for `/api/next`
};

/// Reads `files.json` of a folder and every file that it names, which stay as they are now, whatever becomes
/// of the folder. Throws InputError when the folder is none of export's, was exported for another host, or a
/// file is missing, leads out of the folder, or has another size or hash.
[[nodiscard]] SiteFiles read_site_files(const std::filesystem::path& folder);

}  // namespace seamline::study::online
