#include "measure/scene/rung.h"

#include "grader/service/process/spawn.h"
#include "pt/error.h"

#include <algorithm>
#include <cstdlib>

#include <unistd.h>

namespace measure::scene {

namespace fs = std::filesystem;

RungProgram::RungProgram(std::vector<std::string> command, const std::string& mixture,
                         pt::Engine engine) {
  name_ = "ladder_rung." + mixture;
  std::replace(name_.begin(), name_.end(), '=', '-');
  command[0] = fs::absolute(command[0]).parent_path() / name_;
  if (!fs::exists(command[0])) {
    throw pt::Error(command[0] + " is missing: build the target ladder_rungs");
  }
  command.insert(command.end(), {"--engine", std::string(name(engine))});
  grader::base::Pipe in = grader::base::make_pipe(), out = grader::base::make_pipe();
  grader::process::Child child{command, grader::process::own_environment(), {}, "", {}};
  child.descriptors = {in.read_end.number(), out.write_end.number(), STDERR_FILENO};
  pid_ = grader::process::spawn(child);
  requests_ = std::move(in.write_end);
  replies_.reset(fdopen(dup(out.read_end.number()), "r"));
  if (!replies_) throw pt::Error("no descriptor is left");
}

RungProgram::~RungProgram() { grader::process::kill_child(pid_); }

RungReply RungProgram::render(const RungRequest& request) {
  const std::string line =
      nlohmann::json{to_json(request.spec), request.first, request.step}.dump() + "\n";
  char* text = nullptr;
  std::size_t size = 0;
  const bool sent = write(requests_.number(), line.data(), line.size()) == ssize_t(line.size());
  const bool answered = sent && getline(&text, &size, replies_.get()) > 0;
  const std::string reply = answered ? text : "";
  std::free(text);
  if (!answered) throw pt::Error(name_ + " has ended: it says above why");
  return nlohmann::json::parse(reply);
}

}  // namespace measure::scene
