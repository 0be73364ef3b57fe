#include "view/server.h"

#include "pt/end_of_program.h"
#include "view/page.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <httplib.h>
#include <sys/random.h>

namespace view {

namespace {

using httplib::Request;
using httplib::Response;

constexpr std::size_t kMaxBody = 1024;  // requests have none

void refuse(Response& response, int status, const std::string& sentence) {
  response.status = status;
  response.set_content(sentence + "\n", "text/plain; charset=utf-8");
}

// Compares in a time that does not tell where the texts differ.
bool is_same(const std::string& a, const std::string& b) {
  unsigned difference = a.size() == b.size() ? 0 : 1;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
  }
  return difference == 0;
}

// Why a request is not answered; empty: it is. A page of the web can send requests to this port, also under a name of its own
// (DNS rebinding), but cannot know the token, and says where it comes from.
std::string objection(const Request& request, const std::string& token, int port) {
  const auto is_ours = [&](const std::string& host) {
    return host == fmt::format("127.0.0.1:{}", port) || host == fmt::format("localhost:{}", port);
  };
  if (request.method != "GET") return "only GET is answered here";
  if (!is_ours(request.get_header_value("Host"))) return "this address belongs to another host";
  const std::string origin = request.get_header_value("Origin");
  if (!origin.empty() && !(origin.starts_with("http://") && is_ours(origin.substr(7)))) {
    return "a page of another origin cannot ask here";
  }
  const std::string site = request.get_header_value("Sec-Fetch-Site");
  if (!site.empty() && site != "same-origin" && site != "none") {
    return "a page of another site cannot ask here";
  }
  if (request.get_param_value_count("token") != 1 ||
      !is_same(request.get_param_value("token"), token)) {
    return "the token is missing; open the address that ./run view prints";
  }
  return "";
}

void answer(const Served& served, const std::string& what, const Request& request,
            Response& response) {
  Child* child = served.own;
  std::map<std::string, std::string> query;
  for (const auto& [name, value] : request.params) {
    if (name == "token") continue;
    if (name == "from") {
      child = value == "reference" ? served.reference : served.own;
    } else if (!query.emplace(name, value).second) {
      return refuse(response, 400, "'" + pt::printable(name) + "' is given twice");
    }
  }
  if (child == nullptr) return refuse(response, 400, "there is no reference beside these tasks");
  try {
    const bool is_file = what == "exr";
    const Reply reply = child->ask(is_file ? "picture" : what, query);
    const std::string state =
        reply.state.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    if (is_file) {
      response.set_content(exr_of(reply), "image/x-exr");
    } else if (reply.bytes.empty()) {
      response.set_content(state, "application/json");
    } else {
      response.set_header("X-State", state);
      response.set_content(reply.bytes, "application/octet-stream");
    }
  } catch (const ChildEnded& ended) {
    refuse(response, 503, pt::sentence_of(ended));
  } catch (const std::exception& error) {
    refuse(response, 400, pt::sentence_of(error));
  }
}

}  // namespace

std::string random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getentropy(bytes.data(), bytes.size()) != 0) {
    throw pt::Error("the system has no random numbers for a token");
  }
  std::string text;
  for (const unsigned char byte : bytes) text += fmt::format("{:02x}", byte);
  return text;
}

Server::Server(Served served)
    : served_(std::move(served)), http_(std::make_unique<httplib::Server>()) {
  http_->set_default_headers({{"Cache-Control", "no-store"},
                              {"X-Content-Type-Options", "nosniff"},
                              {"Referrer-Policy", "no-referrer"},
                              {"X-Frame-Options", "DENY"},
                              {"Cross-Origin-Resource-Policy", "same-origin"}});
  http_->set_payload_max_length(kMaxBody);
  http_->set_keep_alive_timeout(1);
  http_->set_tcp_nodelay(true);
  http_->set_pre_routing_handler([this](const Request& request, Response& response) {
    const std::string why = objection(request, served_.token, port_);
    if (why.empty()) return httplib::Server::HandlerResponse::Unhandled;
    refuse(response, 403, why);
    return httplib::Server::HandlerResponse::Handled;
  });
  http_->Get("/", [this](const Request&, Response& response) {
    response.set_content(served_.page, "text/html; charset=utf-8");
  });
  for (const char* what : {"scene", "picture", "exr", "paths", "disk", "tree", "ray", "depth"}) {
    http_->Get(std::string("/") + what, [this, what](const Request& request, Response& response) {
      answer(served_, what, request, response);
    });
  }
  http_->Get("/saved", [this](const Request&, Response& response) {
    const Live::State state = served_.live == nullptr ? Live::State{} : served_.live->state();
    const nlohmann::json told{{"saves", state.saves}, {"error", pt::printable(state.error)}};
    response.set_content(told.dump(), "application/json");
  });
  http_->set_error_handler([](const Request&, Response& response) {
    if (response.body.empty()) refuse(response, response.status, "there is nothing here");
  });
}

Server::~Server() = default;

int Server::bind(int port) {
  if (port == 0) {
    port_ = http_->bind_to_any_port("127.0.0.1");
  } else {
    port_ = http_->bind_to_port("127.0.0.1", port) ? port : -1;
  }
  if (port_ <= 0) {
    throw pt::Error(
        fmt::format("port {} of 127.0.0.1 is taken; give another one with --port, or none", port));
  }
  return port_;
}

std::string Server::address() const {
  return fmt::format("http://127.0.0.1:{}/?token={}", port_, served_.token);
}

void Server::listen() { http_->listen_after_bind(); }
void Server::stop() { http_->stop(); }

}  // namespace view
