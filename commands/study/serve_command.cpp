#include "commands/study/study_commands.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "commands/options/output_files.h"
#include "study/log/online/online_log.h"
#include "study/online/serving/http_request.h"
#include "study/online/serving/nginx_configuration.h"
#include "study/online/serving/serve.h"
#include "study/online/serving/systemd_unit.h"
#include "study/online/serving/tokens.h"
#include "support/files/atomic_file.h"
#include "support/running/standard_streams.h"
#include "support/text/error.h"
#include "support/text/number_option.h"
#include "support/text/printable.h"

namespace seamline::study::online {
namespace fs = std::filesystem;
namespace {

struct ServeOptions {
  std::string folder, log, set, address = "127.0.0.1", tokens, codes, code_of, nginx, systemd, watch;
  bool list_tokens = false;
  std::vector<std::string> hosts;
  int port = 8080, make_tokens = 0;
};

void refuse_beside(const ServeOptions& options, const std::string& flag) {
  for (const auto& [given, name] :
       {std::pair(!options.folder.empty(), "a folder"), std::pair(!options.log.empty(), "--log"),
        std::pair(!options.set.empty(), "--set")})
    if (given)
      throw input_error({.field = flag, .wanted = "nothing served by the same command", .found = name});
}

/// In the order in which they were made, since nobody but the experimenter knows the words.
void list_tokens(const ServeOptions& options) {
  if (options.tokens.empty() || options.log.empty())
    throw input_error({.field = "--list-tokens",
                       .wanted = "--tokens FILE and --log LOG, which knows the used ones",
                       .found = options.tokens.empty() ? "no --tokens" : "no --log"});
  int number = 0, used = 0;
  for (const ListedInvitation& one : list_invitations(options.tokens, used_invitations(options.log))) {
    used += one.used ? 1 : 0;
    fmt::print("{:>5}  {}  {}\n", ++number, one.token_sha256.substr(0, 12), one.used ? "used" : "free");
  }
  fmt::print("{} of {} invitations are free\n", number - used, number);
}

/// The same command with whole paths, for a service that begins in another folder.
std::vector<std::string> command_of(const ServeOptions& options) {
  const auto whole = [](const std::string& path) { return fs::absolute(path).lexically_normal().string(); };
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  std::vector<std::string> command = {error ? "/usr/bin/seamline" : program.string(),
                                      "serve",
                                      whole(options.folder),
                                      "--log",
                                      whole(options.log),
                                      "--listen",
                                      options.address,
                                      "--port",
                                      std::to_string(options.port)};
  for (const auto& [flag, path] : {std::pair("--set", options.set), std::pair("--tokens", options.tokens),
                                   std::pair("--codes", options.codes), std::pair("--watch", options.watch)})
    if (!path.empty()) command.insert(command.end(), {flag, whole(path)});
  for (const std::string& host : options.hosts) command.insert(command.end(), {"--host", host});
  return command;
}

void run_serve(const ServeOptions& options) {
  for (const std::string& host : options.hosts)
    if (!is_host_name(host))
      throw input_error({.field = "--host",
                         .wanted = "a name like study.example.org, without a port",
                         .found = "\"" + printable(host, 80) + "\""});
  if (options.make_tokens > 0) {
    refuse_beside(options, "--make-tokens");
    if (options.tokens.empty())
      throw input_error(
          {.field = "--make-tokens", .wanted = "--tokens FILE for their hashes", .found = "none"});
    make_tokens(options.make_tokens, options.tokens, [](const std::vector<std::string>& tokens) {
      for (const std::string& token : tokens) fmt::print("{}\n", token);
      require_standard_output();  // else there would be hashes of invitations that nobody has
    });
    return;
  }
  if (!options.code_of.empty()) {
    refuse_beside(options, "--code-of");
    if (options.codes.empty())
      throw input_error({.field = "--code-of", .wanted = "--codes FILE that a server kept", .found = "none"});
    fmt::print("{}\n", code_of_invitation(options.codes, options.code_of));
    return;
  }
  if (options.list_tokens) return list_tokens(options);
  if (!options.codes.empty() && options.tokens.empty())
    throw input_error({.field = "--codes",
                       .wanted = "--tokens FILE, since a code is kept beside an invitation",
                       .found = "none"});
  if (!options.nginx.empty()) {
    refuse_beside(options, "--nginx");
    write_file_atomically(options.nginx, nginx_configuration(options.port, options.hosts));
    fmt::print("{}: written for port {}; fill in the host's {}certificate\n", options.nginx, options.port,
               options.hosts.empty() ? "name and " : "");
    return;
  }
  if (options.folder.empty() || options.log.empty())
    throw input_error({.field = "seamline serve",
                       .wanted = "a folder of seamline export web and --log LOG",
                       .found = options.folder.empty() ? "no folder" : "no log"});
  if (!options.systemd.empty()) {
    write_file_atomically(options.systemd, systemd_unit(command_of(options), options.log));
    fmt::print("{}: written; fill in the user\n", options.systemd);
    return;
  }
  serve({.folder = options.folder,
         .log = options.log,
         .set = options.set,
         .address = options.address,
         .port = options.port,
         .hosts = options.hosts,
         .tokens = options.tokens,
         .codes = options.codes,
         .watch = options.watch},
        [](const std::string& line) {
          fmt::print("{}\n", line);
          std::fflush(stdout);
        });
}

}  // namespace

void add_serve_command(CLI::App& app) {
  const auto options = std::make_shared<ServeOptions>();
  CLI::App* command = app.add_subcommand("serve", "host a study for browsers; answers go into a log");
  command->add_option("folder", options->folder, "what seamline export web wrote");
  command->add_option("--log", options->log, "SQLite log of answers; made when it is missing");
  command->add_option("--set", options->set, "the rendered set; else where the log says");
  add_number(*command, "--port", options->port, {0, 65535}, "0: any that is free")->capture_default_str();
  command
      ->add_option("--listen", options->address, "address of this computer; the default is for itself alone")
      ->capture_default_str();
  command->add_option("--host", options->hosts,
                      "name by which browsers reach it, like study.example.org; may be given again");
  command->add_option("--tokens", options->tokens, "hashes of invitations: only who has one may take part");
  add_number(*command, "--make-tokens", options->make_tokens, {1, 100000},
             "print so many new invitations, and add their hashes to --tokens FILE");
  command->add_option("--codes", options->codes,
                      "keep in this file whose code each invitation became; else that is known to nobody");
  command->add_option("--code-of", options->code_of,
                      "print the code of whoever came by this invitation or link, from --codes FILE");
  command->add_flag("--list-tokens", options->list_tokens,
                    "print which invitations of --tokens FILE are free, and which used in --log LOG");
  command->add_option(
      "--watch", options->watch,
      "serve /watch, a page that says who takes part, to who has the secret in this file (made "
      "when it is missing)");
  command->add_option("--systemd", options->systemd,
                      "write a unit of systemd that serves with this command's other options");
  command->add_option("--nginx", options->nginx, "write a configuration for nginx, for a wider network");
  command->callback([options, command] {
    require_outputs(*command, {"--systemd", "--nginx"}, {"--log", "--tokens", "--codes", "--watch"});
    run_serve(*options);
  });
}

}  // namespace seamline::study::online
