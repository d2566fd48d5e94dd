#include "study/online/serving/systemd_unit.h"

#include <fmt/core.h>

namespace seamline::study::online {
namespace {

/// systemd.service(5): quoted, with % and $ doubled.
std::string unit_word(const std::string& word) {
  std::string quoted = "\"";
  for (const char letter : word) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    if (letter == '%' || letter == '$') quoted += letter;
    quoted += letter;
  }
  return quoted + "\"";
}

}  // namespace

std::string systemd_unit(const std::vector<std::string>& command, const std::filesystem::path& log) {
  std::string line;
  for (const std::string& word : command) line += (line.empty() ? "" : " ") + unit_word(word);
  std::string folder = std::filesystem::absolute(log).lexically_normal().parent_path().string();
  for (std::size_t at = folder.find('%'); at != std::string::npos; at = folder.find('%', at + 2))
    folder.insert(at, "%");
  return fmt::format(
      R"unit(# `seamline serve` as a service. Put this into /etc/systemd/system/seamline.service, write the user whose log it
# is where it says CHANGE-ME, then: systemctl daemon-reload && systemctl enable --now seamline
[Unit]
Description=Seamline serves a study
After=network-online.target
Wants=network-online.target

[Service]
User=CHANGE-ME
ExecStart={}
Restart=on-failure
RestartSec=2
KillSignal=SIGTERM
TimeoutStopSec=30
UMask=0077
LimitNOFILE=16384
NoNewPrivileges=yes
PrivateTmp=yes
PrivateDevices=yes
ProtectSystem=strict
ProtectHome=read-only
ReadWritePaths="{}"
RestrictAddressFamilies=AF_INET AF_INET6 AF_UNIX

[Install]
WantedBy=multi-user.target
)unit",
      line, folder);
}

}  // namespace seamline::study::online
