#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace seamline::study {

/// How a participant came to a study.
enum class Origin {
  window,       ///< this program's own window, or a simulated participant
  serve,        ///< a browser, from `seamline serve`
  static_host,  ///< a browser, from a host of files; the answers came by a downloaded file
  jatos         ///< a browser, from JATOS
};
/// Those that messages can say of themselves.
inline constexpr std::array<Origin, 3> every_web_origin = {Origin::serve, Origin::static_host, Origin::jatos};
inline constexpr std::array<Origin, 4> every_origin = {Origin::window, Origin::serve, Origin::static_host,
                                                       Origin::jatos};

/// "window", "serve", "static", "jatos".
[[nodiscard]] std::string_view word(Origin origin);
[[nodiscard]] std::optional<Origin> origin_from_word(std::string_view text);

}  // namespace seamline::study
