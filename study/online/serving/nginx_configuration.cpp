#include "study/online/serving/nginx_configuration.h"

#include <fmt/core.h>

#include <string>
#include <utility>

#include "study/online/serving/study_service.h"

namespace seamline::study::online {

std::string nginx_configuration(int port, const std::vector<std::string>& hosts) {
  constexpr const char* text =
      R"conf(# nginx before `seamline serve`, for people outside the laboratory's network. Put it into
# /etc/nginx/conf.d/seamline.conf, write the host's own name and certificate where it says @HOST@,
# start `seamline serve` with --host @HOST@ (it answers under no other name),
# and let nothing but this computer reach port @PORT@ (which is so unless seamline was given --listen).
# A class may come at once from one address; of HTTP/2, each file on its way is a connection to limit_conn. For more than
# a hundred people at a time give nginx itself 4096 worker_connections (/etc/nginx/nginx.conf).
limit_req_zone  $binary_remote_addr zone=seamline_requests:10m rate=@ADDRESS_A_SECOND@r/s;
limit_req_zone  $binary_remote_addr zone=seamline_newcomers:10m rate=@NEWCOMERS_A_SECOND@r/s;
limit_conn_zone $binary_remote_addr zone=seamline_connections:10m;

# Neither addresses nor what a link carries behind its question mark (an invitation) are kept. Every line of
# an error log has both, so only what stops nginx itself is written there.
log_format seamline '$time_iso8601 $request_method $uri $status $body_bytes_sent $request_time';

upstream seamline {
  server 127.0.0.1:@PORT@;
  keepalive 64;
}

server {
  listen 80;
  listen [::]:80;
  server_name @HOSTS@;
  access_log off;
  error_log /var/log/nginx/seamline_error.log emerg;
  return 301 https://$host$request_uri;
}

server {
  listen 443 ssl http2;
  listen [::]:443 ssl http2;
  server_name @HOSTS@;
  ssl_certificate     /etc/letsencrypt/live/@HOST@/fullchain.pem;
  ssl_certificate_key /etc/letsencrypt/live/@HOST@/privkey.pem;
  ssl_protocols       TLSv1.2 TLSv1.3;
  ssl_session_cache   shared:seamline_tls:10m;
  ssl_session_tickets off;
  add_header Strict-Transport-Security "max-age=31536000" always;

  access_log /var/log/nginx/seamline.log seamline;
  error_log  /var/log/nginx/seamline_error.log emerg;
  server_tokens off;

  client_max_body_size        1m;
  client_body_buffer_size     64k;
  client_header_timeout       15s;
  client_body_timeout         15s;
  send_timeout                60s;
  keepalive_timeout           75s;
  large_client_header_buffers 4 8k;
  http2_max_concurrent_streams 16;
  limit_conn        seamline_connections 1000;
  limit_req         zone=seamline_requests burst=@ADDRESS_AT_ONCE@ nodelay;
  limit_req_status  429;
  limit_conn_status 429;

  proxy_http_version 1.1;
  proxy_set_header   Host $http_host;
  proxy_set_header   Connection "";
  proxy_set_header   Expect "";
  proxy_request_buffering on;   # a slow browser waits here, not at seamline
  proxy_read_timeout 60s;

  location = /api/enrol {
    limit_req zone=seamline_newcomers burst=@NEWCOMERS_AT_ONCE@ nodelay;
    proxy_pass http://seamline;
  }
  location = /health {
    allow 127.0.0.1;
    allow ::1;
    deny  all;
    proxy_pass http://seamline;
  }
  location = / {
    error_page 429 502 503 504 @again;
    proxy_pass http://seamline;
  }
  # Everything else is asked for again by the page.
  location @again {
    default_type text/html;
    return 503 '<!doctype html><html lang="en"><meta http-equiv="refresh" content="5"><title>Please wait</title><p>The study cannot be reached. This page tries again by itself.';
  }
  location / {
    proxy_pass http://seamline;
  }
}
)conf";
  const ServiceLimits limits;
  const std::string host = hosts.empty() ? "study.example.org" : hosts.front();
  std::string written = text, names = host;
  for (std::size_t i = 1; i < hosts.size(); ++i) names += " " + hosts[i];
  const auto whole = [](double number) { return fmt::format("{:.0f}", number); };
  for (const auto& [place, value] : {std::pair<std::string, std::string>("@PORT@", std::to_string(port)),
                                     {"@HOSTS@", names},
                                     {"@HOST@", host},
                                     {"@ADDRESS_A_SECOND@", whole(limits.address.a_second)},
                                     {"@ADDRESS_AT_ONCE@", whole(limits.address.at_once)},
                                     {"@NEWCOMERS_A_SECOND@", whole(limits.newcomers.a_second)},
                                     {"@NEWCOMERS_AT_ONCE@", whole(limits.newcomers.at_once)}})
    for (std::size_t at = written.find(place); at != std::string::npos; at = written.find(place))
      written.replace(at, place.size(), value);
  return written;
}

}  // namespace seamline::study::online
