#pragma once

#include "view/child.h"

#include <filesystem>
#include <memory>
#include <string>
#include <thread>

namespace httplib {
class Server;
}

namespace view {

// Compiles the tasks again whenever one of their files is saved, and ends the child, so that the next question starts the new program.
class Live {
 public:
  // The files are below `tasks`; the command compiles them.
  Live(std::filesystem::path tasks, std::vector<std::string> command, Child& child);

  struct State {
    int saves = 0;      // that have been compiled
    std::string error;  // of the last one: the compiler's first error, or empty
  };
  State state();

 private:
  void watch(const std::stop_token& stop);
  void compile(const std::stop_token& stop);

  std::filesystem::path tasks_;
  std::vector<std::string> command_;
  Child& child_;
  std::mutex reading_;
  State state_;
  std::jthread thread_;  // ends first
};

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
