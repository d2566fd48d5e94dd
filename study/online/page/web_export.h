#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "study/log/origin.h"

namespace seamline::study::online {

/// What `seamline export web SET DIR` asks for.
struct WebRequest {
  std::filesystem::path set_folder = {};
  std::filesystem::path out_folder = {};  ///< not there yet, or empty
  std::optional<int> slots = {};          ///< orders that participants get; none: the study's, else 200
  Origin host = Origin::static_host;      ///< what will host it, the only thing that its page talks to
  bool pilot = false;                     ///< everybody is a trial run
};

struct WebSummary {
  int slots = 0;
  bool adaptive = false;  ///< no trials are planned: `seamline serve` places them
  /// Orders follow from a seed so small that all can be tried: two files of orders give the set's list away.
  bool guessable_orders = false;
  int pictures = 0;
  int files = 0;
  std::int64_t bytes = 0;
  std::vector<std::string> drafts = {};  ///< languages that a machine translated, and no speaker has checked
};

/// Writes a folder that shows the study in a browser: whole or not at all, the same bytes for the same set,
/// request and program. Throws InputError when the program was built without the page, the set is not whole,
/// the shipped consent text would be shown to somebody who is no pilot, the study is adaptive and `serve` not
/// its host, there are more slots than orders, or the folder holds something.
[[nodiscard]] WebSummary export_web(const WebRequest& request);

}  // namespace seamline::study::online
