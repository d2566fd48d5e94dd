#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "study/online/serving/http_server.h"
#include "study/online/serving/study_service.h"

namespace seamline::study::online {

/// What `seamline serve DIR --log LOG` asks for.
struct ServeRequest {
  std::filesystem::path folder = {};  ///< of export's
  std::filesystem::path log = {};
  std::filesystem::path set = {};  ///< empty: where the log says
  std::string address = "127.0.0.1";
  int port = 8080;
  std::vector<std::string> hosts = {};  ///< names by which browsers reach it, besides its address
  std::filesystem::path tokens = {};    ///< empty: nobody needs an invitation
  std::filesystem::path codes = {};     ///< where codes are kept beside invitations; empty: nowhere
  std::filesystem::path watch = {};     ///< the secret of the experimenter's page; empty: there is none
  HttpLimits http = {};
  ServiceLimits service = {};
};

/// Serves until the person asks to stop (Ctrl-C, SIGTERM); what came in is stored then. `say` gets lines for
/// whoever looks after the server, without a word about participants. Throws InputError when the page, the
/// set and the log do not belong together, or the port is taken.
void serve(const ServeRequest& request, const std::function<void(const std::string&)>& say);

}  // namespace seamline::study::online
