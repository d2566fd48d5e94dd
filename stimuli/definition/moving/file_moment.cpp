#include "stimuli/definition/moving/file_moment.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>

namespace seamline::inline stimuli {
namespace {

constexpr char moment_mark = '#', time_mark = '@';

bool is_gltf(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return name.ends_with(".gltf") || name.ends_with(".glb");
}

}  // namespace

NamedFile split_moment(const std::string& written) {
  for (std::size_t mark = written.find(moment_mark); mark != std::string::npos;
       mark = written.find(moment_mark, mark + 1)) {
    if (!is_gltf(written.substr(0, mark))) continue;
    const std::size_t at = written.rfind(time_mark);
    if (at == std::string::npos || at < mark) continue;
    FileMoment moment{.animation = written.substr(mark + 1, at - mark - 1)};
    const char* const end = written.data() + written.size();
    const auto [read, error] = std::from_chars(written.data() + at + 1, end, moment.time_s);
    if (error != std::errc() || read != end || !std::isfinite(moment.time_s)) continue;
    return {.file = written.substr(0, mark), .moment = std::move(moment)};
  }
  return {.file = written};
}

std::string with_moment(const std::string& written, const FileMoment& moment) {
  return fmt::format("{}{}{}{}{}", split_moment(written).file, moment_mark, moment.animation, time_mark,
                     moment.time_s);
}

}  // namespace seamline::inline stimuli
