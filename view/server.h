#pragma once

#include "view/live.h"

#include <memory>
#include <string>

namespace httplib {
class Server;
}

namespace view {

// The children that answer, and the page that asks.
struct Served {
  std::string page;            // HTML
  std::string token;           // in every request
  Child* own = nullptr;        // the tasks that are looked at
  Child* reference = nullptr;  // beside them; none: they are the reference
  Live* live = nullptr;        // compiles them when they are saved; none: nothing is watched
};

// A server for one person on this machine. It answers a request only with the token, addressed to this host, and not from a page
// of another origin.
class Server {
 public:
  explicit Server(Served served);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  // Returns the port. Throws pt::Error if 127.0.0.1 has none; port 0: any.
  int bind(int port);
  std::string address() const;

  void listen();  // until stop()
  void stop();

 private:
  Served served_;
  int port_ = 0;
  std::unique_ptr<httplib::Server> http_;
};

// 128 random bits, as text.
std::string random_token();

}  // namespace view
