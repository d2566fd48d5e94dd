#pragma once
#include <string>
#include <vector>

namespace seamline::study::online {

/// A configuration for nginx before a server on this computer: TLS, sizes, rates and times for a network that
/// anybody can reach. Without `hosts`, the server's names (the first is the certificate's), study.example.org
/// stands for the reader's own; the certificate is theirs to make.
[[nodiscard]] std::string nginx_configuration(int port, const std::vector<std::string>& hosts = {});

}  // namespace seamline::study::online
