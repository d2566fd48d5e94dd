#pragma once
#include <string>

namespace seamline::study::online {

/// A configuration for nginx before a server on this computer: TLS, sizes, rates and times for a network that
/// anybody can reach. The host's name and its certificate are the reader's to fill in.
[[nodiscard]] std::string nginx_configuration(int port);

}  // namespace seamline::study::online
